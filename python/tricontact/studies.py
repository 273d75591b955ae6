"""Studies: many points of a case side by side."""

import os
from pathlib import Path
from typing import Optional, Union

from ._core import _default_sweep_folder, _sweep
from .table import Table, read_table

StrPath = Union[str, "os.PathLike[str]"]


def sweep(
    study: StrPath,
    output: Optional[StrPath] = None,
    *,
    jobs: Optional[int] = None,
    retry_failed: bool = False,
    vtk: bool = False,
    report: bool = True,
) -> Table:
    """Compute the points of a study that its folder has not yet, and return the table of all.

    As the program's command of that name, with the same files in the folder `output`
    (results/<name of the study>): a sweep that was stopped, also by Ctrl-C, goes on when it is
    called again. `jobs` processes work side by side (one per core).

    Raises InputError, and RuntimeError if points failed: the table, in which their errors stand,
    is written all the same.
    """
    folder = os.fspath(output) if output is not None else _default_sweep_folder(os.fspath(study))
    if jobs is not None and jobs < 1:
        raise ValueError("jobs: must be at least 1")
    _sweep(os.fspath(study), folder, jobs or os.cpu_count() or 1, retry_failed, vtk, report)
    return read_table(Path(folder) / "results.csv")
