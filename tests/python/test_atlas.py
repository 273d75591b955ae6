"""Atlases: arrays and numbers, refusals, and the program's own predictions."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

import tricontact
from tricontact import atlas, theory

POINT = {"amplitude_ratio": 0.24, "limit_fraction": 0.56 / 0.646912, "angle": 0.0, "poisson": 0.5}


@pytest.fixture
def half_space():
    return atlas.load("sphere_half_space")


def test_an_atlas_tells_what_it_is(half_space):
    assert atlas.names() == sorted(atlas.names()) and half_space.name in atlas.names()
    keys = {axis.key: (axis.name, axis.unit, axis.range) for axis in half_space.axes}
    assert keys["rolling.angle"] == ("angle", "rad", (0, np.pi / 2))
    assert keys["substrate.poisson"] == ("poisson", "1", (0, 0.5))
    assert "settled_shift_ratio" in half_space.quantities
    assert half_space.model == "bem" and half_space.points > 100
    assert "[vary]" in half_space.study and half_space.title
    assert repr(half_space).startswith("<Atlas sphere_half_space: settled_shift_ratio, ")


def test_numbers_are_those_of_boundary_elements(half_space):
    # Runs on 22 cells per radius, to 3e-3.
    value, error = half_space.evaluate("settled_shift_ratio", **POINT)
    assert isinstance(value, float) and isinstance(error, float)
    assert value == pytest.approx(0.55940, abs=error + 3e-3 * value)
    assert 0 < error < 3e-3 * value
    across = half_space("settled_shift_ratio", **{**POINT, "angle": np.pi / 2})
    assert across.values == pytest.approx(0.58237, abs=across.errors + 3e-3 * value)


def test_coordinates_broadcast(half_space):
    w, fraction = np.linspace(0.1, 0.7, 3)[:, None], np.linspace(0.1, 0.9, 4)
    rest = {"angle": 0.4, "poisson": [[0.3]]}
    found = half_space.evaluate(
        "settled_shift_ratio", amplitude_ratio=w, limit_fraction=fraction, **rest
    )
    assert found.values.shape == found.errors.shape == (3, 4)
    for i, k in np.ndindex(3, 4):
        one = half_space.evaluate(
            "settled_shift_ratio",
            rolling_amplitude_ratio=w[i, 0],
            load_limit_fraction=fraction[k],
            angle=0.4,
            poisson=0.3,
        )
        assert one.values == pytest.approx(found.values[i, k], rel=1e-12)
        assert one.errors == pytest.approx(found.errors[i, k], rel=1e-9)
    empty = half_space.evaluate("kappa", **{**POINT, "angle": []})
    assert empty.values.shape == (0,)


def test_outside_is_refused_or_nan(half_space):
    point = {**POINT, "amplitude_ratio": [0.24, 0.9, 0.5]}
    with pytest.raises(ValueError, match=r"rolling.amplitude_ratio = 0.9: .* from 0.02 to 0.85"):
        half_space.evaluate("kappa", **point)
    values, errors = half_space.evaluate("kappa", outside="nan", **point)
    assert list(np.isnan(values)) == list(np.isnan(errors)) == [False, True, False]
    for bad in (np.nan, np.inf, -0.1):
        with pytest.raises(ValueError, match="substrate.poisson = "):
            half_space.evaluate("kappa", **{**POINT, "poisson": bad})
        assert np.isnan(half_space.evaluate("kappa", outside="nan", **{**POINT, "poisson": bad})[0])


def test_wrong_arguments_are_refused(half_space):
    with pytest.raises(TypeError, match="coordinate angle is missing"):
        half_space.evaluate("kappa", amplitude_ratio=0.2, limit_fraction=0.5, poisson=0.5)
    with pytest.raises(TypeError, match="no coordinate thickness_ratio"):
        half_space.evaluate("kappa", thickness_ratio=1, **POINT)
    with pytest.raises(TypeError, match="angle is given twice"):
        half_space.evaluate("kappa", rolling_angle=0, **POINT)
    with pytest.raises(ValueError, match="has no quantity eta"):
        half_space.evaluate("eta", **POINT)
    with pytest.raises(ValueError, match="outside"):
        half_space.evaluate("kappa", outside="clip", **POINT)
    with pytest.raises(ValueError, match="broadcast"):
        half_space.evaluate("kappa", **{**POINT, "angle": [0, 1], "poisson": [0.1, 0.2, 0.3]})


def test_pressed_layers_are_the_exact_ones():
    pressed = atlas.load("sphere_layer_pressed")
    for nu, b in ((0.5, 0.25), (0.3, 1.0), (0.0, 6.0)):
        values = {
            "models": ["bem-layer"],
            "indenter": {"radius": "40 mm"},
            "substrate": {"young": "5.2 MPa", "poisson": nu, "thickness_ratio": b},
            "friction": {"coefficient": 0.57},
            "load": {"normal_force": "20 N", "tangential_force": "0 N"},
        }
        case = tricontact.Case.from_dict(values)
        exact, hertz = theory.layer_contact(case), case.scales
        at = {"amplitude_ratio": 0.3, "thickness_ratio": b, "poisson": nu}
        for quantity, ratio in (
            ("contact_radius_m", exact.contact_radius / hertz.contact_radius),
            ("indentation_m", exact.indentation / hertz.indentation),
            ("limit_tangential_ratio", exact.shakedown_limit(0.3)),
        ):
            assert pressed(quantity, **at).values == pytest.approx(ratio, rel=1e-4)


def test_files_are_read_and_changes_refused(tmp_path):
    with pytest.raises(tricontact.InputError, match="nowhere.json"):
        atlas.load(tmp_path / "nowhere.json")
    with pytest.raises(tricontact.InputError, match="nowhere"):
        atlas.load("nowhere")
    file = tmp_path / "some.json"
    file.write_text('{"format": "tricontact atlas 1", "digest": "0"}')
    with pytest.raises(tricontact.InputError, match="does not fit its digest"):
        atlas.load(file)


@pytest.mark.parametrize("models", [None, ["bem"]])
def test_predictions_are_those_of_the_program(rig, models, tmp_path):
    program = Path(rig).parents[4] / "bin" / "tricontact"
    # The half-space without coupling; its indenter is rigid.
    case = tricontact.Case.from_file(rig, {"contact.coupling": False})
    command = [program, "predict", rig, "--json", "--set", "contact.coupling=false"]
    command += ["--models", ",".join(models)] if models else []
    printed = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    predicted = tricontact.predict(case, models)
    assert predicted["models"] == json.loads(printed.stdout)["models"]
    assert predicted["bem"]["state"] == "shakedown"
    assert predicted["bem"]["settled_shift_ratio_error"] > 0


def test_predictions_are_shown_as_a_whole(rig):
    predicted = tricontact.predict(rig)
    page = predicted._repr_html_()
    for name in ("static shift", "settled shift", "shakedown limit of the load", "mapping parameter", "rests on"):
        assert name in page, page
    assert page.count("<tr>") > 12 and "<th>mdr</th><th>bem</th>" in page
    bem = predicted["bem"]
    assert f"{bem['kappa']:.6g} ± {bem['kappa_error']:.2g}" in page
    with pytest.raises(KeyError, match="no fem; there are .*mdr, bem"):
        predicted["fem"]


@pytest.mark.parametrize("text", ["[" * 20000, "NaN", "1e400", "{}", '{"format": 3}', "[1]", ""])
def test_files_that_are_none_are_refused_in_words(text, tmp_path):
    file = tmp_path / "none.json"
    file.write_text(text)
    with pytest.raises(tricontact.InputError, match="none.json: is no atlas") as refused:
        tricontact.atlas.load(file)
    assert "json.exception" not in str(refused.value) and "; " in str(refused.value)


def test_what_no_atlas_is_about_is_refused(examples):
    case = tricontact.Case.from_file(examples / "cases" / "rolling_cylinder.toml")
    with pytest.raises(tricontact.InputError, match="no atlas is about"):
        tricontact.predict(case)
