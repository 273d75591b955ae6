"""The installed copy under test, its examples and its program."""

import json
import os
import subprocess
from pathlib import Path

import pytest

COPY = Path(os.environ["TRICONTACT_COPY"])


@pytest.fixture
def examples():
    return COPY / "share" / "tricontact" / "examples"


@pytest.fixture
def rig(examples):
    """The rig's sphere on a half-space."""
    return examples / "cases" / "rig_sphere_parallel.toml"


@pytest.fixture
def program(tmp_path):
    """Calls the installed program in a folder of its own; returns what it printed as errors."""

    def call(*arguments, code=0):
        done = subprocess.run(
            [COPY / "bin" / "tricontact", *map(str, arguments)],
            cwd=tmp_path,
            capture_output=True,
            text=True,
        )
        assert done.returncode == code, done.stderr
        return done.stderr

    return call


@pytest.fixture
def summary_of():
    """The numbers of a summary without the times taken, which differ."""

    def numbers(summary):
        if not isinstance(summary, dict):
            summary = json.loads(Path(summary).read_text())
        for model in summary.get("models", {}).values():
            del model["cpu_s"], model["wall_s"]
        times = ("cpu_s", "wall_s", "lane_steps_per_s")
        return {key: value for key, value in summary.items() if key not in times}

    return numbers
