#!/usr/bin/env bash
# Runs a case with a relaxing substrate at a range of drive speeds, by `tricontact sweep`: one table
# and one picture of the shift over the frequency. Called again it keeps the points that are finished.
# usage: frequency_sweep.sh CASE.toml FROM TO POINTS [--model NAME] [--output DIR] [--program FILE]
#                           [--set KEY=VALUE]...
#   FROM, TO   slowest and fastest drive [mm/s]; POINTS of them (2 to 1000) at equal ratios
#   --model    the model that runs (the first one of the case)
#   --output   folder for the sweep's results and frequency_sweep.svg (results/<case>_frequencies)
#   --program  (build/release/app/tricontact)
#   --set      overrides a key of the case
# Exit codes: 0 done, 1 a run failed (the others are in the table), 2 bad input.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)

refuse() {
    printf 'error: %s\n' "$1" >&2
    exit 2
}

positional=()
settings=()
model=
output=
program=$root/build/release/app/tricontact
while [ $# -gt 0 ]; do
    case $1 in
        --model | --output | --program | --set)
            [ $# -ge 2 ] || refuse "$1: a value is missing; give one"
            case $1 in
                --model) model=$2 ;;
                --output) output=$2 ;;
                --program) program=$2 ;;
                --set) settings+=(--set "$2") ;;
            esac
            shift
            ;;
        --*) refuse "$1: unknown option; options are --model, --output, --program, --set" ;;
        *) positional+=("$1") ;;
    esac
    shift
done
[ ${#positional[@]} -eq 4 ] ||
    refuse "${#positional[@]} arguments, but four are due: CASE.toml FROM TO POINTS"
case_file=${positional[0]} from=${positional[1]} to=${positional[2]} points=${positional[3]}
for speed in "$from" "$to"; do
    [[ $speed =~ ^[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$ ]] ||
        refuse "$speed: is no drive speed; give a plain number of mm/s"
done
awk -v a="$from" -v b="$to" 'BEGIN { exit !(0 < a && a < b) }' ||
    refuse "from $from to $to mm/s: speeds must be positive and rise; exchange or correct them"
{ [[ $points =~ ^[0-9]{1,4}$ ]] && [ "$points" -ge 2 ] && [ "$points" -le 1000 ]; } ||
    refuse "$points: number of points must be whole, 2 to 1000"
[ -x "$program" ] || refuse "$program: is no program; build it, or name it by --program"
command -v gnuplot >/dev/null || refuse "gnuplot is missing; install gnuplot-nox"

if [ -z "$output" ]; then
    name=$(basename "$case_file")
    output=results/${name%.toml}_frequencies
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# resolve SETTINGS...: the case as the program understands it; the program says what is wrong.
resolve() {
    "$program" check "$case_file" "${settings[@]}" --set "rolling.speed=$from mm/s" "$@"
}
resolve >"$work/case.toml" || exit $?
[ -n "$model" ] || model=$(sed -n 's/^models = *\[ *['\''"]\([^'\''"]*\).*/\1/p' "$work/case.toml")
resolve --set "models=[\"$model\"]" >"$work/case.toml" || exit $?
grep -q '^\[substrate.relaxation\]' "$work/case.toml" ||
    refuse "$case_file: the substrate does not relax: shifts are the same at all speeds; add [substrate.relaxation]"
cat >"$work/study.toml" <<EOF
case = "case.toml"
[vary]
rolling.speed = {from = "$from mm/s", to = "$to mm/s", points = $points, scale = "log"}
EOF
code=0
"$program" sweep "$work/study.toml" --output "$output" || code=$?
[ "$code" -le 1 ] || exit "$code"
table=$output/results.csv
grep -qE ',(shakedown|ratcheting|undecided),' "$table" || exit "$code" # nothing to be drawn

gnuplot <<EOF
set terminal svg size 640,720 font "sans,12"
set output "$output/frequency_sweep.svg"
set datafile separator ","
set datafile columnheaders
set logscale x
set format x "10^{%T}"
set format y "%g"
set grid linecolor rgb "#e4e4e4"
set key above horizontal reverse Left
set border 3
set tics nomirror out
set lmargin 12
set multiplot layout 2,1
set ylabel "shift U / U_{max}, $model"
f = "frequency_Hz"
settled(state) = strcol("state") eq state ? column("final_shift_ratio") : NaN
plot "$table" using (column(f)):"static_shift_ratio" with linespoints pointtype 7 \
        linecolor rgb "#555555" title "static", \
    "" using (column(f)):"final_shift_ratio" with lines linecolor rgb "#0072b2" \
        title "after the last period", \
    "" using (column(f)):(settled("shakedown")) with points pointtype 7 \
        linecolor rgb "#0072b2" title "shakedown", \
    "" using (column(f)):(settled("ratcheting")) with points pointtype 9 \
        linecolor rgb "#d55e00" title "ratcheting", \
    "" using (column(f)):(settled("undecided")) with points pointtype 6 \
        linecolor rgb "#0072b2" title "undecided"
set xlabel "frequency of the rolling [Hz]"
set ylabel "modulus [MPa]"
set logscale y
megapascals(name) = column(name)/1e6
plot "$table" using (column(f)):(megapascals("storage_modulus_Pa")) with linespoints \
        pointtype 7 linecolor rgb "#d55e00" title "G'", \
    "" using (column(f)):(megapascals("loss_modulus_Pa")) with linespoints \
        pointtype 5 linecolor rgb "#0072b2" title "G''"
unset multiplot
EOF
printf 'table:   %s\npicture: %s\n' "$table" "$output/frequency_sweep.svg"
exit "$code"
