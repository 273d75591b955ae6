#!/usr/bin/env bash
# Surfaces that attract each other by finite elements: pull-off of a layer beside the exact one, the audit, fields for ParaView,
# refusals.
# usage: adhesion_of_elements.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"

case=$source_dir/examples/cases/adhesive_sphere.toml
elements=(--set contact.coupling=false --set 'substrate.thickness="0.14 mm"' --set 'fem.size="47 um"')

# Within these parts of pull-off and radius of mdr-layer, the audit passed, fields in the surface's file.
holds() {
    "$python" -S - "$@" <<'PYTHON' || complain "$1 $2"
import json, sys
folder, name, within = sys.argv[1], sys.argv[2], float(sys.argv[3])
models = json.load(open(f"{folder}/summary.json"))["models"]
elements, exact = models[name], models["mdr-layer"]
assert abs(elements["pull_off_force_N"] / exact["pull_off_force_N"] - 1) < within
assert abs(elements["contact_radius_m"] / exact["contact_radius_m"] - 1) < within
for check in ("traction_follows_separation", "base_reaction"):
    assert elements["audit"][check]["passed"], check
surface = open(f"{folder}/{name}/surface.ex2", "rb").read()
assert all(field in surface for field in (b"tension_Pa", b"separation_work_J_per_m2", b"attraction_state"))
PYTHON
}

# 1. Three elements in the radius at pull-off, on a layer as thick as that: some percent.
"$program" run "$case" --models fem,mdr-layer "${elements[@]}" --set path.steps=2 --output out --no-studies --no-report --quiet >text 2>&1 ||
    complain "no run: $(cat text)"
holds out fem .03

# 2. A section, 60 elements across the pressed contact, along the whole path: it lets go within 1 %, and what it sets free closes
# the balance.
"$program" run "$case" --models fem-axisymmetric,mdr-layer "${elements[@]:0:4}" --set path.steps=5 --output section --no-studies --no-report --quiet \
    >text 2>&1 || complain "no section: $(cat text)"
holds section fem-axisymmetric .01

# A path that ends as the surfaces part, where one model touches at a point: its figures are drawn.
sed '/^\[path\]/,$d' "$case" >parts.toml
printf '[path]\nsteps = 2\ntable = """\nindentation [um]\n0\n4.27394\n0\n"""\n' >>parts.toml
"$program" run parts.toml --models fem-axisymmetric,mdr-layer --set contact.coupling=false --set 'substrate.thickness="0.071 mm"' \
    --set 'fem.size="5.9 um"' --no-studies --output parts --quiet >text 2>&1 || complain "no report of surfaces that part: $(cat text)"

# 3. What elements do not compute is refused by name.
refused() {
    local what=$1
    shift
    "$program" check "$case" --set "models=[\"${model:-fem}\"]" "${elements[@]}" "$@" >text 2>&1 && complain "$what is taken"
    grep -q "$what" text || complain "$what: $(cat text)"
}
refused "iterative solver does not compute surfaces that attract each other" --set 'fem.solver="iterative"'
model=fem-axisymmetric refused "fem-axisymmetric has Coulomb's friction alone beside attraction" \
    --set 'friction.shear_strength="10 kPa"'
model=fem-plane refused "fem-plane knows no surfaces that attract each other"
refused "finite strains know no surfaces that attract each other" --set 'substrate.material="neo-hookean"'
"$program" run "$case" --models fem "${elements[@]:0:4}" --set 'fem.size="70 um"' --set 'adhesion.range="1 nm"' --output short --quiet >text 2>&1 &&
    complain "a range of 1 nm is resolved"
grep -q "less than two cells, or distances of nodes" text || complain "short: $(cat text)"
finish
