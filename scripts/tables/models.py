"""docs/explanation/models/bem.md, mdr.md and common.md."""

import math
import tempfile
from pathlib import Path

from .common import CASES, percent, power, short, table

RIG = CASES / "rig_sphere_parallel.toml"


def hertz(radius=.04, young=5.2e6, poisson=.5, force=21.1, mu=.57, ratio=.56):
    """Johnson (1985), ch. 4, and Cattaneo and Mindlin: a, d [m], p0 [Pa], static shift [m]."""
    modulus = young / (1 - poisson ** 2)
    a = (3 * force * radius / (4 * modulus)) ** (1 / 3)
    shear = 4 * young / (2 * (1 + poisson)) / (2 - poisson)
    shift = mu * modulus / shear * a * a / radius * (1 - (1 - ratio) ** (2 / 3))
    return a, a * a / radius, 1.5 * force / (math.pi * a * a), shift


@table("docs/explanation/models/bem.md", "| Cells in a | a | d | p0 | static shift |", cheap=True)
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


@table("docs/explanation/models/bem.md", "| `bem.spacing` | u_sd | | `mdr.springs` | u_sd | kappa - 3/2 |", cheap=True)
def bem_settled(program):
    until = ["rolling.steps=turning-points", "rolling.periods=200"]
    rows = []
    for spacing, springs in (("0.4 mm", "100"), ("0.2 mm", "1000"), ("0.1 mm", "10000")):
        bem = program.run(RIG, f"bem.spacing={spacing}", *until, models="bem")["bem"]
        mdr = program.run(RIG, f"mdr.springs={springs}", *until, models="mdr")["mdr"]
        rows.append([spacing, short(bem["final_shift_ratio"], 5), "", springs, short(mdr["final_shift_ratio"], 6),
                     power(mdr["kappa"] - 1.5, 1)])
    return rows


@table("docs/explanation/models/bem.md", "| `rolling.increment` | `bem` | `mdr` |")
def bem_ratcheting(program):
    rows = []
    for step in ("0.4 mm", "0.2 mm", "0.1 mm", "0.05 mm"):
        models = program.run(CASES / "rig_sphere_parallel_ratcheting.toml", f"rolling.increment={step}",
                             models="mdr,bem")
        rows.append([step, *(short(models[name]["shift_increment_ratio"], 4) for name in ("bem", "mdr"))])
    return rows


# --- docs/explanation/models/mdr.md -----------------------------------------------------------------------------------

@table("docs/explanation/models/mdr.md", "| Test | | | |", cheap=True)
def relaxing_springs(program):
    return [[row[0], *(f"{row[k]}: {power(float(row[k + 1]))}" for k in (1, 3, 5))]
            for row in program.tests("verification_tests", "MdrViscoelastic.*")]


# --- docs/explanation/models/common.md --------------------------------------------------------------------------------

@table("docs/explanation/models/common.md", "| Changed | static shift | settled shift | static shift, ratcheting | Du |")
def loading_variants(program):
    found = [program.call("run", CASES / "rig_layer_parallel.toml", ["output.vtk=none", *settings], "--models", "bem-layer",
                          "--no-report")["loading_variants"] for settings in ([], ["load.tangential_ratio=0.8"])]
    rows = []
    for key, text in (("load.press", '`load.press = "frictionless"`'), ("load.press_steps", "`load.press_steps = 1`"),
                      ("contact.coupling", "`contact.coupling = false`")):
        changes = [next(one[name] for one in variants if one["key"] == key)
                   for variants in found for name in ("loaded_change", "rolled_change")]
        rows.append([text, *(percent(change, 2) if abs(change) > 5e-5 else f"{power(100 * change, 1)} %" for change in changes)])
    return rows


# --- docs/explanation/accuracy.md -------------------------------------------------------------------------------------

@table("docs/explanation/accuracy.md", "| w, f_T | `mdr` | `bem` along | `bem` across the load |", cheap=True)
def settled_shifts(program):
    rows = []
    for w, f in ((.24, .24), (.24, .56), (.51, .09), (.51, .24)):
        settings = ["rolling.steps=turning-points", "rolling.periods=200", f"rolling.amplitude_ratio={w}", f"load.tangential_ratio={f}"]
        along = program.run(RIG, *settings, models="mdr,bem")
        across = program.run(RIG, *settings, 'rolling.angle="90 deg"', models="bem")
        rows.append([f"{short(w, 2)} {short(f, 2)}", *(short(one["final_shift_ratio"], 4) for one in
                                                       (along["mdr"], along["bem"], across["bem"]))])
    return rows
