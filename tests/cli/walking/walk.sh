#!/usr/bin/env bash
# tricontact run: the numbers of sets A and B, of a machine with dimensions, files, what does not
# walk; what is refused leaves nothing behind.
# usage: walk.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
cases=$source_dir/examples/cases

# walk NAME CASE OPTIONS...: into the folder NAME, table to NAME.txt.
walk() {
    local name=$1 case_file=$2
    shift 2
    "$program" run "$cases/$case_file.toml" --output "$name" --set output.frames=4 "$@" \
        >"$name.txt" 2>"$name.log" || complain "$name: exit code $?: $(cat "$name.log")"
}

# number FILE KEY: its value, the key at any depth.
number() {
    sed -n "s/^ *\"$2\": \(.*[^,]\),\{0,1\}$/\1/p" "$1/summary.json"
}

# near FOLDER KEY DUE ERROR
near() {
    awk -v found="$(number "$1" "$2")" -v due="$3" -v error="$4" 'BEGIN {
        exit !(found != "" && found != "null" && found - due <= error && due - found <= error) }' ||
        complain "$1: $2 = $(number "$1" "$2") instead of $3 +- $4"
}

# is FOLDER KEY TEXT
is() {
    [ "$(number "$1" "$2")" = "$3" ] || complain "$1: $2 is $(number "$1" "$2") instead of $3"
}

# 1. Set B of the thesis on its limit cycle, as an independent program found it; the tolerances are
#    its digits.
walk b walking_set_b --set time.end=2500
is b regime '"limit-cycle"'
is b transient_over true
near b mu_e 0.0440 0.0005
near b period 4.2930 0.0001
near b z_min_ratio -0.4289 0.0005
near b z_max_ratio 2.3545 0.0005
near b stick_time_1 0.4265 0.002
near b stick_time_2 0.4931 0.002
near b correlation_1 -0.759 0.001
near b correlation_2 -0.727 0.001
near b kinetic_energy 3.225 0.001
near b phi_min -3.32e-5 1e-7
near b phi_max 3.12e-5 1e-7
near b lyapunov 0 0.02
near b critical_friction 0.917431 1e-6
is b dimensional null
for key in mu_e_error cpu_s lane_steps_per_s; do
    awk -v x="$(number b $key)" 'BEGIN { exit !(x > 0) }' || complain "b: $key is $(number b $key)"
done
grep -qE '^regime +limit-cycle +from t = [0-9.]+ on$' b.txt || complain "table: $(cat b.txt)"

# 2. Its files.
for file in case.toml summary.json windows.csv motion.csv report.html animation/machine.ex2; do
    [ -s "b/$file" ] || complain "no b/$file"
done
# One file; the number of its states follows netCDF's mark and version.
[ "$(find b/animation -type f | wc -l)" -eq 1 ] || complain "animation: $(ls b/animation)"
[ "$(od -An -tu1 -j4 -N4 b/animation/machine.ex2 | xargs)" = "0 0 0 4" ] || complain "frames: not 4"
[ "$(head -n 1 b/motion.csv | cut -d, -f1-9)" = \
    time,base,x,z,phi,x_velocity,z_velocity,phi_velocity,spring_force ] || complain "motion.csv"
[ "$(wc -l <b/motion.csv)" -eq $((500 * 20 + 2)) ] || complain "motion.csv has other lines"
awk -F, 'NR > 1 && NF != 12 { exit 1 }' b/windows.csv || complain "windows.csv has ragged lines"

# 3. The resolved case gives the same bytes but for the time taken.
"$program" run b/case.toml --output again --quiet || complain "again"
for file in case.toml windows.csv motion.csv animation/machine.ex2; do
    cmp -s "b/$file" "again/$file" || complain "$file differs"
done
diff <(grep -v '_s"' b/summary.json) <(grep -v '_s"' again/summary.json) || complain "numbers differ"

# 4. Set A slides; without friction there is no mu_e; a short run says so; beyond mu_c it tilts.
walk a walking_set_a --set time.end=5000 --no-report
is a regime '"steady"'
near a mu_e 1 0.001
[ -e a/report.html ] && complain "a report in spite of --no-report"
walk frictionless walking_set_b --set machine.kappa5=0 --set time.end=100
is frictionless mu_e null
walk short walking_set_b --set time.end=300
is short transient_over false
grep -q 'transient is not over' short.txt || complain "short: $(cat short.txt)"
walk tilting walking_set_b --set machine.kappa5=0.95 --set time.end=5000
is tilting regime '"tilting"'
awk -v x="$(number tilting tilting_time)" 'BEGIN { exit !(x > 0 && x < 5000) }' ||
    complain "tilting_time is $(number tilting tilting_time)"

#    A base too slow to load the spring by the end: nothing slides, nothing is known of friction.
walk loading walking_set_b --set machine.kappa6=1e-9 --set machine.kappa8=0.2 --set time.end=2000
is loading regime '"sticking"'
is loading transient_over false
is loading mu_e null
near loading loading_time 68000 1e-6
grep -q '^loaded  *t = 68000' loading.txt || complain "loading: $(cat loading.txt)"
grep -q 'Does not slide yet' loading/report.html || complain "loading: the report does not say so"
grep -q 'Slides steadily' loading/report.html && complain "loading: slides steadily"

# Progress as of other runs, on standard error; --quiet has none.
"$program" run "$cases/walking_set_b.toml" --set time.end=50 --no-report --output told >/dev/null 2>said.txt
[ "$(grep -c '^walk: [0-9]*0 %, part ' said.txt)" -eq 10 ] || complain "progress: $(cat said.txt)"
"$program" run "$cases/walking_set_b.toml" --set time.end=50 --no-report --output told --quiet >/dev/null 2>said.txt
[ -s said.txt ] && complain "--quiet: $(cat said.txt)"

# 5. Dimensions: tau = sqrt(m/k_x) of check, time in s.
walk rig walking_rig_set_5 --set "time.duration=0.1 s" --no-report
tau=$("$program" check "$cases/walking_rig_set_5.toml" --json |
    "$python" -S -c 'import json, sys; print(json.load(sys.stdin)["derived"]["tau"]["value"])')
near rig characteristic_time_s "$tau" 1e-9
head -n 1 rig/motion.csv | grep -q time_s,spring_force_N || complain "rig: no SI units in motion.csv"
awk -F, -v tau="$tau" 'END { exit !($10/tau - $1 < 1e-3 && $1 - $10/tau < 1e-3) }' rig/motion.csv ||
    complain "rig: time_s is not tau times time"

# 6. Any spots, rounded tips: a number for each, a report.
walk spots walking_set_b --set machine.model=spots --set "spots.positions=[-1, 0, 1]" \
    --set time.end=200
near spots stick_time_3 0.5 0.5
walk tips walking_set_b --set bed.radius=0.5 --set bed.springs=10 --set time.end=30
near tips stick_time_2 0.5 0.5
[ -s tips/report.html ] || complain "no report of rounded tips"

# 7. An earlier run's files do not stand beside a new one's.
"$program" run "$cases/walking_set_b.toml" --output b --quiet --no-report --set time.end=50 \
    --set output.frames=0 || complain "b again"
[ -e b/report.html ] || [ -e b/animation/machine.ex2 ] && complain "files of the run before"

for option in "--models bem" "--threads 2" "--points 3" --no-studies; do
    # shellcheck disable=SC2086
    refused "a case of the micro-walking machine has no ${option% *}; leave it out" run "$cases/walking_set_b.toml" $option
done
refused "exceeds the stable limit 0.6828" run "$cases/walking_set_b.toml" --set time.step=0.7
refused "machine.kappa5 = -0.1: must be at least 0" run "$cases/walking_set_b.toml" \
    --set machine.kappa5=-0.1
refused 'machine.mass = "-1 kg": must be greater than 0 kg' run "$cases/walking_rig_set_5.toml" \
    --set "machine.mass=-1 kg"

finish
