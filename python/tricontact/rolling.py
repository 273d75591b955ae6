"""A contact that rolls on."""

from dataclasses import dataclass
from typing import Any, Callable, Optional, Sequence

from ._core import Case, Surface, _roll
from .inputs import Input, Overrides, case_of, merged
from .progress import Progress, display
from .table import Table


@dataclass(frozen=True)
class Rolling:
    """What the models of a case that rolls on came to."""

    summary: dict[str, Any]
    """The numbers of summary.json."""
    histories: dict[str, Table]
    """Of each model the steps from rest on, as in history.csv; last the steady state."""
    surfaces: dict[str, Surface]
    """Of each model the surface in steady rolling; slip and dissipation are per rolled way."""
    creep: Table
    """Force over creepage of models and theories, as in creep.csv."""


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
    what it raises ends the run. progress: see tricontact.progress. Other threads go on, and Ctrl-C ends the run between two of these.

    Raises InputError, NotConverged.
    """
    names = list(models) if models is not None else None
    resolved = case_of(Case, case, merged(overrides, keys))
    shown = display(progress)

    def tell(model: str, step: int, steps: int) -> None:
        shown.progress(model, step, steps)
        if on_step is not None:
            on_step(model, step, steps)

    try:
        summary, histories, surfaces, creep = _roll(resolved, names, points, threads, tell)
    finally:
        shown.close()
    tables = {model: Table(text) for model, text in histories.items()}
    return Rolling(summary, tables, surfaces, Table(creep))
