"""What functions take for a case: a file, a case, or a dictionary that holds what a file would."""

import contextlib
import copy
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple, Optional, TypeVar, Union

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


class Origin(NamedTuple):
    """What a case was made of. Commands for rigs read more of it than the resolved case holds: [rig],
    [measurement], [record], [design], uncertain numbers."""

    path: Optional[str]
    """Of its file, absolute; None of a dictionary."""
    content: Any
    """The bytes of the file, or the dictionary."""
    overrides: dict[str, Any]


def origin_of(path: Optional[StrPath], values: Optional[dict[str, Any]], overrides: dict[str, Any]) -> Origin:
    """Called by the module when it has read a case."""
    if path is None:
        return Origin(None, copy.deepcopy(values), dict(overrides))
    file = Path(os.fsdecode(path)).absolute()
    return Origin(str(file), file.read_bytes() if file.is_file() else b"", dict(overrides))


@contextlib.contextmanager
def file_of(given: Any, whole: bool = False) -> Iterator[tuple[str, dict[str, Any]]]:
    """The file itself, or one that is gone afterwards, which errors do not name; overrides for it.

    whole: of a case what it was made of. Raises InputError if its file has changed since.
    """
    origin = getattr(given, "_origin", None) if whole and isinstance(given, Case) else None
    if origin and origin.path is not None:
        path = Path(origin.path)
        if not path.is_file() or path.read_bytes() != origin.content:
            raise InputError(f"{path}: has changed since the case was read from it; read the case again")
        yield origin.path, origin.overrides
        return
    if not isinstance(given, (Case, dict)):
        yield os.fspath(given), {}
        return
    name = "<case>" if isinstance(given, Case) else "<dict>"
    values, overrides = (origin.content, origin.overrides) if origin else (given, {})
    with tempfile.TemporaryDirectory(prefix="tricontact-") as folder:
        text = values.to_toml() if isinstance(values, Case) else _toml.document(_with_case(values, folder))
        path = Path(folder) / "case.toml"
        path.write_text(text, encoding="utf-8")
        try:
            yield str(path), overrides
        except InputError as error:
            raise InputError(str(error).replace(str(path), name).replace(f"{folder}/", "")) from None


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
