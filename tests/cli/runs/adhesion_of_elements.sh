#!/usr/bin/env bash
# Surfaces that attract each other by finite elements: pull-off of a layer beside the exact one, the audit, fields for ParaView,
# refusals.
# usage: adhesion_of_elements.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"

case=$source_dir/examples/cases/adhesive_sphere.toml
elements=(--set contact.coupling=false --set 'substrate.thickness="0.14 mm"' --set 'fem.size="35 um"')

# 1. Four elements in the radius at pull-off, on a layer as thick as that: some percent.
"$program" run "$case" --models fem,mdr-layer "${elements[@]}" --set path.steps=2 --output out --no-studies --quiet >text 2>&1 ||
    complain "no run: $(cat text)"
"$python" - <<'PYTHON' || complain "elements"
import json
models = json.load(open("out/summary.json"))["models"]
fem, exact = models["fem"], models["mdr-layer"]
assert abs(fem["pull_off_force_N"] / exact["pull_off_force_N"] - 1) < .03
assert abs(fem["contact_radius_m"] / exact["contact_radius_m"] - 1) < .03
for name in ("traction_follows_separation", "base_reaction"):
    assert fem["audit"][name]["passed"], name
surface = open("out/fem/surface.ex2", "rb").read()
assert all(field in surface for field in (b"tension_Pa", b"separation_work_J_per_m2", b"attraction_state"))
PYTHON

# 2. A section, 60 elements across the pressed contact, along the whole path: it lets go within 1 %, and what it sets free closes
# the balance.
"$program" run "$case" --models fem-axisymmetric,mdr-layer "${elements[@]:0:4}" --set path.steps=5 --output section --no-studies --quiet \
    >text 2>&1 || complain "no section: $(cat text)"
"$python" - <<'PYTHON' || complain "section"
import json
models = json.load(open("section/summary.json"))["models"]
section, exact = models["fem-axisymmetric"], models["mdr-layer"]
assert abs(section["pull_off_force_N"] / exact["pull_off_force_N"] - 1) < .01
assert abs(section["contact_radius_m"] / exact["contact_radius_m"] - 1) < .01
for name in ("traction_follows_separation", "base_reaction"):
    assert section["audit"][name]["passed"], name
assert b"tension_Pa" in open("section/fem-axisymmetric/surface.ex2", "rb").read()
PYTHON

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
"$program" run "$case" --models fem "${elements[@]}" --set 'adhesion.range="1 nm"' --output short --quiet >text 2>&1 &&
    complain "a range of 1 nm is resolved"
grep -q "less than two cells, or two thirds of elements" text || complain "short: $(cat text)"
finish
