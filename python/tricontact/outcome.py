"""What a command of the program came to."""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Optional, Union

from . import plots, shown
from .labels import label_of
from .equality import same
from .table import Table, entry, read_table


class Outcome(Mapping[str, Any]):
    """Numbers of the command's JSON file by their keys, its tables, its report.

    Those of a model also stand under its name: outcome["bem"] is outcome["models"]["bem"].
    """

    def __init__(
        self,
        command: str,
        numbers: dict[str, Any],
        tables: Optional[dict[str, Table]] = None,
        text: str = "",
        report: str = "",
        folder: Optional[Path] = None,
    ) -> None:
        self._numbers = numbers
        self._tables = {**(tables or {}), **_tables_in(numbers)}
        self.command = command
        """Name of the command."""
        self.text = text
        """What the program prints as the answer."""
        self.report = report
        """The page of the report, HTML; empty if there is none."""
        self.folder = folder
        """Where the files are; None if nobody asked for them."""

    def __getitem__(self, key: str) -> Any:
        if key in self._numbers:
            return self._numbers[key]
        models = self._numbers.get("models")
        if isinstance(models, dict) and key in models:
            return models[key]
        there = list(self._numbers) + (list(models) if isinstance(models, dict) else [])
        raise KeyError(f"no {key}; there are {', '.join(there) or 'none'}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)

    @property
    def tables(self) -> dict[str, Table]:
        """The tables of its CSV files, then those in its numbers, by their places."""
        return dict(self._tables)

    def table(self, name: Optional[str] = None) -> Table:
        """One of its tables, by default the first one. Raises KeyError."""
        if name is None and self._tables:
            return next(iter(self._tables.values()))
        return entry(self._tables, "table", str(name))

    def quantities(self) -> list[tuple[str, Any, str]]:
        """Place, value and SI unit of every single number and text but those of the case."""
        return list(_quantities_in(self._numbers))

    def to_xarray(self, table: Optional[str] = None) -> Any:
        """One of its tables as a Dataset. Raises ImportError where there is no xarray."""
        return self.table(table).to_xarray()

    def to_pandas(self, table: Optional[str] = None) -> Any:
        """One of its tables as a DataFrame. Raises ImportError where there is no pandas."""
        return self.table(table).to_pandas()

    def plot(self, table: Optional[str] = None, x: Optional[str] = None,
             y: Union[None, str, Sequence[str]] = None, ax: Any = None) -> Any:
        """Columns of one of its tables with matplotlib; returns the axes. Raises ImportError."""
        return plots.table(self.table(table), x, y, ax)

    def __eq__(self, other: object) -> bool:
        """Equal numbers and tables; times of computing do not count."""
        if not isinstance(other, Outcome):
            return NotImplemented
        mine, others = [(one.command, one._numbers, one._tables) for one in (self, other)]
        return mine[0] == others[0] and same(mine[1], others[1]) and same(mine[2], others[2])

    def __contains__(self, key: object) -> bool:
        models = self._numbers.get("models")
        return key in self._numbers or (isinstance(models, dict) and key in models)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<Outcome of {self.command}: {', '.join(self._numbers)}>"

    def _repr_html_(self) -> str:
        parts = [shown.preformatted(self.text)] if self.text else []
        single = [one for one in self.quantities() if "/" not in one[0]]
        if single:
            parts.append(shown.numbers(single, f"tricontact {self.command}"))
        parts += [shown.table(one, name) for name, one in list(self._tables.items())[:3]]
        models = self._numbers.get("models")
        if not self.text and isinstance(models, dict) and all(isinstance(one, dict) for one in models.values()):
            parts.append(shown.models(models, f"tricontact {self.command}"))
        return "".join(parts)


def read_outcome(command: str, folder: Path, text: str, keep: bool, tables_in: str = "*.csv") -> Outcome:
    """What a command has written into a folder; tables by their paths from there."""
    numbers: dict[str, Any] = {}
    for path in sorted(folder.glob("*.json")):
        numbers.update(json.loads(path.read_text(encoding="utf-8")))
    tables = {
        path.relative_to(folder).with_suffix("").as_posix(): read_table(path) for path in sorted(folder.glob(tables_in))
    }
    return Outcome(command, numbers, tables, text, page_of(folder), folder if keep else None)


def page_of(folder: Path) -> str:
    """The first page in a folder; empty if there is none."""
    pages = sorted(folder.glob("*.html"))
    return pages[0].read_text(encoding="utf-8") if pages else ""


def _is_single(item: Any) -> bool:
    return not isinstance(item, (dict, list))


def _is_quantity(item: Any) -> bool:
    """{"value": 1.2, "unit": "m", ...}"""
    return isinstance(item, dict) and "unit" in item and _is_single(item.get("value", []))


def _quantities_in(item: dict[str, Any], place: str = "") -> Iterator[tuple[str, Any, str]]:
    for key, value in item.items():
        here = f"{place}/{key}" if place else key
        if here == "case":
            continue
        if _is_quantity(value):
            yield here, value["value"], str(value["unit"])
        elif isinstance(value, dict):
            yield from _quantities_in(value, here)
        elif _is_single(value):
            yield here, value, label_of(key).unit if isinstance(value, (int, float)) else ""


def _flat(item: dict[str, Any], units: dict[str, str], place: str = "") -> dict[str, Any]:
    """The single values of an object and of those in it."""
    found: dict[str, Any] = {}
    for key, value in item.items():
        here = f"{place}.{key}" if place else key
        if _is_quantity(value):
            found[here] = value["value"]
            units[here] = str(value["unit"]) if units.get(here, value["unit"]) == value["unit"] else ""
            if value.get("standard_error"):
                found[here + "_standard_error"] = value["standard_error"]
        elif isinstance(value, dict):
            found.update(_flat(value, units, here))
        elif _is_single(value):
            found[here] = value
    return found


def _table_of(rows: list[dict[str, Any]]) -> Optional[Table]:
    units: dict[str, str] = {}
    flat = [_flat(row, units) for row in rows]
    names = dict.fromkeys(name for row in flat for name in row)
    if not names:
        return None
    return Table({name: [row.get(name) for row in flat] for name in names}, units)


def _tables_in(item: Any, place: str = "") -> dict[str, Table]:
    """Lists of objects, and objects of equally long lists of numbers, by their places."""
    found: dict[str, Table] = {}
    if not isinstance(item, dict):
        return found
    columns = {key: value for key, value in item.items() if _is_column(value)}
    lengths = {len(value) for value in columns.values()}
    if len(columns) > 1 and len(lengths) == 1:
        found[place or "numbers"] = Table(columns)
    for key, value in item.items():
        here = f"{place}/{key}" if place else key
        if here == "case":
            continue
        if isinstance(value, dict):
            found.update(_tables_in(value, here))
        elif isinstance(value, list) and value and all(isinstance(one, dict) for one in value):
            table = _table_of(value)
            if table:
                found[here] = table
            for i, one in enumerate(value):
                found.update(_tables_in(one, f"{here}/{one.get('name', i)}"))
    return found


def _is_column(value: Any) -> bool:
    return (
        isinstance(value, list)
        and len(value) > 0
        and all(one is None or isinstance(one, (int, float)) for one in value)
    )
