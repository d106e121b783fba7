"""The program that the wheel carries."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from .errors import ProgramNotFound

#: Path of another program to run.
VARIABLE = "TANKCHECK_BINARY"


@dataclass(frozen=True)
class Completed:
    """A finished run."""

    exit_code: int
    stdout: str
    stderr: str


def _places() -> Iterator[Path]:
    """Where installers put the scripts of a wheel."""
    name = "tankcheck" + (sysconfig.get_config_var("EXE") or "")
    here = Path(__file__).resolve().parent
    yield Path(sysconfig.get_path("scripts")) / name
    # `pip install --user`.
    if sys.version_info >= (3, 10):
        scheme = sysconfig.get_preferred_scheme("user")
    else:
        scheme = "nt_user" if os.name == "nt" else "posix_user"
    yield Path(sysconfig.get_path("scripts", scheme=scheme)) / name
    # `pip install --target FOLDER`.
    yield here.parent / "bin" / name
    # `pip install --prefix FOLDER`: FOLDER/lib/python3.X/site-packages/tankcheck, or FOLDER/Lib/site-packages/tankcheck.
    for up in (3, 2):
        if len(here.parents) > up:
            yield here.parents[up] / ("Scripts" if os.name == "nt" else "bin") / name


def find_program() -> Path:
    """Path of the program: ``$TANKCHECK_BINARY``, or else the one installed with this package.

    Raises :class:`ProgramNotFound`.
    """
    named = os.environ.get(VARIABLE)
    if named:
        if Path(named).is_file():
            return Path(named)
        raise ProgramNotFound(f"error: {VARIABLE} is not a file; found `{named}`")
    places = list(dict.fromkeys(_places()))
    for place in places:
        if place.is_file():
            return place
    searched = "\n".join(f"  {place}" for place in places)
    raise ProgramNotFound(
        "error: the program tankcheck is not installed next to its package; searched\n"
        f"{searched}\n  help: install the wheel again, or set {VARIABLE} to the path of the program"
    )


def run(arguments: Sequence[str | os.PathLike[str]], *, stdin: str | None = None) -> Completed:
    """Runs the program with these arguments, whatever its exit code is.

    * ``stdin``: text for standard input; without it standard input is empty

    Raises :class:`ProgramNotFound`.
    """
    command = [os.fspath(find_program()), *(os.fspath(a) for a in arguments)]
    done = subprocess.run(
        command,
        input=(stdin or "").encode(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=False,
    )
    return Completed(
        exit_code=done.returncode,
        stdout=done.stdout.decode("utf-8", "replace"),
        stderr=done.stderr.decode("utf-8", "replace"),
    )


@lru_cache(maxsize=None)
def has_option(program: Path, command: str, option: str) -> bool:
    """Whether the help of a subcommand lists an option."""
    done = subprocess.run([os.fspath(program), command, "--help"], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    words = done.stdout.decode("utf-8", "replace").split()
    return any(word.rstrip(",") == option for word in words)
