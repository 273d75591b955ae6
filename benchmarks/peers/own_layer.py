"""The program itself on the rig's layer: reads what `tricontact run` wrote (vtk = "all") and what
/usr/bin/time said. Needs Debian's python3-vtk9, hence /usr/bin/python3."""

import csv
import json
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOExodus import vtkExodusIIReader

import exact_layer
import layer_grid as rig


def fields(path):
    """Points [mm], pressure and tangential traction [MPa] of one surface file."""
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.Update()
    grid = reader.GetOutput().GetBlock(0).GetBlock(0)
    data = grid.GetPointData()
    return (vtk_to_numpy(grid.GetPoints().GetData()) * 1e3,
            vtk_to_numpy(data.GetArray("normal_traction_Pa")) / 1e6,
            vtk_to_numpy(data.GetArray("tangential_traction_Pa_")) / 1e6)


def read(folder):
    """The state under F_N and F_T, and the indentation before F_T, which is the first step with a
    tangential force."""
    with open(f"{folder}/fem/history.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    loaded = next(i for i, row in enumerate(rows) if float(row["tangential_force_x_N"]) > 1e-3)
    with open(f"{folder}/summary.json", encoding="utf-8") as file:
        model = json.load(file)["models"]["fem"]
    points, p, t = fields(f"{folder}/fem/surface.ex2")
    before, row = rows[loaded - 1], rows[loaded]
    return {"d": float(before["indentation_m"]) * 1e3, "a": model["contact_radius_m"] * 1e3,
            "u_stat": (float(row["shift_x_m"]) - float(before["shift_x_m"])) * 1e3,
            "steps_after": len(rows) - loaded - 1,
            "excess": rig.friction_excess(p, t[:, 0], t[:, 1])} \
        | exact_layer.pressure_summary(points[:, 0], points[:, 1], p)


if __name__ == "__main__":
    print(json.dumps(read(sys.argv[1]), default=float))
