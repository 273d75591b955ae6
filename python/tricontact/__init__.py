"""Tricontact: models of frictional contact side by side, from one case.

    case = tricontact.Case.from_file("case.toml")
    result = tricontact.run(case)
    result["bem"]["shift_x_m"], result.summary

Quantities are in SI units; those of a case may be texts with units, as in case files.
"""

from . import atlas, theory
from ._core import (
    Case,
    HalfSpaceScales,
    History,
    InputError,
    NotConverged,
    Result,
    Results,
    Scales,
    Snapshot,
    Surface,
    WalkCase,
    __version__,
    run,
)
from .atlas import predict
from .rolling import Rolling, roll
from .studies import sweep
from .table import Table, read_table
from .walking import Walk, walk

__all__ = [
    "Case",
    "HalfSpaceScales",
    "History",
    "InputError",
    "NotConverged",
    "Result",
    "Results",
    "Rolling",
    "Scales",
    "Snapshot",
    "Surface",
    "Table",
    "Walk",
    "WalkCase",
    "__version__",
    "atlas",
    "predict",
    "read_table",
    "roll",
    "run",
    "sweep",
    "theory",
    "walk",
]
