"""Tables of numbers, as the program writes them in CSV."""

import csv
import importlib
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Optional, Sequence, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from . import plots, shown
from .equality import same
from .labels import Label, label_of

_Array = NDArray[Any]
_Entry = TypeVar("_Entry")


def entry(found: Mapping[str, _Entry], kind: str, name: str) -> _Entry:
    """The entry of this name, of entries of one kind. Raises KeyError, which names them all."""
    if name not in found:
        raise KeyError(f"no {kind} {name}; there are {', '.join(found) or 'none'}")
    return found[name]


class Table(Mapping[str, _Array]):
    """Columns by their names, each a NumPy array: of numbers, missing ones NaN, or of texts."""

    def __init__(
        self,
        content: Union[str, Mapping[str, Sequence[Any]]],
        units: Optional[Mapping[str, str]] = None,
    ) -> None:
        """From the text of a CSV file, or from columns.

        units: of columns whose names do not tell them.
        """
        columns = _columns_of(content) if isinstance(content, str) else content
        self._columns = {name: _column(fields) for name, fields in columns.items()}
        self._units = dict(units or {})

    def __getitem__(self, name: str) -> _Array:
        return entry(self._columns, "column", name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """Number of columns; that of rows is the length of each."""
        return len(self._columns)

    def __eq__(self, other: object) -> bool:
        """Equal columns in the same order, NaN equal to NaN."""
        if not isinstance(other, Table):
            return NotImplemented
        return list(self) == list(other) and same(self._columns, other._columns)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<Table of {self.n_rows} rows: {', '.join(self._columns)}>"

    def _repr_html_(self) -> str:
        return shown.table(self)

    @property
    def n_rows(self) -> int:
        """Number of rows."""
        return len(next(iter(self._columns.values()), ()))

    def label(self, name: str) -> Label:
        """Unit and meaning of a column."""
        label = label_of(name)
        return label._replace(unit=self._units[name]) if name in self._units else label

    @property
    def units(self) -> dict[str, str]:
        """SI units of the columns of numbers: "m", "1"; "" where a table mixes them."""
        return {
            name: self.label(name).unit
            for name, values in self._columns.items()
            if values.dtype.kind in "fiu"
        }

    def to_pandas(self) -> Any:
        """The same as a DataFrame. Raises ImportError where there is no pandas."""
        return importlib.import_module("pandas").DataFrame(self._columns)

    def to_xarray(self, dim: str = "row") -> Any:
        """The same as a Dataset along `dim`, units in the attributes. Raises ImportError."""
        xarray = importlib.import_module("xarray")
        return xarray.Dataset(
            {
                name: (dim, values, self.label(name).attributes)
                for name, values in self._columns.items()
            }
        )

    def plot(self, x: Optional[str] = None, y: Union[None, str, Sequence[str]] = None,
             ax: Any = None) -> Any:
        """Columns y over column x with matplotlib; returns the axes. Raises ImportError.

        x: the first column of numbers. y: the second one.
        """
        return plots.table(self, x, y, ax)


def read_table(path: Union[str, "os.PathLike[str]"]) -> Table:
    """Read a table that the program has written. Raises OSError."""
    return Table(Path(path).read_text(encoding="utf-8"))


def _columns_of(text: str) -> dict[str, list[str]]:
    names, *rows = list(csv.reader(text.splitlines()))
    return {name: [row[i] for row in rows] for i, name in enumerate(names)}


def _column(fields: Sequence[Any]) -> _Array:
    if isinstance(fields, np.ndarray):
        return fields
    if any(isinstance(field, bool) for field in fields):
        return np.array(fields)
    try:
        return np.array([np.nan if field in ("", None) else float(field) for field in fields])
    except (TypeError, ValueError):
        return np.array(["" if field is None else str(field) for field in fields])
