#!/usr/bin/env bash
# tricontact experiment: the example, its numbers and files, and what is wrong with records.
# usage: experiment.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# expect CODE ARGUMENTS...: output goes to the files out and err.
expect() {
    local code=$1 got
    shift
    "$program" experiment "$@" >out 2>err
    got=$?
    [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*: $(cat err)"
}

# says TEXT FILE
says() {
    grep -qF -- "$1" "$2" || complain "no '$1' in $2: $(head -c 600 "$2")"
}

# refused TEXT: data.toml is, with this message and nothing written.
refused() {
    expect 2 data.toml --output none
    says "$1" err
    [ "$(wc -l <err)" -eq 1 ] || complain "more than one line: $(cat err)"
    [ -e none ] && complain "$1: something was written"
}

# 1. The example, by the fast model only: its truth is that of bem-layer.
mkdir examples && cp -r "$source_dir/examples/records" examples
sed -i 's/^models = .*/models = ["mdr"]/' examples/records/synthetic_shakedown.toml
expect 0 examples/records/synthetic_shakedown.toml --output example --quiet
says "Shakedown in 3 of 3 runs" out
says "disagrees; this comparison would have seen" out
says "MDR, all periods: measured minus computed over n = 0 ... 12: furthest at n = " out
says "series_mdr" example/report.html
[ -s err ] && complain "--quiet is not silent: $(cat err)"
says '"state": "shakedown"' example/experiment.json
says "curvature" example/report.html
expect 0 examples/records/synthetic_shakedown.toml --output again --quiet
cmp -s example/experiment.json again/experiment.json || complain "another time, other numbers"
cmp -s example/report.html again/report.html || complain "another time, another report"

# 2. The same records made again: equal bytes, but for what another processor's models round.
grep -q SYNTHETIC examples/records/synthetic/run_1.csv || complain "a synthetic record does not say so"

# 3. What is wrong with [record].
run=examples/records/synthetic/run_1.csv
# write LINE...: a file with records alone.
write() { printf '%s\n' '[record]' "$@" >data.toml; }
# of_case SED LINE...: the example's case with another [record].
of_case() {
    sed '/^\[record\]/,$d' examples/records/synthetic_shakedown.toml | sed "$1" >data.toml
    shift
    printf '%s\n' '[record]' "$@" >>data.toml
}
printf 'title = "nothing"\n' >data.toml
refused "data.toml:1:1: missing section [record]: nothing was recorded"
write 'runs = ["run.csv"]'
refused "data.toml:1:1: missing key record.kind"
write 'kind = "shakedwon"' 'runs = ["run.csv"]'
refused '"shakedwon" is not one of "shakedown", "ratcheting", "limit"; did you mean "shakedown"?'
write 'kind = "shakedown"'
refused "missing key record.runs"
write 'kind = "shakedown"' "runs = [\"$run\", \"$run\"]"
refused "stands twice; name each once"
write 'kind = "shakedown"' 'runs = ["missing.csv"]'
refused "missing.csv: the file cannot be read"
write 'kind = "shakedown"' "runs = [\"$run\"]" 'confidnce = 0.9'
refused "data.toml:4:1: unknown key record.confidnce; did you mean record.confidence?"
write 'kind = "shakedown"' "runs = [\"$run\"]" '[record.drive]' 'period = "4 s"'
refused "data.toml:4:1: [record.drive] and the column drive of the runs both give it"
write 'kind = "shakedown"' "runs = [\"$run\"]" 'resolution = 80'
refused "data.toml:4:14: record.resolution = 80: must be a length, but has no unit"
of_case 's/21.1 ± 0.1 N/21.1 ± 0.1 mm/' 'kind = "shakedown"' "runs = [\"$run\"]"
refused 'load.normal_force = "21.1 ± 0.1 mm": "mm" is a unit of length, but this is a force'
of_case 's/^amplitude_ratio = .*/amplitude_ratio = 0.24/; s/^thickness = .*/thickness_ratio = "0.9 ± 0.1"/' \
    'kind = "shakedown"' "runs = [\"$run\"]"
refused "substrate.thickness_ratio: an uncertainty of this ratio is not propagated; state the length"

# The same substrate, its modulus stated relaxed or unrelaxed (g = 0.5: twice as large), both known to 5 %: the same ±.
for young in "relaxed 5.2 MPa" "unrelaxed 10.4 MPa"; do
    of_case "s/^young = \"5.2 MPa\"/young = \"${young#* } ± 5 %\"/; /^thickness/d; s/^\[rolling\]/&\nspeed = \"1 mm\/s\"/
        s/^\[friction\]/[substrate.relaxation]\nmodulus = \"${young% * *}\"\nrelative_moduli = [0.5]\ntimes = [\"0.1 s\"]\n&/" \
        'kind = "shakedown"' "runs = [\"$run\"]"
    expect 0 data.toml --output relaxing --quiet
    mv out "${young% * *}"
done
says "U_sd = 302 ± 7 µm" relaxed
cmp relaxed unrelaxed || complain "the uncertainty of an unrelaxed modulus: $(cat unrelaxed)"

# 4. What is wrong with a record. record NAME COMMAND...: run 1 changed by awk.
write 'kind = "shakedown"' 'runs = ["run.csv"]'
record() { awk -F, -v OFS=, "$1" "$run" >run.csv; }
record '{ print $1, $3 }'
refused "run.csv:3: the column shift is missing"
record 'NR == 3 { print "time [s],shift,drive [mm]"; next } 1'
refused 'run.csv:3: the column "shift" has no unit in brackets; write for example time [s], shift [um]'
record 'NR == 3 { print "time [s],shift [s],drive [mm]"; next } 1'
refused '"s" is a unit of time, but this is a length'
record 'NR == 3 { print "time [s],shift [um],speed [mm]"; next } 1'
refused 'unknown column "speed"; known are time, shift, drive'
record 'NR == 100 { $1 = 0 } 1'
refused "run.csv:100: time = 0: times must increase from row to row"
record 'NR == 99 { before = $1 } NR == 100 { $1 = before } 1'
refused "times must increase from row to row"
record 'NR == 100 { $2 = "nan" } 1'
refused "run.csv:100: shift = nan: must be a finite number"
record 'NR == 100 { print $1, $2; next } 1'
refused "run.csv:100: has 2 columns instead of 3"
record 'NR > 3 { $3 = 0 } 1'
refused "the drive does not move"
record 'NR <= 3 || NR > 590'
refused "samples of rest under load before rolling"
record 'NR <= 3 || NR < 950'
refused "periods from 30 s on, fewer than 5"
record 'NR <= 3 || NR % 4 == 0'
refused "samples, fewer than 32; sample faster"
record 'NR <= 3 || NR % 100 == 0'
refused "run.csv: "
record '{ print $1, $2 }'
refused "without a column drive its start and number of periods must be known"

# 5. Without the drive its period is found, or given.
write 'kind = "shakedown"' 'runs = ["run.csv"]' '[record.drive]' 'start = "30 s"' 'periods = 12'
expect 0 data.toml --output found --quiet
says "Shakedown: residual ratcheting contributes at most" out
write 'kind = "shakedown"' 'runs = ["run.csv"]' '[record.drive]' 'start = "30 s"' 'periods = 12' \
    'amplitude = "1.0807 mm"' 'speed = "1 mm/s"'
expect 0 data.toml --output given --quiet
says '"amplitude_m": 0.0010807' given/experiment.json
write 'kind = "limit"' 'runs = ["run.csv"]'
refused "amplitudes that rise in steps need the column drive"

# 6. A limit run: 1, 1.1, 1.2 and 1.3 mm at 1 mm/s; from 1.2 mm on the contact ratchets 3 um per period.
awk 'BEGIN {
    print "time [s],shift [um],drive [mm]"
    begin = 30; u = 60
    for (t = 0; t < 30; t += 0.05) printf "%.2f,%.2f,0\n", t, u
    for (stage = 0; stage < 4; stage++) {
        W = 1 + stage / 10
        for (; t < begin + 24 * W; t += 0.05) {
            n = (t - begin) / (4 * W); phase = n - int(n)
            w = W * (phase < .25 ? 4 * phase : phase < .75 ? 2 - 4 * phase : 4 * phase - 4)
            step = int(n) + (phase < .25 ? 0 : phase < .75 ? 0.5 : 1)
            s = u + 10 * (1 - 0.3 ^ step) + (stage > 1 ? 3 * step : 0)
            printf "%.2f,%.2f,%.4f\n", t, s, w
        }
        u += 10 * (1 - 0.3 ^ 6) + (stage > 1 ? 18 : 0); begin += 24 * W
    }
    for (i = 0; i < 40; i++) printf "%.2f,%.2f,0\n", t + i * 0.05, u
}' >run.csv
of_case '' 'kind = "limit"' 'runs = ["run.csv"]'
expect 0 data.toml --output limit --quiet
says "W_lim = 1.15 ± 0.05 mm" out
says "MDR: W_lim" out
says '"last_shakedown_m": 0.00109' limit/experiment.json
grep -q "all periods" out && complain "a limit run has no series"
write 'kind = "shakedown"' 'runs = ["run.csv"]'
refused "the amplitude changes from 1 mm to 1.1 mm at 54 s"

# 7. What the rig sets is a force: f_T has the errors of mu and F_N whether the case states F_T or
#    its ratio, and no number is ± 0. Without [errors] it is undecided whether models differ.
json() { "$python" -c "import json; print(json.load(open('$1'))$2)"; }
run=examples/records/synthetic/run_1.csv
cp "$source_dir/$run" run.csv
ratio=$(awk 'BEGIN { printf "%.17g", 6.735 / (0.57 * 21.1) }')
exact='s/21.1 ± 0.1 N/21.1 N/; s/"0.57 ± 0.01"/0.57/'
as_ratio="s/^tangential_force.*/tangential_ratio = $ratio/"
uncertain='s/^coefficient.*/coefficient = "0.57 ± 0.02"/'
record=('kind = "shakedown"' 'runs = ["run.csv"]')
of_case "$exact; $uncertain" "${record[@]}"
expect 0 data.toml --output force --quiet
of_case "$exact; $uncertain; $as_ratio" "${record[@]}"
expect 0 data.toml --output ratio --quiet
for number in "['normalised']['tangential_ratio']['standard_error']" \
    "['models'][0]['deviations'][0]['predicted_m']['high']"; do
    a=$(json force/experiment.json "$number") b=$(json ratio/experiment.json "$number")
    awk "BEGIN { exit !($a > 0 && ($a / $b - 1)^2 < 1e-12) }" || complain "$number: $a, $b"
done
of_case "$exact; s/^tangential_force.*/tangential_ratio = \"$ratio ± 0.01\"/" "${record[@]}"
expect 0 data.toml --output set --quiet
got=$(json set/experiment.json "['normalised']['tangential_ratio']['standard_error']")
awk "BEGIN { exit !(($got / 0.01 - 1)^2 < 1e-12) }" || complain "error of the ratio: $got"
of_case "$exact; $as_ratio" "${record[@]}"
expect 0 data.toml --output plain --quiet
says "states no uncertainty" out
grep -q "disagrees" out && complain "models differ without errors"
grep -q "± 0 " out && complain "± 0: $(cat out)"
[ "$(json plain/experiment.json "['models'][0]['deviations'][0]['differs']")" = None ] ||
    complain "differs without errors"
[ "$(json plain/experiment.json "['models'][0]['series']['differs']")" = None ] ||
    complain "the series differs without errors"

# 8. A relaxing substrate rests under F_T as long as recorded, and rolls as fast: the model's
#    static shift is that of a run with this hold.
of_case "$exact; $uncertain; $as_ratio; s/^periods.*/&\nspeed = \"9 m\/s\"/; /^\[bem\]/,\$d" \
    '[substrate.relaxation]' 'G2 = "1.73 MPa"' 'eta = "17.3 MPa s"' '[output]' 'vtk = "none"'
sed '/^\[record\]/d' data.toml >relaxing.toml
# relaxing LINE...: that case with [record].
relaxing() { (cat relaxing.toml && printf '%s\n' '[record]' 'kind = "shakedown"' "$@") >data.toml; }
awk -F, 'NR > 3 && $1 < 4 { $2 = 0.0 } { print $1 "," $2 (NR > 2 ? "," $3 : "") }' run.csv >loaded.csv
relaxing 'runs = ["loaded.csv"]' 'loading = "4 s"'
expect 0 data.toml --output relaxing --quiet
says "The substrate relaxes: the models rest under F_T for" out
hold=$(json relaxing/experiment.json "['rolled_as']['hold_s']")
speed=$(json relaxing/experiment.json "['rolled_as']['speed_m_per_s']")
awk "BEGIN { exit !($hold > 25 && $hold < 27 && $speed > .9e-3 && $speed < 1.1e-3) }" ||
    complain "hold $hold, speed $speed"
"$program" run relaxing.toml --set load.hold="$hold s" --set rolling.speed="$speed m/s" \
    --output run >/dev/null 2>&1 || complain "run"
a=$(json relaxing/experiment.json "['models'][0]['shift_m'][0]")
b=$(json run/summary.json "['models']['mdr']['static_shift_m']" 2>/dev/null ||
    json run/summary.json "['models'][0]['static_shift_m']")
awk "BEGIN { exit !(($a / $b - 1)^2 < 1e-12) }" || complain "static shift $a, after a hold $b"
relaxing 'runs = ["run.csv"]'
expect 0 data.toml --output missing --quiet
says "the record does not say when F_T was applied" out
says "how long F_T acted before the rolling is not known" out

# A prescribed path is refused by its name, not by a key that nobody typed.
{
    sed '/^\[load\]/,/^$/d; /^\[rolling\]/,$d' "$source_dir/examples/records/synthetic_shakedown.toml"
    printf '%s\n' '[path]' 'table = """' 'normal_force [N], tangential_force_x [N]' '21, 0' '21, 5' '"""' \
        '[record]' 'kind = "shakedown"' 'runs = ["run.csv"]'
} >data.toml
expect 2 data.toml --output path --quiet
says "data.toml: [path]: records are compared with models that roll back and forth" err
# 9. A record is checked before it is evaluated: what is wrong with it is named, and stands in the JSON.
write 'kind = "shakedown"' 'runs = ["run.csv"]'
run="$source_dir/examples/records/synthetic/run_1.csv"
# damaged KIND TEXT AWK: evaluated, with a finding of the kind.
damaged() {
    record "$3"
    expect 0 data.toml --output damaged --quiet
    says "$2" out
    json damaged/experiment.json "['runs'][0]['findings'][0]['kind']" | grep -qx "$1" || complain "no $1"
}
damaged outlier "1 sample is left out" 'NR == 300 { $2 += 40 } 1'
damaged jump "the shift jumps by" 'NR > 800 { $2 += 40 } 1'
says "Shakedown and ratcheting are not resolved" out
damaged gap "there is a gap of 0.6500 s" 'NR < 620 || NR > 631'
record 'NR > 3 { $2 = 12.5 } 1'
refused "the shift is 12.5 µm in all"
record 'NR < 900 || NR > 960'
refused "what the drive did there is not known"
damaged sign "the shift under F_T is −15" 'NR > 3 { $2 = -$2 } 1'
says "Its values are not compared with models" out
damaged drive "the drive turns" 'NR > 3 && $3 > .7 { $3 = .7 } 1'
write 'kind = "shakedown"' 'loading = "4 s"' 'runs = ["run.csv"]'
record '1'
refused "but the shift does not rise before the rolling"
damaged loading "the shift rises at 3 s: the record counts" 'NR > 3 && $1 < 3 { $2 = 0 } 1'

# The models roll as the drive did: another amplitude is said, another unit refused.
of_case 's/^models.*/models = ["mdr"]/; s/^amplitude_ratio.*/amplitude = "1.4 mm"/' 'kind = "shakedown"' 'runs = ["run.csv"]'
record '1'
expect 0 data.toml --output rolled --quiet
says "The models roll as the drive did, by 1.08 mm; the case states 1.40 mm." out
record 'NR > 3 { $3 *= 1000 } 1'
refused "run.csv: the drive goes to 1.08 m on both sides, the case states 1.40 mm"

# 10. Steps are a source of uncertainty; where the limit of the half-space (mu = 0.493) lies within the
#     error of mu, both fates are possible, and the answer says how probable.
cp "$run" run.csv
of_case 's/^coefficient.*/coefficient = "0.493 ± 0.02"/; s/^steps_per_quarter.*/steps_per_quarter = 2/; s/^thickness.*//' \
    'kind = "shakedown"' 'runs = ["run.csv"]'
expect 0 data.toml --output near --quiet
says "MDR: the limit lies within the uncertainty of the case. Shakedown and ratcheting are both possible" out
json near/experiment.json "['models'][0]['deviations'][1]['comparison']['sources']" | grep -q "'steps'" ||
    complain "steps are no source"
sed -i 's/0.493 ± 0.02/0.57 ± 0.002/' data.toml
expect 0 data.toml --output far --quiet
grep -q "the limit lies within" out && complain "a limit that is far off: $(cat out)"
[ "$(json far/experiment.json "['models'][0]['chance_of_ratcheting']")" = None ] || complain "a chance"

finish
