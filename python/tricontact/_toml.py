"""Dictionaries as the TOML that the readers of cases take."""

import json
from typing import Any, NoReturn

from ._core import InputError
from .labels import is_quantity


def _refuse(what: str) -> NoReturn:
    raise TypeError(f"{what}; TOML has texts, numbers, true and false, and lists of them")


def argument(text: str) -> bytes:
    """As a shell would give it; bytes of file names that are no text stay what they were."""
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        _refuse_half(text)


def _refuse_half(text: str) -> NoReturn:
    raise InputError(f"{text!r}: holds half a character (a surrogate without the other); remove it")


def _text(text: str) -> str:
    if any("\ud800" <= c <= "\udfff" for c in text):
        _refuse_half(text)
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(key: Any) -> str:
    if not isinstance(key, str):
        _refuse(f"keys are texts, not {key!r}")
    bare = key.isascii() and key.replace("_", "a").replace("-", "a").isalnum()
    return key if bare else _text(key)


def value(item: Any) -> str:
    """What stands behind a key."""
    if isinstance(item, bool):
        return "true" if item else "false"
    if isinstance(item, str):
        return _text(item)
    if isinstance(item, int):
        return str(item)
    if isinstance(item, float):
        return float.__repr__(item)
    if isinstance(item, (list, tuple)):
        return "[" + ", ".join(map(value, item)) + "]"
    if is_quantity(item):  # of pint
        unit = f"{item.units:~C}".replace("**", "^")
        number = getattr(item.magnitude, "tolist", lambda: item.magnitude)()
        if isinstance(number, list):
            return value([one * item.units for one in number])
        return _text(f"{number!r} {unit}") if unit else value(number)
    if hasattr(item, "tolist"):  # NumPy's numbers and arrays
        return value(item.tolist())
    _refuse(f"{item!r} is no value for a key")


def document(values: dict[str, Any], path: str = "") -> str:
    """A file, its dictionaries as tables. Keys first: those behind a table's heading are its own."""
    tables = {key: item for key, item in values.items() if isinstance(item, dict)}
    lines = [f"{_key(key)} = {value(item)}\n" for key, item in values.items() if key not in tables]
    for key, table in tables.items():
        below = f"{path}.{_key(key)}" if path else _key(key)
        lines += [f"[{below}]\n", document(table, below)]
    return "".join(lines)


def overrides(values: dict[str, Any]) -> list[str]:
    """As the program's --set has them."""
    return [f"{key}={value(item)}" for key, item in values.items()]
