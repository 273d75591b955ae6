"""Plots of results with matplotlib, where it is installed."""

import importlib
from typing import TYPE_CHECKING, Any, Optional, Sequence, Union

import numpy as np

from .labels import label_of

if TYPE_CHECKING:
    from ._core import History, Result, Surface
    from .table import Table

# Colours of Okabe and Ito (2008), which all eyes tell apart; black is for references.
_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))


def axes(ax: Any = None) -> Any:
    """These axes, or those of a new figure."""
    if ax is not None:
        return ax
    pyplot = importlib.import_module("matplotlib.pyplot")
    figure, made = pyplot.subplots(figsize=(6, 4), layout="constrained")
    made.set_prop_cycle(color=_COLOURS)
    return made


def scale_of(values: Any, unit: str) -> tuple[float, str]:
    """Factor and unit in which numbers have few digits: 1e6 and "µm" of micrometres in m."""
    finite = np.abs(np.asarray(values, dtype=float))
    finite = finite[np.isfinite(finite)]
    if unit not in ("m", "Pa", "N", "J") or finite.size == 0 or finite.max() == 0:
        return 1.0, unit
    for factor, prefix in _PREFIXES:
        if finite.max() >= 0.999 * factor:
            return 1 / factor, prefix + unit
    return 1.0, unit


def _axis_text(text: str, unit: str) -> str:
    return f"{text} [{unit}]" if unit not in ("", "1") else text


def table(
    shown: "Table", x: Optional[str], y: Union[None, str, Sequence[str]], ax: Any = None
) -> Any:
    numbers = [name for name in shown if shown[name].dtype.kind in "fiu"]
    for name in [x, *([y] if isinstance(y, str) else y or [])]:
        if name is not None and name not in shown:
            raise KeyError(f"no column {name}; there are {', '.join(shown)}")
    across = x or (numbers[0] if numbers else None)
    others = [name for name in numbers if name != across]
    ups = [y] if isinstance(y, str) else list(y or others[:1])
    if across is None or not ups:
        raise ValueError("there are no two columns of numbers to plot")
    ax = axes(ax)
    label = shown.label(across)
    is_text = shown[across].dtype.kind not in "fiu"
    factor, unit = (1.0, "") if is_text else scale_of(shown[across], label.unit)
    at = shown[across] if is_text else factor * shown[across]
    order = np.arange(len(at)) if is_text else np.argsort(at, kind="stable")
    up_unit = shown.label(ups[0]).unit
    up_factor, up_shown = scale_of(np.concatenate([shown[up] for up in ups]), up_unit)
    for up in ups:
        ax.plot(at[order], up_factor * shown[up][order], "." if shown.n_rows < 3 else ".-",
                label=shown.label(up).text)
    ax.set_xlabel(_axis_text(label.text, label.over or unit))
    first = shown.label(ups[0])
    ax.set_ylabel(_axis_text(first.text if len(ups) == 1 else "", first.over or up_shown))
    if len(ups) > 1:
        ax.legend(frameon=False)
    return ax


def histories(shown: Sequence["History"], column: str = "shift_x_m", ax: Any = None) -> Any:
    """A column of models over the rolling periods."""
    ax = axes(ax)
    label = label_of(column)
    largest = [np.nanmax(np.abs(np.asarray(one[column], dtype=float))) for one in shown]
    factor, unit = scale_of(largest, label.unit)
    for one in shown:
        ax.plot(one["phase"], factor * np.asarray(one[column], dtype=float), label=one.model)
    ax.set_xlabel("rolling periods")
    ax.set_ylabel(_axis_text(label.text, unit))
    ax.legend(frameon=False)
    return ax


def history(shown: "History", column: str = "shift_x_m", ax: Any = None) -> Any:
    return histories([shown], column, ax)


def result(shown: "Result", column: str = "shift_x_m", ax: Any = None) -> Any:
    return histories([shown[model] for model in shown.models], column, ax)


def surface(shown: "Surface", field: str = "normal_traction_Pa", ax: Any = None) -> Any:
    """A field as a map, of springs along their line."""
    ax = axes(ax)
    values = np.asarray(shown[field], dtype=float)
    label = label_of(field)
    factor, unit = scale_of(values, label.unit)
    length, length_unit = scale_of(shown.x, "m")
    ax.set_xlabel(f"x [{length_unit}]")
    if shown.layout == "line":
        ax.plot(length * np.ravel(shown.x), factor * values.ravel())
        ax.set_ylabel(_axis_text(label.text, unit))
        return ax
    # Both signs: white is zero.
    signed = values.min() < 0
    most = factor * np.abs(values).max()
    colours = {"cmap": "RdBu_r", "vmin": -most, "vmax": most} if signed else {"cmap": "viridis"}
    if values.ndim == 2:
        image = ax.pcolormesh(length * shown.x, length * shown.y, factor * values,
                              shading="nearest", rasterized=True, **colours)
    else:
        image = ax.scatter(length * shown.x, length * shown.y, c=factor * values, s=4, **colours)
    ax.set_ylabel(f"y [{length_unit}]")
    ax.set_aspect("equal")
    ax.figure.colorbar(image, ax=ax, label=_axis_text(label.text, unit), shrink=0.8)
    return ax


def grouped(shown: "Table", group: str, x: str, y: str, ax: Any = None) -> Any:
    """Column y over column x, a line for each text in the column `group`."""
    ax = axes(ax)
    for name in dict.fromkeys(shown[group]):
        rows = shown[group] == name
        order = np.argsort(shown[x][rows], kind="stable")
        ax.plot(shown[x][rows][order], shown[y][rows][order], ".-", label=name)
    ax.set_xlabel(str(shown.label(x)))
    ax.set_ylabel(str(shown.label(y)))
    if ax.lines:
        ax.legend(frameon=False)
    return ax
