#!/usr/bin/env bash
# load.limit_fraction and substrate.thickness_ratio: a sweep over both, runs of resolved cases, commands that
# take another load, and those that refuse a load of each model's own.
# usage: smooth_coordinates.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
rig=$source_dir/examples/cases/rig_sphere_parallel.toml
layer=$source_dir/examples/cases/rig_layer_parallel.toml
coarse=(--set mdr.springs=400 --set bem.cells_per_radius=6 --set rolling.steps=turning-points --set rolling.periods=3)

# near A B TOLERANCE
near() { awk -v a="$1" -v b="$2" -v e="$3" 'BEGIN { exit !(a - b < e && b - a < e) }'; }
# value NAME FILE: the first number of that name in a summary.
value() { grep -m1 "\"$1\"" "$2" | sed 's/.*: //; s/,$//'; }

# 1. A sweep: each model's f_T is its fraction of its limit, the layer as thick as said.
cat >study.toml <<EOF
case = "$layer"
models = ["mdr", "mdr-layer", "bem-layer"]
[set]
rolling.steps = "turning-points"
rolling.periods = 40
rolling.amplitude_ratio = 0.3
rolling.amplitude_reference = "model"
mdr.springs = 400
bem.cells_per_radius = 6
contact.coupling = false
output.vtk = "quarters"
[vary]
load.limit_fraction = [0.5, 1.05]
substrate.thickness_ratio = [0.5, 2.0]
EOF
"$program" sweep study.toml --output study --vtk --jobs 2 --quiet 2>log || complain "the sweep: $(cat log)"
[ "$(head -1 study/results.csv | cut -d, -f1-4)" = "load.limit_fraction,substrate.thickness_ratio,model,level" ] ||
    complain "columns: $(head -1 study/results.csv)"
[ "$(rows study)" -eq 12 ] || complain "$(rows study) rows"
paste -d, <(column load.limit_fraction study/results.csv) <(column tangential_ratio study/results.csv) \
    <(column limit_tangential_ratio study/results.csv) <(column state study/results.csv) |
    while IFS=, read -r fraction f limit state; do
        near "$f" "$(awk -v a="$fraction" -v b="$limit" 'BEGIN { print a*b }')" 1e-5 || echo "$fraction: $f, $limit"
        [ "$fraction" = 0.5 ] && expected=shakedown || expected=ratcheting
        [ "$state" = $expected ] || echo "$fraction: $state"
    done >found
[ -s found ] && complain "loads: $(cat found)"
grep -qs 'limit_fraction' study/points/*/case.toml || complain "the resolved case has no fraction"
grep -qs 'thickness_ratio' study/points/*/case.toml && complain "the resolved case has no thickness"
derived() { "$python" -c 'import json, sys; print(json.load(open(sys.argv[1]))["derived"][sys.argv[2]]["value"])' "$@"; }
"$program" check "$layer" --json >check.json
diameter=$(awk -v a="$(derived check.json a)" 'BEGIN { print 2000*a }')
thickness=$(grep -hs '^thickness' study/points/*/case.toml | sed 's/.*"\(.*\) m"/\1/' | sort -gu | tr '\n' ' ')
read -r thin thick <<<"$thickness"
near "$(awk -v b="$thin" -v d="$diameter" 'BEGIN { print 1000*b/d }')" 0.5 1e-4 || complain "thickness $thin of $diameter mm"
near "$(awk -v b="$thick" -v d="$diameter" 'BEGIN { print 1000*b/d }')" 2 4e-4 || complain "thickness $thick"

# 2. A coupled run and that of its resolved case: the same bytes; with its f_T given: the same shift.
fraction=(--set load.limit_fraction=0.5 --set substrate.thickness_ratio=0.9 --models bem-layer)
"$program" run "$layer" "${coarse[@]}" "${fraction[@]}" --output a --quiet || complain "the run"
"$program" run a/case.toml --output b --quiet --no-report --no-studies || complain "the resolved case"
cmp -s a/bem-layer/history.csv b/bem-layer/history.csv || complain "the resolved case is another"
grep -q 'limit of shakedown' a/report.html || complain "the report does not tell the load"
"$program" run "$layer" "${coarse[@]}" "${fraction[@]}" --output c --quiet --no-report --no-studies \
    --set "load.tangential_ratio=$(value tangential_ratio a/summary.json)" 2>log && complain "both loads at once"
grep -q 'contradicts' log || complain "both loads: $(cat log)"
"$program" run "$layer" "${coarse[@]}" "${fraction[@]:2}" --output c --quiet --no-report --no-studies \
    --set "load.tangential_ratio=$(value tangential_ratio a/summary.json)" || complain "the same load"
near "$(value final_shift_ratio a/summary.json)" "$(value final_shift_ratio c/summary.json)" 1e-5 ||
    complain "shifts: $(value final_shift_ratio a/summary.json) $(value final_shift_ratio c/summary.json)"

# Several models: the report tells their loads apart.
"$program" run "$layer" "${coarse[@]}" --set load.limit_fraction=0.5 --models mdr,bem-layer --output d --quiet --no-studies ||
    complain "two models"
grep -q 'of its own limit of shakedown' d/report.html || complain "the loads of the models"

# 3. What derives from the case: the closed form's load, 1 - 3/2 w + 1/2 w^3 at w = 0.24.
"$program" check "$rig" --set load.limit_fraction=0.5 --json >out || complain "check"
near "$(derived out f_T)" 0.323456 1e-5 || complain "check: $(cat out)"
"$program" check "$source_dir/examples/cases/body_profile.toml" --set load.limit_fraction=0.5 >out || complain "check of a profile"
grep -qi 'nan' out && complain "no number: $(cat out)"
"$program" limit "$rig" --set load.limit_fraction=0.5 --models mdr --tolerance 0.01 --quiet --output limit >out ||
    complain "limit"
"$program" refine "$rig" --set load.limit_fraction=0.5 --models bem "${coarse[@]}" --quiet --output refine >out ||
    complain "refine"

# 4. Refused.
refused "load.limit_fraction follows the amplitude" limit "$rig" --vary amplitude --set load.limit_fraction=0.5
refused "load.limit_fraction: layer and half-space are compared under one F_T" \
    deviation "$layer" --set load.limit_fraction=0.5
refused "load.limit_fraction: the model's limit is known by a run alone" \
    contact export "$rig" --set load.limit_fraction=0.5
refused "load: the tangential force" run "$rig" --models mdr --set load.limit_fraction=1.6
refused "leaves no point in contact" run "$rig" --models mdr --set load.limit_fraction=0.5 --set rolling.amplitude_ratio=1.2
"$program" fit study.toml --output study 2>log && complain "fit of loads of each model's own"
grep -q 'vary load.tangential_ratio' log || complain "fit: $(cat log)"

finish
