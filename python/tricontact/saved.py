"""Results that are kept: what a folder of the program holds, or what a pickle brought along.

They have the attributes of those that a run returns; what a folder does not tell is None.
"""

import os
from pathlib import Path
from typing import Any, Callable, NamedTuple, Optional

import numpy as np

from . import _core, _toml, labelled, plots, shown
from .equality import same
from .table import Table, entry, read_table

_SCALES = ("normal_force", "contact_radius", "indentation", "peak_pressure", "unit_shift")


class SavedScales(NamedTuple):
    """The pressed state of a model: F_N [N], a [m], d [m], p0 [Pa], U_max [m]."""

    normal_force: Optional[float]
    contact_radius: Optional[float]
    indentation: Optional[float]
    peak_pressure: Optional[float]
    unit_shift: Optional[float]


class _Labelled:
    """What is labelled, drawn and shown as the computed one of its kind, a name in these modules."""

    _kind = ""

    def to_xarray(self) -> Any:
        """All of it as a Dataset with named dimensions. Raises ImportError."""
        return getattr(labelled, self._kind)(self)


class _Shown(_Labelled):
    def plot(self, column: str = "shift_x_m", ax: Any = None) -> Any:
        """A column over the rolling periods with matplotlib. Raises ImportError."""
        return getattr(plots, self._kind)(self, column, ax)

    def _repr_html_(self) -> str:
        return str(getattr(shown, self._kind)(self))


class SavedSurface(_Labelled):
    """Fields of a contact surface by their names; see Surface for shapes, units and signs."""

    _kind = "surface"

    def __init__(self, fields: dict[str, Any], layout: str, shape: tuple[int, ...], x: Any, y: Any,
                 offset: tuple[float, float]) -> None:
        self._fields = fields
        self.layout = layout
        self.shape = shape
        self.x = x
        self.y = y
        self.offset = offset

    @property
    def fields(self) -> list[str]:
        """Names of the fields."""
        return list(self._fields)

    def __getitem__(self, name: str) -> Any:
        """A field. Raises KeyError."""
        return entry(self._fields, "field", name)

    def plot(self, field: str = "normal_traction_Pa", ax: Any = None) -> Any:
        """A field as a map with matplotlib. Raises ImportError."""
        return plots.surface(self, field, ax)  # type: ignore[arg-type]


class SavedSnapshot:
    """The contact surface at a phase; one of a folder is read when it is asked for."""

    def __init__(self, phase: float, surface: Any = None, path: Optional[bytes] = None,
                 state: int = 0) -> None:
        self.phase = phase
        self._surface = surface
        self._path = path
        self._state = state

    @property
    def surface(self) -> Any:
        """Its fields. Raises InputError for a damaged file."""
        if self._surface is None:
            self._surface = _core._read_surface(self._path or b"", self._state)
        return self._surface

    def __reduce__(self) -> Any:
        return SavedSnapshot, (self.phase, self.surface)


class SavedHistory(_Shown):
    """What one model came to, step by step; see History for units and shapes."""

    _kind = "history"

    def __init__(self, columns: dict[str, Any], values: dict[str, Any], snapshots: list[Any]) -> None:
        self._columns = columns
        self._values = values
        self.snapshots = snapshots
        """Surfaces at phases of the load path."""

    def __getattr__(self, name: str) -> Any:
        values = self.__dict__.get("_values", {})
        if name in values:
            return values[name]
        raise AttributeError(f"a history has no {name}")

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._columns)

    def __getitem__(self, name: str) -> Any:
        """A column, one value per step. Raises KeyError."""
        return entry(self._columns, "column", name)

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def to_pandas(self) -> Any:
        """All columns as a DataFrame. Raises ImportError."""
        return Table(self._columns).to_pandas()


class SavedQuantities:
    """The quantities of a model in SI units, None where undefined; see Results."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__.update(values)


class SavedResult(_Shown):
    """What the models of a case came to: histories by name, as of Result."""

    _kind = "result"

    def __init__(self, case: Any, summary: dict[str, Any], histories: dict[str, Any],
                 surfaces: dict[str, list[Any]]) -> None:
        self.case = case
        """The resolved case."""
        self.summary = summary
        """The numbers of summary.json."""
        self._histories = histories
        self._surfaces = surfaces

    @property
    def models(self) -> list[str]:
        """Names of the models."""
        return list(self._histories)

    def __getitem__(self, model: str) -> Any:
        """The history of a model. Raises KeyError."""
        return entry(self._histories, "model", model)

    def surfaces(self, model: str) -> labelled.Surfaces:
        """The contact surfaces of a model. Raises KeyError."""
        return labelled.Surfaces(entry(self._surfaces, "model", model))

    def results(self, model: str) -> SavedQuantities:
        """The quantities of a model. Raises KeyError."""
        return SavedQuantities(quantities_of(entry(self.summary["models"], "model", model)))


def quantities_of(numbers: dict[str, Any]) -> dict[str, Any]:
    """Those of a model's part of summary.json, also the ones within its parts."""
    flat = dict(numbers)
    for part in numbers.values():
        if isinstance(part, dict):
            flat.update({key: value for key, value in part.items() if key not in flat})
    return {name: flat.get(name) for name in shown.quantity_names()}


def saved_run(folder: Path, summary: dict[str, Any]) -> SavedResult:
    """The results of a run in its folder. Raises InputError for damaged ones."""
    files = _core._saved_surfaces(_toml.argument(os.fspath(folder)))
    histories, surfaces = {}, {}
    for model, numbers in summary["models"].items():
        path = folder / model / "history.csv"
        table = read_table(path) if path.is_file() else Table({})
        columns = {name: table[name] for name in table if name != "step"}
        surfaces[model] = [SavedSnapshot(time, None, file, state) for time, file, state in files.get(model, [])]
        histories[model] = SavedHistory(columns, _values_of(model, numbers), surfaces[model])
    return SavedResult(_core.Case.from_dict(summary["case"]), summary, histories, surfaces)


def _values_of(model: str, numbers: dict[str, Any]) -> dict[str, Any]:
    units = ("N", "m", "m", "Pa", "m")
    scales = [numbers.get(f"{name}_{unit}") for name, unit in zip(_SCALES, units)]
    found = quantities_of(numbers)
    shift = np.array(found["shift_ratio_per_period"] or [], dtype=float)
    return {
        "model": model, "state": found["state"], "scales": SavedScales(*scales),
        "amplitude": found["amplitude_m"], "tangential_force": None, "friction_limit": None,
        "static_shift": found["static_shift_m"],
        "limit_tangential_ratio": found["limit_tangential_ratio"],
        "shift_per_period": shift * (scales[-1] or np.nan),
        "dissipation_per_period": None, "audit": numbers.get("audit", {}),
        "cpu_s": found["cpu_s"], "wall_s": found["wall_s"],
    }


# Kept copies of what a run returned, for pickle.

_VALUES = ("model", "state", "amplitude", "tangential_force", "friction_limit", "static_shift",
           "limit_tangential_ratio", "shift_per_period", "dissipation_per_period", "audit", "cpu_s",
           "wall_s")


def kept_surface(one: Any) -> SavedSurface:
    fields = {name: np.array(one[name]) for name in one.fields}
    return SavedSurface(fields, one.layout, one.shape, np.array(one.x), np.array(one.y), one.offset)


def kept_snapshot(one: Any) -> SavedSnapshot:
    return SavedSnapshot(one.phase, kept_surface(one.surface))


def kept_history(one: Any) -> SavedHistory:
    values = {name: getattr(one, name) for name in _VALUES}
    for name in ("shift_per_period", "dissipation_per_period"):
        if values[name] is not None:
            values[name] = np.array(values[name])
    values["scales"] = SavedScales(*(getattr(one.scales, name) for name in _SCALES))
    columns = {name: np.array(one[name]) for name in one.columns}
    return SavedHistory(columns, values, [kept_snapshot(each) for each in one.snapshots])


def kept_result(one: Any) -> SavedResult:
    histories = {model: kept_history(one[model]) for model in one.models}
    surfaces = {model: [kept_snapshot(each) for each in one.surfaces(model)] for model in one.models}
    return SavedResult(one.case, one.summary, histories, surfaces)


# Iteration, texts and equality, of both kinds.

def _content(one: Any) -> Any:
    if isinstance(one, (_core.Surface, SavedSurface)):
        fields = {name: one[name] for name in one.fields}
        return [fields, one.layout, one.shape, one.x, one.y, one.offset]
    if isinstance(one, (_core.Snapshot, SavedSnapshot)):
        return [one.phase, _content(one.surface)]
    if isinstance(one, (_core.History, SavedHistory)):
        columns = {name: one[name] for name in one.columns}
        return [one.model, columns, [_content(each) for each in one.snapshots]]
    surfaces = [[_content(each) for each in one.surfaces(model)] for model in one.models]
    return [one.case.to_toml(), one.summary, [_content(one[model]) for model in one.models], surfaces]


def _equal(kinds: tuple[type, ...]) -> Callable[[Any, Any], Any]:
    def equal(self: Any, other: Any) -> Any:
        if not isinstance(other, kinds):
            return NotImplemented
        return self is other or same(_content(self), _content(other))
    return equal


def _texts(one: Any) -> str:
    if isinstance(one, (_core.Surface, SavedSurface)):
        return f"<Surface, {one.layout} of {' x '.join(map(str, one.shape))}: {len(one.fields)} fields>"
    if isinstance(one, (_core.Snapshot, SavedSnapshot)):
        return f"<Snapshot at phase {one.phase:g}>"
    if isinstance(one, (_core.History, SavedHistory)):
        return f"<History of {one.model}: {len(one)} steps, {one.state or 'no rolling'}>"
    states = ", ".join(f"{model} {one[model].state or 'pressed'}" for model in one.models)
    return f"<Result of {one.case.title!r}: {states}>"


def _names(one: Any) -> list[str]:
    for attribute in ("models", "columns", "fields"):
        if hasattr(one, attribute):
            return list(getattr(one, attribute))
    return []


_PAIRS: tuple[tuple[type, type, Callable[[Any], Any], bool], ...] = (
    (_core.Surface, SavedSurface, kept_surface, True),
    (_core.Snapshot, SavedSnapshot, kept_snapshot, False),
    (_core.History, SavedHistory, kept_history, True),
    (_core.Result, SavedResult, kept_result, True),
)


def _same_object(one: Any) -> Any:
    return one


def _reduced(keep: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return lambda self: (_same_object, (keep(self),))


def _case_again(kind: Any, values: dict[str, Any], origin: Any) -> Any:
    made = kind.from_dict(values)
    made._origin = origin
    return made


def _attach() -> None:
    for computed, saved, keep, has_names in _PAIRS:
        for kind in (computed, saved):
            setattr(kind, "__eq__", _equal((computed, saved)))
            setattr(kind, "__hash__", None)
            setattr(kind, "__repr__", _texts)
            if has_names:
                setattr(kind, "__iter__", lambda self: iter(_names(self)))
                setattr(kind, "__contains__", lambda self, name: name in _names(self))
        setattr(computed, "__reduce__", _reduced(keep))
    for result in (_core.Result, SavedResult):
        setattr(result, "__len__", lambda self: len(self.models))
    for case in (_core.Case, _core.WalkCase):
        setattr(case, "__eq__", lambda self, other: NotImplemented if type(other) is not type(self)
                else self.to_toml() == other.to_toml())
        setattr(case, "__hash__", lambda self: hash(self.to_toml()))
        setattr(case, "__reduce__", lambda self: (_case_again, (type(self), self.to_dict(), getattr(self, "_origin", None))))


_attach()
