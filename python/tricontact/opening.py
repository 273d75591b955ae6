"""Folders of results, of any command."""

import json
import os
from pathlib import Path
from typing import Any, Union

from ._core import InputError
from .inputs import StrPath
from .outcome import Outcome, page_of
from .saved import SavedResult, saved_run
from .table import Table, read_table


# Files with a command's numbers: the command, and a key that only such a file has.
_FILES = {
    "summary.json": ("run", "case"),
    "limit.json": ("limit", "limit_of"),
    "refinement.json": ("refine", "sizes_m"),
    "deviation.json": ("deviation", "hertz_diameter_m"),
    "finite_strain.json": ("deviation", "elements_in_radius"),
    "body_size.json": ("deviation", "bodies"),
    "prediction.json": ("predict", "models"),
    "experiment.json": ("experiment", "verdict_confidence"),
    "identify.json": ("identify", "verdicts"),
    "rig.json": ("rig", "assumptions"),
    "design.json": ("design", "requirements"),
    "fit.json": ("fit", "caveat"),
    "atlas.json": ("atlas", "format"),
    "compare.json": ("compare", "case_differences"),
    "comparison.json": ("benchmark compare", "verdict_unexplained"),
    "reproduction.json": ("reproduce", "same_bytes"),
    "verification.json": ("verify", "rows"),
}
_GIVE = "give the folder named by --output"


def open(folder: StrPath) -> Union[SavedResult, Outcome]:
    """The results that a command of the program, or a function with `output`, left in a folder.

    Of `run`: a SavedResult, with the attributes of what run() returns; surfaces are read when they
    are asked for, and have the files' single precision. Of other commands, and of contacts that
    roll on and machines: an Outcome, with the numbers of its JSON files and every CSV file as a
    table by its place, such as "bem/history"; that of a sweep is table("results").

    Raises InputError for a folder that is missing, holds no results of a command, or damaged ones.
    """
    path = Path(os.fspath(folder))
    if not path.is_dir():
        raise InputError(f"{path}: is no folder; give one that a command wrote its results to")
    numbers = {name: _numbers_of(path / name) for name in _FILES if (path / name).is_file()}
    is_sweep = (path / "results.csv").is_file()
    if not numbers and not is_sweep:
        raise InputError(f"{path}: holds no results of a command; {_GIVE}")
    if is_sweep:
        columns = set(_table_of(path / "results.csv"))
        if "error" not in columns or not {"model", "regime"} & columns:
            raise InputError(f"{path / 'results.csv'}: is no table of a study; {_GIVE}")
    if list(numbers) == ["summary.json"] and isinstance(numbers["summary.json"].get("models"), dict):
        return saved_run(path, numbers["summary.json"])
    command = "sweep" if is_sweep else _FILES[next(iter(numbers))][0]
    tables = {file.stem: _table_of(file) for file in sorted(path.glob("*.csv"))}
    tables |= {str(file.relative_to(path).with_suffix("")): _table_of(file)
               for file in sorted(path.glob("*/*.csv"))}
    together = {key: value for one in numbers.values() for key, value in one.items()}
    return Outcome(command, together, tables, "", page_of(path), path)


def _numbers_of(file: Path) -> dict[str, Any]:
    """The object in a file of results. Raises InputError for damaged and foreign ones."""
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except (ValueError, UnicodeDecodeError):
        raise InputError(f"{file}: is no JSON; the results are damaged, compute them again") from None
    command, key = _FILES[file.name]
    if not isinstance(found, dict) or key not in found:
        raise InputError(f"{file}: was not written by tricontact {command}, it has no {key}; {_GIVE}")
    return found


def _table_of(file: Path) -> Table:
    """Raises InputError for what is no table."""
    try:
        return read_table(file)
    except (ValueError, IndexError):
        raise InputError(f"{file}: is no table; the results are damaged, compute them again") from None
