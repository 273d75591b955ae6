"""Results as xarray's Datasets, where it is installed: coordinates, units in the attributes."""

import importlib
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Union, overload

import numpy as np

from . import plots
from .labels import label_of
from .shown import quantity_names

if TYPE_CHECKING:
    from ._core import History, Result, Snapshot, Surface


def _xarray() -> Any:
    return importlib.import_module("xarray")


def history(shown: "History") -> Any:
    """The columns of history.csv along `step`, with `phase` as a coordinate."""
    columns = {
        name: ("step", shown[name], label_of(name).attributes) for name in shown.columns
    }
    phase = {"phase": columns.pop("phase")} if "phase" in columns else {}
    attributes = {"model": shown.model, "state": shown.state or ""}
    return _xarray().Dataset(columns, coords=phase, attrs=attributes)


def _axes(shown: "Surface") -> tuple[tuple[str, ...], dict[str, Any]]:
    """Dimensions of the fields and their coordinates."""
    metre = {"units": "m"}
    if len(shown.shape) == 2:
        return ("y", "x"), {"x": ("x", shown.x, metre), "y": ("y", shown.y, metre)}
    return ("point",), {"x": ("point", shown.x, metre), "y": ("point", shown.y, metre)}


def surface(shown: "Surface") -> Any:
    """All fields over y and x of a grid, over `point` of other nodes."""
    dims, coords = _axes(shown)
    fields = {name: (dims, shown[name], label_of(name).attributes) for name in shown.fields}
    return _xarray().Dataset(
        fields, coords=coords, attrs={"indenter_position_m": list(shown.offset)}
    )


def result(shown: "Result") -> Any:
    """The quantities of all models along `model`; lists, one value per period, are left out."""
    found = [shown.results(model) for model in shown.models]
    variables = {}
    for name in quantity_names():
        values = [getattr(one, name) for one in found]
        if any(isinstance(value, list) for value in values):
            continue
        is_text = any(isinstance(value, str) for value in values)
        missing: Any = "" if is_text else np.nan
        column = [missing if value is None else value for value in values]
        variables[name] = ("model", column, label_of(name).attributes)
    return _xarray().Dataset(
        variables, coords={"model": shown.models}, attrs={"title": shown.case.title}
    )


class Surfaces(Sequence["Snapshot"]):
    """The contact surface of a model at instants of the load path."""

    def __init__(self, snapshots: Sequence["Snapshot"]) -> None:
        self._snapshots = list(snapshots)

    @overload
    def __getitem__(self, place: int) -> "Snapshot": ...
    @overload
    def __getitem__(self, place: slice) -> "Surfaces": ...
    def __getitem__(self, place: Union[int, slice]) -> "Union[Snapshot, Surfaces]":
        if isinstance(place, slice):
            return Surfaces(self._snapshots[place])
        return self._snapshots[place]

    def __len__(self) -> int:
        return len(self._snapshots)

    @property
    def phases(self) -> list[float]:
        """Rolling periods since the start."""
        return [one.phase for one in self._snapshots]

    def to_xarray(self) -> Any:
        """All fields along `instant`, with `phase` as a coordinate. Raises ImportError.

        Fields that are not known at all instants (those of a period) are NaN at the others.
        """
        surfaces = [one.surface for one in self._snapshots]
        dims, coords = _axes(surfaces[0])
        names = dict.fromkeys(name for one in surfaces for name in one.fields)
        coords["phase"] = ("instant", self.phases, {"long_name": "rolling periods", "units": "1"})
        for i, axis in enumerate("xy"):
            positions = [one.offset[i] for one in surfaces]
            coords[f"indenter_{axis}"] = ("instant", positions, {"units": "m"})
        fields = {}
        for name in names:
            unknown = np.full(surfaces[0].shape, np.nan)
            each = [one[name] if name in one.fields else unknown for one in surfaces]
            fields[name] = (("instant", *dims), np.stack(each), label_of(name).attributes)
        return _xarray().Dataset(fields, coords=coords)

    def plot(self, field: str = "normal_traction_Pa", instant: int = -1, ax: Any = None) -> Any:
        """A field at an instant, by default the last one, with matplotlib. Raises ImportError."""
        return plots.surface(self[instant].surface, field, ax)
