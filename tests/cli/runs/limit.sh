#!/usr/bin/env bash
# tricontact limit: brackets around the closed form in load and amplitude, files, bad input.
# usage: limit.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
case_file=$source_dir/examples/cases/rig_sphere_parallel.toml

# expect CODE ARGUMENTS...: output goes to the files out and err.
expect() {
    local code=$1 got
    shift
    "$program" limit "$@" >out 2>err
    got=$?
    [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*: $(cat err)"
}

# says TEXT FILE
says() {
    grep -qF -- "$1" "$2" || complain "no '$1' in $2: $(head -c 600 "$2")"
}

# brackets MODEL VALUE FILE: its last shakedown and first ratcheting in a limit.csv.
brackets() {
    awk -F, -v model="$1" -v value="$2" \
        '$1 == model && $4 <= value && value <= $5 { found = 1 } END { exit !found }' "$3" ||
        complain "$3: $1 does not bracket $2: $(cat "$3")"
}

# 1. In the load: f_T = 1 - 3/2 w + 1/2 w^3 at w = 0.51.
coarse=(--set mdr.springs=2000 --set "bem.spacing=0.8 mm" --tolerance 0.01)
expect 0 "$case_file" --set rolling.amplitude_ratio=0.51 "${coarse[@]}" --quiet --output load
brackets mdr 0.3013255 load/limit.csv
brackets bem 0.3013255 load/limit.csv
says "limit of shakedown in f_T at w = 0.51" out
says '"exact_uncoupled_limit": 0.301325' load/limit.json
# As many digits as the bracket tells (half width 0.0039): 0.2969, not 0.296875; limit.json has all.
awk '$1 == "mdr" && $5 ~ /^0\.[0-9][0-9][0-9][0-9]$/ && $6 ~ /^0\.[0-9][0-9][0-9][0-9]$/ { found = 1 } END { exit !found }' <(sed 's/MDR/mdr/' out) ||
    complain "digits of the bracket: $(cat out)"
says "first ratcheting" load/report.html
[ -s load/case.toml ] || complain "no resolved case"
[ -s err ] && complain "--quiet is not silent: $(cat err)"

# 2. In the amplitude: the same point, from the other side.
expect 0 "$case_file" --vary amplitude --models mdr --set load.tangential_ratio=0.3013255 \
    "${coarse[@]}" --output amplitude
brackets mdr 0.51 amplitude/limit.csv
says "report: amplitude/report.html" err

# 3. Bad input, nothing written.
static=static.toml
sed '/^\[rolling\]/,/^increment/d' "$case_file" >"$static"
expect 2 "$static" --output none
says "static.toml: there is no [rolling]" err
expect 2 "$case_file" --set rolling.amplitude_ratio=1.1 --models mdr --output empty
says "no load shakes down; lower rolling.amplitude" err
[ -e empty/limit.json ] && complain "numbers of no limit"
expect 2 "$case_file" --tolerance 0 --output none
says "--tolerance" err
expect 2 "$case_file" --vary angle --output none
says "--vary" err
expect 2 "$case_file" --vary amplitude --set load.tangential_ratio=0 --output none
says "no amplitude ratchets" err
expect 2 "$case_file" --set load.tangential_amplitude_ratio=0.1 --output none
says "the loads oscillate" err
expect 2 "$case_file" --models spring --output none
[ -e none ] && complain "bad input left a folder behind"

finish
