"""The micro-walking machine."""

from dataclasses import dataclass
from typing import Any, Union

from ._core import WalkCase, _walk
from .inputs import Overrides, StrPath, case_of, merged
from .table import Table


@dataclass(frozen=True)
class Walk:
    """What a machine's run came to."""

    summary: dict[str, Any]
    """The numbers of summary.json."""
    motion: Table
    """Motion and forces at the end of the run, as in motion.csv."""
    windows: Table
    """Means of the run window by window, as in windows.csv."""


def walk(
    case: Union[StrPath, WalkCase, dict[str, Any]], *, overrides: Overrides = None,
    **keys: Any,
) -> Walk:
    """Run a machine - a file, a WalkCase or a dictionary - and judge its motion.

    `overrides` are the program's --set. Takes seconds; other threads go on, Ctrl-C waits.
    """
    summary, motion, windows = _walk(case_of(WalkCase, case, merged(overrides, keys)))
    return Walk(summary, Table(motion), Table(windows))
