"""Maps of results over keys of a case, computed beforehand, with the error beside each value.

    half_space = tricontact.atlas.load("sphere_half_space")
    half_space.evaluate("settled_shift_ratio", amplitude_ratio=0.24, limit_fraction=[0.3, 0.6],
                        angle=0, poisson=0.5)

Coordinates are in SI units, angles in radians.
"""

import os
from typing import Any, Literal, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, _toml, shown
from ._core import Axis
from .commands import build_atlas as build
from .commands import predict
from .labels import magnitude

__all__ = ["Atlas", "Axis", "Values", "build", "load", "names", "predict"]


class Values(NamedTuple):
    """Numbers read from an atlas: floats if all coordinates are numbers, else arrays."""

    values: Any
    """The quantity, in the shape to which the coordinates broadcast."""
    errors: Any
    """Half widths of the bars of 95 %, in the same unit and shape."""


class Atlas:
    """One quantity or more over some keys of a case: see load."""

    def __init__(self, maps: _core.AtlasMaps) -> None:
        self._maps = maps

    @property
    def name(self) -> str:
        """Name of its study."""
        return self._maps.name

    @property
    def title(self) -> str:
        """What it is about."""
        return self._maps.title

    @property
    def model(self) -> str:
        """The model whose runs it holds: "bem"."""
        return self._maps.model

    @property
    def version(self) -> str:
        """That of the program that computed it."""
        return self._maps.version

    @property
    def study(self) -> str:
        """Text of the study that computed it."""
        return self._maps.study

    @property
    def points(self) -> int:
        """Number of points of that study."""
        return self._maps.points

    @property
    def axes(self) -> list[Axis]:
        """The coordinates: each with key, name, unit and range."""
        return self._maps.axes

    @property
    def quantities(self) -> list[str]:
        """Keys of its quantities, as in summary.json.

        Those with a unit are quotients by the closed form of the half-space.
        """
        return self._maps.quantities

    def __repr__(self) -> str:
        return f"<Atlas {self.name}: {', '.join(self.quantities)}>"

    def _repr_html_(self) -> str:
        lines = [[axis.key, *axis.range, axis.unit] for axis in self.axes]
        title = f"{self.title}: {', '.join(self.quantities)}"
        return shown.rows(["", "from", "to", "unit"], lines, title)

    def __call__(
        self, quantity: str, *, outside: Literal["raise", "nan"] = "raise", **coordinates: ArrayLike
    ) -> Values:
        """As evaluate."""
        return self.evaluate(quantity, outside=outside, **coordinates)

    def evaluate(
        self, quantity: str, *, outside: Literal["raise", "nan"] = "raise", **coordinates: ArrayLike
    ) -> Values:
        """Read a quantity at one point or many.

        coordinates: one per axis, by its name (amplitude_ratio=0.24) or its whole key with _ for
        the dot (rolling_amplitude_ratio=0.24), numbers or arrays, which broadcast; SI units, or
        quantities of pint.
        outside: what becomes of points outside the domain, those with NaN included, and of those
        where the bar is too long for the atlas to say a value: "raise", or "nan". Other threads of Python go on meanwhile.

        Raises ValueError outside the domain, naming key, value and range, and for another quantity;
        TypeError for a coordinate that is missing, or none.
        """
        if outside not in ("raise", "nan"):
            raise ValueError(f'outside = {outside!r}: must be "raise" or "nan"')
        columns = np.broadcast_arrays(*self._in_order(coordinates))
        points = np.stack([column.ravel() for column in columns], axis=-1)
        found = self._maps.read(quantity, points, outside == "raise")
        values, errors = (numbers.reshape(columns[0].shape) for numbers in found)
        if values.ndim == 0:
            return Values(float(values), float(errors))
        return Values(values, errors)

    def _in_order(self, coordinates: dict[str, ArrayLike]) -> list[NDArray[np.float64]]:
        """One array per axis."""
        left = dict(coordinates)
        arrays = []
        for axis in self.axes:
            given = [name for name in (axis.name, axis.key.replace(".", "_")) if name in left]
            if len(given) != 1:
                raise TypeError(f"atlas {self.name}: coordinate {axis.name} is "
                                + ("given twice" if given else "missing"))
            number = magnitude(left.pop(given[0]), axis.unit)
            arrays.append(np.asarray(number, dtype=np.float64))
        if left:
            names = ", ".join(axis.name for axis in self.axes)
            raise TypeError(f"atlas {self.name} has no coordinate {next(iter(left))}: {names}")
        return arrays


def names() -> list[str]:
    """Names of the atlases that are part of the program, in alphabetical order."""
    return _core._atlas_names()


def load(name: Union[str, "os.PathLike[str]"]) -> Atlas:
    """An atlas of the program by its name, or the file of another one, which tricontact atlas wrote.

    Raises InputError if there is neither, or if the file has been changed or is none of this
    program.
    """
    if isinstance(name, str) and name in names():
        return Atlas(_core._shipped_atlas(name))
    return Atlas(_core._read_atlas(_toml.argument(os.fspath(name))))
