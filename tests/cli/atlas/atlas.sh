#!/usr/bin/env bash
# tricontact atlas: maps of MDR, whose closed forms are exact, so that every map is that of its closed form within the
# springs' error; whole, killed and gone on with, and in parts: the same bytes. Then tricontact predict, sweeps by the
# model atlas, and what is refused.
# usage: atlas.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
rig=$source_dir/examples/cases/rig_sphere_parallel.toml

cat >case.toml <<EOF
models = ["mdr"]
[indenter]
radius = "40 mm"
[substrate]
young = "5 MPa"
poisson = 0.5
[friction]
coefficient = 0.5
[load]
normal_force = "20 N"
limit_fraction = 0.5
[rolling]
amplitude_ratio = 0.3
amplitude_reference = "model"
steps = "turning-points"
periods = 2000
until = "settled"
[mdr]
springs = 1000
EOF
cat >maps.toml <<EOF
title = "MDR: shakedown"
case = "case.toml"
models = ["mdr"]
levels = 2
[vary]
rolling.amplitude_ratio = {from = 0.05, to = 0.7}
load.limit_fraction = {from = 0.1, to = 0.95}
[atlas]
points = 60
error = 0.001
quantities = ["settled_shift_ratio", "static_shift_ratio", "kappa", "indentation_m"]
EOF

# 1. The whole, checked by random points on twice as many springs.
"$program" atlas maps.toml --output whole --jobs 2 --check 25 >checked 2>log || complain "the atlas: $(tail -1 log)"
[ "$(grep -c 'within their bars' checked)" -eq 4 ] || complain "checks: $(cat checked)"
$python - whole/atlas.json whole/points.csv whole/check.csv <<'EOF' || complain "what the atlas holds"
import csv, json, sys
atlas = json.load(open(sys.argv[1]))
assert atlas["format"] == "tricontact atlas 1" and atlas["model"] == "mdr", atlas["format"]
assert [axis["key"] for axis in atlas["axes"]] == ["rolling.amplitude_ratio", "load.limit_fraction"]
maps = {m["quantity"]: m for m in atlas["maps"]}
# What the springs leave: of the settled shift 1e-4, of kappa, which divides by w u, a hundred times as much.
assert maps["settled_shift_ratio"]["over"] == "u_sd of MDR" and maps["settled_shift_ratio"]["largest_error"] < 1e-3
assert abs(maps["settled_shift_ratio"]["polynomial"]["coefficients"][0]) < 1e-3
assert maps["indentation_m"]["median_error"] < 1e-5
rows = list(csv.DictReader(open(sys.argv[3])))
kappas = [float(r["atlas"]) for r in rows if r["quantity"] == "kappa" and float(r["rolling.amplitude_ratio"]) > .2]
assert len(kappas) > 10 and all(abs(k - 1.5) < .02 for k in kappas), kappas
assert len(list(csv.DictReader(open(sys.argv[2])))) == atlas["points"] - atlas["failed"]
EOF

# 2. Killed, and gone on with; in parts, and merged; once more: the same bytes.
"$program" atlas maps.toml --output killed --jobs 1 --quiet &
child=$!
for _ in $(seq 200); do [ -s killed/results.sqlite ] && break; sleep 0.02; done
kill -9 $child 2>/dev/null
wait $child 2>/dev/null
[ -e killed/atlas.json ] && complain "killed too late to tell"
"$program" atlas maps.toml --output killed --jobs 2 --quiet || complain "going on"
for part in 1 2; do
    "$program" atlas maps.toml --output part_$part --shard $part/2 --quiet || complain "part $part"
    [ -e part_$part/atlas.json ] && complain "a part has an atlas"
done
"$program" sweep merge merged part_1 part_2 >/dev/null || complain "merge"
"$program" atlas maps.toml --output merged --quiet 2>log || complain "of the merged parts: $(cat log)"
for folder in killed merged; do
    cmp -s whole/atlas.json $folder/atlas.json || complain "$folder: another atlas"
    cmp -s whole/points.csv $folder/points.csv || complain "$folder: other points"
done
"$program" atlas maps.toml --atlas whole/atlas.json --output elsewhere --check 25 --seed 2 --quiet >again ||
    complain "a check of a finished atlas: $(cat again)"
[ -e elsewhere/atlas.json ] && complain "a check builds an atlas"

# 3. Predictions of the shipped atlases: the table of the settled shift (docs/explanation/accuracy.md), and the exact limit.
"$program" predict "$rig" --set load.tangential_ratio=0.24 --set rolling.amplitude_ratio=0.51 --json >p.json ||
    complain "predict"
"$program" predict "$rig" --set load.tangential_ratio=0.24 --set rolling.amplitude_ratio=0.51 \
    --set "rolling.angle=270 deg" --json >across.json || complain "predict across the load"
$python - p.json across.json <<'EOF' || complain "predictions"
import json, sys
along, across = (json.load(open(name))["models"] for name in sys.argv[1:])
def near(models, model, key, value, tolerance):
    got = models[model][key]
    assert abs(got - value) <= tolerance, (model, key, got, value)
near(along, "mdr", "settled_shift_ratio", .4281, 1e-4)
assert along["mdr"]["settled_shift_ratio_error"] == 0
near(along, "bem", "settled_shift_ratio", .3010, along["bem"]["settled_shift_ratio_error"] + 5e-5)
near(across, "bem", "settled_shift_ratio", .3299, across["bem"]["settled_shift_ratio_error"] + 5e-5)
assert along["bem"]["settled_shift_ratio_error"] < 2e-3
near(along, "bem", "limit_tangential_ratio", 1 - 1.5 * .51 + .5 * .51**3, 1e-12)
assert along["bem"]["state"] == "shakedown" and not along["bem"]["gaps"], along["bem"]
near(along, "bem", "settled_shift_m", along["bem"]["settled_shift_ratio"] * along["bem"]["unit_shift_m"], 1e-12)
EOF
"$program" predict "$rig" --set rolling.amplitude_ratio=0.95 --set load.tangential_ratio=0.002 --models bem >gap || complain "predict beyond the maps"
grep -q 'no value: .*rolling.amplitude_ratio = 0.95' gap || complain "no gap: $(cat gap)"
grep -q 'settled shift' gap && complain "a shift beyond the maps: $(cat gap)"
"$program" predict "$rig" --set load.tangential_ratio=0.7 --models bem >ratchets || complain "predict of ratcheting"
grep -q '^bem: ratcheting' ratchets || complain "ratcheting: $(cat ratchets)"
grep -q 'settled shift' ratchets && complain "a settled shift while ratcheting: $(cat ratchets)"

"$program" predict "$source_dir/examples/cases/rig_layer_parallel.toml" --set "substrate.thickness=1 m" \
    --models bem-layer >gap || complain "predict of a layer beyond the maps"
grep -q 'no value: substrate.thickness_ratio' gap || complain "no gap of the thickness: $(cat gap)"

# Line contacts: closed forms on the half-space; of the layer nothing knows the cylinder's length, and a depth is that
# of its force.
cylinder=$source_dir/examples/cases/rig_cylinder.toml
own=(--set rolling.amplitude_ratio=0.26 --set rolling.amplitude_reference=model)
"$program" predict "$cylinder" "${own[@]}" --json >short.json || complain "predict of a cylinder"
"$program" predict "$cylinder" "${own[@]}" --set "indenter.length=160 mm" --set "load.normal_force=64.6 N" --json >long.json ||
    complain "predict of a longer one"
depth=$($python -c 'import json; print(json.load(open("short.json"))["models"]["bem-layer"]["indentation_m"])')
"$program" predict "$cylinder" "${own[@]}" --set "load.indentation=$depth m" \
    --models bem-layer --json >deep.json || complain "predict of a cylinder pressed to a depth"
$python - <<'EOF' || complain "predictions of cylinders"
import json, math
short, long, deep = ({m: r for m, r in json.load(open(name + ".json"))["models"].items()} for name in ("short", "long", "deep"))
assert set(short) == {"bem", "bem-layer"}, set(short)
half_space = short["bem"]
assert "kappa" not in half_space
assert abs(half_space["limit_tangential_ratio"] - 2 / math.pi * (math.acos(.26) - .26 * math.sqrt(1 - .26**2))) < 1e-12
for key in "contact_radius_m", "peak_pressure_Pa", "indentation_m", "unit_shift_m", "static_shift_ratio", "settled_shift_ratio":
    a, b = short["bem-layer"][key], long["bem-layer"][key]
    assert abs(b / a - 1) < 1e-12, (key, a, b)
# lambda of the half-space knows it.
assert long["bem"]["unit_shift_m"] / half_space["unit_shift_m"] > 1.1
assert abs(deep["bem-layer"]["normal_force_N"] / 32.3 - 1) < 1e-9, deep
EOF
"$program" predict "$cylinder" "${own[@]}" --output cylinder >said || complain "files of a cylinder"
grep -q 'no page: it is about spheres' said || complain "a page of spheres for a cylinder: $(cat said)"
[ "$(ls cylinder | tr '\n' ' ')" = "prediction.json " ] || complain "files of a cylinder: $(ls cylinder)"

# 4. A sweep by the model atlas beside one by runs.
cat >study.toml <<EOF
case = "$rig"
models = ["bem", "atlas"]
[set]
rolling.steps = "turning-points"
rolling.periods = 100
[vary]
load.tangential_ratio = [0.2, 0.4]
EOF
"$program" sweep study.toml --output study --quiet || complain "a sweep by the atlas"
paste -d' ' <(column model study/results.csv) <(column settled_shift_ratio study/results.csv) | $python -c '
import sys
rows = [line.split() for line in sys.stdin]
for (_, run), (model, read) in zip(rows[::2], rows[1::2]):
    assert model == "atlas" and abs(float(read) / float(run) - 1) < .003, (run, read)' || complain "atlas beside bem"

# fit evaluates what was read like what was run, its bar as the numerical error.
"$program" fit study.toml --output study >said || complain "fit of a sweep by the atlas: $(cat said)"
$python - <<'EOF' || complain "points of the atlas in fit"
import json
points = json.load(open("study/fit.json"))["points"]
shifts = {model: [p["settled_shift_ratio"] for p in points if p["model"] == model] for model in ("bem", "atlas")}
assert len(shifts["bem"]) == len(shifts["atlas"]) == 2, shifts
for run, read in zip(shifts["bem"], shifts["atlas"]):
    assert abs(read["value"] / run["value"] - 1) < .003, (run, read)
    assert 0 < read["numerical_error"] < .005 * read["value"], read
EOF

# 5. Refused.
refused "is the study of an atlas; tricontact atlas computes it" sweep ../maps.toml
refused "no atlas is about bodies other than smooth paraboloids, spheres and cylinders" \
    predict "$source_dir/examples/cases/body_cone.toml"
layer=$source_dir/examples/cases/rig_layer_parallel.toml
refused "no atlas is about layers of finite width or depth" predict "$layer" --set "substrate.width=60 mm"
refused "no atlas is about layers without coupling" predict "$layer" --set contact.coupling=false
refused "no atlas is about indenters on a layer that are not rigid" predict "$layer" \
    --set "indenter.young=10 MPa" --set "models=[\"bem-layer\"]"
"$program" predict "$layer" --set "substrate.width=60 mm" --models mdr >said || complain "predict of the half-space, asked for"
grep -q 'leaves out substrate.thickness: the substrate is a half-space' said || complain "a layer left out: $(cat said)"
sed -n 2p said | grep -q 'the thickness of the layer is not seen' || complain "numbers before what they leave out: $(cat said)"
refused "no atlas is about line contacts by MDR" predict "$cylinder" --models mdr
refused "no atlas is about half-spaces that couple" predict "$rig" --set substrate.poisson=0.3 --set "models=[\"bem\"]" --models bem
refused "atlas runs nothing" run "$rig" --models atlas
sed 's/"kappa"/"kapa"/' maps.toml >bad.toml
refused 'unknown quantity kapa; did you mean kappa?' atlas ../bad.toml
sed 's/models = \["mdr"\]/models = ["mdr", "bem"]/' maps.toml >bad.toml
refused "an atlas is that of one model" atlas ../bad.toml
sed 's/^load.limit_fraction.*/load.limit_fraction = [0.2, 0.4]/' maps.toml >bad.toml
refused "an atlas goes over ranges without points" atlas ../bad.toml
sed '/^\[atlas\]/,$d' maps.toml >bad.toml
printf '[latin_hypercube]\npoints = 5\n' >>bad.toml
refused "is no study of an atlas of contacts" atlas ../bad.toml
sed 's/"points":60/"points":61/' whole/atlas.json >changed.json
refused "does not fit its digest" atlas ../maps.toml --atlas ../changed.json --check 5

finish
