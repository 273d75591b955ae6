#!/usr/bin/env python3
"""Writes the tables of numbers in the documents again, each from the commands that compute it.

usage: document_tables.py [--program PROGRAM] [--check] [--cheap] [NAME]...

A table stands in its document between `<!-- table: NAME -->` and `<!-- end of table -->`. Without names all tables are
written; --cheap takes those alone that are computed within seconds; --check writes nothing, and fails (exit code 1) where
a document says something else. --list prints the names.
"""

import argparse
import csv
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASES = ROOT / "examples/cases"
TABLES = {}


class Program:
    """The program's answers as its files have them."""

    def __init__(self, path):
        self.path = Path(path).resolve()

    def call(self, command, file, settings, *arguments, output="summary.json"):
        with tempfile.TemporaryDirectory() as folder:
            sets = [part for one in settings for part in ("--set", one)]
            subprocess.run([self.path, command, file, *arguments, *sets, "--output", folder + "/out", "--quiet"],
                           cwd=folder, check=True, stdout=subprocess.DEVNULL)
            text = (Path(folder) / "out" / output).read_text()
        return list(csv.DictReader(text.splitlines())) if output.endswith(".csv") else json.loads(text)

    def run(self, file, *settings, models):
        """The models of summary.json, by their names."""
        return self.call("run", file, ["output.vtk=none", *settings], "--models", models, "--no-report",
                         "--no-studies")["models"]

    def sweep(self, study):
        """The rows of results.csv."""
        return self.call("sweep", study, [], "--no-report", output="results.csv")


def table(document, header, cheap=False):
    """Declares a table: the function gives its rows as lists of texts."""
    def declare(rows):
        TABLES[rows.__name__] = {"document": ROOT / document, "header": header, "rows": rows, "cheap": cheap}
        return rows
    return declare


def short(number, digits=3):
    """.258, -.0016: without the zero before the point, as the documents write it."""
    text = f"{number:.{digits}f}"
    return text.replace("0.", ".", 1) if abs(number) < 1 else text


def power(number, digits=2):
    """1.3e-2."""
    if number == 0:
        return "0"
    exponent = math.floor(math.log10(abs(number)) + 1e-12)
    text = f"{number / 10.**exponent:.{digits - 1}f}"
    if abs(float(text)) >= 10:
        exponent += 1
        text = f"{number / 10.**exponent:.{digits - 1}f}"
    return f"{text}e{exponent}"


# --- docs/models/bem.md ------------------------------------------------------------------------------------------------

RIG = CASES / "rig_sphere_parallel.toml"


def hertz(radius=.04, young=5.2e6, poisson=.5, force=21.1, mu=.57, ratio=.56):
    """Johnson (1985), ch. 4, and Cattaneo and Mindlin: a, d [m], p0 [Pa], static shift [m]."""
    modulus = young / (1 - poisson ** 2)
    a = (3 * force * radius / (4 * modulus)) ** (1 / 3)
    shear = 4 * young / (2 * (1 + poisson)) / (2 - poisson)
    shift = mu * modulus / shear * a * a / radius * (1 - (1 - ratio) ** (2 / 3))
    return a, a * a / radius, 1.5 * force / (math.pi * a * a), shift


@table("docs/models/bem.md", "| Cells in a | a | d | p0 | static shift |", cheap=True)
def bem_static(program):
    names = ["contact_radius_m", "indentation_m", "peak_pressure_Pa", "static_shift_m"]
    rows = []
    for cells in ("11.25", "22.5", "45", "90"):
        found = program.run(static_case(program), f"bem.cells_per_radius={cells}", models="bem")["bem"]
        rows.append([cells, *(power(found[name] / exact - 1) for name, exact in zip(names, hertz()))])
    found = program.run(static_case(program), models="mdr")["mdr"]
    rows.append(["`mdr`, 10000 springs", *(power(found[name] / exact - 1, 1) for name, exact in zip(names, hertz()))])
    return rows


def static_case(_):
    """The rig's sphere as a paraboloid, pressed and pulled, not rolled: written once into a folder of its own."""
    if not hasattr(static_case, "folder"):
        static_case.folder = tempfile.TemporaryDirectory()
        (Path(static_case.folder.name) / "static.toml").write_text("""models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
""")
    return Path(static_case.folder.name) / "static.toml"


@table("docs/models/bem.md", "| `bem.spacing` | u_sd | | `mdr.springs` | u_sd | kappa - 3/2 |", cheap=True)
def bem_settled(program):
    until = ["rolling.steps=turning-points", "rolling.periods=200"]
    rows = []
    for spacing, springs in (("0.4 mm", "100"), ("0.2 mm", "1000"), ("0.1 mm", "10000")):
        bem = program.run(RIG, f"bem.spacing={spacing}", *until, models="bem")["bem"]
        mdr = program.run(RIG, f"mdr.springs={springs}", *until, models="mdr")["mdr"]
        rows.append([spacing, short(bem["final_shift_ratio"], 5), "", springs, short(mdr["final_shift_ratio"], 6),
                     power(mdr["kappa"] - 1.5, 1)])
    return rows


@table("docs/models/bem.md", "| `rolling.increment` | `bem` | `mdr` |")
def bem_ratcheting(program):
    rows = []
    for step in ("0.4 mm", "0.2 mm", "0.1 mm", "0.05 mm"):
        models = program.run(CASES / "rig_sphere_parallel_ratcheting.toml", f"rolling.increment={step}",
                             models="mdr,bem")
        rows.append([step, *(short(models[name]["shift_increment_ratio"], 4) for name in ("bem", "mdr"))])
    return rows


# --- docs/superposed.md ------------------------------------------------------------------------------------------------

def oscillating(program, study, amplitude, phase, ratios):
    """Rows by amplitude and phase: shift of mdr and bem at each ratio, or Delta u where it ratchets."""
    found = program.sweep(ROOT / "examples/studies" / study)
    rows = []
    for r in sorted({float(one[amplitude]) for one in found}):
        phases = sorted({one[phase] for one in found}, key=float)
        for angle in phases[:1] if r == 0 else phases:
            row = [short(r, 1) if r else "0", f"{math.degrees(float(angle)):.0f} deg" if r else ""]
            limit = None
            for ratio in ratios:
                for model in ("mdr", "bem"):
                    one = next(x for x in found if x["model"] == model and float(x[amplitude]) == r and
                               x[phase] == angle and math.isclose(float(x["load.tangential_ratio"]), ratio))
                    limit = one["limit_tangential_ratio"] if model == "bem" else limit
                    row.append(short(float(one["final_shift_ratio"])) if one["state"] != "ratcheting" else
                               f"ratchets, {short(float(one['shift_increment_ratio']), 4)} per period")
            rows.append((row, limit))
    return rows


@table("docs/superposed.md", "| Amplitude over F_N | Phase | f_T,lim (`bem`) | u at f_T = .30: `mdr` | `bem` "
       "| u at f_T = .56: `mdr` | `bem` |")
def oscillating_normal(program):
    rows = oscillating(program, "oscillating_normal_force.toml", "load.normal_amplitude_ratio", "load.normal_phase",
                       (.3, .56))
    return [[*row[:2], short(float(limit)), *row[2:]] for row, limit in rows]


@table("docs/superposed.md", "| Amplitude r | Phase | u at f_T = .30: `mdr` | `bem` | u at f_T = .50: `mdr` | `bem` |")
def oscillating_tangential(program):
    return [row for row, _ in oscillating(program, "oscillating_tangential_force.toml",
                                          "load.tangential_amplitude_ratio", "load.tangential_phase", (.3, .5))]


# --- docs/limits.md ----------------------------------------------------------------------------------------------------

@table("docs/limits.md", "| Model | w | last shakedown | first ratcheting | by pressures | closed form |")
def limits(program):
    rows = []
    for model, w, angle in (("mdr", .24, 0), ("mdr", .51, 0), ("bem", .51, 0), ("bem", .24, 90)):
        answer = program.call("limit", RIG, [f"rolling.amplitude_ratio={w}", f"rolling.angle={angle} deg"], "--models",
                              model, output="limit.csv")[0]
        digits = 7 if model == "mdr" else 5
        exact = 1 - 1.5 * w + .5 * w ** 3
        rows.append([f"`{model}`" + (", across" if angle else ""), f"{w}",
                     *(f"{float(answer[name]):.{digits}f}" for name in ("last_shakedown", "first_ratcheting", "limit_by_pressures")),
                     f"{exact:.{digits}f}"])
    return rows


def text_of(one, rows):
    lines = [one["header"], "|" + "---|" * (one["header"].count("|") - 1)]
    return "".join(line + "\n" for line in [*lines, *("| " + " | ".join(row) + " |" for row in rows)]).replace("|  |", "| |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--program", default=ROOT / "build/release/app/tricontact")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--cheap", action="store_true")
    parser.add_argument("--list", action="store_true")
    given = parser.parse_args()
    if unknown := set(given.names) - set(TABLES):
        parser.error(f"no table {', '.join(sorted(unknown))}; there are {', '.join(TABLES)}")
    if given.list:
        print("\n".join(TABLES))
        return 0
    program = Program(given.program)
    differing = 0
    for name, one in TABLES.items():
        if (given.names and name not in given.names) or (given.cheap and not one["cheap"]):
            continue
        document = one["document"].read_text()
        place = re.compile(rf"(<!-- table: {name} -->\n)(.*?)(<!-- end of table -->)", re.S)
        if not place.search(document):
            sys.exit(f"{one['document']}: no <!-- table: {name} -->")
        text = text_of(one, one["rows"](program))
        new = place.sub(lambda found, text=text: found[1] + text + found[3], document)
        if given.check and new != document:
            differing += 1
            print(f"{one['document']}: table {name} has other numbers than its command:\n{text}")
        elif not given.check:
            one["document"].write_text(new)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
