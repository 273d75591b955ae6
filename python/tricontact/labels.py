"""What numbers are in: units and meanings, from the names that they have in files and tables."""

import re
from typing import Any, NamedTuple

from . import _core

_SUFFIX = re.compile(r"_(um|mm|m|Pa|N|Nm|J|s|Hz|rad|K|W|kg)(\d?)((?:_per_(?:m|s|K|N|J|rad)\d?)*)$")
_INVERSE = re.compile(r"_per_((?:m|s|K|N|J|rad)\d?)$")


class Label(NamedTuple):
    """Of a column, a field or a quantity."""

    unit: str
    """SI: "m", "J/m2"; "1" of what has none, "" of texts and unknown names."""
    text: str
    """What it means."""
    over: str = ""
    """What a ratio is a multiple of: "U_max"."""

    def __str__(self) -> str:
        """For an axis."""
        unit = self.over or (self.unit if self.unit != "1" else "")
        return f"{self.text} [{unit}]" if unit else self.text

    @property
    def attributes(self) -> dict[str, str]:
        """As xarray and others who follow the CF conventions look for them."""
        named = {"units": self.unit, "long_name": self.text, "multiple_of": self.over}
        return {key: text for key, text in named.items() if text}


def label_of(name: str) -> Label:
    """Of results and keys what their declarations say; else by the unit that ends the name."""
    last = name.rsplit("/", 1)[-1]
    declared = _core._label(last)
    if declared:
        return Label(*declared)
    match = _SUFFIX.search(last)
    if match and not last[: match.start()].endswith("_per"):
        text = last[: match.start()].replace("_", " ")
        return Label(_unit(*match.groups()), text)
    inverse = _INVERSE.search(last)
    if inverse:
        return Label("1/" + inverse.group(1), last[: inverse.start()].replace("_", " "))
    return Label("1" if last.endswith("_ratio") else "", last.replace("_", " "))


def _unit(base: str, power: str, below: str) -> str:
    return "/".join([base + power, *(one for one in below.split("_per_") if one)])


def is_quantity(item: Any) -> bool:
    """Whether it is a number with a unit, of pint or like its."""
    return hasattr(item, "magnitude") and hasattr(item, "units")


def magnitude(item: Any, unit: str) -> Any:
    """The number or the array itself; of a quantity with a unit what it is in that unit.

    Raises what pint raises where the dimension is another one.
    """
    if not is_quantity(item):
        return item
    return item.to("" if unit == "1" else unit).magnitude
