"""`check` and `compare`: a tank and options in, results out."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
import warnings
import weakref
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Union

from . import errors
from ._program import find_program, has_option, run
from ._results import Results

#: A tank: path of its file, or its content.
Tank = Union[str, "os.PathLike[str]", Mapping[str, Any]]

#: Options that change the form of the answer.
_FORMS = {"format", "select", "solve", "table", "help", "version"}


def version() -> str:
    """Version of the program, such as ``"0.5.0"``."""
    done = run(["--version"])
    if done.exit_code != 0:
        raise errors.of_exit_code(done.exit_code, done.stderr.strip())
    return done.stdout.split()[-1]


def template(shape: str = "cylinder") -> str:
    """A commented tank file to start from, as ``tankcheck init`` writes it.

    * ``shape``: ``"cylinder"`` or ``"rectangle"``
    """
    done = run(["init", f"--shape={shape}"])
    if done.exit_code != 0:
        raise errors.of_exit_code(done.exit_code, done.stderr.strip())
    return done.stdout


def check(tank: Tank, *, out: str | os.PathLike[str] | None = None, **options: Any) -> Results:
    """Runs the code procedures without finite elements (``tankcheck check``).

    * ``tank``: path of a tank file, or its content
    * ``out``: folder for a report
    * ``options``: options of the command with underscores, such as ``quake="elcentro.csv"`` or
      ``procedures=["ec8-2006"]``; ``True`` for an option without a value

    Raises :class:`InputError`, :class:`ComputationError`, :class:`Interrupted`, :class:`ProgramNotFound`.
    """
    return _results("check", tank, None if out is None else Path(out), options)


def compare(
    tank: Tank,
    *,
    quake: str | os.PathLike[str] | None = None,
    out: str | os.PathLike[str] | None = None,
    **options: Any,
) -> Results:
    """Runs code procedures and finite elements side by side (``tankcheck compare``).

    * ``tank``: path of a tank file, or its content
    * ``quake``: record of the horizontal ground acceleration; without it the design spectrum of the tank's ``site``
    * ``out``: folder for report, histories and figures; without it a temporary one, which is removed with the results
    * ``options``: options of the command with underscores, such as ``fe="both"`` or ``vertical="up.at2"``

    A collapse of the tank and a run that was stopped are results (``exit_code`` 3).

    Raises :class:`InputError`, :class:`ComputationError`, :class:`Interrupted`, :class:`ProgramNotFound`.
    """
    if out is not None:
        return _results("compare", tank, Path(out), {"quake": quake, **options})
    parent = tempfile.mkdtemp(prefix="tankcheck-")
    try:
        results = _results("compare", tank, Path(parent) / "out", {"quake": quake, **options})
    except BaseException:
        shutil.rmtree(parent, ignore_errors=True)
        raise
    weakref.finalize(results, shutil.rmtree, parent, True)
    return results


def _results(command: str, tank: Tank, out: Path | None, options: Mapping[str, Any]) -> Results:
    path, stdin = _tank(tank)
    program = find_program()
    arguments = [command, path, "--format=json", "--quiet", "--color=never"]
    # Programs that select what they print: everything.
    if has_option(program, command, "--select"):
        arguments.append("--select=all")
    if out is not None:
        arguments.append(f"--out={os.fspath(out)}")
    arguments += _arguments(options)
    done = run(arguments, stdin=stdin)
    data = _json(done.stdout)
    if data is None:
        raise errors.of_exit_code(done.exit_code, done.stderr.strip())
    messages = tuple(line for line in done.stderr.splitlines() if line.strip())
    for line in messages:
        if line.startswith("warning[") or line.startswith("warning: "):
            # The code stays: `T0903: …`, as `tankcheck explain` knows it.
            text = line[len("warning") :].removeprefix(": ").removeprefix("[").replace("]: ", ": ", 1)
            warnings.warn(text, errors.TankcheckWarning, stacklevel=3)
    return Results(data, exit_code=done.exit_code, messages=messages, folder=out)


def _tank(tank: Tank) -> tuple[str, str | None]:
    """The argument of a tank, and what standard input has."""
    if isinstance(tank, Mapping):
        try:
            # On lines of their own: a message shows the line of its fault.
            return "-", json.dumps(tank, allow_nan=False, ensure_ascii=False, indent=2)
        except (TypeError, ValueError) as error:
            raise errors.InputError(f"error: the tank is not JSON; {error}", 2) from error
    if not isinstance(tank, (str, os.PathLike)):
        raise TypeError(f"tank: expected a path or a dict, found {type(tank).__name__}")
    path = os.fspath(tank)
    # `-` is standard input and `-x` an option; here both are names of files.
    return (os.path.join(os.curdir, path) if path.startswith("-") else path), None


def _arguments(options: Mapping[str, Any]) -> list[str]:
    arguments = []
    for name, value in options.items():
        if name in _FORMS:
            raise TypeError(f"{name}: this option changes the form of the answer; use tankcheck.run for it")
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            arguments.append(option)
        elif isinstance(value, (list, tuple)):
            arguments.append(f"{option}={','.join(_text(v) for v in value)}")
        else:
            arguments.append(f"{option}={_text(value)}")
    return arguments


def _text(value: Any) -> str:
    return os.fspath(value) if isinstance(value, os.PathLike) else str(value)


def _json(text: str) -> dict[str, Any] | None:
    """The results on standard output; ``None`` if there are none."""
    try:
        data = json.loads(text)
    except ValueError:
        return None
    known = isinstance(data, dict) and str(data.get("format", "")).startswith("tankcheck-results/")
    return data if known else None
