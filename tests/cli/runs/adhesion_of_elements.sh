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

# 2. What elements do not compute is refused by name.
refused() {
    local what=$1
    shift
    "$program" check "$case" --set 'models=["fem"]' "${elements[@]}" "$@" >text 2>&1 && complain "$what is taken"
    grep -q "$what" text || complain "$what: $(cat text)"
}
refused "iterative solver does not compute surfaces that attract each other" --set 'fem.solver="iterative"'
refused "finite strains know no surfaces that attract each other" --set 'substrate.material="neo-hookean"'
"$program" run "$case" --models fem "${elements[@]}" --set 'adhesion.range="1 nm"' --output short --quiet >text 2>&1 &&
    complain "a range of 1 nm is resolved"
grep -q "less than two cells, or two thirds of elements" text || complain "short: $(cat text)"
finish
