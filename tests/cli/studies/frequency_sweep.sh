#!/usr/bin/env bash
# scripts/frequency_sweep.sh: a row per speed, what a run says of it; finished points are kept, those
# of another case are not; bad input is refused before anything is written.
# usage: frequency_sweep.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

case_file=$source_dir/examples/cases/rig_sphere_layer_relaxing.toml
sweep() {
    "$source_dir/scripts/frequency_sweep.sh" --program "$program" "$@"
}
small=(--model mdr --set mdr.springs=200 --set rolling.periods=3)

# column NAME: its values.
column() {
    awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i; next }
        { print $k }' out/results.csv
}
# rises_by FACTOR: numbers, each so many times the one before (0: greater than that).
rises_by() {
    awk -v f="$1" '!/^[0-9.]+(e[-+]?[0-9]+)?$/ { exit 1 }
        NR > 1 && (f ? $1 / last / f - 1 > 1e-9 || $1 / last / f - 1 < -1e-9 : $1 <= last) { exit 1 }
        { last = $1 }'
}

sweep "$case_file" 0.1 10 3 "${small[@]}" --output out >first.txt 2>&1 || complain "$(cat first.txt)"
grep -q '^sweep: 3 points in ' first.txt || complain "not three runs: $(cat first.txt)"
[ "$(wc -l <out/results.csv)" -eq 4 ] || complain "not three rows"
grep -q '</svg>' out/frequency_sweep.svg || complain "no picture"
[ "$(grep -c '<title>' out/frequency_sweep.svg)" -ge 7 ] || complain "curves are missing"
column rolling.speed_m_per_s | rises_by 10 || complain "speeds: $(column rolling.speed_m_per_s)"
column frequency_Hz | rises_by 10 || complain "frequencies: $(column frequency_Hz)"
column largest_deborah_number | rises_by 10 || complain "$(column largest_deborah_number)"
column storage_modulus_Pa | rises_by 0 || complain "moduli: $(column storage_modulus_Pa)"
"$program" run "$case_file" --models mdr --set mdr.springs=200 --set rolling.periods=3 --quiet \
    --no-report --no-studies --set "rolling.speed=1 mm/s" --output alone || complain "a run alone"
alone() { grep -m1 "\"$1\"" alone/summary.json | sed 's/.*: //; s/,$//'; }
[ "$(column final_shift_ratio | sed -n 2p)" = "$(alone final_shift_ratio)" ] ||
    complain "another shift than a run alone: $(alone final_shift_ratio)"
for name in frequency_Hz storage_modulus_Pa loss_modulus_Pa; do
    [ "$(column $name | sed -n 2p)" = "$(alone $name)" ] ||
        complain "$name: not that of a run alone: $(alone $name)"
done

# Again: nothing is left to be done. Another case is another sweep.
cp out/results.csv first.csv
sweep "$case_file" 0.1 10 3 "${small[@]}" --output out >again.txt 2>&1 || complain "the second sweep"
grep -q '^3 of 3 points are there already$' again.txt || complain "not resumed: $(cat again.txt)"
cmp -s first.csv out/results.csv || complain "another table after resuming"
sweep "$case_file" 0.1 10 3 "${small[@]}" --set friction.coefficient=0.6 --output out >other.txt 2>&1
grep -q 'there already' other.txt && complain "points of another case taken over"

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
refused "the substrate does not relax" "$source_dir/examples/cases/rig_sphere_parallel.toml" 0.1 10 3
refused "is no program" "$case_file" 0.1 10 3 --program missing

finish
