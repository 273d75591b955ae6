"""The micro-walking machine."""

from dataclasses import dataclass
from typing import Any

from ._core import WalkCase, _walk
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


def walk(case: WalkCase) -> Walk:
    """Run a machine and judge its motion. Takes seconds; other threads go on, Ctrl-C waits."""
    summary, motion, windows = _walk(case)
    return Walk(summary, Table(motion), Table(windows))
