"""docs/explanation/peers.md: the program's own models, submitted as those of any other code."""

import json
import subprocess
import tempfile
from pathlib import Path

from .common import NotBuilt, figures, table

# Three meshes each, twice as fine from one to the next.
MODELS = (("bem-layer", "bem.cells_per_radius", (10, 20, 40), "cells in Hertz' radius"),
          ("mdr-layer", "mdr.elements_per_radius", (10, 20, 40), "elements in Hertz' radius"),
          ("fem", "fem.size", ('"1.4 mm"', '"0.7 mm"', '"0.35 mm"'), "element at the contact"))


def rows_of(path):
    """Heading and rows of a surface of a run: cells with their areas, points of a profile, or nodes."""
    try:
        from vtk import vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
    except ImportError:
        raise NotBuilt("python3-vtk9") from None
    reader = {".vti": vtkXMLImageDataReader, ".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    surface = reader.GetOutput()
    if path.suffix == ".vti":
        pressure = surface.GetCellData().GetArray("normal_traction_Pa")
        dx, dy, _ = surface.GetSpacing()
        for k in range(surface.GetNumberOfCells()):
            x0, x1, y0, y1, *_ = surface.GetCell(k).GetBounds()
            yield {"x [mm]": 500 * (x0 + x1), "y [mm]": 500 * (y0 + y1), "p [MPa]": 1e-6 * pressure.GetValue(k), "area [mm2]": 1e6 * dx * dy}
        return
    pressure = surface.GetPointData().GetArray("normal_traction_Pa")
    for k in range(surface.GetNumberOfPoints()):
        x, y, _ = (1e3 * one for one in surface.GetPoint(k))
        if path.suffix == ".vtu":
            yield {"x [mm]": x, "y [mm]": y, "p [MPa]": 1e-6 * pressure.GetValue(k)}
        elif x >= 0:
            yield {"r [mm]": x, "p [MPa]": 1e-6 * pressure.GetValue(k)}


def write_submission(program, model, setting, folder, case):
    """Runs the case by a model and writes its last surface as a table."""
    subprocess.run([program.path, "run", case, "--models", model, "--set", setting, "--no-report", "--no-studies", "--quiet",
                    "--output", folder / "run"], check=True, stdout=subprocess.DEVNULL)
    force = json.loads((folder / "run/summary.json").read_text())["models"][model]["normal_force_N"]
    rows = list(rows_of(sorted((folder / "run" / model).glob("surface_*.vt[ipu]"))[-1]))
    lines = [f"# normal_force = {force:.9g} N", ", ".join(rows[0])]
    lines += [", ".join(f"{value:.9g}" for value in row.values()) for row in rows]
    (folder / "field.csv").write_text("\n".join(lines) + "\n")
    return folder / "field.csv"


@table("docs/explanation/peers.md", "| Model | Meshes | F_N, finest | L2 of p | order | load inside r | Verdict |")
def own_submissions(program):
    rows = []
    for model, key, levels, what in MODELS:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            case = folder / "case.toml"
            case.write_text(subprocess.run([program.path, "benchmark", "show", "layer_pressed", "--case"], check=True,
                                           capture_output=True, text=True).stdout)
            files = []
            for k, level in enumerate(levels):
                (folder / str(k)).mkdir()
                files.append(write_submission(program, model, f"{key}={level}", folder / str(k), case))
            done = subprocess.run([program.path, "benchmark", "compare", "--case", "layer_pressed", *files, "--no-report", "--quiet",
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
