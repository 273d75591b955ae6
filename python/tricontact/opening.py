"""Folders of results, of any command."""

import json
import os
from pathlib import Path
from typing import Union

from ._core import InputError
from .inputs import StrPath
from .outcome import Outcome, read_outcome
from .saved import SavedResult, saved_run
from .table import read_table


def open(folder: StrPath) -> Union[SavedResult, Outcome]:
    """The results that a command of the program, or a function with `output`, left in a folder.

    Of `run`: a SavedResult, with the attributes of what run() returns; surfaces are read when they
    are asked for, and have the files' single precision. Of other commands: an Outcome, with the
    numbers of its JSON files and every CSV file as a table by its place, such as "bem/history";
    that of a sweep is table("results").

    Raises InputError for a folder that is missing, holds no results, or damaged ones.
    """
    path = Path(os.fspath(folder))
    if not path.is_dir():
        raise InputError(f"{path}: is no folder; give one that a command wrote its results to")
    numbers = [file for file in sorted(path.glob("*.json")) if _is_result(file)]
    if not numbers and not (path / "results.csv").is_file():
        raise InputError(f"{path}: holds no results of a command; give the folder named by --output")
    names = [file.stem for file in numbers]
    if names == ["summary"]:
        summary = json.loads(numbers[0].read_text(encoding="utf-8"))
        if isinstance(summary.get("models"), dict):
            return saved_run(path, summary)
    command = "sweep" if (path / "results.csv").is_file() else (
        "run" if "summary" in names else names[0])
    outcome = read_outcome(command, path, "", keep=True)
    for file in sorted(path.glob("*/*.csv")):
        outcome._tables[str(file.relative_to(path).with_suffix(""))] = read_table(file)
    return outcome


def _is_result(file: Path) -> bool:
    try:
        return isinstance(json.loads(file.read_text(encoding="utf-8")), dict)
    except (ValueError, UnicodeDecodeError):
        raise InputError(f"{file}: is no JSON; the results are damaged, compute them again") from None
