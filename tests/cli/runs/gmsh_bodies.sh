#!/usr/bin/env bash
# usage: gmsh_bodies.sh PROGRAM SOURCE_DIR
# Bodies of gmsh files, whose nodes do not match, beside the built-in pair; and files that are broken.
source "$(dirname "$0")/../prepare.bash"
command -v gmsh >/dev/null || { complain "gmsh is not installed"; exit 1; }
export TRICONTACT_CACHE=$work/cache

# of FOLDER QUANTITY
of() {
    $python -c "import json, sys; print(json.load(open(sys.argv[1] + '/summary.json'))['models']['fem'][sys.argv[2]])" "$@"
}
# near NAME VALUE REFERENCE RELATIVE_TOLERANCE
near() {
    $python -c "import sys; v, r, t = map(float, sys.argv[1:]); sys.exit(abs(v / r - 1) > t)" "$2" "$3" "$4" ||
        complain "$1: $2 instead of $3"
}

cp "$source_dir"/examples/meshes/* .
for body in hemisphere block; do gmsh -3 $body.geo -o $body.msh >log 2>&1 || complain "$(cat log)"; done
quick=(--models fem --no-report --no-studies)
"$program" run hemisphere_on_block.toml "${quick[@]}" -o meshed >log 2>&1 || complain "$(cat log)"
grep -q "pressures on a grid of" log || complain "the grid is not told: $(cat log)"

# The same by the program's own meshes, whose nodes match.
sed '/^mesh/d' hemisphere_on_block.toml >own.toml
"$program" run own.toml "${quick[@]}" --set indenter.body=hemisphere --set indenter.support=holder \
    --set "substrate.width=60 mm" --set "substrate.depth=60 mm" --set "fem.size=0.84 mm" -o own >log 2>&1 ||
    complain "$(cat log)"
near "force beside the built-in pair" "$(of meshed normal_force_N)" "$(of own normal_force_N)" .01
near "radius beside the built-in pair" "$(of meshed contact_radius_m)" "$(of own contact_radius_m)" .01
near "pressure beside the built-in pair" "$(of meshed peak_pressure_Pa)" "$(of own peak_pressure_Pa)" .01
# Friction is that of both, too: what a tangential force shifts.
loaded=(--set load.tangential_ratio=0.5 --set load.press=friction)
"$program" run hemisphere_on_block.toml "${quick[@]}" "${loaded[@]}" -o meshed_t >log 2>&1 || complain "$(cat log)"
grep -q "condensed substrate reused" log || complain "the block is condensed again for another load"
"$program" run own.toml "${quick[@]}" "${loaded[@]}" --set indenter.body=hemisphere --set indenter.support=holder \
    --set "substrate.width=60 mm" --set "substrate.depth=60 mm" --set "fem.size=0.84 mm" -o own_t >log 2>&1 ||
    complain "$(cat log)"
near "shift beside the built-in pair" "$(of meshed_t final_shift_m)" "$(of own_t final_shift_m)" .01
# Reference of another program: axisymmetric finite elements, an unbounded layer.
near "force" "$(of meshed normal_force_N)" 11.4475 .01
near "radius" "$(of meshed contact_radius_m)" .0035162 .01
near "peak pressure" "$(of meshed peak_pressure_Pa)" 435660 .01
# The same body by tetrahedra, coarser than in the documents.
gmsh -3 hemisphere_tetrahedra.geo -setnumber h 1.2 -o hemisphere.msh >log 2>&1 || complain "$(cat log)"
"$program" run hemisphere_on_block.toml "${quick[@]}" -o tetrahedra >log 2>&1 || complain "$(cat log)"
near "force by tetrahedra" "$(of tetrahedra normal_force_N)" 11.4475 .002
near "radius by tetrahedra" "$(of tetrahedra contact_radius_m)" .0035162 .01
near "pressure by tetrahedra" "$(of tetrahedra peak_pressure_Pa)" 435660 .01
gmsh -3 hemisphere.geo -o hemisphere.msh >log 2>&1 || complain "$(cat log)"
# On a layer of the program's own mesh, and on a rigid plane (F = 14.3762, a = 3.3742, p0 = .59060).
sed '/^\[fem\]/,$d' hemisphere_on_block.toml >on_layer.toml
"$program" run on_layer.toml "${quick[@]}" -o layer >log 2>&1 || complain "$(cat log)"
near "force on a layer" "$(of layer normal_force_N)" 11.4475 .01
near "pressure on a layer" "$(of layer peak_pressure_Pa)" 435660 .01
sed '/^young = "4/d; /^thickness/d; /^\[substrate\]/,/^$/{/poisson/d}; s/^\[substrate\]/&\nrigid = true/' on_layer.toml >on_plane.toml
"$program" run on_plane.toml "${quick[@]}" -o plane >log 2>&1 || complain "$(cat log)"
near "force on a plane" "$(of plane normal_force_N)" 14.3762 .01
near "radius on a plane" "$(of plane contact_radius_m)" .0033742 .01
near "pressure on a plane" "$(of plane peak_pressure_Pa)" 590600 .01
# The hemisphere relaxes there as one: at a depth that is held from G_0 to G(t), a second after its time of a second.
sed '/^\[load\]/,/^$/d; /^\[contact\]/,/^$/d' on_plane.toml >relaxing.toml
cat >>relaxing.toml <<'TOML'
[contact]
coupling = false
[substrate.relaxation]
relative_moduli = [0.4]
times = ["1 s"]
body = "indenter"
[path]
table = """
time [s], indentation [mm], steps
0, 0, 1
1e-9, 1, 1
1, 1, 3
"""
TOML
"$program" run relaxing.toml --models fem --no-report --no-studies --quiet -o relaxing >log 2>&1 || complain "$(cat log)"
near "force that relaxes" "$(awk -F, '$4 ~ /^[0-9]/ && $3 > 0 { if (!first) first = $6; last = $6 } END { printf "%.9f", last / first }' relaxing/fem/history.csv)" \
    "$($python -c 'import math; print(.6 + .4 * math.exp(-1))')" 1e-5

# Broken files. box NAME CHANGE: a box of 20 mm x 20 mm x 10 mm above z = 0, 2 x 2 x 2 elements.
box() {
    $python - "$@" <<'PYTHON'
import sys
name, change = sys.argv[1], sys.argv[2]
n, side, height = 2, 20., 10.
number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)
nodes = [(number(i, j, k), i * side / n - side / 2, j * side / n - side / 2, k * height / n)
         for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
hexes = [[number(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
         for k in range(n) for j in range(n) for i in range(n)]
face = lambda k: [[number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
                  for j in range(n) for i in range(n)]
contact, support, names = face(0), face(n), {1: (2, "contact"), 2: (2, "support"), 3: (3, "body")}
if change == "inverted": hexes[3] = hexes[3][4:] + hexes[3][:4]
if change == "open": hexes = []
if change == "low": nodes = [(k, x, y, z - 2) for k, x, y, z in nodes]
if change == "turned": contact, support = support, contact
if change == "beside": nodes = [(k, x + 50, y, z) for k, x, y, z in nodes]
if change == "no support": del names[2]; support = []
if change == "no contact": del names[1]; contact = []
if change == "no body": del names[3]
if change == "other": names[2] = (2, "holder")
if change == "held": support = support + contact[:0] + [[number(0, j, k), number(0, j + 1, k), number(0, j + 1, k + 1),
                     number(0, j, k + 1)] for j in range(n) for k in range(n)]
if change == "cracked":  # the elements of one quarter have nodes of their own
    nodes += [(k + 1000, x, y, z) for k, x, y, z in nodes]
    for at in (0, 4): hexes[at] = [k + 1000 for k in hexes[at]]
    contact[0] = [k + 1000 for k in contact[0]]
    support[0] = [k + 1000 for k in support[0]]
if change == "in pieces":
    hexes = hexes[:1] + hexes[7:]
    contact, support = contact[:1], support[3:]
groups = {group: g for g, (d, group) in names.items()}
elements = [(3, groups.get("contact", 0), 1, f) for f in contact]
elements += [(3, groups.get("support", groups.get("holder", 0)), 2, f) for f in support]
elements += [(5, groups.get("body", 0), 3, h) for h in hexes]
with open(name, "w") as out:
    print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", len(names), sep="\n", file=out)
    for g, (d, group) in names.items(): print(d, g, f'"{group}"', file=out)
    print("$EndPhysicalNames\n$Nodes", len(nodes), sep="\n", file=out)
    for node in nodes: print(*node, file=out)
    print("$EndNodes\n$Elements", len(elements), sep="\n", file=out)
    for e, (kind, group, entity, at) in enumerate(elements): print(e + 1, kind, 2, group, entity, *at, file=out)
    print("$EndElements", file=out)
PYTHON
}
# broken CHANGE EXPECTED: refused as an indenter, by the file's name.
broken() {
    box "$work/box.msh" "$1"
    refused "$2" run "$work/on_plane.toml" "${quick[@]}" --set "indenter.mesh=$work/box.msh" -o out
    [[ $message == *box.msh* && $message == *\;* ]] || complain "no file or remedy in: $message"
}
broken "open" "is open: it holds surfaces and no volume"
broken "cracked" "the body is open at (0, -0.005, 0.0025) m: a face touches another without sharing its nodes"
broken "in pieces" "the body is in pieces"
broken "inverted" "hexahedron 4 of 8, centre (0.005, 0.005, 0.0025) m, is inverted or flat"
broken "no body" "belongs to no physical group"
broken "no contact" 'has no surface "contact"'
broken "no support" 'has no surface "support": nothing holds the body'
broken "other" 'unknown name "holder" of a physical surface'
broken "held" "the support touches the contact at (-0.01, -0.01, 0) m"
broken "low" "the bodies overlap: the node at (-0.01, -0.01, -0.002) m lies 0.002 m below the substrate's surface"
broken "turned" "does not face the other body: z of its outward normal is 1, not below -0.5"
broken "beside" "the contact surfaces do not face each other about the origin"
# Under another body they overlap where their surfaces do, and must be halves alike.
sed 's/{0, 0, b} {/{0, 0, b + 0.5} {/' block.geo >high.geo
gmsh -3 high.geo -o high.msh >log 2>&1 || complain "$(cat log)"
refused "the bodies overlap by 0.0005 m" run "$work/hemisphere_on_block.toml" "${quick[@]}" --set "fem.mesh=$work/high.msh" -o out
box "$work/box.msh" turned
refused "mesh both alike" run "$work/hemisphere_on_block.toml" "${quick[@]}" --set "fem.mesh=$work/box.msh" -o out

# What is not computed is refused by the key.
case=$work/hemisphere_on_block.toml
refused "indenter.mesh = \"none.msh\"" run "$case" "${quick[@]}" --set indenter.mesh=none.msh -o out
refused "indenter.body gives the indenter another body" run "$case" --set indenter.body=hemisphere --set indenter.support=holder -o out
refused "rolling.amplitude" run "$case" "${quick[@]}" --set "rolling.amplitude=1 mm" -o out
refused "indenter.mesh: mesh writes the layer under a rigid indenter" mesh "$case" -o out
refused "cannot be refined" refine "$case" --models fem -o out
refused "fem-axisymmetric meshes a section of its own" run "$work/on_layer.toml" --models fem-axisymmetric -o out
refused "fem.sides" run "$case" "${quick[@]}" --set fem.sides=fixed -o out
refused "the only mesh is the indenter's" run "$work/on_plane.toml" "${quick[@]}" --set "fem.size=1 mm" -o out

finish
