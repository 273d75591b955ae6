"""docs/explanation/walking.md, docs/explanation/walking-studies.md."""

import html
import re

from .common import STUDIES, find, table


def interval(value, error):
    """0.486 ± 0.033: two digits of the error; without it where it is below 5e-5."""
    value, error = float(value), float(error)
    if error < 5e-5:
        return f"{value:.4f}"
    digits = 4 if error < 1e-3 else 3
    return f"{value:.{digits}f} ± {error:.{digits}f}"


@table("docs/explanation/walking.md", "| kappa8, mu | all | no vertical motion | no rotation | friction does not follow the load |")
def walking_mechanisms(program):
    found = program.sweep("walking_mechanisms.toml")
    rows = []
    for kappa8 in (1, 1.18, 1.4):
        for mu in (.55, .68):
            row = [f"{kappa8:g}, {mu:g}" + (" (set B)" if (kappa8, mu) == (1.18, .68) else "")]
            for taken in (None, "vertical", "rotation", "coupling"):
                one = find(found, **{"machine.kappa8": kappa8, "machine.kappa5": mu, **{
                    f"mechanisms.{name}": "false" if name == taken else "true" for name in ("vertical", "rotation", "coupling")}})
                row.append(interval(one["mu_e"], one["mu_e_error"]))
            rows.append(row)
    return rows


@table("docs/explanation/walking.md", "| f | shakedown | ratcheting | walking | falls over |")
def walking_rocking(program):
    found = program.sweep("walking_rocking.toml")
    amplitudes = sorted({float(one["excitation.moment"]) for one in found})
    pulls = sorted({float(one["start.base"]) for one in found})
    rows = []
    for pull, f in zip(pulls, (.3, .5, .7), strict=True):
        row = [f"{f}"]
        for regime in ("shakedown", "ratcheting", "walking", "tilting"):
            held = [.05 * (amplitudes.index(float(one["excitation.moment"])) + 1) for one in found
                    if float(one["start.base"]) == pull and one["regime"] == regime]
            row.append("" if not held else f"m = {min(held):.2f}" + (f" to {max(held):.2f}" if len(held) > 1 else ""))
        rows.append(row)
    return rows


# --- docs/explanation/walking-studies.md ------------------------------------------------------------------------------

REGIONS = {"critical": ("critical: tilts", "46.7"), "no effect": ("no effect: mu_e > 0.99", "26.5"),
           "reduction": ("reduction: mu_e < 0.95", "25.6"), "strong reduction": ("mu_e < 0.5", "10.0"),
           "constant z": ("z constant to 1 % of z_stat", "13.6"), "jumps": ("jumps: z_min < 0", "31.2")}  # and the other program's


@table("docs/explanation/walking-studies.md", "| Region | as judged | second half | other program |")
def walking_map(program):
    page = program.call("sweep", STUDIES / "walking_map.toml", outputs=["report.html"])
    rows = [[html.unescape(re.sub("<.*?>", "", cell)).strip() for cell in re.findall(r"<t[dh].*?</t[dh]>", row, re.S)]
            for row in re.findall(r"<tr.*?</tr>", page, re.S)]
    return [[REGIONS[row[0]][0], row[2], row[3], REGIONS[row[0]][1]] for row in rows if len(row) == 4 and row[0] in REGIONS]
