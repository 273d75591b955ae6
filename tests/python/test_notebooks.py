"""The notebooks of docs/tutorials: executed, they print the numbers that are stored in them."""

import os
import re
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat", reason="python3-nbformat is not installed")
nbclient = pytest.importorskip("nbclient", reason="python3-nbclient is not installed")
pytest.importorskip("ipykernel", reason="python3-ipykernel is not installed")

FOLDER = Path(os.environ["TRICONTACT_DOCS"]) / "tutorials"
NUMBER = re.compile(r"-?\d+(?:\.\d*)?(?:e[-+]?\d+)?")


def texts(notebook):
    """What each cell printed and returned as text."""
    found = []
    for cell in notebook.cells:
        outputs = cell.get("outputs", [])
        parts = [one.get("text", "") or one.get("data", {}).get("text/plain", "") for one in outputs
                 if one.get("name") != "stderr"]
        # Neither pictures nor the line of progress, which is taken away at the end.
        found.append("".join(part for part in parts if not re.match("<(Figure|IPython)", part)))
    return found


@pytest.mark.parametrize("name", ["first_run", "sweep_and_fit"])
def test_stored_outputs_are_those_that_come_out(name, examples, tmp_path):
    stored = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    (tmp_path / "examples").symlink_to(examples)
    fresh = nbformat.from_dict(stored)
    expected = texts(stored)
    assert sum(map(bool, expected)) >= 3
    nbclient.NotebookClient(fresh, timeout=60, kernel_name="python3",
                            resources={"metadata": {"path": str(tmp_path)}}).execute()
    for before, after in zip(expected, texts(fresh)):
        assert NUMBER.sub("#", before) == NUMBER.sub("#", after)
        # Printed with at most six digits: another machine rounds the last one differently.
        for one, other in zip(NUMBER.findall(before), NUMBER.findall(after)):
            assert float(other) == pytest.approx(float(one), rel=1e-4)
