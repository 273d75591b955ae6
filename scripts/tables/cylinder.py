"""docs/explanation/cylinder.md."""

import math

from .common import CASES, find, percent, table

RIG = CASES / "rig_cylinder.toml"


def of_fit(points, model, w, f):
    return next(one for one in points if one["model"] == model and math.isclose(one["amplitude_ratio"], w, rel_tol=1e-6)
                and math.isclose(one["tangential_ratio"], f, rel_tol=1e-6))


def digits(value, places):
    return f"{value['value']:.{places}f} ± {value['numerical_error']:.{places}f}"


@table("docs/explanation/cylinder.md", "| w = W/a_Hertz | f_T,lim, half-space | f_T,lim, layer | difference |")
def cylinder_limits(program):
    rows = []
    for w in (.1, .26, .52, .77):
        found = program.call("limit", RIG, [f"rolling.amplitude_ratio={w}"], "--models", "bem,bem-layer", "--tolerance", ".1",
                             outputs=["limit.csv"])
        half_space, layer = (float(find(found, model=model)["exact_uncoupled_limit"]) for model in ("bem", "bem-layer"))
        rows.append([f"{w:.2f}", f"{half_space:.4f}", f"{layer:.4f}", f"{100 * (layer / half_space - 1):.2g} %"])
    return rows


@table("docs/explanation/cylinder.md", "| w | f_T | u_sd of `bem` | (3.5.26) | difference |")
def cylinder_settled(program):
    points = program.fit("cylinder_shakedown.toml")["points"]
    rows = []
    for w, f in ((.26, .08), (.26, .3), (.26, .5), (.26, .65), (.52, .36), (.77, .12)):
        found = of_fit(points, "bem", w, f)["settled_shift_ratio"]
        thesis = 1 - (1 - f) ** .92 + .3 * f * w
        rows.append([f"{w}", f"{f:.2f}", digits(found, 5), f"{thesis:.4f}", percent(thesis / found["value"] - 1)])
    return rows


@table("docs/explanation/cylinder.md", "| w | f_T | Du of `bem` | over f_T (w - w_lim) | (3.5.30) | Du of `bem-layer` |")
def cylinder_ratcheting(program):
    points = program.fit("cylinder_ratcheting.toml")["points"]
    rows = []
    for w, loads in ((.28, (.7, .8, .9)), (.52, (.5, .7, .8, .9)), (.76, (.2, .35, .5, .7, .8, .9))):
        for f in loads:
            half_space, layer = (of_fit(points, model, w, f)["shift_increment_ratio"] for model in ("bem", "bem-layer"))
            low, high = 0., 1.  # of (3.5.27)
            for _ in range(60):
                middle = (low + high) / 2
                limit = 2 / math.pi * (math.acos(middle) - middle * math.sqrt(1 - middle ** 2))
                low, high = (middle, high) if limit > f else (low, middle)
            thesis = .64 * f * (w - (1 - f ** .73))
            rows.append([f"{w}", f"{f:.2f}", digits(half_space, 4), f"{half_space['value'] / (f * (w - low)):.2f}",
                         f"{thesis:.4f}", digits(layer, 3)])
    return rows


@table("docs/explanation/cylinder.md", "| Substrate | Ends | d | f_T,lim | U_stat | U_sd | largest half width | wider up to | differs up to |")
def roller_ends(program):
    plane = program.run(RIG, "rolling.steps_per_quarter=1", models="bem-layer")["bem-layer"]
    rows = []
    for one in program.sweep("roller_ends.toml"):
        ratios = [float(one[key]) / plane[key] - 1 for key in ("indentation_m", "static_shift_m", "final_shift_m")]
        goes_on = float(one["substrate.depth_m"]) > .081
        widest = float(one["widest_half_width_ratio"])
        rows.append(["goes on" if goes_on else "flush",
                     f"{1e3 * float(one['indenter.chamfer_m']):g} mm" if float(one["indenter.chamfer_m"]) else "sharp",
                     percent(ratios[0]), f"{float(one['limit_tangential_ratio']):.4f}", percent(ratios[1]), percent(ratios[2]),
                     f"{widest:.3f}" if widest > 1.0005 else "that of the middle",
                     f"{1e3 * float(one['knuckle_m']):.2g} mm" if widest > 1.0005 else "", f"{1e3 * float(one['end_reach_m']):.1f} mm"])
    return sorted(rows, key=lambda row: (row[0] != "flush", row[1] != "sharp"))
