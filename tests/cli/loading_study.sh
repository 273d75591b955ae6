#!/usr/bin/env bash
# What a run says that another kinematics, coupling or way of pressing would change is what a run
# with that key finds.
# usage: loading_study.sh PROGRAM SOURCE_DIR
set -uo pipefail
program=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export OPENBLAS_NUM_THREADS=1
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

if ! "$program" list | grep -q '^  fem '; then
    echo "built without fem: nothing to be tested"
    exit 0
fi

# run NAME ARGUMENTS...: the rig's layer in coarse elements.
run() {
    local name=$1
    shift
    "$program" run "$source_dir/cases/rig_layer_parallel.toml" --models fem --quiet --no-report \
        --set rolling.periods=1 --set rolling.steps=turning-points --set output.volume=none \
        --set "fem.size=1.5 mm" --set "fem.cache=$work/cache" --set load.press_steps=4 \
        --output "$name" "$@" || complain "run $name: $*"
}

# value NAME KEY: the first value of a key in a summary.
value() {
    grep -m1 "\"$2\":" "$1/summary.json" | sed 's/.*: //; s/,$//'
}

# changed NAME KEY: static shift of the run with that key changed, as the run says.
changed() {
    grep -A4 "\"key\": \"$2\"" "$1/summary.json" | grep changed_static_shift_m |
        sed 's/.*: //; s/,$//'
}

run base
[ "$(grep -c '"key": ' base/summary.json)" -eq 3 ] || complain "not three variants"
# Half a percent of the exact layer at six elements per diameter.
awk -v d="$(grep -A3 '"over_exact"' base/summary.json | grep indentation | sed 's/.*: //; s/,//')" \
    'BEGIN { exit !(d != "" && d < 5e-3 && d > -5e-3) }' || complain "indentation off the exact layer"
# The finite difference of three presses: a few percent.
awk -v k="$(grep -A7 '"over_exact"' base/summary.json | grep normal_stiffness | sed 's/.*: //; s/,//')" \
    'BEGIN { exit !(k != "" && k < 5e-2 && k > -5e-2) }' || complain "stiffness off the exact layer"

for setting in contact.kinematics=deformed contact.coupling=false load.press=frictionless; do
    key=${setting%%=*}
    run "$key" --set "$setting"
    [ "$(value "$key" static_shift_m)" = "$(changed base "$key")" ] ||
        complain "$setting: $(value "$key" static_shift_m) by a run, $(changed base "$key") said"
    [ "$(value "$key" static_shift_m)" != "$(value base static_shift_m)" ] ||
        complain "$setting changes nothing"
done
# Where nothing is coupled there is no way of pressing to be remembered, but still a coupling to be
# switched on.
[ "$(changed contact.coupling contact.coupling)" = "$(value base static_shift_m)" ] ||
    complain "coupling switched on again: $(changed contact.coupling contact.coupling)"
grep -q '"key": "load.press"' contact.coupling/summary.json && complain "pressing without coupling"

printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
