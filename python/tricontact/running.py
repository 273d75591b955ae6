"""Runs of a case."""

from typing import Callable, Literal, Optional, Sequence

from ._core import Case, Result, _run
from .progress import Progress, display


def run(
    case: Case,
    *,
    models: Optional[Sequence[str]] = None,
    threads: Optional[int] = None,
    studies: bool = True,
    surfaces: Literal["quarters", "all"] = "quarters",
    on_step: Optional[Callable[[str, int, int], object]] = None,
    progress: Progress = None,
) -> Result:
    """Run the models of a case, or those named.

    threads: for large grids (all cores). studies: also the further runs that the program makes for
    comparison. surfaces: result.surfaces(model) has the contact surface at the quarters of the
    first three periods and of the last one, or of every step. on_step(model, step, steps_at_most)
    is called after each step; what it raises ends the run. progress: see tricontact.progress.
    Other threads go on, and Ctrl-C ends the run between two steps.

    Raises InputError, NotConverged.
    """
    if surfaces not in ("quarters", "all"):
        raise ValueError(f'surfaces = {surfaces!r}: must be "quarters" or "all"')
    shown = display(progress)

    def tell(model: str, step: int, steps: int) -> None:
        shown.progress(model, step, steps)
        if on_step is not None:
            on_step(model, step, steps)

    names = list(models) if models is not None else None
    try:
        return _run(case, names, threads, studies, surfaces == "all", tell)
    finally:
        shown.close()
