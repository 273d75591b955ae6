"""Contacts that roll on."""

import json

import numpy as np
import pytest

import tricontact

COARSE = {"bem.cells_per_radius": 12, "tractive_rolling.distance": 2}


@pytest.fixture
def cylinder(examples):
    return examples / "cases" / "rolling_cylinder.toml"


def test_rolling_is_that_of_the_program(cylinder, program, tmp_path):
    rolling = tricontact.roll(tricontact.Case.from_file(cylinder, COARSE), points=3, threads=1)
    arguments = [text for key, value in COARSE.items() for text in ("--set", f"{key}={value}")]
    program("run", cylinder, *arguments, "--points", 3, "--quiet", "--output", "out")
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    # The half widths of the steady state are further runs, which roll() leaves to the program.
    for model in summary["models"]:
        assert model["numerical_error"]["half_widths"]["indentation_m"] >= 0
        model["numerical_error"] = None
    assert rolling.summary == summary
    for table, name in ((rolling.creep, "creep"), (rolling.histories["bem"], "bem/history")):
        file = tricontact.read_table(tmp_path / "out" / f"{name}.csv")
        assert list(file) == list(table)
        for column in table:
            np.testing.assert_array_equal(table[column], file[column])


def test_surface_obeys_coulomb(cylinder):
    rolling = tricontact.roll(tricontact.Case.from_file(cylinder, COARSE), points=0)
    surface = rolling.surfaces["bem"]
    traction, bound = surface["tangential_traction_x_Pa"], surface["friction_bound_Pa"]
    assert np.all(np.abs(traction) <= bound * (1 + 1e-9))
    assert np.all(surface["slip_x_m"][surface["contact_state"] == 1] <= 1e-6)
    assert len(rolling.creep["model"]) == 0


def test_steps_are_told_and_can_end_the_run(cylinder):
    case = tricontact.Case.from_file(cylinder, COARSE)
    told = []

    def tell(model, step, steps):
        told.append((model, step, steps))
        if step == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        tricontact.roll(case, points=2, on_step=tell)
    assert told == [("bem", step, 26) for step in (1, 2, 3)]  # 2 a of 12 cells, 2 points


def test_each_kind_of_case_has_its_function(cylinder, rig):
    with pytest.raises(tricontact.InputError, match="there is no .tractive_rolling"):
        tricontact.roll(tricontact.Case.from_file(rig))
    with pytest.raises(tricontact.InputError, match="rolls on and does not come back"):
        tricontact.run(tricontact.Case.from_file(cylinder))
    with pytest.raises(ValueError, match="points"):
        tricontact.roll(tricontact.Case.from_file(cylinder), points=-1)


def test_temperatures_of_both_surfaces(examples):
    coarse = {"bem.spacing": "0.6 mm", "tractive_rolling.distance": 0.1}
    rolling = tricontact.roll(tricontact.Case.from_file(examples / "cases" / "rolling_temperature.toml", coarse), points=0)
    fields, surface = rolling.temperatures["bem"], rolling.surfaces["bem"]
    touching = surface["contact_state"] > 0
    assert fields["indenter"].shape == surface["normal_traction_Pa"].shape
    np.testing.assert_allclose(fields["indenter"][touching], fields["substrate"][touching], rtol=1e-12)
    assert fields["substrate"][touching].max() == rolling.steady["bem"]["highest_temperature_degC"]
    assert fields["indenter"][:, -1] == pytest.approx(150) and fields["substrate"][:, -1] == pytest.approx(0)  # ahead
    assert rolling == rolling and not fields["indenter"].flags.writeable


def test_without_heat_there_are_no_temperatures(cylinder):
    assert tricontact.roll(tricontact.Case.from_file(cylinder, COARSE), points=0).temperatures == {}
