"""``python -m tankcheck.hook``: ``tankcheck check`` for several files, for pre-commit and continuous integration."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence

from ._program import find_program
from .errors import ProgramNotFound

USAGE = """usage: python -m tankcheck.hook [--allow-incomplete] [OPTION...] [--] FILE...

Runs `tankcheck check OPTION... -- FILE` for each file. Options have the form --option=value or --option; after -- all are files.

--allow-incomplete: limit states that were not checked (exit code 4) do not count

The exit code is that of the worst file: 2 bad input, 3 failed computation, 1 failed check, 4 not checked, 0.
"""

#: Exit codes from the worst to the best.
_ORDER = (2, 3, 1, 4, 0)


def _split(given: list[str]) -> tuple[list[str], list[str]]:
    """Options and files; what follows ``--`` is a file."""
    end = given.index("--") if "--" in given else len(given)
    options = [a for a in given[:end] if a.startswith("-")]
    files = [a for a in given[:end] if not a.startswith("-")]
    return options, files + given[end + 1 :]


def _shown(text: str) -> str:
    """A name in one line, without characters or words that act on a terminal or on the runner that reads the log."""
    plain = "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in text)
    return plain.replace("##", "#\\x23")


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    options, files = _split(given)
    if "--help" in options or "-h" in options:
        print(USAGE, end="")
        return 0
    # A file in a folder whose name begins with a dash is no option.
    doubtful = next((a for a in options if os.path.lexists(a)), None)
    if doubtful is not None:
        print(f"error: `{_shown(doubtful)}` is a file and looks like an option; write -- before the files", file=sys.stderr)
        return 2
    if not files:
        print("error: no file is given; expected python -m tankcheck.hook [OPTION...] [--] FILE...", file=sys.stderr)
        return 2
    incomplete = "--allow-incomplete" in options
    options = [a for a in options if a != "--allow-incomplete"]
    try:
        program = find_program()
    except ProgramNotFound as error:
        print(error, file=sys.stderr)
        return 3
    codes = []
    for file in files:
        # A title for each file, before what the program prints.
        print(f"== {_shown(file)}", flush=True)
        code = subprocess.run([str(program), "check", *options, "--", file], check=False).returncode
        codes.append(0 if code == 4 and incomplete else code)
    return min(codes, key=lambda code: _ORDER.index(code) if code in _ORDER else -1)


if __name__ == "__main__":
    sys.exit(main())
