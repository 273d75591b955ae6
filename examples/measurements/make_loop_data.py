#!/usr/bin/env python3
"""Writes fretting_loops.csv in this folder, not measured: crossed cylinders of steel, R = 10 mm, E = 200 GPa
below and 206 GPa above, nu = 0.3, in a rig of 30 N/um in series, under 300 and 600 N with amplitudes of 10 and
40 um. mu rises by 12 % of its mean 0.6 from cycle 1 to cycle 200. Springs of the method of dimensionality
reduction (Popov and Hess 2015) that stick or slip, driven step by step; force and shift have offsets, and noise
from a stated seed.
usage: make_loop_data.py [FOLDER]"""
import math
import os
import random
import sys

radius, above, below, poisson = 10e-3, 206e9, 200e9, 0.3
friction, drift, rig = 0.6, 0.12, 30e6
cycles = [1, 50, 100, 150, 200]
n_springs, n_rows = 200, 48
plane = 1 / ((1 - poisson ** 2) * (1 / above + 1 / below))
shear = 1 / ((2 - poisson) * (1 + poisson) / 2 * (1 / above + 1 / below))  # 1/G* = sum of (2 - nu)/(4 G)
source = ("# Synthetic, no measurement: crossed cylinders of steel, R = 10 mm, E = 200 GPa and 206 GPa, k_rig = 30 N/um,\n"
          "# mu = 0.6, rising by 12 % over the cycles; noise 3 N and 0.05 um, seed 48; made by make_loop_data.py.\n")


class Contact:
    def __init__(self, load):
        self.load = load
        a = (0.75 * load * radius / plane) ** (1 / 3)
        places = [a * (i + 0.5) / n_springs for i in range(n_springs)]
        bounds = [a * a - x * x for x in places]
        self.bounds = [load * b / sum(bounds) for b in bounds]
        self.stiffness = 2 * shear * a / n_springs
        self.forces = [0.0] * n_springs
        self.shift = 0.0

    def moved(self, shift, mu):
        step = self.stiffness * (shift - self.shift)
        return [max(-mu * b, min(mu * b, f + step)) for f, b in zip(self.forces, self.bounds)]

    def drive(self, to, mu):
        """The force when the drive, behind the rig's spring, is there."""
        reach = abs(to) + mu * self.load / rig
        low, high = -reach, reach
        for _ in range(45):
            middle = (low + high) / 2
            if sum(self.moved(middle, mu)) > rig * (to - middle):
                high = middle
            else:
                low = middle
        self.forces, self.shift = self.moved(low, mu), low
        return sum(self.forces)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    noise = random.Random(48)
    with open(os.path.join(folder, "fretting_loops.csv"), "w") as file:
        file.write(source)
        file.write("cycle, shift [um], tangential_force [N], normal_force [N], amplitude [um]\n")
        for load in (300, 600):
            for amplitude in (10e-6, 40e-6):
                contact = Contact(load)
                for i in range(1, 41):
                    contact.drive(amplitude * i / 40, friction)
                for cycle in [0] + cycles:
                    mu = friction * (1 + drift * (max(cycle, 1) - 100.2) / 199)
                    for i in range(1, n_rows + 1):
                        to = amplitude * math.cos(2 * math.pi * i / n_rows)
                        force = contact.drive(to, mu)
                        if cycle == 0:
                            continue
                        file.write("%d, %.3f, %.2f, %g, %g\n" % (
                            cycle, 1e6 * to + 3.2 + 0.002 * cycle + noise.gauss(0, 0.05),
                            force + 4.5 + noise.gauss(0, 3), load, 1e6 * amplitude))


main()
