#!/usr/bin/env python3
"""Writes lens_pull_off.csv in this folder, not measured: a glass lens, R = 10 mm, pressed into silicone rubber of
E = 1.8 MPa, nu = 1/2, and pulled off, with a work of adhesion of 50 mJ/m2. Johnson, Kendall and Roberts' curve:
in contact from a depth of 0 on, and down to where it lets go. Depths count from a place that is not known; noise of
force and depth from a stated seed.
usage: make_adhesion_data.py [FOLDER]"""
import math
import os
import random
import sys

radius, young, poisson, work = 10e-3, 1.8e6, 0.5, 50e-3
zero, deepest, start, n_rows = 123e-6, 12e-6, -6e-6, 60
force_noise, depth_noise = 20e-6, 20e-9
plane = young / (1 - poisson ** 2)
source = ("# Synthetic, no measurement: glass lens on silicone, R = 10 mm, E = 1.8 MPa, w = 50 mJ/m2, zero depth 123 um;\n"
          "# rows in the order of time, noise 20 uN and 20 nm, seed 50; made by make_adhesion_data.py.\n")


def state(a):
    """Depth and force of the contact radius a."""
    stretched = math.sqrt(2 * math.pi * a * work / plane)
    return a * a / radius - stretched, 4 * plane * a ** 3 / (3 * radius) - 2 * plane * a * stretched


def force(depth, last):
    low, high = last, radius
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if state(middle)[0] < depth else (low, middle)
    return state(low)[1]


# The depth is least where 2 a/R is half of l/a.
last_radius = (radius ** 2 * math.pi * work / (8 * plane)) ** (1 / 3)
last_depth = state(last_radius)[0]
folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
draw = random.Random(50)
ways = [i / (n_rows - 1) for i in range(n_rows)]
touches = False
with open(os.path.join(folder, "lens_pull_off.csv"), "w") as out:
    out.write(source + "indentation [um], normal_force [mN]\n")
    for i, way in enumerate(ways + ways[::-1]):
        depth = start + (deepest - start) * way
        touches = depth >= 0 if i < n_rows else touches and depth >= last_depth
        measured = zero + depth + depth_noise * draw.gauss(0, 1)
        carried = (force(depth, last_radius) if touches else 0) + force_noise * draw.gauss(0, 1)
        out.write(f"{1e6 * measured:.3f}, {1e3 * carried:.4f}\n")
