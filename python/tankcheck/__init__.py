"""Seismic verification of liquid storage tanks.

The package runs the ``tankcheck`` program that its wheel carries and gives its results as objects::

    import tankcheck

    results = tankcheck.check("tank.json")
    results.status                      # "holds", "fails", "incomplete", "not_assessed"
    results.governing.utilisation
    results.value("base_shear", method="ec8-2006")
    results.quantities.to_frame()       # with pandas

    results = tankcheck.compare("tank.json", quake="elcentro.csv", out="out")
    results.report                      # path of report.html

A tank is the path of a tank file, or the same as a ``dict``. Values are SI. Failures are exceptions
(:class:`InputError`, :class:`ComputationError`, :class:`Interrupted`); a check that fails is a result.
"""

from __future__ import annotations

from ._calls import check, compare, template, version
from ._program import Completed, find_program, run
from ._results import Check, Method, Quantity, Results, Table
from .errors import (
    ComputationError,
    InputError,
    Interrupted,
    ProgramNotFound,
    TankcheckError,
    TankcheckWarning,
)

__all__ = [
    "Check",
    "Completed",
    "ComputationError",
    "InputError",
    "Interrupted",
    "Method",
    "ProgramNotFound",
    "Quantity",
    "Results",
    "Table",
    "TankcheckError",
    "TankcheckWarning",
    "check",
    "compare",
    "find_program",
    "run",
    "template",
    "version",
]
