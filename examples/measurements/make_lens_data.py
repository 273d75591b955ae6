#!/usr/bin/env python3
"""Writes the tables of the lens in this folder, none of them measured: closed forms of a contact of
constant shear strength on a half-space, with noise from a stated seed. A glass lens of R = 10 mm on
silicone, E = 1.8 MPa, nu = 1/2, tau_0 = 0.35 MPa.
Beside them two tables under one load, with 3 % of noise, which leave the law open.
usage: make_lens_data.py [FOLDER]"""
import math
import os
import random
import sys

radius, young, strength = 10e-3, 1.8e6, 0.35e6
plane, shear = young / 0.75, 4 * young / 3 / 1.5  # E*, G* = 4 G/(2 - nu)
source = "# Synthetic, no measurement: E = 1.8 MPa, tau_0 = 0.35 MPa, R = 10 mm; made by make_lens_data.py.\n"


def contact_radius(load):
    return (3 * load * radius / (4 * plane)) ** (1 / 3)


def limit(load):
    return math.pi * strength * contact_radius(load) ** 2


def shift(load, force):
    """F_T/limit = (2/pi) [u sqrt(1 - u^2) + arcsin u], u = U G*/(2 tau_0 a)."""
    low, high = 0.0, 1.0
    for _ in range(60):
        u = (low + high) / 2
        if 2 / math.pi * (u * math.sqrt(1 - u * u) + math.asin(u)) < force / limit(load):
            low = u
        else:
            high = u
    return 2 * strength * contact_radius(load) / shear * low


folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
noise = random.Random(46)
with open(os.path.join(folder, "lens_static_shift.csv"), "w", encoding="utf-8") as table:
    table.write(source + "normal_force [N], tangential_force [N], shift [um]\n")
    for load in (0.1, 0.3, 1.0):
        for k in range(1, 9):
            force = round(0.11 * k * limit(load), 4)
            table.write(f"{load}, {force:.4f}, {1e6 * shift(load, force) + noise.gauss(0, 1):.2f}\n")
with open(os.path.join(folder, "lens_sliding.csv"), "w", encoding="utf-8") as table:
    table.write(source + "normal_force [N], sliding_force [N]\n")
    for load in (0.05, 0.1, 0.2, 0.4, 0.8, 1.2):
        table.write(f"{load}, {limit(load) + noise.gauss(0, 0.02):.4f}\n")
with open(os.path.join(folder, "lens_one_load_shift.csv"), "w", encoding="utf-8") as table:
    table.write(source + "tangential_force [N], shift [um], shift_error [um]\n")
    for k in range(1, 7):
        force = round(0.12 * k * limit(0.5), 4)
        true = 1e6 * shift(0.5, force)
        table.write(f"{force:.4f}, {true * (1 + noise.gauss(0, 0.03)):.2f}, {0.03 * true:.2f}\n")
with open(os.path.join(folder, "lens_one_load_sliding.csv"), "w", encoding="utf-8") as table:
    table.write(source + "normal_force [N], sliding_force [N], sliding_force_error [N]\n")
    for _ in range(3):
        table.write(f"0.5, {limit(0.5) * (1 + noise.gauss(0, 0.03)):.4f}, {0.03 * limit(0.5):.4f}\n")
