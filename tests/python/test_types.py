"""The stubs: complete, and what mypy makes of them."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

import tricontact

FOLDER = Path(tricontact.__file__).parent
OPERATORS = {"__getitem__", "__len__", "__iter__", "__contains__"}

USE = """
import numpy as np
from numpy.typing import NDArray
import tricontact
from tricontact import theory

case = tricontact.Case.from_file("case.toml", {"rolling.periods": 3})
result = tricontact.run(case, models=["mdr"], threads=2, on_step=lambda model, step, steps: None)
shift: NDArray[np.float64] = result["mdr"]["shift_x_m"]
limit: float = theory.shakedown_limit(0.5)
limits: NDArray[np.float64] = theory.shakedown_limit(np.array([0.1, 0.5]))
rig = tricontact.atlas.load("sphere_half_space")
values, errors = rig("kappa", amplitude_ratio=np.array([0.1, 0.2]), outside="nan", angle=0)
predicted: float = tricontact.predict(case)["bem"]["settled_shift_ratio"]
rows: int = len(tricontact.sweep("study.toml", jobs=2)["model"])
case.models = []  # an error: it cannot be set
case.run()  # an error: there is none
"""


def public(names):
    return {name for name in names if not name.startswith("__") or name in OPERATORS}


def names_in(body):
    return public(node.name for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef)))


def test_stub_and_module_have_the_same_names():
    stub = ast.parse((FOLDER / "_core.pyi").read_text())
    module = tricontact._core
    classes = [node for node in stub.body if isinstance(node, ast.ClassDef)]
    helpers = {node.name for node in classes if node.name.startswith("_")}
    assert names_in(stub.body) - helpers == public(vars(module))
    for node in classes:
        if node.name not in helpers:
            assert names_in(node.body) == public(vars(getattr(module, node.name))), node.name


def test_everything_is_documented():
    for name in tricontact.__all__:
        thing = getattr(tricontact, name)
        assert name == "__version__" or thing.__doc__, name
    for module in (tricontact.theory, tricontact.atlas):
        for name in module.__all__:
            assert getattr(module, name).__doc__, name


def mypy(*arguments, cwd):
    environment = {**os.environ, "MYPYPATH": str(FOLDER.parent), "MYPY_CACHE_DIR": str(cwd)}
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", *arguments],
        cwd=cwd,
        env=environment,
        capture_output=True,
        text=True,
    )
    return [line for line in done.stdout.splitlines() if ": error:" in line]


def test_mypy_knows_the_module(tmp_path):
    pytest.importorskip("mypy")
    assert mypy("-p", "tricontact", cwd=tmp_path) == []
    (tmp_path / "use.py").write_text(USE)
    errors = mypy("use.py", cwd=tmp_path)
    assert len(errors) == 2, errors
    assert "read-only" in errors[0] and 'has no attribute "run"' in errors[1]
