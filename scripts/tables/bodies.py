"""docs/explanation/bodies.md."""

import math

from .common import CASES, find, table


def number(value, digits=4):
    return f"{value:.{digits}f}"


@table("docs/explanation/bodies.md", "| n | w | exact | `bem` | `mdr` | u_sd, `bem` | u_sd, `mdr` |", cheap=True)
def bodies_power_law(program):
    found = program.sweep("bodies_power_law.toml")
    rows = []
    for w in (.24, .5):
        for n in (1, 1.5, 2, 3, 4, 8):
            bem, mdr = (find(found, **{"indenter.exponent": n, "rolling.amplitude_ratio": w, "model": model})
                        for model in ("bem", "mdr"))
            exact = program.check(CASES / "body_power_law.toml", f"indenter.exponent={n}", f"rolling.amplitude_ratio={w}")
            rows.append([f"{n:g}", f"{w:g}", number(exact["f_T,lim"]),
                         *(number(float(one["limit_tangential_ratio"])) for one in (bem, mdr)),
                         *(number(float(one["final_shift_ratio"])) for one in (bem, mdr))])
    return rows


def axis_ratio(radius_ratio):
    """a_x/a_y of Hertz' ellipse at R_y/R_x: 1/R_x is proportional to the integral of
    ds/((a_x^2 + s)^(3/2) (a_y^2 + s)^(1/2) s^(1/2)) over s > 0, here s = tan^2 t."""
    def curvature(a, b):
        n = 400
        def at(t):
            c, s = math.cos(t) ** 2, math.sin(t) ** 2
            return c / ((a * a * c + s) ** 1.5 * (b * b * c + s) ** .5)
        return sum(at((k + .5) * math.pi / 2 / n) for k in range(n))
    low, high = 1e-3, 1e3
    for _ in range(80):
        middle = math.sqrt(low * high)
        # The longer axis has the larger radius.
        low, high = (middle, high) if curvature(middle, 1) > curvature(1, middle) * radius_ratio else (low, middle)
    return middle


@table("docs/explanation/bodies.md", "| R_y | a_x/a_y | rolling | exact | `bem` | u_stat | u_sd |", cheap=True)
def bodies_ellipsoid(program):
    found = program.sweep("bodies_ellipsoid.toml")
    rows = []
    for radius, along, across in ((10, "along x, the long axis", "along y, the short axis"), (40, "along x", "along y"),
                                  (160, "along x, the short axis", "along y, the long axis")):
        for angle, text in ((0, along), (90, across)):
            one = find(found, **{"indenter.radius_y_m": radius * 1e-3, "rolling.angle_rad": math.radians(angle)})
            exact = program.check(CASES / "body_ellipsoid.toml", f'indenter.radius_y="{radius} mm"', f'rolling.angle="{angle} deg"')
            rows.append([f"{radius} mm", f"{axis_ratio(radius / 40):.3f}", text, number(exact["f_T,lim"]),
                         *(number(float(one[key])) for key in
                           ("limit_tangential_ratio", "static_shift_ratio", "final_shift_ratio"))])
    return rows
