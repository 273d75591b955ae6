#!/usr/bin/env bash
# What a run says that coupling or another way of pressing would change is what a run with that key
# finds, after loading and after rolling.
# usage: loading_study.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
export OPENBLAS_NUM_THREADS=1

models=bem-layer
has_fem && models="bem-layer fem"

# The rig's layer in coarse elements, by turning points until it has settled, as the study rolls it.
cat >base.toml <<'END'
models = ["bem-layer"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.4
press_steps = 4
[rolling]
amplitude_ratio = 0.24
periods = 100
steps = "turning-points"
[bem]
spacing = "0.6 mm"
[fem]
size = "1.5 mm"
cache = "cache"
END
# What ratchets is rolled for as many periods as the case has.
sed 's/^tangential_ratio.*/tangential_ratio = 0.9/; s/^periods.*/periods = 8/' base.toml \
    >base-ratcheting.toml

# run CASE MODEL NAME ARGUMENTS...
run() {
    local case=$1 model=$2 name=$3
    shift 3
    "$program" run "$case.toml" --models "$model" --quiet --no-report --output "$name" "$@" ||
        complain "run $name: $*"
}

# value NAME KEY: the first value of a key in a summary.
value() {
    grep -m1 "\"$2\":" "$1/summary.json" | sed 's/.*: //; s/,$//'
}

# changed NAME CASE_KEY KEY: a value of the run with the case's key changed, as the run says.
changed() {
    grep -A20 "\"key\": \"$2\"" "$1/summary.json" | sed -n '/"other"/,$p' | grep -m1 "\"$3\":" |
        sed 's/.*: //; s/,$//'
}

# same MODEL NAME CASE_KEY KEY: the run with the changed key has what the base said of it.
same() {
    [ "$(value "$2" "$4")" = "$(changed "base-$1" "$3" "$4")" ] ||
        complain "$1, $3: $4 $(value "$2" "$4") by a run, $(changed "base-$1" "$3" "$4") said"
}

for model in $models; do
    run base "$model" "base-$model"
    [ "$(grep -c '"key": ' "base-$model/summary.json")" -eq 3 ] || complain "not three variants"
    # A percent of the exact layer at six elements per diameter.
    awk -v d="$(grep -A3 '"over_exact"' "base-$model/summary.json" | grep indentation |
        sed 's/.*: //; s/,//')" 'BEGIN { exit !(d != "" && d < 1e-2 && d > -1e-2) }' ||
        complain "$model: indentation off the exact layer"
    # The finite difference of three presses: a few percent.
    awk -v k="$(grep -A7 '"over_exact"' "base-$model/summary.json" | grep normal_stiffness |
        sed 's/.*: //; s/,//')" 'BEGIN { exit !(k != "" && k < 5e-2 && k > -5e-2) }' ||
        complain "$model: stiffness off the exact layer"

    for setting in contact.coupling=false load.press=frictionless load.press_steps=1; do
        key=${setting%%=*} name=$model-${setting%%=*}
        studies=--no-studies
        [ "$key" = contact.coupling ] && studies=  # what it says of coupling is asked for below
        run base "$model" "$name" --set "$setting" $studies
        for result in static_shift_m final_shift_m state; do
            same "$model" "$name" "$key" $result
        done
        [ "$(value "$name" static_shift_m)" != "$(value "base-$model" static_shift_m)" ] ||
            complain "$model: $setting changes nothing"
    done
    # Where nothing is coupled there is no way of pressing to be remembered, but still a coupling to
    # be switched on.
    uncoupled=$model-contact.coupling
    for key in static_shift_m final_shift_m; do
        [ "$(changed "$uncoupled" contact.coupling $key)" = "$(value "base-$model" $key)" ] ||
            complain "$model: coupling switched on again: $key"
    done
    grep -q '"key": "load.press' "$uncoupled/summary.json" && complain "pressing without coupling"
done

run base-ratcheting bem-layer base-ratcheting
run base-ratcheting bem-layer coupling --set contact.coupling=false --no-studies
[ "$(value base-ratcheting state)" = '"ratcheting"' ] || complain "nothing ratchets"
for key in static_shift_m final_shift_m state; do
    same ratcheting coupling contact.coupling $key
done

finish
