"""docs/explanation/models/mdr-layer.md."""

from .common import CASES, power, short, table

LAYER = CASES / "rig_layer_parallel.toml"
EXACT = ("contact_radius_m", "indentation_m", "peak_pressure_Pa", "unit_shift_m")


@table("docs/explanation/models/mdr-layer.md", "| chi | .1 | .2 | .5 | 1 | 2 |", cheap=True)
def layer_series(program):
    return program.tests("unit_tests", "TheoryLayerSeries.ErrorsAgainstTheExactSolution")


@table("docs/explanation/models/mdr-layer.md", "| a/b | nu = .5 | radial only | coupling | nu = .3 | radial only | coupling |", cheap=True)
def sticking_contact(program):
    return program.tests("unit_tests", "TheoryStickingContact.PrintsTheTable")


@table("docs/explanation/models/mdr-layer.md", "| b, w, f_T | U_stat: `mdr-layer` | uncoupled | coupled | u_sd: `mdr-layer` | `bem-layer` "
       "parallel, uncoupled | excess parallel | perpendicular |")
def springs_beside_layer(program):
    rows = []
    for b, w, f in ((8, .24, .24), (8, .24, .56), (8, .51, .09), (8, .51, .24), (4, .24, .24), (4, .24, .56)):
        settings = [f'substrate.thickness="{b} mm"', f"rolling.amplitude_ratio={w}", f"load.tangential_ratio={f}",
                    "rolling.amplitude_reference=model", "rolling.steps=turning-points", "rolling.periods=200"]
        springs = program.run(LAYER, *settings, "contact.coupling=false", models="mdr-layer")["mdr-layer"]
        found = {(coupled, angle): program.run(LAYER, *settings, f"contact.coupling={coupled}", f'rolling.angle="{angle} deg"',
                                               models="bem-layer")["bem-layer"]
                 for coupled in ("false", "true") for angle in (0, 90)}
        def excess(angle):
            uncoupled, coupled = (100 * (springs["final_shift_ratio"] / found[one, angle]["final_shift_ratio"] - 1)
                                  for one in ("false", "true"))
            return f"{uncoupled:.0f}, {coupled:.0f} %"
        rows.append([f"{b} mm, {short(w, 2)}, {short(f, 2)}",
                     *(short(1e3 * one["static_shift_m"], 5) for one in (springs, found["false", 0], found["true", 0])),
                     short(springs["final_shift_ratio"], 4), short(found["false", 0]["final_shift_ratio"], 4), excess(0), excess(90)])
    return rows
