#!/usr/bin/env bash
# fem-plane and fem-axisymmetric: blocks and punches that nothing holds but the contact, beside closed forms and published
# benchmarks; refusals.
# usage: loose_sections.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"
cases=$source_dir/examples/cases
run() { # OUTPUT ARGUMENTS...
    local output=$1
    shift
    "$program" run "$@" --quiet --no-studies --no-report --set 'output.vtk="none"' --output "$output" || complain "$*: does not run"
}

# 1. A strip that recedes from a half-plane: Keer, Dundurs and Tsai (1972), c/h and p(0) h/P by the ratio of both moduli at
# the same nu, alpha = (E_1 - E_2)/(E_1 + E_2). The half width is by moments of the pressure, as if it were a ball's: 1.3 %
# at most. The block is 300 h thick.
while read -r young half_width peak; do
    run "recedes_$young" "$cases/receding_layer.toml" --set "indenter.young=$young MPa"
    summary=recedes_$young/summary.json
    near "$(value fem-plane contact_radius_m "$summary")" "$(awk -v c="$half_width" 'BEGIN { print 2e-3 * c }')" 1.5e-2 "c of $young"
    near "$(value fem-plane peak_pressure_Pa "$summary")" "$(awk -v p="$peak" 'BEGIN { print p * 10 / .8 / 2e-3 }')" 3e-3 "p of $young"
done <<'END'
0.105263 0.88696 0.93858
0.666667 1.03714 0.84615
2 1.324165 0.713080
6 1.83630 0.539451
END
# The contact does not grow with the load.
run recedes_more "$cases/receding_layer.toml" --set "load.normal_force=25 N"
near "$(value fem-plane contact_radius_m recedes_more/summary.json)" "$(value fem-plane contact_radius_m recedes_2/summary.json)" 1e-8 \
    "c under a larger load"

# 2. NAFEMS' second contact benchmark (Konter 2006; SSNA122 of Code_Aster's manuals): displacement of the middle of the
# block's face, -0.130734 and -0.132941 mm on two meshes there, which friction makes smaller by 0.00215 mm.
cat >middle.py <<'PY'
import sys
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOExodus import vtkExodusIIReader

for folder in sys.argv[1:]:
    reader = vtkExodusIIReader()
    reader.SetFileName(folder + "/fem-axisymmetric/volume.ex2")
    reader.ApplyDisplacementsOff()
    reader.UpdateInformation()
    for kind in (reader.NODAL, reader.ELEM_BLOCK):
        reader.SetAllArrayStatus(kind, 1)
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    lowest = 0
    for i in range(blocks.GetNumberOfBlocks()):
        points = vtk_to_numpy(blocks.GetBlock(i).GetPoints().GetData())
        moved = vtk_to_numpy(blocks.GetBlock(i).GetPointData().GetArray("elastic_displacement_m_"))
        lowest = min(lowest, *moved[abs(points).max(axis=1) < 1e-9, 2])
    print(-lowest)
PY
run punch "$cases/nafems_punch.toml" --set output.volume=last --set "fem.size=1 mm"
run rubbed "$cases/nafems_punch.toml" --set output.volume=last --set "fem.size=1 mm" --set contact.coupling=true
{ read -r without && read -r with; } < <("$python" middle.py punch rubbed) || complain "no displacements"
near "$without" 0.132941e-3 0.01 "middle of the block under the punch"
near "$(awk -v a="$without" -v b="$with" 'BEGIN { print a - b }')" 2.15e-6 0.05 "part of friction"

# 3. A block that is held and one that is pressed evenly: the edge of neither has a largest pressure.
cat >block.toml <<'TOML'
title = "block"
models = ["fem-axisymmetric"]
[indenter]
shape = "flat-punch"
flat_radius = "5 mm"
young = "2 MPa"
poisson = 0.3
body = "block"
support = "holder"
height = "10 mm"
[substrate]
young = "2 MPa"
poisson = 0.3
thickness = "500 mm"
[friction]
coefficient = 0.5
[contact]
coupling = false
[load]
normal_force = "1 N"
tangential_ratio = 0
TOML
run block block.toml
[ "$(value fem-axisymmetric peak_pressure_Pa block/summary.json)" = None ] || complain "a largest pressure at a sharp edge"
near "$(value fem-axisymmetric contact_radius_m block/summary.json)" 5e-3 1e-9 "radius of a whole face"
# A rigid one on the half-space: F = 2 E* b d, Sneddon (1965); of the layer b/h is left.
grep -v -E '^(body|support|height)' block.toml | awk '/^\[/ { section = $0 } !(section == "[indenter]" && /^(young|poisson)/)' >rigid.toml
run rigid rigid.toml
near "$(value fem-axisymmetric indentation_m rigid/summary.json)" "$(awk 'BEGIN { print .91 / (2 * 2e6 * 5e-3) }')" 0.012 "depth of a rigid punch"

# 4. Refused by name, nothing written.
refuses() { refused "$1" run "$work/block.toml" --output out "${@:2}"; }
refuses "knows no punch of revolution with a sharp edge" --set 'models=["bem"]'
refuses "fem-plane with indenter.length" --set 'models=["fem-plane"]'
refuses "knows no punch along y" --set "indenter.length=200 mm"
refuses "load.tangential_ratio" --set indenter.support=pressure --set load.tangential_ratio=0.2
refuses "there is no depth" --set indenter.support=force --set "load.indentation=1 mm"
refuses "does not roll" --set "rolling.amplitude=1 mm"
refused "the formulas of rigs" rig "$work/rigid.toml" --output out
refuses "substrate.width" --set "substrate.width=8 mm"
finish
