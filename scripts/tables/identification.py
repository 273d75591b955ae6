"""docs/explanation/identify.md."""

import re

from .common import ROOT, figures, table

MEASUREMENTS = ROOT / "examples/measurements"
WHAT = {
    "rig_static_shift": "E = 4.22 MPa, mu = 0.57, 0.5 um of noise",
    "rig_indentation": "E = 4.22 MPa, 0.05 N of noise",
    "rig_joint": "both tables, b = 8 mm unknown too",
    "rig_pivot": "shifts that follow the drive beside those of `rig_static_shift`, Dh = 60 um",
    "rig_relaxation": "relaxed E = 4.22 MPa, g = 0.3, tau = 10 s",
    "soft_indentation": "a ball of 12 mm radius, 0.45 to 0.85 mm deep in 6 mm of E = 0.6 MPa",
    "thesis_static_shift": "the thesis' fit, 5.2 MPa, 0.57",
}
FORMS = {"young": lambda x: f"{1e-6 * x:.2f} MPa" if x > 1e6 else f"{1e-3 * x:.0f} kPa",
         "friction": lambda x: f"{x:.3f}", "thickness": lambda x: f"{1e3 * x:.2f} mm", "pivot": lambda x: f"{figures(1e6 * x)} um",
         "relative": lambda x: f"{x:.3f}", "relaxation": lambda x: f"{figures(x)} s"}


@table("docs/explanation/identify.md", "| Table | Half-space | `layer` | `bem-layer` | `fem` |")
def identified(program):
    rows = []
    for name, text in WHAT.items():
        file = ROOT / "examples/rigs/sphere_parallel.toml" if name.startswith("thesis") else MEASUREMENTS / f"{name}.toml"
        models = program.call("identify", file, outputs=["identify.json"])["models"]
        row = [f"`{name}`: {text}"]
        for model in ("half-space", "layer", "bem-layer", "fem"):
            one = models.get(model)
            values = [] if one is None else [FORMS[key.split("_")[0]](part["value"]) for key, part in one.items()
                                             if isinstance(part, dict) and part.get("value") is not None]
            row.append(", ".join(values + (["rejected"] if one and one["is_rejected"] else [])))
        rows.append(row)
    return rows


@table("docs/explanation/identify.md", "| Intervals of | statements | hold |")
def identified_coverage(program):
    text = program.random("random_identification", "7", "340")
    found = re.findall(r"^(\S.*?)  +(\d+) statements, (\S+) % held$", text, re.M)
    return [[name, n, f"{share} %"] for name, n, share in found if "," not in name or name.startswith("all,")]
