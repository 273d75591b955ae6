"""Closed forms, each beside what can be computed without it."""

import numpy as np
import pytest

import tricontact
from tricontact import theory

f = np.linspace(0, 1, 11)


def test_cattaneo_and_mindlin():
    np.testing.assert_allclose(theory.static_shift_ratio(f), 1 - (1 - f) ** (2 / 3), rtol=1e-14)
    np.testing.assert_allclose(theory.stick_radius_ratio(f), (1 - f) ** (1 / 3), rtol=1e-14)
    # The traction's integral is F_T: 3 ∫ tau/(mu p0) rho drho = f; Gauss between the edges.
    nodes, weights = np.polynomial.legendre.leggauss(200)
    for value in (0.2, 0.56, 0.9):
        c = theory.stick_radius_ratio(value)
        total = 0.0
        for low, high in ((0, c), (c, 1)):
            rho = low + (high - low) * (nodes + 1) / 2
            traction = theory.cattaneo_mindlin_traction(rho, value)
            total += (high - low) / 2 * weights @ (traction * rho)
        # Gauss' error at the square root of the edges: n^-3.
        assert 3 * total == pytest.approx(value, rel=1e-5)


def test_hertz(rig):
    scales = tricontact.Case.from_file(rig).scales
    theta = (np.arange(20000) + 0.5) / 20000 * np.pi / 2
    a = scales.contact_radius
    pressure = theory.hertz_pressure(scales, a * np.sin(theta))
    force = 2 * np.pi * a**2 * np.mean(pressure * np.sin(theta) * np.cos(theta)) * np.pi / 2
    # Midpoints: an error of the order of 20000^-2.
    assert force == pytest.approx(scales.normal_force, rel=1e-8)
    assert theory.hertz_pressure(scales, 2 * a) == 0
    assert theory.hertz_surface_displacement(scales, 0.0) == pytest.approx(scales.indentation)


def test_oscillating_rolling():
    w = np.linspace(0, 1, 11)
    limit = theory.shakedown_limit(w)
    np.testing.assert_allclose(limit, 1 - 1.5 * w + 0.5 * w**3, atol=1e-15)
    # At w = 1 a square root: half the digits.
    np.testing.assert_allclose(theory.amplitude_limit(limit), w, atol=1e-6)
    u = theory.settled_shift_ratio(0.24, 0.56)
    assert 1 - 1.5 * 0.24 * u - (1 - u) ** 1.5 == pytest.approx(0.56, rel=1e-12)
    assert theory.mapping_parameter(0.24, 0.56, u) == pytest.approx(1.5)
    assert np.isnan(theory.settled_shift_ratio(0.9, 0.56))  # it ratchets


def test_carter_and_kalker():
    np.testing.assert_allclose(theory.carter_force_ratio(theory.carter_creepage_ratio(f)), f)
    # The traction's integral is F_T: ∫ tau/(mu p0) dx/a = f pi/2; midpoints err by n^-3/2 at edges.
    x = (np.arange(200000) + 0.5) / 100000 - 1
    total = np.mean(theory.carter_traction(x, 0.56)) * 2
    assert total == pytest.approx(0.56 * np.pi / 2, rel=1e-6)
    # Kalker's table for a circle and nu = 1/4, to its three digits.
    circle = theory.kalker_coefficients(1, 0.25)
    assert circle.longitudinal == pytest.approx(4.12, abs=0.005)
    assert circle.lateral == pytest.approx(3.67, abs=0.005)
    assert circle.spin == pytest.approx(1.47, abs=0.005)


def test_shapes_and_errors():
    assert isinstance(theory.static_shift_ratio(0.5), float)
    assert theory.shakedown_limit(np.zeros((2, 3))).shape == (2, 3)
    assert theory.settled_shift_ratio(np.zeros((2, 1)), np.zeros(3)).shape == (2, 3)
    with pytest.raises(ValueError):
        theory.static_shift_ratio(1.5)


def layer(thickness):
    values = {
        "models": ["bem-layer"],
        "indenter": {"radius": "40 mm"},
        "substrate": {"young": "5.2 MPa", "poisson": 0.5, "thickness": f"{thickness} mm"},
        "friction": {"coefficient": 0.57},
        "load": {"indentation": "0.5 mm", "tangential_force": "0 N"},
    }
    return tricontact.Case.from_dict(values)


def test_the_exact_layer_becomes_a_half_space():
    def excess(thickness):
        case = layer(thickness)
        return theory.layer_contact(case).normal_force / case.scales.normal_force - 1

    # F = F_Hertz (1 + c a/b + ...), a/b = 0.011 and 0.0056.
    assert excess(400) / excess(800) == pytest.approx(2, rel=0.05)
    contact = theory.layer_contact(layer(800))
    assert contact.pressure(0.0) == pytest.approx(contact.centre_pressure)
    # The limit of shakedown differs from that of the half-space by the square of the layer's effect
    # at least: the profile of the pressure changes with (a/b)^3.
    np.testing.assert_allclose(contact.shakedown_limit(f), 1 - 1.5 * f + 0.5 * f**3, atol=1e-5)


def test_no_exact_layer(rig):
    with pytest.raises(tricontact.InputError, match="substrate.thickness"):
        theory.layer_contact(tricontact.Case.from_file(rig))
