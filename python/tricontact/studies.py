"""Studies: many points of a case side by side."""

import os
from pathlib import Path
from typing import Optional

from . import _toml
from ._core import _sweep
from .inputs import StrPath, StudyInput, file_of, study_folder
from .progress import Progress, display
from .table import Table, read_table


def sweep(
    study: StudyInput,
    output: Optional[StrPath] = None,
    *,
    jobs: Optional[int] = None,
    retry_failed: bool = False,
    vtk: bool = False,
    report: bool = True,
    progress: Progress = None,
) -> Table:
    """Compute the points of a study that its folder has not yet, and return the table of all.

    As the program's command of that name, with the same files in the folder `output`
    (results/<name of the study>): a sweep that was stopped, also by Ctrl-C, goes on when it is
    called again. `jobs` processes work side by side (one per core). progress: see
    tricontact.progress; it counts points.

    Raises InputError, and RuntimeError if points failed: the table, in which their errors stand,
    is written all the same.
    """
    folder = study_folder(study, output)
    if jobs is not None and jobs < 1:
        raise ValueError("jobs: must be at least 1")
    told = display(progress)
    try:
        with file_of(study) as (file, _):
            _sweep(_toml.argument(file), _toml.argument(folder), jobs or os.cpu_count() or 1, retry_failed,
                   vtk, report, told.say, told.progress)
    finally:
        told.close()
    return read_table(Path(folder) / "results.csv")
