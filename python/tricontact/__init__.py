"""Tricontact: models of frictional contact side by side, from one case.

    case = tricontact.Case.from_file("case.toml")
    result = tricontact.run(case)
    result["bem"]["shift_x_m"], result.summary

Quantities are in SI units; those of a case may be texts with units, as in case files, or
quantities of pint.
"""

from . import atlas, benchmark, theory
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
)
from .commands import (
    deviation,
    compare,
    design,
    examples,
    experiment,
    fit,
    identify,
    limit,
    new,
    predict,
    refine,
    reproduce,
    rig,
    wear,
)
from .labelled import Surfaces
from .opening import open
from .outcome import Outcome
from .rolling import Rolling, roll
from .running import run
from .saved import SavedResult
from .studies import sweep
from .table import Table, read_table
from .walking import Walk, walk

__all__ = [
    "Case",
    "HalfSpaceScales",
    "History",
    "InputError",
    "NotConverged",
    "Outcome",
    "Result",
    "Results",
    "Rolling",
    "SavedResult",
    "Scales",
    "Snapshot",
    "Surface",
    "Surfaces",
    "Table",
    "Walk",
    "WalkCase",
    "__version__",
    "atlas",
    "benchmark",
    "compare",
    "design",
    "deviation",
    "examples",
    "experiment",
    "fit",
    "identify",
    "limit",
    "new",
    "open",
    "predict",
    "read_table",
    "refine",
    "reproduce",
    "rig",
    "roll",
    "run",
    "sweep",
    "theory",
    "walk",
    "wear",
]
