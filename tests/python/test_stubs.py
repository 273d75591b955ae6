"""The stub of the compiled module beside the module: names, parameters, defaults, results."""

import ast
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import tricontact
from tricontact import _core, saved

FOLDER = Path(tricontact.__file__).parent
STUB = (FOLDER / "_core.pyi").read_text()
# Results as pybind11 names them, and as the stub does.
RESULTS = {"None": "None", "str": "str", "float": "float", "int": "int", "bool": "bool", "List[str]": "list[str]",
           "tuple": "tuple", "dict": "dict", "list": "list"}
SIGNATURE = re.compile(r"^\w*\((.*?)\)(?: -> (.*))?$")


def stubtest(text, folder):
    """What stubtest of mypy finds; every class of pybind11 has a metaclass and an __init__ of which no stub speaks."""
    package = folder / "tricontact"
    package.mkdir()
    for file in FOLDER.iterdir():
        if file.name != "_core.pyi":
            (package / file.name).symlink_to(file)
    (package / "_core.pyi").write_text(text)
    classes = [name for name, one in vars(_core).items() if inspect.isclass(one) and f"class {name}" in text]
    (folder / "allowed").write_text("".join(f"tricontact._core.{name}\ntricontact._core.{name}.__init__\n" for name in classes))
    libraries = {str(file.parent) for file in Path(os.environ["TRICONTACT_COPY"]).rglob("libtricontact.so")}
    environment = {**os.environ, "PYTHONPATH": str(folder), "MYPYPATH": str(folder),
                   "LD_LIBRARY_PATH": ":".join(libraries)}
    done = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "tricontact._core", "--ignore-unused-allowlist", "--concise",
         "--allowlist", str(folder / "allowed")],
        cwd=folder, env=environment, capture_output=True, text=True,
    )
    assert done.returncode in (0, 1), done.stderr
    return [line for line in done.stdout.splitlines() if line.startswith("tricontact.")]


def test_stubtest_finds_every_name(tmp_path):
    pytest.importorskip("mypy")
    assert stubtest(STUB, tmp_path) == []


def test_stubtest_finds_a_name_left_out(tmp_path):
    pytest.importorskip("mypy")
    text = STUB.replace("    def __len__(self) -> int: ...\n    def to_pandas(self) -> Any: ...\n", "", 1)
    text = text.replace("    @property\n    def digest(self) -> str: ...\n", "")
    found = stubtest(text, tmp_path)
    assert len(found) == 3, found
    for name in ("History.__len__", "History.to_pandas", "BenchmarkReference.digest"):
        assert any(line.startswith(f"tricontact._core.{name} is not present in stub") for line in found), found


def pieces(text):
    """Parameters, split at commas outside of brackets."""
    found, depth, piece = [], 0, ""
    for c in text:
        depth += (c in "[({") - (c in "])}")
        if c == "," and depth == 0:
            found.append(piece)
            piece = ""
        else:
            piece += c
    return [one.strip() for one in [*found, piece] if one.strip()]


def parameters_of(function):
    """Of a function of Python its parameters, each with whether it has a default."""
    signature = inspect.signature(function)
    return [(one.name, one.default is not one.empty) for one in signature.parameters.values()]


def compiled(function):
    """The same of a compiled one, and its result, from the first line of its text by pybind11."""
    match = SIGNATURE.match((function.__doc__ or "").partition("\n")[0])
    if not match:
        return None, None
    return [(re.split("[:=]", one)[0].strip(), "=" in one) for one in pieces(match[1])], match[2]


def in_module(owner, name):
    """Parameters and result of what the module has."""
    function = getattr(owner, name)
    if inspect.isfunction(function):  # saved.py gives it to the class
        return parameters_of(function), None
    parameters, result = compiled(function)
    if parameters and ("*args", False) in parameters:  # handed on; a kept result has the same method
        kept = {computed: other for computed, other, *_ in saved._PAIRS}.get(owner)
        method = getattr(kept, name, None)
        return (parameters_of(method) if inspect.isfunction(method) else None), None
    return parameters, result


def in_stub(node):
    names = node.args.args
    first_default = len(names) - len(node.args.defaults)
    return [(one.arg, i >= first_default) for i, one in enumerate(names)], ast.unparse(node.returns)


def is_other(told, stated):
    """Whether a result is another one than the stub's, as far as pybind11 tells it."""
    if told is not None and told.startswith("tricontact._core."):
        return stated != told.removeprefix("tricontact._core.")
    return told in RESULTS and stated != RESULTS[told] and stated.split("[")[0] != RESULTS[told]


def faults(text):
    """Where stub and module differ."""
    stub = ast.parse(text)
    places = [("", _core, stub.body)]
    places += [(node.name + ".", getattr(_core, node.name), node.body)
               for node in stub.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")]
    for before, owner, body in places:
        overloads = {}
        for node in body:
            if isinstance(node, ast.FunctionDef):
                overloads.setdefault(node.name, []).append(node)
        for name, nodes in overloads.items():
            stated = [in_stub(node) for node in nodes]
            if isinstance(inspect.getattr_static(owner, name), property):
                result = compiled(getattr(owner, name).fget)[1]
                if is_other(result, stated[0][1]):
                    yield f"{before}{name}: {result}, in the stub {stated[0][1]}"
                continue
            parameters, result = in_module(owner, name)
            for there, returned in stated:
                if is_other(result, returned):
                    yield f"{before}{name}: {result}, in the stub {returned}"
                names = [one for one, _ in there]
                if parameters is not None and names != [one for one, _ in parameters]:
                    yield f"{before}{name}: parameters {parameters}, in the stub {names}"
            if parameters is not None and len({len(there) for there, _ in stated} | {len(parameters)}) == 1:
                # A default stands in one of the overloads at least: another may ask for what decides between them.
                for i, (parameter, has_default) in enumerate(parameters):
                    if has_default != any(there[i][1] for there, _ in stated):
                        yield f"{before}{name}: {parameter} {'has a' if has_default else 'has no'} default"


def test_signatures_are_those_of_the_module():
    assert list(faults(STUB)) == []


@pytest.mark.parametrize(("old", "new", "fault"), [
    ("def to_toml(self) -> str", "def to_toml(self) -> int", "Case.to_toml: str, in the stub int"),
    ("def contact_radius(self) -> float", "def contact_radius(self) -> str", "HalfSpaceScales.contact_radius: float"),
    ("def _label(name: str)", "def _label(key: str)", "_label: parameters"),
    ("def results(self, model: str)", "def results(self, model: str, of: str)", "Result.results: parameters"),
    ("kappa: float = ...", "kappa: float", None),  # its other overload still has it
    ("    case: Case,\n    models", "    models", "_run: parameters"),
    ("field: str = ..., ax: Any = ...", "field: str = ..., axes: Any = ...", "Surface.plot: parameters"),
    ("column: str = ..., ax: Any = ...", "column: str, ax: Any = ...", "History.plot: column has a default"),
    ("def __getitem__(self, name: str)", "def __getitem__(self, key: str)", "Surface.__getitem__: parameters"),
])
def test_other_signatures_are_found(old, new, fault):
    assert old in STUB
    found = list(faults(STUB.replace(old, new, 1)))
    assert len(found) == (fault is not None) and all(one.startswith(fault) for one in found), found
