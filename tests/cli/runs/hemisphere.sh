#!/usr/bin/env bash
# usage: hemisphere.sh PROGRAM SOURCE_DIR
# A hemisphere glued to a holder, on a rigid plane: fem meshes the body, bem takes it for a half-space, and
# says so. What lies between both is the half-space deviation of the body.
source "$(dirname "$0")/../prepare.bash"
export TRICONTACT_CACHE=$work/cache

# of FOLDER MODEL QUANTITY
of() {
    $python -S -c "import json, sys; print(json.load(open(sys.argv[1] + '/summary.json'))['models'][sys.argv[2]][sys.argv[3]])" "$@"
}
# near NAME VALUE REFERENCE RELATIVE_TOLERANCE
near() {
    $python -S -c "import sys; v, r, t = map(float, sys.argv[1:]); sys.exit(abs(v / r - 1) > t)" "$2" "$3" "$4" ||
        complain "$1: $2 instead of $3"
}
case=$source_dir/examples/cases/hemisphere.toml
quick=(--no-report --no-studies --set "load.indentation=1 mm" --set "fem.size=1.1 mm" --set load.press=frictionless)

# Reference: axisymmetric finite elements of another program, F = 14.3762(6) N; with the parabola as gap 1.3072 of Hertz' force.
# Condensed ahead of the run, which finds it.
"$program" cache condense "$case" --set "load.indentation=1 mm" --set "fem.size=1.1 mm" >log 2>&1 || complain "$(cat log)"
"$program" run "$case" "${quick[@]}" -o sphere >log 2>&1 || complain "$(cat log)"
grep -q "condensed indenter reused" log || complain "the condensed indenter is not found: $(cat log)"
near "force of the hemisphere" "$(of sphere fem normal_force_N)" 14.3762 .003
near "peak pressure" "$(of sphere fem peak_pressure_Pa)" 590600 .01
"$program" run "$case" "${quick[@]}" --set indenter.shape=paraboloid -o parabola >log 2>&1 || complain "$(cat log)"
ratio=$($python -S -c "print($(of parabola fem normal_force_N) / $(of parabola bem normal_force_N))")
near "force over that of the half-space" "$ratio" 1.3072 .004
grep -q "leaves out indenter.body: the indenter is a half-space" log || complain "bem does not say what it leaves out"
# What the half-space changes is an entry of its own, with bars; without a body there is none.
"$program" run "$case" --models bem,fem-axisymmetric --no-report --set load.tangential_ratio=0 --set load.press=frictionless -o entry >log 2>&1 || complain "$(cat log)"
$python -S - entry/summary.json >log 2>&1 <<'PY' || complain "half-space deviation: $(cat log)"
import json, math, sys
entry = json.load(open(sys.argv[1]))["half_space_deviation"]
force = entry["quantities"]["normal_force_N"]
assert (entry["half_space_model"], entry["body_model"]) == ("bem", "fem-axisymmetric"), entry
# Half-space: Sneddon (1965) of the true sphere, R = 10, d = 0.5 mm. Body: 1.1922 of Hertz' force by sections on finer
# meshes (deviation --body), which another program's numbers stand beside.
low, high = 1, 3
while high - low > 1e-12:
    a = (low + high) / 2
    low, high = (a, high) if a / 2 * math.log((10 + a) / (10 - a)) < .5 else (low, a)
modulus = 2 / (1 - .495 ** 2)
sphere = modulus * ((a * a + 100) / 2 * math.log((10 + a) / (10 - a)) - 10 * a)
body = 1.1922 * 4 / 3 * modulus * 10 ** .5 * .5 ** 1.5
assert abs(force["deviation"] - (sphere / body - 1)) < 1.5 * force["deviation_half_width"] < .005, (force, sphere, body)
assert "indentation_m" not in entry["quantities"], "prescribed"
PY
# A cover that rolls: the limit of shakedown, which the pressures tell, is hardly another one, where it settles is.
"$program" run "$source_dir/examples/cases/cylinder_on_hub.toml" --no-report --set rolling.amplitude_ratio=0.6 --set rolling.periods=40 --set rolling.steps=turning-points \
    --set load.tangential_ratio=0.2 -o rolled >log 2>&1 || complain "$(cat log)"
$python -S - rolled/summary.json >log 2>&1 <<'PY' || complain "half-space deviation, rolled: $(cat log)"
import json, math, sys
summary = json.load(open(sys.argv[1]))
entry = summary["half_space_deviation"]
assert entry["other_assumptions"] == "half-space", entry
limit, settled = (entry["quantities"][key] for key in ("limit_tangential_ratio", "settled_shift_m"))
# Line contact of half-spaces, docs/explanation/cylinder.md: (2/pi)(arccos w - w sqrt(1 - w^2)), w = 0.6.
exact = 2 / math.pi * (math.acos(.6) - .6 * .8)
assert abs(limit["half_space"] - exact) < .005, (limit, exact)
assert abs(limit["deviation"]) < .03 and .3 < settled["deviation"] < .4, entry
assert 0 < settled["deviation_half_width"] < .02, settled
PY
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --models mdr,bem --no-report --no-studies --set rolling.periods=1 \
    --set "bem.cells_per_radius=8" -o rigid >log 2>&1 || complain "$(cat log)"
grep -q half_space_deviation rigid/summary.json && complain "an entry of a body that is not there"
refused "indenter.body: mesh writes the layer under a rigid indenter; leave indenter.body out" mesh "$case" -o out \
    --set "substrate.rigid=false" --set "substrate.young=4 MPa" --set substrate.poisson=0.495 --set "substrate.thickness=5 mm"

finish
