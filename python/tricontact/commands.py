"""The program's commands, called within this process: their numbers, tables and reports.

Options are those of the program. Without `output` no files are left behind; with it they are
where the program would put them, and what is there already is not computed again. What is wrong
raises InputError, what does not converge NotConverged. Other threads go on; Ctrl-C ends a command
(not while finite elements are condensed), and so does what `progress` raises. `export`: a folder
for what papers need, and an archive from which reproduce() runs again.
"""

import json
import os
import tempfile
from pathlib import Path
from typing import Any, Literal, Optional, Sequence, Union

from . import _core, _toml
from ._core import Case, InputError
from .inputs import Input, Overrides, StrPath, StudyInput, case_of, file_of, merged, study_folder
from .outcome import Outcome, read_outcome
from .progress import Progress, display

# Commands that read more than the resolved case holds.
_WHOLE = {"rig", "design", "identify", "experiment", "predict"}


def _arguments(options: dict[str, Any]) -> list[str]:
    """As a shell would give them; what is None or False is not given."""
    found = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        found.append("--" + name.replace("_", "-"))
        if value is not True:
            is_list = not isinstance(value, str) and isinstance(value, Sequence)
            found.append(",".join(value) if is_list else str(value))
    return found


def _printed(
    name: str, given: Any, overrides: Overrides, progress: Progress, options: dict[str, Any],
    further: Sequence[str] = (),
) -> str:
    """Calls the command; what it prints."""
    shown = display(progress)
    try:
        with file_of(given, name in _WHOLE) as (file, first):
            changed = {**first, **(overrides or {})}
            sets = [part for one in _toml.overrides(changed) for part in ("--set", one)]
            arguments = [_toml.argument(one) for one in (file, *further, *sets, *_arguments(options))]
            return _core._run_command(name, arguments, shown.say, shown.progress)
    finally:
        shown.close()


def _call(
    name: str,
    given: Any,
    overrides: Overrides,
    output: Optional[StrPath],
    progress: Progress,
    further: Sequence[str] = (),
    tables_in: str = "*.csv",
    **options: Any,
) -> Outcome:
    with tempfile.TemporaryDirectory(prefix="tricontact-") as temporary:
        folder = Path(temporary) / "results" if output is None else Path(os.fspath(output))
        options["output"] = str(folder)
        text = _printed(name, given, overrides, progress, options, further)
        return read_outcome(name, folder, text, keep=output is not None, tables_in=tables_in)


def wear(
    case: Input,
    *,
    overrides: Overrides = None,
    models: Optional[Sequence[str]] = None,
    threads: Optional[int] = None,
    studies: bool = True,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    progress: Progress = None,
    **keys: Any,
) -> Outcome:
    """The contact of a case with [wear] over its cycles: outcome.table("bem/wear") has a row per
    worn state, outcome.table("bem/profiles") what stands along x in some of them.

    studies: also what cells of twice the size change. With `output` a run that was ended goes on
    from its last state.
    """
    changed = merged(overrides, keys)
    if "\n[wear]\n" not in case_of(Case, case, changed).to_toml():
        raise InputError("case: without [wear] nothing wears; tricontact.run computes such a case")
    return _call("run", case, changed, output, progress, tables_in="*/*.csv", models=models, threads=threads,
                 no_studies=not studies, export=export)


def limit(
    case: Input,
    *,
    overrides: Overrides = None,
    vary: Literal["load", "amplitude"] = "load",
    tolerance: Optional[float] = None,
    models: Optional[Sequence[str]] = None,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    threads: Optional[int] = None,
    progress: Progress = None,
    **keys: Any,
) -> Outcome:
    """The limit of shakedown of each model, in the load f_T or the amplitude w, by bisection.

    tolerance: width of the bracket (1e-6 of mdr, 1e-3 of others).
    """
    return _call("limit", case, merged(overrides, keys), output, progress, vary=vary, tolerance=tolerance,
                 models=models, threads=threads, export=export)


def refine(
    case: Input,
    *,
    overrides: Overrides = None,
    levels: int = 3,
    models: Union[str, Sequence[str]] = "fem",
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    threads: Optional[int] = None,
    jobs: int = 1,
    progress: Progress = None,
    **keys: Any,
) -> Outcome:
    """A case on finer and finer meshes: extrapolated values and their errors.

    models: the one model that is refined. jobs: levels side by side, but for the finest.
    """
    return _call("refine", case, merged(overrides, keys), output, progress, levels=levels, models=models,
                 threads=threads, jobs=jobs, export=export)


def deviation(
    case: Input,
    *,
    overrides: Overrides = None,
    no_runs: bool = False,
    finite_strain: bool = False,
    body: bool = False,
    elements: Optional[float] = None,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    jobs: Optional[int] = None,
    progress: Progress = None,
    **keys: Any,
) -> Outcome:
    """How far the layer of a case is from a half-space, or linear elasticity from finite strains.

    no_runs: exact theory alone. finite_strain: by finite elements, so many `elements` in the
    contact radius (5). body: the indenter's body in place of the layer, over its size.
    """
    return _call("deviation", case, merged(overrides, keys), output, progress, no_runs=no_runs,
                 finite_strain=finite_strain, body=body, elements=elements, jobs=jobs, export=export)


def predict(
    case: Input,
    models: Optional[Sequence[str]] = None,
    *,
    overrides: Overrides = None,
    samples: Optional[int] = None,
    output: Optional[StrPath] = None,
    **keys: Any,
) -> Outcome:
    """Predict a case from the atlases, without a run.

    outcome[model] has the quantities with keys and SI units of summary.json, beside each the half
    width of its bar of 95 % (KEY_error; 0 of closed forms), "state", what it rests on ("rests_on"),
    and what is not said ("gaps"). models: all that an atlas is about. samples: points of the
    uncertain numbers of the case, for distributions and Sobol' indices.
    """
    if output is not None:
        return _call("predict", case, merged(overrides, keys), output, None, models=models, samples=samples)
    options = {"models": models, "samples": samples, "json": True}
    return Outcome("predict", json.loads(_printed("predict", case, merged(overrides, keys), None, options)))


def experiment(
    case: Input,
    *,
    overrides: Overrides = None,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    threads: Optional[int] = None,
    progress: Progress = None,
    **keys: Any,
) -> Outcome:
    """Records of a rig evaluated, and compared with its models."""
    return _call("experiment", case, merged(overrides, keys), output, progress, threads=threads, export=export)


def identify(
    case: Input,
    *,
    overrides: Overrides = None,
    posterior: bool = False,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    threads: Optional[int] = None,
    progress: Progress = None,
    **keys: Any,
) -> Outcome:
    """E, nu, mu, lengths and Prony terms from measurements on a rig.

    posterior: also draw from the density of what is found (the table "posterior").
    """
    return _call("identify", case, merged(overrides, keys), output, progress, posterior=posterior,
                 threads=threads, export=export)


def rig(
    case: Input,
    *,
    overrides: Overrides = None,
    samples: Optional[int] = None,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    **keys: Any,
) -> Outcome:
    """What the evaluation of a rig assumes, checked. Violations are no error.

    samples: of the uncertain quantities, for the chance that an assumption is violated.
    """
    return _call("rig", case, merged(overrides, keys), output, None, samples=samples, export=export)


def design(
    case: Input,
    *,
    overrides: Overrides = None,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    **keys: Any,
) -> Outcome:
    """Values of a rig that make assumptions hold and deviations visible."""
    return _call("design", case, merged(overrides, keys), output, None, export=export)


def fit(
    study: StudyInput,
    output: Optional[StrPath] = None,
    *,
    confidence: float = 0.95,
    export: Optional[StrPath] = None,
) -> Outcome:
    """kappa and eta fitted to a finished sweep, in the folder that sweep() filled; models compared."""
    folder = study_folder(study, output)
    return _call("fit", study, None, folder, None, confidence=confidence, export=export)


def build_atlas(
    study: StudyInput,
    output: Optional[StrPath] = None,
    *,
    check: Optional[int] = None,
    seed: int = 1,
    atlas: Optional[StrPath] = None,
    shard: Optional[str] = None,
    jobs: Optional[int] = None,
    retry_failed: bool = False,
    progress: Progress = None,
) -> Outcome:
    """Map results over keys of a case, as the program's command atlas; tricontact.atlas.build.

    The folder `output` (results/<name of the study>) then holds atlas.json, which load() reads;
    runs that were computed before an interruption are taken from it. check: so many random points,
    computed more finely, are compared with the atlas, or with another one's file `atlas`. shard:
    "i/n", only the i-th of n parts of the runs.

    Raises RuntimeError if the error bars cover too few of the random points.
    """
    part = "_shard_" + shard.replace("/", "_of_") if shard is not None and output is None else ""
    folder = study_folder(study, output) + part
    other = os.fspath(atlas) if atlas is not None else None
    return _call("atlas", study, None, folder, progress, check=check, seed=seed, atlas=other,
                 shard=shard, jobs=jobs, retry_failed=retry_failed)


def new(
    output: StrPath, *, example: Optional[str] = None, overrides: Overrides = None, **keys: Any
) -> Path:
    """Writes a first case, to begin with: one of the examples, or a sphere on a half-space or layer.

    Returns its path; a file that is there is never written over. overrides: answers to what the
    program's command asks on a terminal; for the rest the usual ones.
    """
    sets = [part for one in _toml.overrides(merged(overrides, keys) or {}) for part in ("--set", one)]
    options = {"example": example, "defaults": example is None, "output": os.fspath(output)}
    arguments = [_toml.argument(one) for one in (*sets, *_arguments(options))]
    shown = display(None)
    try:
        _core._run_command("new", arguments, shown.say, shown.progress)
    finally:
        shown.close()
    return Path(output)


def examples() -> list[dict[str, str]]:
    """The examples that new() writes: name, title and the command that reads each."""
    shown = display(None)
    try:
        arguments = [_toml.argument(one) for one in ("--list", "--json")]
        text = _core._run_command("new", arguments, shown.say, shown.progress)
    finally:
        shown.close()
    return list(json.loads(text)["examples"])


def reproduce(
    archive: StrPath,
    *,
    tolerance: float = 1e-6,
    output: Optional[StrPath] = None,
    progress: Progress = None,
) -> Outcome:
    """Runs again what a command with `export` has put into its archive.zip, and compares the numbers.

    outcome["reproduces"]: all numbers agree within the relative tolerance or their stated errors;
    outcome["same_bytes"], and the table "changed" of the quantities that differ.
    """
    return _call("reproduce", archive, None, output, progress, tolerance=tolerance)


def compare(
    a: StrPath,
    b: StrPath,
    *,
    output: Optional[StrPath] = None,
    export: Optional[StrPath] = None,
    progress: Progress = None,
) -> Outcome:
    """Two folders of results of run() side by side: quantities, histories, fields; A minus B.

    outcome["case_differences"]: keys of the cases that differ; outcome["pairs"]: a model of A
    beside one of B.
    """
    return _call("compare", a, None, output, progress, further=[os.fspath(b)], export=export)
