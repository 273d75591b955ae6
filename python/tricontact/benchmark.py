"""Contact codes of others: problems, references with their bars, comparisons.

    tricontact.benchmark.problems("friction"), tricontact.benchmark.problem("layer_pressed")
    reference = tricontact.benchmark.reference("layer.toml")
    reference.values["normal_force"]["value"], reference.pressure(x, y)
    tricontact.benchmark.compare("coarse.csv", "fine.csv", case="layer_pressed")["verdict"]

Quantities are in SI units, tractions act on the elastic body, z points into it.
"""

import json
import os
import tempfile
from pathlib import Path
from typing import Any, Literal, Optional

from . import _core, _toml
from ._core import BenchmarkReference as Reference
from ._core import Case, _reference
from .commands import _arguments
from .inputs import Input, Overrides, StrPath, case_of, merged
from .outcome import Outcome, read_outcome
from .progress import Progress, display

__all__ = ["Reference", "compare", "deck", "problem", "problems", "reference"]


def _answer(name: str, arguments: list[str], progress: Progress = None) -> str:
    shown = display(progress)
    try:
        given = [_toml.argument(one) for one in arguments]
        return _core._run_command("benchmark " + name, given, shown.say, shown.progress)
    finally:
        shown.close()


def problems(tests: Optional[str] = None) -> list[dict[str, Any]]:
    """The problems of the catalogue, or those whose name, title, group or tests have a word."""
    found = json.loads(_answer("list", _arguments({"json": True, "tests": tests})))
    return list(found)


def problem(name: str) -> dict[str, Any]:
    """A problem: its text and case, its reference, published numbers, what can go wrong."""
    return dict(json.loads(_answer("show", [name, "--json"])))


def deck(
    problem: str,
    output: StrPath,
    *,
    code: Literal["calculix", "abaqus", "freefem", "getfem", "mesh"],
    elements: Optional[str] = None,
    levels: Optional[int] = None,
    half: bool = False,
    progress: Progress = None,
) -> list[Path]:
    """Writes inputs of a problem, or of a case file, for a code; the files in `output`."""
    folder = Path(os.fspath(output))
    options = {"code": code, "elements": elements, "levels": levels, "half": half,
               "output": str(folder)}
    _answer("deck", [problem, *_arguments(options)], progress)
    return sorted(path for path in folder.iterdir() if not path.name.startswith("."))


def compare(
    *inputs: StrPath,
    case: Optional[str] = None,
    tolerance: Optional[float] = None,
    code: Optional[str] = None,
    elements: Optional[str] = None,
    method: Optional[str] = None,
    penalty: Optional[str] = None,
    stick_slope: Optional[str] = None,
    kinematics: Optional[str] = None,
    press_steps: Optional[int] = None,
    block_width: Optional[str] = None,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    no_report: bool = False,
    progress: Progress = None,
) -> Outcome:
    """Compares results of a code with the reference: a submission file, or with `case` files with
    fields, coarse to fine.

    outcome["verdict"]: "pass", "fail" or "not-resolved"; outcome["quantities"]["normal_force"] and
    others have "verdict", "difference", "explained" and "uncertainty", outcome["diagnoses"] an "id".
    """
    options = {"case": case, "tolerance": tolerance, "code": code, "elements": elements,
               "method": method, "penalty": penalty, "stick_slope": stick_slope,
               "kinematics": kinematics, "press_steps": press_steps, "block_width": block_width,
               "export": None if export is None else os.fspath(export), "no_report": no_report}
    files = [os.fspath(one) for one in inputs]
    with tempfile.TemporaryDirectory(prefix="tricontact-") as temporary:
        folder = Path(temporary) / "results" if output is None else Path(os.fspath(output))
        options["output"] = str(folder)
        text = _answer("compare", [*files, *_arguments(options)], progress)
        return read_outcome("benchmark compare", folder, text, keep=output is not None)


def reference(
    case: Input, *, overrides: Overrides = None, threads: Optional[int] = None,
    **keys: Any,
) -> Reference:
    """The reference of a case: scalars and fields at the end of its path, each with a bar.

    Kept by the case's digest: the second call reads the first one's. `overrides` are the program's
    --set. threads: for large grids (1).

    Raises InputError where no model is a reference for the case, NotConverged.
    """
    return _reference(case_of(Case, case, merged(overrides, keys)), 1 if threads is None else threads)
