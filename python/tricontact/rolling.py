"""A contact that rolls on."""

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any, Callable, Optional, Sequence

from . import plots, shown
from ._core import Case, Surface, _roll
from .equality import same
from .inputs import Input, Overrides, case_of, merged
from .progress import Progress, display
from .table import Table, entry


@dataclass(frozen=True, eq=False, repr=False)
class Rolling:
    """What the models of a case that rolls on came to: histories by the models' names."""

    summary: dict[str, Any]
    """The numbers of summary.json."""
    histories: dict[str, Table]
    """Of each model the steps from rest on, as in history.csv; last the steady state."""
    surfaces: dict[str, Surface]
    """Of each model the surface in steady rolling; slip and dissipation are per rolled way."""
    temperatures: dict[str, dict[str, Any]]
    """Of each model, where the case states heat, temperatures of the surfaces of "indenter" and "substrate" in
    steady rolling [degC], rows of points along x as those of `surfaces`."""
    creep: Table
    """Force over creepage of models and theories, as in creep.csv."""

    @property
    def models(self) -> list[str]:
        """Names of the models."""
        return list(self.histories)

    @property
    def steady(self) -> dict[str, dict[str, Any]]:
        """Of each model the numbers of steady rolling."""
        return {one["model"]: one["steady"] for one in self.summary["models"]}

    def __getitem__(self, model: str) -> Table:
        """The history of a model. Raises KeyError."""
        return entry(self.histories, "model", model)

    def __iter__(self) -> Iterator[str]:
        return iter(self.histories)

    def __contains__(self, model: object) -> bool:
        return model in self.histories

    def __len__(self) -> int:
        return len(self.histories)

    def __eq__(self, other: object) -> bool:
        """Equal numbers, tables and surfaces; times of computing do not count."""
        if not isinstance(other, Rolling):
            return NotImplemented
        return all(same(getattr(self, one.name), getattr(other, one.name)) for one in fields(self))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        parts = [f"{model} creepage {one['longitudinal_creepage']:.3g} at force ratio {one['force_ratio']:.3g}"
                 for model, one in self.steady.items()]
        return f"<Rolling: {', '.join(parts)}>"

    def plot(self, ax: Any = None) -> Any:
        """The creep curve of models and theories with matplotlib. Raises ImportError."""
        return plots.grouped(self.creep, "model", "longitudinal_creepage", "force_ratio_x", ax)

    def _repr_html_(self) -> str:
        figure = shown.picture(self.plot) if self.creep.n_rows else ""
        return figure + shown.models(self.steady, "steady rolling") + shown.table(self.creep, "creep")


def roll(
    case: Input,
    *,
    overrides: Overrides = None,
    models: Optional[Sequence[str]] = None,
    points: int = 12,
    threads: Optional[int] = None,
    on_step: Optional[Callable[[str, int, int], object]] = None,
    progress: Progress = None,
    **keys: Any,
) -> Rolling:
    """Roll the models of a case, or those named, from rest to steady rolling. `overrides`
    are the program's --set.

    `points` of each creep curve (0: none). threads: for large grids (all cores).
    on_step(model, step, steps) is called after each step from rest and each point of the curve;
    what it raises ends the run. progress: see tricontact.progress. Other threads go on, and Ctrl-C
    ends the run between two of these.

    Raises InputError, NotConverged.
    """
    names = list(models) if models is not None else None
    resolved = case_of(Case, case, merged(overrides, keys))
    told = display(progress)

    def tell(model: str, step: int, steps: int) -> None:
        told.progress(model, step, steps)
        if on_step is not None:
            on_step(model, step, steps)

    try:
        summary, histories, surfaces, temperatures, creep = _roll(resolved, names, points, threads, tell)
    finally:
        told.close()
    tables = {model: Table(text) for model, text in histories.items()}
    return Rolling(summary, tables, surfaces, temperatures, Table(creep))
