"""References beside closed forms."""

import numpy as np
import pytest

import tricontact
from tricontact import benchmark

HERTZ = {
    "models": ["bem"],
    "indenter": {"radius": "1 m"},
    "substrate": {"young": "15 MPa", "poisson": 0.3},
    "friction": {"coefficient": 0.3},
    "contact": {"coupling": False},
    "load": {"indentation": "10 mm", "tangential_ratio": 0.0},
}


@pytest.fixture
def hertz(tmp_path, monkeypatch):
    monkeypatch.setenv("TRICONTACT_CACHE", str(tmp_path))
    reference = benchmark.reference(HERTZ)
    assert len(list(tmp_path.glob("*.reference"))) == 1
    again = benchmark.reference(HERTZ)
    assert again.values == reference.values
    return reference


def test_values_are_those_of_hertz(hertz):
    scales = tricontact.Case.from_dict(HERTZ).scales
    force = hertz.values["normal_force"]
    assert force["source"] == "Hertz (1882)"
    assert force["value"] == pytest.approx(scales.normal_force, rel=1e-9)
    assert 0 < force["bar"] < 1e-3 * force["value"]
    assert hertz.values["indentation"]["bar"] == 0
    assert hertz.prescribed == ["indentation"]
    assert hertz.geometry == "axisymmetric"
    assert hertz.contact_radius == pytest.approx(scales.contact_radius)
    # -1/2 d/dd of pi/2 p0^2 a^2, see tests/unit/benchmarks/reference.cc.
    modulus = 15e6 / 0.91
    compliance = hertz.effects["normal_compliance"]["value"]
    assert compliance == pytest.approx(-2 / np.pi * modulus**2 * 0.01, rel=1e-6)


def test_fields_take_arrays(hertz):
    scales = tricontact.Case.from_dict(HERTZ).scales
    x = np.linspace(0, 0.12, 7)
    pressure = hertz.pressure(x)
    np.testing.assert_allclose(pressure, tricontact.theory.hertz_pressure(scales, x),
                               atol=1e-7 * scales.peak_pressure)
    assert hertz.pressure(0.03, 0.04) == pytest.approx(hertz.pressure(0.05))
    assert hertz.pressure(np.zeros((2, 3)), 0.01).shape == (2, 3)
    # p0 (1 - r^2/a^2)^(1/2): its mean over a square of the side s about the centre is p0 (1 - s^2/(12 a^2)).
    side = 0.05 * scales.contact_radius
    assert hertz.mean_pressure(0, 0, side**2) == pytest.approx(scales.peak_pressure * (1 - 0.05**2 / 12), rel=1e-6)
    assert hertz.traction(x, x).shape == (7, 2)
    assert hertz.displacement(x, x).shape == (7, 3)
    np.testing.assert_allclose(hertz.displacement(0.0)[2], 0.01)
    assert (hertz.pressure_bar(x) >= 0).all()
    assert hertz.load_within(1.0) == pytest.approx(scales.normal_force)


def test_no_reference_is_refused():
    with pytest.raises(tricontact.InputError, match="relaxes"):
        benchmark.reference({
            **HERTZ,
            "substrate": {**HERTZ["substrate"], "relaxation": {
                "relative_moduli": [0.5], "times": ["1 s"]}},
        })


def test_the_catalogue_is_there():
    names = [one["name"] for one in benchmark.problems()]
    assert len(names) >= 18 and "layer_pressed" in names
    assert [one["name"] for one in benchmark.problems("locking")] == [
        "layer_pressed_nearly_incompressible"
    ]
    page = benchmark.problem("two-spheres")
    assert page["targets"][0]["value"] == pytest.approx(0.01)
    with pytest.raises(tricontact.InputError, match="did you mean layer_pressed"):
        benchmark.problem("layer_presed")


def test_exact_values_of_a_code_pass(tmp_path, monkeypatch):
    monkeypatch.setenv("TRICONTACT_CACHE", str(tmp_path))
    files = []
    for n in (16, 32, 64):
        # Hertz: 20 kN on a radius of 100 mm, sampled at nodes.
        r = np.arange(2 * n + 1) * 100 / n
        p = 0.9549297 * np.sqrt(np.maximum(0, 1 - (r / 100) ** 2))
        files.append(tmp_path / f"mesh_{n}.csv")
        lines = [f"{one}, {other}" for one, other in zip(r, p)]
        files[-1].write_text("# normal_force = 20 kN\nr [mm], p [MPa]\n" + "\n".join(lines) + "\n")
    found = benchmark.compare(*files, case="hertz_sphere", no_report=True)
    assert found["quantities"]["normal_force"]["verdict"] == "pass"
    assert abs(found["quantities"]["normal_force"]["difference"]) < 1e-3
    with pytest.raises(tricontact.InputError, match="reaches 22.7 times as far"):
        benchmark.compare(*files, case="layer_pressed", no_report=True, tolerance=0.01)
