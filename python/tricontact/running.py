"""Runs of a case."""

from typing import Any, Callable, Literal, Optional, Sequence

from ._core import Case, Result, _run
from .commands import _call
from .inputs import Input, Overrides, StrPath, case_of, merged
from .progress import Progress, display


def run(
    case: Input,
    *,
    overrides: Overrides = None,
    models: Optional[Sequence[str]] = None,
    threads: Optional[int] = None,
    studies: bool = True,
    surfaces: Literal["quarters", "all"] = "quarters",
    on_step: Optional[Callable[[str, int, int], object]] = None,
    export: Optional[StrPath] = None,
    progress: Progress = None,
    **keys: Any,
) -> Result:
    """Run the models of a case, or those named. `overrides` are the program's --set,
    and keywords such as load__tangential_ratio=0.4 single ones of them.

    threads: for large grids (all cores). studies: also the further runs that the program makes for
    comparison. surfaces: result.surfaces(model) has the contact surface at the quarters of the
    first three periods and of the last one, or of every step. on_step(model, step, steps_at_most)
    is called after each step; what it raises ends the run. progress: see tricontact.progress.
    export: a folder for papers, for which the program's command runs the models once more.
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
    resolved = case_of(Case, case, merged(overrides, keys))
    try:
        result = _run(resolved, names, threads, studies, surfaces == "all", tell)
    finally:
        shown.close()
    if export is not None:
        _call("run", case, merged(overrides, keys), None, progress, models=names, threads=threads,
              no_studies=not studies, export=export)
    return result
