"""Frictionless paraboloid on a bonded incompressible layer: the exact solution, for the errors of
the peers' pressures. q(x) - (1/pi) int_0^a q(t) [H(x-t) + H(x+t)] dt = E* (d - x^2/R), q(a) = 0,
F = 2 int_0^a q dx, p(r) = -(1/pi) int_r^a q'(x)/sqrt(x^2 - r^2) dx (Hayes et al. 1972; here by
Gauss points)."""

import numpy as np

import layer_grid as rig

E_STAR = rig.E / (1 - rig.NU**2)
N_POINTS = 40


def kernel(s):
    """H(s) = int_0^inf (1 - M(k b)) cos(k s) dk; 1 - M falls as x^2 exp(-2x)."""
    x, w = np.polynomial.legendre.leggauss(200)
    x, w = 15 * (x + 1), 15 * w
    decay = np.exp(-2 * x)
    # bonded, nu = 1/2 (kappa = 1), numerator and denominator times exp(-2x)
    m = (1 - decay**2 - 4 * x * decay) / (1 + decay**2 + (4 * x**2 + 2) * decay)
    return np.cos(np.multiply.outer(s, x / rig.DEPTH)) @ (w * (1 - m)) / rig.DEPTH


def unit_solutions(a):
    """Points, weights and q/E* under d = 1 and under x^2/R; the last point is x = a."""
    t, w = np.polynomial.legendre.leggauss(N_POINTS)
    t, w = a * (t + 1) / 2, a * w / 2
    x = np.append(t, a)
    matrix = np.eye(N_POINTS + 1)
    matrix[:, :-1] -= (kernel(x[:, None] - t) + kernel(x[:, None] + t)) * w / np.pi
    return x, w, np.linalg.solve(matrix, np.stack([np.ones_like(x), x**2 / rig.R], axis=1))


def solution(a):
    """d [mm], F [N], points [mm] and q [N/mm] for a contact radius a [mm]."""
    x, w, q = unit_solutions(a)
    d = q[-1, 1] / q[-1, 0]
    q = E_STAR * (d * q[:, 0] - q[:, 1])
    return d, 2 * np.sum(w * q[:-1]), x, q


def at_force(force):
    """Contact radius and indentation [mm], and p(r) [MPa] as a function, by bisection."""
    low, high = 0.1, rig.DEPTH
    for _ in range(60):
        a = (low + high) / 2
        low, high = (a, high) if solution(a)[1] < force else (low, a)
    d, _, x, q = solution(a)
    even = np.polynomial.Polynomial.fit((x / a) ** 2, q, 10, domain=[0, 1], window=[0, 1])
    slope = even.deriv()  # dq/d(x^2/a^2): q'(x)/x = 2 slope/a^2
    t, w = np.polynomial.legendre.leggauss(30)

    def pressure(r):
        r = np.asarray(r, dtype=float)
        reach = np.sqrt(np.maximum(a**2 - r**2, 0))[..., None]
        square = (r[..., None] ** 2 + (reach * (t + 1) / 2) ** 2) / a**2
        return -(slope(square) * 2 / a**2 * reach * w / 2).sum(axis=-1) / np.pi

    return a, d, pressure


def pressure_summary(x, y, p):
    """What nodal pressures p [MPa] say: the peak, the least (tension is negative), the worst
    difference to the exact solution inside 0.8 a over the exact peak."""
    a, _, exact = at_force(rig.FN)
    r = np.hypot(x, y)
    inside = r < 0.8 * a
    error = (p - exact(np.minimum(r, a))) / rig.EXACT["p0"]
    return {"p0": float(p.max()), "p_least": float(p.min()),
            "p_error_inside": float(np.abs(error[inside]).max())}


if __name__ == "__main__":
    radius, depth, p = at_force(rig.FN)
    (d1, f1), (d2, f2) = (solution(radius * near)[:2] for near in (0.99, 1.01))
    power = np.log(f2 / f1) / np.log(d2 / d1)
    print(f"a = {radius:.4f} mm, d = {depth:.5f} mm, p0 = {float(p(0)):.4f} MPa, "
          f"F grows as d^{power:.2f}")
