"""Micro-walking machines."""

import numpy as np
import pytest

import tricontact


@pytest.fixture
def machine(examples):
    return examples / "cases" / "walking_set_b.toml"


def test_walk_is_that_of_the_program(machine, program, tmp_path, summary_of):
    settings = {"time.end": 500, "output.frames": 0}
    walk = tricontact.walk(tricontact.WalkCase.from_file(machine, settings))
    arguments = [text for key, value in settings.items() for text in ("--set", f"{key}={value}")]
    program("run", machine, *arguments, "--no-report", "--quiet", "--output", "out")
    assert summary_of(walk.summary) == summary_of(tmp_path / "out" / "summary.json")
    for name, table in (("motion", walk.motion), ("windows", walk.windows)):
        file = tricontact.read_table(tmp_path / "out" / f"{name}.csv")
        assert list(file) == list(table)
        for column in table:
            np.testing.assert_array_equal(table[column], file[column])


def test_progress_is_told_and_may_end_the_run(machine):
    heard = []
    tricontact.walk(machine, time__end=50, progress=lambda *told: heard.append(told))
    assert {name for name, _, _ in heard} == {"walk"}
    assert [done for _, done, _ in heard] == sorted({done for _, done, _ in heard})  # each once, in order
    assert heard[-1][1:] == (1000, 1000) and len(heard) > 100

    def stop(name, done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        tricontact.walk(machine, time__end=50, progress=stop)


def test_spots_obey_coulomb(machine):
    walk = tricontact.walk(tricontact.WalkCase.from_file(machine, {"time.end": 500}))
    mu = 0.68
    for spot in (1, 2):
        normal = walk.motion[f"normal_force_{spot}"]
        tangential = walk.motion[f"tangential_force_{spot}"]
        assert np.all(normal >= 0)
        # Rounding of the largest force.
        assert np.all(np.abs(tangential) <= mu * normal + 1e-12 * normal.max())
