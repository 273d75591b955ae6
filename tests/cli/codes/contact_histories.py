#!/usr/bin/env python3
"""Histories drawn at random, with twist and motion, are written for the program CONTACT and read back from their numbers
alone, the case itself cut off: both give the same forces.

usage: contact_histories.py PROGRAM SEED N
"""

import csv
import pathlib
import random
import subprocess
import sys
import tempfile

ALLOWED = 1e-9  # of mu F_N: both solve the same cells to bem.tolerance, 1e-11
CASE = """models = ["bem"]
[indenter]
radius = "40 mm"
{indenter}
[substrate]
young = "5.2 MPa"
poisson = {poisson}
[friction]
coefficient = {friction}
[bem]
cells_per_radius = {cells}
tolerance = 1e-11
{shape}
[output]
vtk = "none"
[path]
steps = 0
centre_of_rotation = "{frame}"
centre_x = "{centre_x} mm"
centre_y = "{centre_y} mm"
table = \"\"\"
{table}\"\"\"
"""


def case(draw):
    """A path of two to five rows: forces within the friction limit, shifts, twists, places."""
    friction = round(draw.uniform(.2, .8), 3)
    kinds = draw.choice(["forces", "one of each", "shifts"])
    names = ["normal_force [N]", "rotation [mrad]", "offset_x [mm]", "offset_y [mm]",
             "tangential_force_x [N]" if kinds != "shifts" else "shift_x [um]",
             "tangential_force_y [N]" if kinds == "forces" else "shift_y [um]"]
    rows = []
    for row in range(draw.randint(2, 5)):
        normal = draw.uniform(10, 30)
        values = [normal, 0 if row == 0 else draw.uniform(-20, 20), draw.uniform(-2, 2), draw.uniform(-2, 2)]
        for name in names[4:]:
            values.append(0 if row == 0 else draw.uniform(-.6, .6) * friction * normal if "force" in name
                          else draw.uniform(-60, 60))
        rows.append(", ".join(f"{value:.6g}" for value in values))
    coupled = draw.random() < .5
    elastic = draw.random() < .3
    return CASE.format(
        indenter='young = "20 MPa"\npoisson = 0.4' if elastic else "", poisson=.3 if coupled else .5,
        friction=friction, cells=draw.choice([6, 7.3, 8]), frame=draw.choice(["indenter", "substrate"]),
        shape=f"cell_ratio = {draw.choice([.5, 1.7])}" if draw.random() < .3 else "",
        centre_x=round(draw.uniform(-9, 9), 3), centre_y=round(draw.uniform(-9, 9), 3),
        table="\n".join([", ".join(names), *rows]) + "\n"), friction


def columns(folder):
    with open(folder / "bem" / "history.csv", encoding="utf-8") as file:
        return [[float(row[name]) for name in ("normal_force_N", "tangential_force_x_N", "tangential_force_y_N")]
                for row in csv.DictReader(file)]


def difference(program, seed, folder):
    """Largest difference of a force over mu F_N."""

    def run(*arguments):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=folder, check=False)
        if done.returncode != 0:
            raise ValueError(f"{' '.join(map(str, arguments))}: {done.stderr.strip()}")

    text, friction = case(random.Random(seed))
    (folder / "drawn.toml").write_text(text)
    run("contact", "export", "drawn.toml", "--models", "bem", "--output", "out")
    numbers = (folder / "out" / "drawn.inp").read_text().split("% Case of Tricontact")
    if len(numbers) != 2:
        raise ValueError("the case does not stand in the file")
    (folder / "plain.inp").write_text(numbers[0])
    run("contact", "import", "plain.inp", "--output", "back")
    for name in ("drawn.toml", "back/plain.toml"):
        run("run", name, "--no-studies", "--no-report", "--quiet", "--output", f"run_{pathlib.Path(name).stem}")
    ours, back = columns(folder / "run_drawn"), columns(folder / "run_plain")
    if len(ours) != len(back):
        raise ValueError(f"{len(ours)} steps became {len(back)}")
    return max(abs(a - b) / (friction * one[0]) for one, two in zip(ours, back) for a, b in zip(one, two))


def main():
    program, seed, n = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]), int(sys.argv[3])
    worst, failures, refused = 0, 0, 0
    for k in range(n):
        with tempfile.TemporaryDirectory() as folder:
            try:
                found = difference(program, seed * 1000 + k, pathlib.Path(folder))
            except ValueError as why:
                # Loads that slide the contact belong to no case.
                if "friction limit" in str(why):
                    refused += 1
                    continue
                print(f"FAILED: {seed * 1000 + k}: {why}")
                failures += 1
                continue
        worst = max(worst, found)
        if found > ALLOWED:
            print(f"FAILED: {seed * 1000 + k}: forces differ by {found:.1e} of mu F_N")
            failures += 1
    print(f"{n - refused} histories, {refused} that slide, largest difference {worst:.1e} of mu F_N, {failures} failures")
    sys.exit(failures > 0 or refused > n / 2)


if __name__ == "__main__":
    main()
