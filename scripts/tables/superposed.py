"""docs/explanation/superposed.md, docs/how-to/limits.md."""

import math

from .common import CASES, find, short, table

RIG = CASES / "rig_sphere_parallel.toml"


def oscillating(program, study, amplitude, phase, ratios):
    """Rows by amplitude and phase: shift of mdr and bem at each ratio, or Delta u where it ratchets."""
    found = program.sweep(study)
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


@table("docs/explanation/superposed.md", "| Amplitude over F_N | Phase | f_T,lim (`bem`) | u at f_T = .30: `mdr` | `bem` "
       "| u at f_T = .56: `mdr` | `bem` |")
def oscillating_normal(program):
    rows = oscillating(program, "oscillating_normal_force.toml", "load.normal_amplitude_ratio", "load.normal_phase",
                       (.3, .56))
    return [[*row[:2], short(float(limit)), *row[2:]] for row, limit in rows]


@table("docs/explanation/superposed.md", "| Amplitude r | Phase | u at f_T = .30: `mdr` | `bem` | u at f_T = .50: `mdr` | `bem` |")
def oscillating_tangential(program):
    return [row for row, _ in oscillating(program, "oscillating_tangential_force.toml",
                                          "load.tangential_amplitude_ratio", "load.tangential_phase", (.3, .5))]


@table("docs/how-to/limits.md", "| Model | w | last shakedown | first ratcheting | by pressures | closed form |")
def limits(program):
    rows = []
    for model, w, angle in (("mdr", .24, 0), ("mdr", .51, 0), ("bem", .51, 0), ("bem", .24, 90)):
        answer = program.call("limit", RIG, [f"rolling.amplitude_ratio={w}", f"rolling.angle={angle} deg"], "--models",
                              model, outputs=["limit.csv"])[0]
        digits = 7 if model == "mdr" else 5
        exact = 1 - 1.5 * w + .5 * w ** 3
        rows.append([f"`{model}`" + (", across" if angle else ""), f"{w}",
                     *(f"{float(answer[name]):.{digits}f}" for name in ("last_shakedown", "first_ratcheting", "limit_by_pressures")),
                     f"{exact:.{digits}f}"])
    return rows


@table("docs/explanation/superposed.md", "| Angle | w = .24 | w = .51 |", cheap=True)
def rolling_angle(program):
    found = program.sweep("rolling_angle.toml")
    return [[f"{angle} deg",
             *(short(float(find(found, **{"rolling.amplitude_ratio": w, "rolling.angle_rad": math.radians(angle)})
                           ["final_shift_ratio"]), 4) for w in (.24, .51))] for angle in range(0, 91, 15)]
