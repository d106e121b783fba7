"""Failures of a run, by the exit codes of the program."""

from __future__ import annotations


class TankcheckError(Exception):
    """A run without results.

    * ``message``: what the program wrote to standard error
    * ``exit_code``: of the program; ``None`` if it did not start
    """

    def __init__(self, message: str, exit_code: int | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.exit_code = exit_code

    def __reduce__(self) -> tuple[type[TankcheckError], tuple[str, int | None]]:
        return type(self), (self.message, self.exit_code)


class InputError(TankcheckError):
    """Bad input or an unknown option (exit code 2); the message has file, line or key, value and what is allowed."""


class ComputationError(TankcheckError):
    """The computation failed, or its results could not be written (exit code 3, or the program ended abnormally)."""


class Interrupted(TankcheckError):
    """Ctrl-C ended the program without results (exit code 130)."""


class ProgramNotFound(TankcheckError):
    """The program is not next to the package."""


class TankcheckWarning(UserWarning):
    """A warning of the program."""


def of_exit_code(code: int, message: str) -> TankcheckError:
    """The error of an exit code."""
    if code == 2:
        return InputError(message, code)
    if code in (130, -2):
        return Interrupted(message or "interrupted", code)
    if code < 0:
        return ComputationError(f"{message}\ntankcheck was ended by signal {-code}".strip(), code)
    return ComputationError(message or f"tankcheck ended with exit code {code} and without a message", code)
