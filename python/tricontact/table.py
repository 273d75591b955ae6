"""Tables of numbers, as the program writes them in CSV."""

import csv
import importlib
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray


_Array = NDArray[Any]


class Table(Mapping[str, _Array]):
    """Columns by their names, each a NumPy array: of numbers, missing ones NaN, or of texts."""

    def __init__(self, text: str) -> None:
        names, *rows = list(csv.reader(text.splitlines()))
        self._columns = {
            name: _column([row[i] for row in rows]) for i, name in enumerate(names)
        }

    def __getitem__(self, name: str) -> _Array:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """Number of columns; that of rows is the length of each."""
        return len(self._columns)

    def to_pandas(self) -> Any:
        """The same as a DataFrame. Raises ImportError where there is no pandas."""
        return importlib.import_module("pandas").DataFrame(self._columns)


def read_table(path: Union[str, "os.PathLike[str]"]) -> Table:
    """Read a table that the program has written. Raises OSError."""
    return Table(Path(path).read_text(encoding="utf-8"))


def _column(fields: list[str]) -> _Array:
    try:
        return np.array([float(field) if field else np.nan for field in fields])
    except ValueError:
        return np.array(fields)
