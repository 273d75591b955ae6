#!/usr/bin/env python3
"""Writes the tables of the rough lens in this folder, none of them measured: a sphere of R = 10 mm on
silicone, E = 1.8 MPa, nu = 1/2, whose roughness is springs k_n = 20 MPa/mm, k_t = 10 MPa/mm, and
mu = 0.8. Rings of constant traction on a half-space (Love's elliptic integrals), springs on top; with
noise from a stated seed.
usage: make_spring_data.py [FOLDER]"""
import math
import os
import random
import sys

radius, young, friction = 10e-3, 1.8e6, 0.8
normal, tangential = 20e9, 10e9
plane, shear = young / 0.75, 4 * young / 3 / 1.5  # E*, G* = 4 G/(2 - nu)
n_rings = 60
source = ("# Synthetic, no measurement: E = 1.8 MPa, mu = 0.8, k_n = 20 MPa/mm, k_t = 10 MPa/mm, R = 10 mm; "
          "made by make_spring_data.py.\n")


def elliptic(m):
    """K and E of the parameter m, by the arithmetic-geometric mean."""
    a, g, c, power, total = 1.0, math.sqrt(1 - m), math.sqrt(m), 0.5, 0.5 * m
    while abs(c) > 1e-15:
        a, g, c = (a + g) / 2, math.sqrt(a * g), (a - g) / 2
        power *= 2
        total += power * c * c
    first = math.pi / (2 * a)
    return first, first * (1 - total)


def disc(s, r):
    """Modulus times displacement at r of a unit traction within s."""
    if r < s:
        return 4 * s / math.pi * elliptic((r / s) ** 2)[1]
    first, second = elliptic((s / r) ** 2)
    return 4 * r / math.pi * (second - (1 - (s / r) ** 2) * first)


def solved(matrix, right):
    """Gauss' elimination of a positive matrix."""
    a = [row[:] + [value] for row, value in zip(matrix, right)]
    n = len(a)
    for i in range(n):
        for k in range(i + 1, n):
            f = a[k][i] / a[i][i]
            if f:
                a[k] = [x - f * y for x, y in zip(a[k], a[i])]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (a[i][n] - sum(a[i][k] * x[k] for k in range(i + 1, n))) / a[i][i]
    return x


# Edges over the contact radius, finer towards the edge; rings are told by their middles.
edges = [math.sin(math.pi / 2 * k / n_rings) for k in range(n_rings + 1)]
middles = [(edges[k] + edges[k + 1]) / 2 for k in range(n_rings)]
areas = [math.pi * (edges[k + 1] ** 2 - edges[k] ** 2) for k in range(n_rings)]
influence = [[disc(edges[k + 1], r) - (disc(edges[k], r) if k else 0) for k in range(n_rings)] for r in middles]


def with_springs(scale, stiffness):
    return [[scale * value + (1 / stiffness if i == k else 0) for k, value in enumerate(row)]
            for i, row in enumerate(influence)]


def press(a):
    """Depth, force and pressures of a contact of the radius a, whose pressure vanishes at the edge."""
    matrix = with_springs(a / plane, normal)
    by_depth = solved(matrix, [1.0] * n_rings)
    by_shape = solved(matrix, [(a * r) ** 2 / (2 * radius) for r in middles])

    def at_edge(p):  # p^2 is linear there on a half-space, p on springs: from the last two rings
        return p[-1] - (p[-2] - p[-1]) / (middles[-1] - middles[-2]) * (1 - middles[-1])
    depth = at_edge(by_shape) / at_edge(by_depth)
    p = [depth * u - v for u, v in zip(by_depth, by_shape)]
    return depth, a * a * sum(x * y for x, y in zip(p, areas)), p


def pressed(value, which):
    """The contact of a depth (0) or a force (1)."""
    low, high = 1e-6, radius
    for _ in range(30):
        middle = math.sqrt(low * high)
        low, high = (low, middle) if press(middle)[which] > value else (middle, high)
    return low, press(low)


def shifts(load, forces):
    """Under each force: rings outside of a radius slip, of which the least that holds is taken."""
    a, (_, _, p) = pressed(load, 1)
    bound = [friction * x for x in p]
    matrix = with_springs(a / shear, tangential)
    curve = [(a * a * friction * sum(x * y for x, y in zip(p, areas)), None)]
    curve = []
    for inside in range(n_rings + 1):
        # All within stick by U = 1, and take off what the ring outside does; the first slipping ring is at its bound.
        outer = [sum(matrix[i][k] * bound[k] for k in range(inside, n_rings)) for i in range(n_rings)]
        if inside == 0:
            curve.append((a * a * sum(x * y for x, y in zip(bound, areas)), outer[0]))
            continue
        inner = [row[:inside] for row in matrix[:inside]]
        unit, off = solved(inner, [1.0] * inside), solved(inner, outer[:inside])
        edge = inside - 1  # the last ring that sticks begins to slip
        shift = (bound[edge] + off[edge]) / unit[edge]
        t = [shift * u - v for u, v in zip(unit, off)] + bound[inside:]
        curve.append((a * a * sum(x * y for x, y in zip(t, areas)), shift))
    curve.append((0.0, 0.0))
    result = []
    for force in forces:
        for (high, v), (low, u) in zip(curve, curve[1:]):
            if low <= force <= high:
                result.append(u + (v - u) * (force - low) / (high - low))
                break
    return result


folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
noise = random.Random(46)
with open(os.path.join(folder, "rough_indentation.csv"), "w", encoding="utf-8") as table:
    table.write(source + "indentation [um], normal_force [N]\n")
    for k in range(1, 21):
        depth = 8e-6 * k
        table.write(f"{1e6 * depth:.0f}, {pressed(depth, 0)[1][1] + noise.gauss(0, 0.001):.5f}\n")
with open(os.path.join(folder, "rough_static_shift.csv"), "w", encoding="utf-8") as table:
    table.write(source + "normal_force [N], tangential_force [N], shift [um]\n")
    for load in (0.05, 0.2, 0.8):
        forces = [round(0.11 * k * friction * load, 5) for k in range(1, 9)]
        for force, shift in zip(forces, shifts(load, forces)):
            table.write(f"{load}, {force:.5f}, {1e6 * shift + noise.gauss(0, 0.3):.2f}\n")
