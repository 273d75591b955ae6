"""docs/explanation/rolling.md, docs/explanation/contact-program.md."""

import subprocess
import sys

from .common import CASES, ROOT, table


@table("docs/explanation/rolling.md", "| cells in a | `bem` | CONTACT |", cheap=True)
def rolling_spin(program):
    # What CONTACT prints for these grids.
    published = {10: "4.628", 40: "4.654"}
    rows = []
    for cells in (10, 20, 40):
        steady = program.roll(CASES / "rolling_spin.toml", f"bem.cells_per_radius={cells}",
                              "tractive_rolling.distance=0.01")["models"][0]["steady"]
        rows.append([f"{cells}", f"{steady['tangential_force_N'][1]:.3f}", published.get(cells, "")])
    return rows


@table("docs/explanation/rolling.md", "| v | v tau/a | W/F_N of `bem` | Hunter |", cheap=True)
def rolling_resistance(program):
    half_width = program.check(CASES / "rolling_relaxing.toml")["a"] * 1e3  # [mm]
    rows = []
    for speed in (5, 20, 80):
        found = program.roll(CASES / "rolling_relaxing.toml", f'tractive_rolling.speed="{speed} mm/s"',
                             "tractive_rolling.distance=0.01")
        steady = found["models"][0]["steady"]
        hunter = next(one["resistance_ratio"] for one in found["resistances"] if one["theory"] == "hunter")
        rows.append([f"{speed} mm/s", f"{speed * .05 / half_width:.2f}",  # tau = eta/G2 = 50 ms
                     f"{steady['resistance_N'] / steady['normal_force_N']:.5f}", f"{hunter:.5f}"])
    return rows


@table("docs/explanation/rolling.md", "| creepage | `bem` | CONTACT | sticking cells of 81, both |", cheap=True)
def falling_friction(program):
    # What CONTACT prints as FX/(FSTAT FN), rev. 2707: the first in its own example.
    published = {".0009999": "0.5941", ".002": "0.8067", ".003": "0.7625", ".006": "0.6638"}
    rows = []
    for creepage, force in published.items():
        steady = program.roll(CASES / "rolling_falling_friction.toml",
                              f"tractive_rolling.longitudinal_creepage=-0{creepage}")["models"][0]["steady"]
        rows.append([f"0{creepage}", f"{-steady['force_ratio']:.4f}", force, f"{81 * steady['stick_share']:.0f}"])
    return rows


@table("docs/explanation/rolling.md", "| nu | f_T = 0.1 | 0.3 | 0.56 | 0.8 | thesis (2.2.31) |")
def creep_ratio(program):
    text = subprocess.run([ROOT / "scripts/creep_ratio.sh", program.path], check=True, capture_output=True, text=True).stdout
    found = [line.split() for line in text.splitlines()[1:]]
    return [[nu, *(f"{float(one[5]):.3f} ± {float(one[6]):.3f}" for one in found if one[0] == nu),
             f"{next(float(one[7]) for one in found if one[0] == nu):.3f}"] for nu in ("0", "0.25", "0.3", "0.5")]


# --- docs/explanation/contact-program.md -----------------------------------------------------------------------------------

@table("docs/explanation/contact-program.md", "| Example | Quantity | Case | Tricontact | CONTACT | Difference | Reason |")
def contact_examples(program):
    text = subprocess.run([sys.executable, ROOT / "scripts/contact_examples.py", program.path], check=True, capture_output=True,
                          text=True).stdout
    return [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in text.splitlines()[2:] if line.startswith("|")]
