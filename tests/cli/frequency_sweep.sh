#!/usr/bin/env bash
# scripts/frequency_sweep.sh: a row per speed, what a run says of it; finished points are kept, those
# of another case are not; bad input is refused before anything is written.
# usage: frequency_sweep.sh PROGRAM SOURCE_DIR
set -uo pipefail
program=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

case_file=$source_dir/cases/rig_sphere_layer_relaxing.toml
sweep() {
    "$source_dir/scripts/frequency_sweep.sh" --program "$program" "$@"
}
small=(--model mdr --set mdr.springs=200 --set rolling.periods=3)

sweep "$case_file" 0.1 10 3 "${small[@]}" --output out >first.txt || complain "the sweep failed"
[ "$(grep -c ': done$' first.txt)" -eq 3 ] || complain "not three runs: $(cat first.txt)"
[ "$(wc -l <out/frequency_sweep.csv)" -eq 4 ] || complain "not three rows"
grep -q '</svg>' out/frequency_sweep.svg || complain "no picture"
# As many fields as columns, speeds rising by ten, G' rising, and numbers in all but the verdict.
awk -F, 'NR == 1 { n = NF; next }
    NF != n { exit 1 }
    NR > 2 && ($1 / speed - 10 > 1e-5 || $1 / speed - 10 < -1e-5 || $4 <= storage) { exit 1 }
    { speed = $1; storage = $4
      for (i = 1; i <= NF; i++) if (i != 10 && $i !~ /^-?[0-9.]+(e[-+][0-9]+)?$/) exit 1 }' \
    out/frequency_sweep.csv || complain "the table: $(cat out/frequency_sweep.csv)"
"$program" run "$case_file" --models mdr --set mdr.springs=200 --set rolling.periods=3 --quiet \
    --no-report --no-studies --set "rolling.speed=1 mm/s" --output alone || complain "a run alone"
shift_alone=$(grep -m1 '"final_shift_ratio"' alone/summary.json | sed 's/.*: //; s/,$//')
[ "$(awk -F, '$1 == 0.001 { print $8 }' out/frequency_sweep.csv)" = "$shift_alone" ] ||
    complain "another shift than a run alone: $shift_alone"

# Again, with one point unfinished, as a kill leaves it.
cp out/frequency_sweep.csv first.csv
rm out/1/summary.json
sweep "$case_file" 0.1 10 3 "${small[@]}" --output out >again.txt || complain "the second sweep"
[ "$(grep -c ': finished before$' again.txt)" -eq 2 ] || complain "not resumed: $(cat again.txt)"
cmp -s first.csv out/frequency_sweep.csv || complain "another table after resuming"
# Another case is another sweep.
sweep "$case_file" 0.1 10 3 "${small[@]}" --set friction.coefficient=0.6 --output out >other.txt
grep -q 'finished before' other.txt && complain "points of another case taken over"

# refused EXPECTED ARGUMENTS...: exit code 2, one line, nothing written.
refused() {
    local expected=$1 message code
    shift
    mkdir empty
    message=$(cd empty && sweep "$@" 2>&1)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $*"
    [[ $message == "error: "*"$expected"* && $message != *$'\n'* ]] ||
        complain "$*: expected $expected, got $message"
    [ -z "$(ls -A empty)" ] || complain "files left behind: $*"
    rm -rf empty
}
refused "four are due" "$case_file" 0.1 10
refused "is no drive speed" "$case_file" 0.1 "10 mm/s" 3
refused "must be positive and rise" "$case_file" 10 0.1 3
refused "must be positive and rise" "$case_file" 0 1 3
refused "number of points" "$case_file" 0.1 10 1
refused "number of points" "$case_file" 0.1 10 2.5
refused "unknown option" "$case_file" 0.1 10 3 --modell mdr
refused "a value is missing" "$case_file" 0.1 10 3 --set
refused "models" "$case_file" 0.1 10 3 --model mdrr
refused "unknown key mdr.spring" "$case_file" 0.1 10 3 --set mdr.spring=5
refused "cannot be read" missing.toml 0.1 10 3
refused "rolling.speed" "$source_dir/cases/rig_sphere_parallel.toml" 0.1 10 3
refused "is no program" "$case_file" 0.1 10 3 --program missing

printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
