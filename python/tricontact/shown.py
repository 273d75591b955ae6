"""Results as notebooks show them: HTML tables of numbers with their units."""

import base64
import html
import importlib
import io
from typing import TYPE_CHECKING, Any, Callable, Iterable, Sequence

import numpy as np

from . import _core, plots
from .labels import label_of

if TYPE_CHECKING:
    from ._core import Case, History, Result, WalkCase
    from .table import Table

_MOST_ROWS = 20


def text_of(value: Any) -> str:
    """A number with six digits, anything else as it is."""
    if value is None:
        return ""
    if isinstance(value, (bool, np.bool_)):
        return "yes" if value else "no"
    if isinstance(value, (float, np.floating)):
        return "" if np.isnan(value) else f"{value:.6g}"
    return str(value)


def rows(headings: Sequence[str], content: Iterable[Sequence[Any]], caption: str = "") -> str:
    """An HTML table."""
    def line(tag: str, cells: Sequence[str]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    head = f"<caption>{html.escape(caption)}</caption>" if caption else ""
    body = "".join(line("td", [text_of(cell) for cell in row]) for row in content)
    return f"<table>{head}<thead>{line('th', headings)}</thead><tbody>{body}</tbody></table>"


def table(shown: "Table", caption: str = "") -> str:
    def heading(name: str) -> str:
        label = shown.label(name)
        unit = label.over or (label.unit if label.unit != "1" else "")
        return f"{name} [{unit}]" if unit else name

    n = shown.n_rows
    first = [[shown[name][i] for name in shown] for i in range(min(n, _MOST_ROWS))]
    left = f"<p>{n - _MOST_ROWS} rows more</p>" if n > _MOST_ROWS else ""
    return rows([heading(name) for name in shown], first, caption) + left


def numbers(values: Iterable[tuple[str, Any, str]], caption: str = "") -> str:
    """Names, values and units below each other."""
    shown = [(name, value, "" if unit == "1" else unit) for name, value, unit in values]
    return rows(["", "value", "unit"], shown, caption)


def models(found: dict[str, dict[str, Any]], caption: str = "") -> str:
    """A row per quantity with its error, a column per model."""
    def cell(one: dict[str, Any], name: str) -> str:
        value, error = one.get(name), one.get(name + "_error")
        if isinstance(value, list):
            return ", ".join(map(text_of, value))
        return text_of(value) + (f" ± {error:.2g}" if error else "")

    names = dict.fromkeys(name for one in found.values() for name in one)
    lines = []
    for name in names:
        values = [cell(one, name) for one in found.values()]
        if name.endswith("_error") or not any(values):
            continue
        label = label_of(name)
        lines.append([label.text, *values, label.over or ("" if label.unit == "1" else label.unit)])
    return rows(["", *found, "unit"], lines, caption)


def quantity_names() -> list[str]:
    """Of all quantities of a model, in the order of their declaration."""
    return [name for name in _core.Results.__dict__ if not name.startswith("_")]


def result(shown: "Result") -> str:
    """A row per quantity, a column per model."""
    found = {model: shown.results(model) for model in shown.models}
    lines = []
    for name in quantity_names():
        values = [getattr(one, name) for one in found.values()]
        if all(value is None or isinstance(value, list) for value in values):
            continue
        label = label_of(name)
        unit = label.over or ("" if label.unit == "1" else label.unit)
        lines.append([label.text, *values, unit])
    states = ", ".join(f"{model}: {shown[model].state or 'pressed'}" for model in shown.models)
    headline = f"<p><b>{html.escape(states)}</b></p>"
    figure = picture(lambda ax: plots.result(shown, ax=ax))
    return headline + figure + rows(["", *found, "unit"], lines, shown.case.title)


def picture(draw: Callable[[Any], object]) -> str:
    """What draws onto axes, as a picture; empty where there is no matplotlib."""
    try:
        figures = importlib.import_module("matplotlib.figure")
    except ImportError:
        return ""
    figure = figures.Figure(figsize=(6, 4), layout="constrained")
    draw(figure.subplots())
    made = io.BytesIO()
    figure.savefig(made, format="png", metadata={"Software": None})
    return f'<img src="data:image/png;base64,{base64.b64encode(made.getvalue()).decode()}"><br>'


def history(shown: "History") -> str:
    values = [
        ("state", shown.state, ""),
        ("steps", len(shown), ""),
        ("contact radius a", shown.scales.contact_radius, "m"),
        ("indentation d", shown.scales.indentation, "m"),
        ("normal force F_N", shown.scales.normal_force, "N"),
        ("tangential force F_T", shown.tangential_force, "N"),
        ("static shift", shown.static_shift, "m"),
        ("shift at the end", float(shown["shift_x_m"][-1]), "m"),
    ]
    return numbers(values, shown.model)


def case(shown: "Case | WalkCase") -> str:
    title = html.escape(shown.title)
    return f"<details><summary>{title}</summary><pre>{html.escape(shown.to_toml())}</pre></details>"


def preformatted(text: str) -> str:
    """What a terminal would show."""
    return f"<pre>{html.escape(text)}</pre>"
