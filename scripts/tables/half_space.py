"""docs/explanation/half-space-deviation.md."""

from .common import CASES, figures, table

LAYER = CASES / "rig_layer_parallel.toml"
QUANTITIES = {"contact_radius": "a", "indentation": "d", "peak_pressure": "p0", "unit_shift": "U_max", "normal_stiffness": "dF_N/dd",
              "tangential_stiffness": "dF_T/dU", "limit_tangential_ratio": "f_T,lim", "limit_amplitude_ratio": "w_lim"}


@table("docs/explanation/half-space-deviation.md", "| | bonded, nu = 0 | nu = 0.3 | nu = 0.45 | nu = 0.5 | frictionless, any nu |", cheap=True)
def needed_thickness(program):
    curves = program.call("deviation", LAYER, (), "--no-runs", outputs=["deviation.json"])["curves"]
    columns = [next(one["needed"] for one in curves if one["base"] == base and one["poisson"] == nu)
               for base, nu in (("bonded", 0), ("bonded", .3), ("bonded", .45), ("bonded", .5), ("frictionless", .5))]
    return [[name, *(", ".join(figures(needed["thickness_ratio"]) if needed["thickness_ratio"] else "-"
                               for needed in column.get(key, [])) for column in columns)] for key, name in QUANTITIES.items()]
