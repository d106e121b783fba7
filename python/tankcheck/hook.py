"""``python -m tankcheck.hook``: ``tankcheck check`` for several files, for pre-commit and continuous integration."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence

from ._program import find_program
from .errors import ProgramNotFound

USAGE = """usage: python -m tankcheck.hook [--allow-incomplete] [OPTION...] FILE...

Runs `tankcheck check OPTION... FILE` for each file. Options have the form --option=value or --option.

--allow-incomplete: limit states that were not checked (exit code 4) do not count

The exit code is that of the worst file: 2 bad input, 3 failed computation, 1 failed check, 4 not checked, 0.
"""

#: Exit codes from the worst to the best.
_ORDER = (2, 3, 1, 4, 0)


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if "--help" in given or "-h" in given:
        print(USAGE, end="")
        return 0
    incomplete = "--allow-incomplete" in given
    options = [a for a in given if a.startswith("-") and a != "--allow-incomplete"]
    files = [a for a in given if not a.startswith("-")]
    if not files:
        print("error: no file is given; expected python -m tankcheck.hook [OPTION...] FILE...", file=sys.stderr)
        return 2
    try:
        program = find_program()
    except ProgramNotFound as error:
        print(error, file=sys.stderr)
        return 3
    codes = []
    for file in files:
        # A title for each file, before what the program prints.
        print(f"== {file}", flush=True)
        code = subprocess.run([str(program), "check", *options, file], check=False).returncode
        codes.append(0 if code == 4 and incomplete else code)
    return min(codes, key=lambda code: _ORDER.index(code) if code in _ORDER else -1)


if __name__ == "__main__":
    sys.exit(main())
