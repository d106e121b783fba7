"""``python -m tankcheck``: the program."""

from __future__ import annotations

import os
import subprocess
import sys

from ._program import find_program
from .errors import ProgramNotFound


def main() -> int:
    try:
        program = os.fspath(find_program())
    except ProgramNotFound as error:
        print(error, file=sys.stderr)
        return 3
    arguments = [program, *sys.argv[1:]]
    if os.name == "posix":
        os.execv(program, arguments)
    return subprocess.run(arguments, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
