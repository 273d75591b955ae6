"""docs/explanation/peers.md: the program's own models, submitted as those of any other code."""

import json
import subprocess
import tempfile
from pathlib import Path

from .common import figures, table

# Three meshes each, twice as fine from one to the next.
MODELS = (("bem-layer", "bem.cells_per_radius", (10, 20, 40), "cells in Hertz' radius"),
          ("mdr-layer", "mdr.elements_per_radius", (10, 20, 40), "elements in Hertz' radius"),
          ("fem", "fem.size", ('"1.4 mm"', '"0.7 mm"', '"0.35 mm"'), "element at the contact"))


def compute(program, model, setting, folder, case):
    """Runs the case by a model: a mesh of a submission, its last surface and its force."""
    subprocess.run([program.path, "run", case, "--models", model, "--set", setting, "--no-report", "--no-studies", "--quiet",
                    "--output", folder], check=True, stdout=subprocess.DEVNULL)
    force = json.loads((folder / "summary.json").read_text())["models"][model]["normal_force_N"]
    surface = sorted((folder / model).glob("surface_*.vt[ipu]"))[-1]
    return f'[[mesh]]\nfield = "{surface}"\nnormal_force = "{force:.9g} N"\n'


@table("docs/explanation/peers.md", "| Model | Meshes | F_N, finest | L2 of p | order | load inside r | Verdict |")
def own_submissions(program):
    rows = []
    for model, key, levels, what in MODELS:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            case = folder / "case.toml"
            case.write_text(subprocess.run([program.path, "benchmark", "show", "layer_pressed", "--case"], check=True,
                                           capture_output=True, text=True).stdout)
            meshes = [compute(program, model, f"{key}={level}", folder / str(k), case) for k, level in enumerate(levels)]
            submission = folder / "submission.toml"
            submission.write_text('case = "layer_pressed"\ncode = "' + model + '"\n\n' + "\n".join(meshes))
            done = subprocess.run([program.path, "benchmark", "compare", submission, "--no-report", "--quiet",
                                   "--output", folder / "comparison"], check=False, stdout=subprocess.DEVNULL)
            if done.returncode not in (0, 3, 4):
                raise RuntimeError(f"benchmark compare of {model} ends with {done.returncode}")
            found = json.loads((folder / "comparison/comparison.json").read_text())
        numbers = found["quantities"]

        def finest(key):
            return f"{100 * numbers[key]['difference_of_finest']:+.3f} %"
        order = numbers["pressure_l2"]["order"]
        rows.append([f"`{model}`", ", ".join(str(one).strip('"') for one in levels) + f" {what}", finest("normal_force"),
                     figures(100 * numbers["pressure_l2"]["difference_of_finest"]) + " %", figures(order, 2) if order else "–",
                     figures(100 * numbers["load_within"]["difference_of_finest"]) + " %",
                     f"force {numbers['normal_force']['verdict']}, all {found['verdict']}"])
    return rows
