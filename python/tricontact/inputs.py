"""What functions take for a case: a file, a case, or a dictionary that holds what a file would."""

import contextlib
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Optional, TypeVar, Union

from . import _core, _toml
from ._core import Case, InputError, WalkCase

StrPath = Union[str, "os.PathLike[str]"]
Input = Union[StrPath, Case, dict[str, Any]]
"""A file, a case, or a dictionary that holds what a file would (paths in it absolute)."""
StudyInput = Union[StrPath, dict[str, Any]]
"""The file of a study, or a dictionary that holds what one would (paths in it absolute)."""
Overrides = Optional[dict[str, Any]]
Kind = TypeVar("Kind", Case, WalkCase)


def merged(overrides: Overrides, keys: dict[str, Any]) -> dict[str, Any]:
    """Overrides and keywords together: load__tangential_ratio=0.4 is "load.tangential_ratio".

    Raises TypeError for a keyword that is neither an option nor a key, or given twice.
    """
    found = dict(overrides or {})
    for name, value in keys.items():
        key = name.replace("__", ".")
        if "." not in key:
            raise TypeError(f"there is no option {name}; keys of the case have two underscores for "
                            "the dot: load__tangential_ratio=0.4")
        if key in found:
            raise TypeError(f"{key} is given twice, in overrides and as {name}")
        found[key] = value
    return found


def case_of(kind: type[Kind], given: Any, overrides: Overrides = None) -> Kind:
    """The case itself, or that of a file or a dictionary. Raises InputError."""
    changed = overrides or {}
    if isinstance(given, kind):
        return kind.from_dict(given.to_dict(), changed) if changed else given
    if isinstance(given, dict):
        return kind.from_dict(given, changed)
    if isinstance(given, (str, bytes, os.PathLike)):
        return kind.from_file(os.fsdecode(given), changed)
    raise TypeError(f"{given!r} is no case: give a file, a {kind.__name__} or a dictionary")


@contextlib.contextmanager
def file_of(given: Any) -> Iterator[str]:
    """The file itself, or one that is gone afterwards, which errors do not name."""
    if not isinstance(given, (Case, dict)):
        yield os.fspath(given)
        return
    with tempfile.TemporaryDirectory(prefix="tricontact-") as folder:
        text = given.to_toml() if isinstance(given, Case) else _toml.document(_with_case(given, folder))
        path = Path(folder) / "case.toml"
        path.write_text(text, encoding="utf-8")
        try:
            yield str(path)
        except InputError as error:
            name = "<case>" if isinstance(given, Case) else "<dict>"
            raise InputError(str(error).replace(str(path), name)) from None


def _with_case(given: dict[str, Any], folder: str) -> dict[str, Any]:
    """The case of a study may be one, or a dictionary, instead of its file."""
    inner = given.get("case")
    if not isinstance(inner, (Case, dict)):
        return given
    path = Path(folder) / "base.toml"
    path.write_text(inner.to_toml() if isinstance(inner, Case) else _toml.document(inner), encoding="utf-8")
    return {**given, "case": str(path)}


def study_folder(study: StudyInput, output: Optional[StrPath]) -> str:
    """Where a study's results are: as given, or results/<name of the study>."""
    if output is not None:
        return os.fspath(output)
    if isinstance(study, dict):
        raise InputError(
            "<dict>: a study that is a dictionary has no name for its folder; name one by output"
        )
    return _core._default_sweep_folder(_toml.argument(os.fspath(study)))
