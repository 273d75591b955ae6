"""docs/explanation/rolling.md, docs/explanation/surface-temperatures.md, docs/explanation/contact-program.md."""

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


@table("docs/explanation/surface-temperatures.md",
       "| creepages xi, eta; spin | indenter | substrate | `bem` | cells of half the size | CONTACT |", cheap=True)
def surface_temperatures(program):
    # xi, eta, spin [1/m], bulk temperatures, and MAX(T1,T2) of CONTACT's ertz_temperature, rev. 2707; the wheel rolls towards
    # -x there.
    published = [("0.03333", "0", "0", 0, 0, "166.8"), ("0", "0", "0", 0, 150, "75.00"),
                 ("0.03333", "0", "0", 0, 150, "241.8"), ("0.002", "-0.001", "0.2", 0, 150, "90.85")]
    rows = []
    for xi, eta, spin, indenter, substrate, printed in published:
        highest = []
        for cell in (.2, .1):
            steady = program.roll(CASES / "rolling_temperature.toml", f'bem.spacing="{cell} mm"', "bem.cell_ratio=2.5",
                                  f"tractive_rolling.longitudinal_creepage={xi}", f"tractive_rolling.lateral_creepage={eta}",
                                  f'tractive_rolling.spin="{spin} rad/m"', f'indenter.heat.temperature="{indenter} degC"',
                                  f'substrate.heat.temperature="{substrate} degC"',
                                  "tractive_rolling.distance=0.01")["models"][0]["steady"]
            highest.append(f"{steady['highest_temperature_degC']:.2f}")
        rows.append([f"{xi}, {eta}" + ("" if spin == "0" else f"; {spin} rad/m"), f"{indenter}", f"{substrate}", *highest, printed])
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
