#!/usr/bin/env python3
"""Imports the examples of module 3 that the program CONTACT ships, computes them, and prints both programs' numbers.

usage: contact_examples.py [PROGRAM] [FOLDER] [EXAMPLE]...

PROGRAM: tricontact (build/release/app/tricontact). FOLDER: the examples (tests/contact_program of the sources, or
those of CONTACT itself). The table (Markdown) is that of docs/explanation/contact-program.md.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

# What CONTACT prints (examples/*.ref_out of github.com/eve70a/CONTACT, the same in the versions of 10 May 2023 and 23 July 2025): forces and moment on
# body 1 [N, N mm], CREEP X, APPROACH and SHIFT [mm], PMAX [N/mm^2], FRIC.POWER [W], MAX(T1,T2) [C], elements. `sign`: -1 where the
# contact rolls towards -x, `speed` VELOC [mm/s], `cell` DX DY [mm^2].
STEADY = {
    "bentall": dict(sign=-1, speed=1000, cell=1, cases={
        2: dict(CREEPX=5.260e-4, APPROACH=2.081e-3, PMAX=103.1, POWER=-1.156e-4, NCON=200),
        3: dict(CREEPX=3.591e-4, APPROACH=2.080e-3, PMAX=103.8, NCON=200, NADH=200),
        4: dict(CREEPX=4.294e-4, APPROACH=2.080e-3, PMAX=103.6, POWER=-9.475e-3, NCON=200, NADH=125),
        5: dict(CREEPX=2.108e-4, APPROACH=2.080e-3, PMAX=103.2, POWER=-.1955, NCON=200, NADH=36),
        6: dict(CREEPX=5.392e-4, APPROACH=2.081e-3, PMAX=103.3, POWER=-4.418e-2, NCON=201, NADH=106)}),
    "carter2d": dict(sign=1, speed=30000, cell=8, cases={
        1: dict(FX=6955, APPROACH=6.492e-3, PMAX=113.9, POWER=-47.62, NCON=50, NADH=30)}),
    "conformal": dict(sign=1, speed=30000, cell=.16, cases={
        1: dict(FN=1.000e5, FX=9144, FY=2.592e4, MZ=3.860e4, PMAX=912.8,
                POWER=-1.055e4, NCON=1027)}),
    "ertz_temperature": dict(sign=-1, speed=30000, cell=.1, cases={
        1: dict(FX=3.000e4, APPROACH=8.190e-2, PMAX=770.6, POWER=-2.994e4, NCON=1969, MAXT=166.8),
        2: dict(MAXT=75.00), 3: dict(MAXT=241.8),
        4: dict(FX=2.182e4, FY=-4476, MZ=-4.626e4, APPROACH=8.190e-2, PMAX=770.6, POWER=-1672,
                NCON=1969, NADH=770, MAXT=90.85)}),
    "fastsim": dict(sign=1, speed=30000, cell=.08, cases={
        1: dict(FY=-1.494e4, MZ=-4.821e4, APPROACH=9.266e-2, PMAX=1223, POWER=-540.4, NCON=1276,
                NADH=356)}),
    "tractcurv": dict(sign=1, speed=10000, cell=.2889 * .6304, cases={
        1: dict(FX=-247.0, APPROACH=7.651e-2, PMAX=640.7, NCON=1384, NADH=1382),
        2: dict(FX=-9112, POWER=-29.67, NCON=1384, NADH=1182),
        3: dict(FX=-1.670e4, POWER=-120.7, NCON=1384, NADH=976),
        31: dict(FX=-65.81, APPROACH=7.651e-2, PMAX=640.7, POWER=-4.017e-5, NCON=1384, NADH=1382),
        38: dict(FX=-2.911e4, POWER=-1922, NCON=1384, NADH=624),
        47: dict(FX=-3.326e4, POWER=-5183, NCON=1384, NADH=128),
        60: dict(FX=-2.002e4, POWER=-4.999e4, NCON=1384, NADH=0)}),
    "veldep_fric": dict(sign=1, speed=45000, cell=20, cases={
        1: dict(FX=1.109e5, APPROACH=8.879e-2, PMAX=495.3, POWER=-4849, NCON=81, NADH=45)}),
    "visc_cylindr": dict(sign=1, speed=1000, cell=160, cases={
        1: dict(CREEPX=1.378e-2, APPROACH=2.508, PMAX=60.32, POWER=-1438, NCON=80, NADH=51),
        2: dict(CREEPX=1.365e-2, APPROACH=2.367, PMAX=78.74, POWER=-913.7, NCON=62, NADH=37),
        3: dict(CREEPX=1.152e-2, APPROACH=2.063, PMAX=84.72, POWER=-952.0, NCON=57, NADH=36),
        4: dict(CREEPX=9.932e-3, APPROACH=1.455, PMAX=85.31, POWER=-1010, NCON=56, NADH=35)}),
}
# After the last case of a sequence: APPROACH [mm], ELAST.EN. [J], the sum of the shifts [mm].
SHIFTS = {
    "cattaneo": dict(cell=.13333 ** 2, cases={
        2: dict(APPROACH=1.998e-2, SHIFT=8.155e-3, ENERGY=8.525e-5, NCON=177, NADH=45)}),
    "spence35": dict(cell=.04, cases={1: dict(APPROACH=9.874e-2, ENERGY=1.847e-5, NCON=921, NADH=225)}),
}
# catt_to_cart: shift of each rolled step [mm] in fixed coordinates, cases 59 to 73.
ROLLED_SHIFTS = [4.548e-4, 4.705e-4, 4.886e-4, 5.125e-4, 5.349e-4, 5.552e-4, 5.835e-4, 6.069e-4, 6.377e-4, 6.690e-4,
                 7.003e-4, 7.419e-4, 7.960e-4, 8.508e-4, 8.505e-4]
# plastic_3bl: force on body 1 [N] and elastic energy [J] after each case; five sequences begin at these.
YIELDED_FORCES = [84.97, 280, 560, 560, 560, 560, 560, 560, 560, 560, 560, 560, 560, 560, 200, 216, 232, 248, 262.4,
                  262.4, 82.43, 82.43, 266.4, 284, 304, 324.1, 344.1, 364.1, 384.1, 404.1, 424.1, 200, 400, 390, 380,
                  370, 360, 350, 340, 330, 320.1, 310.1, 300.1, 290.1, 20, 20.8, 21.6, 22.6, 23.6, 24.6, 25.6, 26.6,
                  27.6, 28.6, 29.6, 30.6, 31.6]
YIELDED_ENERGIES = [0.004033, 0.008891, 0.02359, 0.02359, 0.02359, 0.02359, 0.02359, 0.02359, 0.02359, 0.02359,
                    0.02359, 0.02359, 0.02359, 0.02359, 0.007991, 0.008657, 0.009374, 0.01014, 0.01088, 0.01088,
                    0.00467, 0.00467, 0.01109, 0.01206, 0.01324, 0.01449, 0.01583, 0.01725, 0.01874, 0.02032,
                    0.02198, 0.006491, 0.01399, 0.0135, 0.01302, 0.01255, 0.01209, 0.01165, 0.01122, 0.0108, 0.01039,
                    0.009999, 0.009618, 0.009249, 0.004191, 0.004207, 0.004224, 0.004246, 0.004269, 0.004293,
                    0.004318, 0.004344, 0.004371, 0.0044, 0.004429, 0.004459, 0.00449]
# Where both differ in more than printed digits.
REASONS = {
    "conformal": "spin is taken at 0.1747 of a cell ahead, there at 1/6",
    "ertz_temperature": "there each cell heats itself twice; its sum over this field has its digits",
    "fastsim": "spin is taken at 0.1747 of a cell ahead, there at 1/6",
}
VISIBLE = 2e-3  # relative difference for which a reason is given
EXAMPLES = ["bentall", "carter2d", "catt_to_cart", "cattaneo", "conformal", "ertz_temperature", "fastsim",
            "plastic_3bl", "spence35", "subsurf", "tractcurv", "veldep_fric", "visc_cylindr"]


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout


def history(folder):
    with open(folder / "bem" / "history.csv", encoding="utf-8") as file:
        return [{key: float(value or "inf") for key, value in row.items()} for row in csv.DictReader(file)]


class Comparison:
    """Rows of one example, a quantity each: what one program has beside the other."""

    def __init__(self, example):
        self.example = example
        self.found = {}  # quantity: [(difference, case, ours, theirs)]

    def add(self, case, reference, name, ours, factor=1, scale=None):
        """`factor`: ours in the units and with the sign of CONTACT. `scale` of the difference, where not the value."""
        if name in reference:
            theirs, ours = reference[name], ours * factor
            difference = (ours - theirs) / (abs(theirs) if scale is None else scale)
            self.found.setdefault(name, []).append((difference, case, ours, theirs))

    def print(self):
        """Of each quantity the case that differs most."""
        for name, cases in self.found.items():
            difference, case, ours, theirs = max(cases, key=lambda found: abs(found[0]))
            all_of = [str(found[1]) for found in cases]
            few = all_of if len(all_of) < 10 else [f"{all_of[0]} to {all_of[-1]}"]
            of = f"{case}" if len(cases) == 1 else f"{case} of {', '.join(few)}"
            reason = REASONS.get(self.example, "") if abs(difference) > VISIBLE else ""
            row = [self.example, name, of, f"{ours:.4g}", f"{theirs:.4g}", f"{100 * difference:.2f} %", reason]
            print("| " + " | ".join(row) + " |")


def compare_steady(rows, case, summary):
    of = STEADY[rows.example]
    reference = of["cases"][case]
    state = summary["models"][0]["steady"]
    normal, sign = state["normal_force_N"], of["sign"]
    rows.add(case, reference, "FN", normal)
    rows.add(case, reference, "FX", state["tangential_force_N"][0], -sign)
    rows.add(case, reference, "FY", state["tangential_force_N"][1], -sign)
    rows.add(case, reference, "MZ", state["spin_moment_Nm"], -1e3)
    rows.add(case, reference, "CREEPX", state["longitudinal_creepage"], sign)
    rows.add(case, reference, "APPROACH", state["indentation_m"], 1e3)
    rows.add(case, reference, "PMAX", state["peak_pressure_Pa"], 1e-6)
    rows.add(case, reference, "MAXT", state["highest_temperature_degC"])
    rows.add(case, reference, "POWER", state["dissipation_J_per_m"], -1e-3 * of["speed"])
    cells = 1e6 * state["contact_area_m2"] / of["cell"]
    rows.add(case, reference, "NCON", cells)
    rows.add(case, reference, "NADH", cells * state["stick_share"], scale=reference.get("NCON"))


def compare_shifts(rows, case, folder):
    of = SHIFTS[rows.example]
    reference = of["cases"][case]
    last = history(folder)[-1]
    rows.add(case, reference, "APPROACH", last["indentation_m"], 1e3)
    rows.add(case, reference, "SHIFT", last["shift_x_m"], 1e3)
    rows.add(case, reference, "ENERGY", last["stored_energy_J"])
    rows.add(case, reference, "NCON", last["contact_area_m2"], 1e6 / of["cell"])
    rows.add(case, reference, "NADH", last["stick_area_m2"], 1e6 / of["cell"], reference["NCON"])


def compare_rolled(rows, case, folder):
    """A step of catt_to_cart: in the frame that moves along, or in a fixed one."""
    states = history(folder)
    for step in (5, 10, 15):
        reference = {"SHIFT": ROLLED_SHIFTS[step - 1]}
        if "longitudinal_creepage" in states[0]:
            rows.add(case + step, reference, "SHIFT", states[step]["longitudinal_creepage"], .25)
        else:
            first = len(states) - 57  # the loaded state, then 56 steps
            rows.add(case + step, reference, "SHIFT", states[first + step]["shift_x_m"] - states[first + step - 1]["shift_x_m"], 1e3)


def compare_yielded(rows, case, folder):
    """All steps of a sequence of plastic_3bl, the last states of its history."""
    states = history(folder)
    beginnings = [1, 2, 15, 32, 45, len(YIELDED_FORCES) + 1]
    n = beginnings[beginnings.index(case) + 1] - case
    for step, state in enumerate(states[-n:]):
        at = case + step - 1
        reference = {"FX": YIELDED_FORCES[at], "ENERGY": YIELDED_ENERGIES[at]}
        rows.add(case + step, reference, "FX", state["tangential_force_x_N"], -1)
        rows.add(case + step, reference, "ENERGY", state["stored_energy_J"])


def computed(program, case_file, folder):
    rolls = "[tractive_rolling]" in case_file.read_text(encoding="utf-8")
    command = ["run", case_file, "--points", 0] if rolls else ["run", case_file]
    run(program, *command, "--no-report", "--quiet", "--output", folder)
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def compare(program, folder, example, work):
    cases = work / example
    done = subprocess.run([program, "contact", "import", folder / f"{example}.inp", "--output", cases], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        reason = done.stderr.strip().removeprefix("error: ")
        print(f"| {example} | | | | | not imported | {reason[reason.find('.inp:') + 1:]} |")
        return
    rows = Comparison(example)
    for case_file in sorted(cases.glob("*.toml")):
        digits = case_file.stem.removeprefix(example).removeprefix("_")
        case = int(digits) if digits else 1
        known = [*STEADY.get(example, SHIFTS.get(example, {"cases": {}}))["cases"]]
        if case not in known and example not in ("catt_to_cart", "plastic_3bl"):
            continue
        result = work / f"{case_file.stem}_result"
        summary = computed(program, case_file, result)
        if example in STEADY:
            compare_steady(rows, case, summary)
        elif example in SHIFTS:
            compare_shifts(rows, case, result)
        elif example == "plastic_3bl":
            compare_yielded(rows, case, result)
        else:
            compare_rolled(rows, case, result)
    rows.print()


def main(arguments):
    root = pathlib.Path(__file__).resolve().parent.parent
    program = pathlib.Path(arguments[0] if arguments else root / "build/release/app/tricontact").resolve()
    folder = pathlib.Path(arguments[1] if len(arguments) > 1 else root / "tests/contact_program")
    print("| Example | Quantity | Case | Tricontact | CONTACT | Difference | Reason |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as work:
        for example in arguments[2:] or EXAMPLES:
            compare(program, folder, example, pathlib.Path(work))


if __name__ == "__main__":
    main(sys.argv[1:])
