#!/usr/bin/env python3
"""Writes python/tricontact/_core.pyi, the types of the compiled module, from that module; whoever changes python/*.cc, or
declares a result, runs it.

usage: python_stubs.py [--check] [MODULE]   (build/release/python/_core*.so; for Debian's interpreter, /usr/bin/python3)

Names, parameters, defaults and most types are what pybind11 says in its docstrings, and Python's annotations where a method
is written in Python. --check writes nothing, and fails (exit code 1) where the file differs.
"""

import argparse
import importlib
import importlib.util
import inspect
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STUB = ROOT / "python/tricontact/_core.pyi"
WIDTH = 120

HEAD = '''\
# Written by scripts/python_stubs.py.
import os
from typing import Any, Callable, Iterator, Optional, Sequence, TypedDict, Union, overload

import numpy as np
from numpy.typing import NDArray

from .labelled import Surfaces

_Path = Union[str, "os.PathLike[str]"]
_Numbers = NDArray[np.float64]
_Array = Union[NDArray[Any], Sequence[float]]
_Any = Union[float, _Array]
_Quantity = Union[None, float, str, list[Optional[float]]]

class _Check(TypedDict):
    worst: float
    allowed: float
    passed: bool

class _ReferenceValue(TypedDict):
    value: float
    bar: float
    grid: float
    model: float
    domain: float
    source: str
'''

# What the module cannot tell. pybind11 calls "object", "dict", "list" or "tuple" whatever C++ hands over as such, and
# arrays "numpy.ndarray" without the type of their numbers.
RESULTS = {
    "Case.from_file": "Case",
    "Case.from_dict": "Case",
    "Case.to_dict": "dict[str, Any]",
    "WalkCase.from_file": "WalkCase",
    "WalkCase.from_dict": "WalkCase",
    "WalkCase.to_dict": "dict[str, Any]",
    "Surface.shape": "tuple[int, ...]",
    "Surface.x": "_Numbers",
    "Surface.y": "_Numbers",
    "Surface.offset": "tuple[float, float]",
    "History.to_pandas": "Any",  # pandas need not be there
    "History.state": "Optional[str]",
    "History.shift_per_period": "_Numbers",
    "History.dissipation_per_period": "_Numbers",
    "History.snapshots": "list[Snapshot]",
    "History.audit": "dict[str, _Check]",
    "Results.*": "_Quantity",
    "Result.__getitem__": "History",
    "Result.surfaces": "Surfaces",
    "Result.summary": "dict[str, Any]",
    "AtlasMaps.read": "tuple[_Numbers, _Numbers]",
    "BenchmarkReference.values": "dict[str, _ReferenceValue]",
    "BenchmarkReference.effects": "dict[str, _ReferenceValue]",
    # Several components along a last axis: arrays also at one point.
    "BenchmarkReference.traction": "_Numbers",
    "BenchmarkReference.traction_bar": "_Numbers",
    "BenchmarkReference.displacement": "_Numbers",
    "BenchmarkReference.displacement_bar": "_Numbers",
    "_command_options": "list[tuple[str, bool, bool, str]]",
    "_label": "Optional[tuple[str, str, str]]",
    "_saved_surfaces": "dict[str, list[tuple[float, bytes, int]]]",
    "_roll": "tuple[dict[str, Any], dict[str, str], dict[str, Surface], dict[str, dict[str, _Numbers]], str]",
    "_walk": "tuple[dict[str, Any], str, str]",
}
# Parameters by their names, of a function alone where they differ. What goes to std::string as the name of a file, or as
# an argument, is bytes: str would refuse names that are no UTF-8.
PARAMETERS = {
    "Case.from_file.path": "_Path",
    "WalkCase.from_file.path": "_Path",
    "path": "bytes",
    "folder": "bytes",
    "study": "bytes",
    "arguments": "Sequence[bytes]",
    "AtlasMaps.read.points": "_Numbers",
    "say": "Callable[[str], object]",
    "progress": "Callable[[str, int, int], object]",
    "on_part": "Callable[[str, int, int], object]",
    "on_step": "Optional[Callable[[str, int, int], object]]",
}
# Methods that are functions of the package, of the object: their modules, where the name is the class's.
HANDED_ON = {"plot": "plots", "to_xarray": "labelled", "_repr_html_": "shown"}
NAMES_THERE = {"WalkCase": "case"}
# Methods that saved.py gives to classes, as Python defines them.
OPERATORS = {
    "__iter__": "def __iter__(self) -> Iterator[str]: ...",
    "__contains__": "def __contains__(self, name: object) -> bool: ...",
    "__len__": "def __len__(self) -> int: ...",
}
SHOWN = {*OPERATORS, "__getitem__", "__version__"}

VALUES = "numpy.ndarray[numpy.float64]"
UNSAID = re.compile(r"\b(object|list|tuple|numpy\.ndarray)\b(?!\[)")
SIGNATURE = re.compile(r"^\w*\((.*)\) -> (.+)$")


class Unknown(Exception):
    """What this script has no rule for, or a row of its tables that nothing asks for."""


def split(text):
    """Parameters, split at commas outside of brackets."""
    found, depth, begin = [], 0, 0
    for place, c in enumerate(text + ","):
        depth += (c in "[({") - (c in "])}")
        if c == "," and depth == 0:
            found.append(text[begin:place].strip())
            begin = place + 1
    if depth != 0:
        raise Unknown(f"brackets in a default, which stay open: {text}")
    return [one for one in found if one]


def in_python(told):
    """A type as pybind11 names it, in the words of the stubs."""
    words = re.sub(r"\b(List|Dict|Tuple|Set)\[", lambda found: found[0].lower(), told)
    words = re.sub(r"\bdict\b(?!\[)", "dict[str, Any]", words)  # all of the module have names as keys
    return words.replace("tricontact._core.", "")


class Writer:
    """The lines of the stubs."""

    def __init__(self, core):
        self.core = core
        self.package = core.__name__.rpartition(".")[0]
        self.asked = set()

    def row(self, table, *names):
        """The first row that there is, or None."""
        for name in names:
            if name in table:
                self.asked.add(name)
                return table[name]
        return None

    def result(self, place, told):
        known = self.row(RESULTS, place, place.rpartition(".")[0] + ".*")
        if known is None and told == "numpy.ndarray":
            return "NDArray[Any]"
        if known is None and UNSAID.search(told):
            raise Unknown(f"{place}: pybind11 calls its result {told}; RESULTS of {Path(__file__).name} needs its type")
        return known or in_python(told)

    def parameter(self, place, name, told):
        if name == "self":
            return None
        known = self.row(PARAMETERS, f"{place}.{name}", name)
        if known is None and UNSAID.search(told):
            raise Unknown(f"{place}: pybind11 calls its {name} {told}; PARAMETERS of {Path(__file__).name} needs its type")
        # Any sequence does where C++ has a vector.
        return known or re.sub(r"\blist\[", "Sequence[", in_python(told))

    def signature(self, place, function):
        """Parameters as (name, type as pybind11 says it, whether there is a default), and the result."""
        match = SIGNATURE.match((function.__doc__ or "").partition("\n")[0])
        if not match:
            raise Unknown(f"{place}: no signature of pybind11 in its text")
        found = []
        for one in split(match[1]):
            name, _, rest = one.partition(": ")
            told, equal, _ = rest.partition(" = ")
            found.append(("self" if name == "arg0" and "." in place else name, told, bool(equal)))
        return found, match[2]

    def function(self, place, function):
        given, told = self.signature(place, function)
        if any(name.startswith("*") for name, *_ in given):
            return self.handed_on(place)
        numbers = [name for name, kind, _ in given if kind == VALUES]
        name = place.rpartition(".")[2]
        if numbers and told == "object" and place not in RESULTS:
            return self.overloads(place, name, given, numbers)
        kinds = [(one, "_Any" if kind == VALUES and f"{place}.{one}" not in PARAMETERS else self.parameter(place, one, kind),
                  default) for one, kind, default in given]
        return definition(name, kinds, self.result(place, told))

    def overloads(self, place, name, given, numbers):
        """Of py::vectorize: a number of numbers, an array as soon as one of them is one, each first one in turn."""
        lines = []
        for first in [None, *numbers]:
            kinds, before = [], True
            for one, kind, default in given:
                if kind != VALUES:
                    kinds.append((one, self.parameter(place, one, kind), default))
                elif one == first:
                    kinds.append((one, "_Array", False))
                    before = False
                else:
                    kinds.append((one, "float" if before else "_Any", default and (first is None or not before)))
            lines += ["@overload", *definition(name, kinds, "_Numbers" if first else "float")]
        return lines

    def handed_on(self, place):
        """As the function of the package says, of which the object is the first parameter."""
        owner, _, name = place.rpartition(".")
        if name not in HANDED_ON:
            raise Unknown(f"{place}: written in Python; HANDED_ON of {Path(__file__).name} needs its module")
        module = importlib.import_module(f"{self.package}.{HANDED_ON[name]}")
        there = inspect.signature(getattr(module, NAMES_THERE.get(owner, owner.lower())))
        kinds = [(one.name, None if k == 0 else inspect.formatannotation(one.annotation).replace("typing.", ""),
                  k > 0 and one.default is not one.empty) for k, one in enumerate(there.parameters.values())]
        kinds[0] = ("self", None, False)
        return definition(name, kinds, inspect.formatannotation(there.return_annotation).replace("typing.", ""))

    def member(self, owner, name, one):
        place = f"{owner}.{name}"
        if name in OPERATORS:
            return [OPERATORS[name]]
        if isinstance(one, property) and one.fset is None:
            _, told = self.signature(place, one.fget)
            return ["@property", *definition(name, [("self", None, False)], self.result(place, told))]
        if isinstance(one, staticmethod):
            return ["@staticmethod", *self.function(place, one.__func__)]
        if callable(one):
            return self.function(place, one)
        raise Unknown(f"{place}: a {type(one).__name__}, which {Path(__file__).name} does not know")

    def of_class(self, name, one):
        base = one.__bases__[0]
        bases = f"({base.__name__})" if base.__module__ == "builtins" and base is not object else ""
        lines = [line for key, member in vars(one).items() if is_shown(key) for line in self.member(name, key, member)]
        return ["", f"class {name}{bases}:", *("    " + line for line in lines)] if lines else [f"class {name}{bases}: ..."]

    def text(self):
        lines = [HEAD]
        before = None
        for name, one in vars(self.core).items():
            if not is_shown(name):
                continue
            if inspect.isclass(one):
                found = self.of_class(name, one)
            elif callable(one):
                found = self.function(name, one)
            elif type(one) in (str, int, float, bool):
                found = [f"{name}: {type(one).__name__}"]
            else:
                raise Unknown(f"{name}: a {type(one).__name__}, which {Path(__file__).name} does not know")
            if found[0] and before is not None and before != type(one):
                lines.append("")
            before = type(one)
            lines += found
        if unasked := ({*RESULTS, *PARAMETERS} - self.asked):
            raise Unknown(f"{Path(__file__).name}: nothing asks for its rows {', '.join(sorted(unasked))}")
        return "\n".join(lines) + "\n"


def is_shown(name):
    return name in SHOWN or not name.startswith("__")


def definition(name, parameters, result):
    """Lines of a function: one, or one per parameter where it would be too long within a class."""
    words = [one + (f": {kind}" if kind else "") + (" = ..." if default else "") for one, kind, default in parameters]
    line = f"def {name}({', '.join(words)}) -> {result}: ..."
    if len(line) <= WIDTH - 4:
        return [line]
    return [f"def {name}(", *(f"    {word}," for word in words), f") -> {result}: ..."]


def stubs_of(core):
    """The text of the stubs of the module tricontact._core. Throws Unknown."""
    return Writer(core).text()


def loaded(module):
    """The compiled module from where it was built, with the package's sources around it."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(STUB.parent.parent))
    spec = importlib.util.spec_from_file_location("tricontact._core", module.resolve())
    core = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = core
    spec.loader.exec_module(core)
    importlib.import_module("tricontact")
    return core


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("module", nargs="?", type=Path, metavar="MODULE")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    module = given.module or next(ROOT.glob("build/release/python/_core*.so"), None)
    if module is None:
        sys.exit("error: no build/release/python/_core*.so: build the target tricontact_python, or name the module")
    try:
        text = stubs_of(loaded(module))
    except (Unknown, ImportError) as error:
        sys.exit(f"error: {error}")
    if not given.check:
        STUB.write_text(text)
    elif text != STUB.read_text():
        sys.exit(f"{STUB.relative_to(ROOT)} differs from what the module says: scripts/python_stubs.py writes it anew")


if __name__ == "__main__":
    main()
