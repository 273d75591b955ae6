#!/usr/bin/env bash
# usage: body_inside.sh PROGRAM SOURCE_DIR
# The inside of both bodies in one file for ParaView, read back by VTK's own reader: two blocks in place, whole where half
# was computed, whose stresses carry the normal force through any plane.
source "$(dirname "$0")/../prepare.bash"
export TRICONTACT_CACHE=$work/cache
hemisphere=$source_dir/examples/cases/hemisphere.toml
options=(--models fem --no-report --no-studies --quiet --set "load.indentation=0.5 mm" --set "fem.size=0.6 mm"
    --set load.press=frictionless --set load.tangential_ratio=0.5 --set indenter.poisson=0.3 --set 'output.volume="last"')

sed 's/^rigid = true/young = "4 MPa"\npoisson = 0.3\nthickness = "5 mm"/' "$hemisphere" >layer.toml
"$program" run layer.toml "${options[@]}" -o layer >log 2>&1 || complain "$(cat log)"
"$program" run "$hemisphere" "${options[@]}" -o plane >log 2>&1 || complain "$(cat log)"
grep -q '"subsurface": null' plane/summary.json || complain "an inside of a rigid substrate"
! grep -q '"subsurface": null' layer/summary.json || complain "no inside of the layer"

cat >check.py <<'PY'
import json, sys
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkIOExodus import vtkExodusIIReader

folder, expected = sys.argv[1], sys.argv[2].split(",")
reader = vtkExodusIIReader()
reader.SetFileName(folder + "/fem/volume.ex2")
reader.ApplyDisplacementsOff()
reader.UpdateInformation()
for kind in (reader.NODAL, reader.ELEM_BLOCK):
    reader.SetAllArrayStatus(kind, 1)
reader.Update()
blocks = reader.GetOutput().GetBlock(0)
names = [blocks.GetMetaData(i).Get(blocks.NAME()).split()[0] for i in range(blocks.GetNumberOfBlocks())]
problems = [] if names == expected else ["blocks %s instead of %s" % (names, expected)]
results = json.load(open(folder + "/summary.json"))["models"]["fem"]
force, pull = results["normal_force_N"], results["tangential_ratio"] * 0.5 * results["normal_force_N"]


def fields(data, *names):
    return [vtk_to_numpy(data.GetPointData().GetArray(name)) for name in names]


def through(block, height):
    """Force of the stresses through the plane z = height on what lies below it [N], by triangles."""
    plane = vtkPlane()
    plane.SetNormal(0, 0, 1)
    plane.SetOrigin(0, 0, height)
    cut = vtkCutter()
    cut.SetCutFunction(plane)
    cut.SetInputData(block)
    cut.Update()
    section = cut.GetOutput()
    points = vtk_to_numpy(section.GetPoints().GetData())
    stress = np.column_stack(fields(section, "stress_Pa_zx", "stress_Pa_yz", "stress_Pa_zz"))
    total = np.zeros(3)
    for i in range(section.GetNumberOfCells()):
        ids = [section.GetCell(i).GetPointId(k) for k in range(section.GetCell(i).GetNumberOfPoints())]
        for k in range(1, len(ids) - 1):
            corners = [ids[0], ids[k], ids[k + 1]]
            a, b, c = points[corners]
            area = np.linalg.norm(np.cross(b - a, c - a)) / 2
            total += area * stress[corners].mean(axis=0)
    return total


def near(name, value, reference, allowed):
    if not abs(value - reference) <= allowed:
        problems.append("%s: %.6g instead of %.6g" % (name, value, reference))


for name, block in zip(names, [blocks.GetBlock(i) for i in range(len(names))]):
    bounds = block.GetBounds()
    near(name + ": both sides of y = 0", bounds[2], -bounds[3], 1e-9)
    above = name == "indenter"
    if (bounds[4] < -1e-9) == above or (bounds[5] > 1e-9) != above:
        problems.append("%s between z = %g and %g" % (name, bounds[4], bounds[5]))
    for share in (.3, .6):
        height = (bounds[5] if above else bounds[4]) * share
        found = through(block, height)
        # Stresses are means at nodes, linear on the triangles of the section: .7 % of the force at most have been seen.
        near("%s: force through z = %.3g" % (name, height), found[2], -force, .01 * force)
        near("%s: pull through z = %.3g" % (name, height), found[0], pull, .01 * force)
        near("%s: nothing across" % name, found[1], 0, 1e-3 * force)
    mises, = fields(block, "von_mises_Pa")
    if not mises.max() > 1e5:
        problems.append("%s: von Mises up to %g Pa" % (name, mises.max()))

# In the middle of the contact both surfaces meet where the load has put them, and stick.
if len(names) == 2:
    ends = []
    for i in range(2):
        points = vtk_to_numpy(blocks.GetBlock(i).GetPoints().GetData())
        moved, = fields(blocks.GetBlock(i), "elastic_displacement_m_")
        at = np.argmin((points ** 2).sum(axis=1))
        ends.append((points + moved)[at])
    near("height of both surfaces", ends[0][2], ends[1][2], 1e-3 * results["indentation_m"])
    near("place of both surfaces", ends[0][0], ends[1][0], 1e-2 * results["static_shift_m"])
    if not ends[0][2] < -.1 * results["indentation_m"]:
        problems.append("the surfaces meet at z = %g" % ends[0][2])
print("\n".join(problems))
sys.exit(bool(problems))
PY
$python check.py layer inside,indenter >problems 2>&1 || complain "layer: $(cat problems)"
$python check.py plane indenter >problems 2>&1 || complain "plane: $(cat problems)"
finish
