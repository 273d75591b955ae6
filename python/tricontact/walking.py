"""The micro-walking machine."""

import html
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Any, Sequence, Union

from . import shown
from ._core import WalkCase, _walk
from .equality import same
from .inputs import Overrides, StrPath, case_of, merged
from .labels import label_of
from .progress import Progress, display
from .table import Table, entry


@dataclass(frozen=True, eq=False, repr=False)
class Walk(Mapping[str, Any]):
    """What a machine's run came to: its numbers by their keys."""

    summary: dict[str, Any]
    """The numbers of summary.json."""
    motion: Table
    """Motion and forces at the end of the run, as in motion.csv."""
    windows: Table
    """Means of the run window by window, as in windows.csv."""

    def __getitem__(self, key: str) -> Any:
        """One of the numbers, such as "mu_e". Raises KeyError."""
        return entry(self.summary, "number", key)

    def __iter__(self) -> Iterator[str]:
        return iter(self.summary)

    def __len__(self) -> int:
        return len(self.summary)

    def __eq__(self, other: object) -> bool:
        """Equal numbers and tables; times of computing do not count."""
        if not isinstance(other, Walk):
            return NotImplemented
        return all(same(getattr(self, one.name), getattr(other, one.name)) for one in fields(self))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<Walk: {self._headline()}>"

    def _headline(self) -> str:
        mu = self.summary["mu_e"]
        return str(self.summary["regime"]) + (f", mu_e = {mu:.3g}" if mu is not None else "")

    def plot(self, y: Union[str, Sequence[str]] = "x", ax: Any = None) -> Any:
        """Columns of the motion over time with matplotlib. Raises ImportError."""
        return self.motion.plot("time", y, ax)

    def _repr_html_(self) -> str:
        single = [(label_of(key).text, value, label_of(key).unit) for key, value in self.summary.items()
                  if value is not None and not isinstance(value, (dict, list))]
        headline = f"<p><b>{html.escape(self._headline())}</b></p>"
        figure = shown.picture(lambda ax: self.plot(ax=ax)) if self.motion.n_rows > 1 else ""
        return headline + figure + shown.numbers(single)


def walk(
    case: Union[StrPath, WalkCase, dict[str, Any]], *, overrides: Overrides = None,
    progress: Progress = None, **keys: Any,
) -> Walk:
    """Run a machine - a file, a WalkCase or a dictionary - and judge its motion.

    `overrides` are the program's --set. progress: see tricontact.progress; it counts thousandths of
    the steps, and what a function raises ends the run. Other threads go on, and Ctrl-C ends it.
    """
    resolved = case_of(WalkCase, case, merged(overrides, keys))
    told = display(progress)
    try:
        summary, motion, windows = _walk(resolved, told.progress)
    finally:
        told.close()
    return Walk(summary, Table(motion), Table(windows))
