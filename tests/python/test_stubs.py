"""The stub of the compiled module: what scripts/python_stubs.py writes, and complete."""

import importlib.util
import inspect
import os
import subprocess
import sys
import types
from pathlib import Path

import pytest

import tricontact
from tricontact import _core

FOLDER = Path(tricontact.__file__).parent
STUB = (FOLDER / "_core.pyi").read_text()
SCRIPT = Path(__file__).parents[2] / "scripts" / "python_stubs.py"


def script():
    spec = importlib.util.spec_from_file_location("python_stubs", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


stubs = script()


def test_stub_is_what_the_script_writes():
    assert stubs.stubs_of(_core) == STUB, "scripts/python_stubs.py writes python/tricontact/_core.pyi anew"


def test_script_checks_the_sources():
    done = subprocess.run([sys.executable, SCRIPT, "--check", _core.__file__], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def told(text):
    """What pybind11 makes of a function, as far as the script looks at it."""
    return types.SimpleNamespace(__doc__=text + "\n")


def written(place, text):
    return "\n".join(stubs.Writer(_core).function(place, told(text)))


@pytest.mark.parametrize(("place", "text", "stub"), [
    ("_new", "_new() -> List[str]", "def _new() -> list[str]: ..."),
    ("_new", "_new(names: List[str], n: Optional[int] = None) -> Dict[str, Tuple[int, float]]",
     "def _new(names: Sequence[str], n: Optional[int] = ...) -> dict[str, tuple[int, float]]: ..."),
    ("Case.new", "new(arg0: tricontact._core.Case, other: tricontact._core.Case) -> tricontact._core.Scales",
     "def new(self, other: Case) -> Scales: ..."),
    ("_new", "_new(path: str) -> numpy.ndarray", "def _new(path: bytes) -> NDArray[Any]: ..."),
    ("new", "new(x: numpy.ndarray[numpy.float64], y: numpy.ndarray[numpy.float64] = 0.0) -> object",
     "@overload\ndef new(x: float, y: float = ...) -> float: ...\n"
     "@overload\ndef new(x: _Array, y: _Any = ...) -> _Numbers: ...\n"
     "@overload\ndef new(x: float, y: _Array) -> _Numbers: ..."),
    ("Surface.plot", "plot(self: object, *args, **kwargs) -> object",
     "def plot(self, field: str = ..., ax: Any = ...) -> Any: ..."),
])
def test_signatures_become_those_of_python(place, text, stub):
    assert written(place, text) == stub


def test_long_signatures_are_broken():
    parameters = ", ".join(f"parameter_{k}: float" for k in range(8))
    lines = written("_new", f"_new({parameters}) -> None").split("\n")
    assert lines[0] == "def _new(" and lines[-1] == ") -> None: ..." and len(lines) == 10
    assert max(map(len, STUB.split("\n"))) <= 120


@pytest.mark.parametrize(("place", "text", "fault"), [
    ("_new", "_new() -> object", "_new: pybind11 calls its result object"),
    ("_new", "_new() -> tuple", "_new: pybind11 calls its result tuple"),
    ("_new", "_new(one: List[object]) -> None", "_new: pybind11 calls its one List"),
    ("Case.new", "new(self: object, *args, **kwargs) -> object", "Case.new: written in Python"),
    ("_new", "A text without a signature.", "_new: no signature"),
    ("_new", "_new(text: str = 'a, (b', x: float = 1.0) -> None", "brackets in a default"),
])
def test_types_that_nothing_tells_are_asked_for(place, text, fault):
    with pytest.raises(stubs.Unknown, match=f"^{fault}"):
        written(place, text)


def test_rows_that_nothing_asks_for_are_found(monkeypatch):
    monkeypatch.setitem(stubs.RESULTS, "Case.gone", "int")
    with pytest.raises(stubs.Unknown, match="Case.gone"):
        stubs.stubs_of(_core)


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
