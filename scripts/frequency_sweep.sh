#!/usr/bin/env bash
# Runs a case with a relaxing substrate at a range of drive speeds: one table and one picture of the
# shift over the frequency. Called again it keeps the points that are finished.
# usage: frequency_sweep.sh CASE.toml FROM TO POINTS [--model NAME] [--output DIR] [--program FILE]
#                           [--set KEY=VALUE]...
#   FROM, TO   slowest and fastest drive [mm/s]; POINTS of them (2 to 1000) at equal ratios
#   --model    the model that runs (the first one of the case)
#   --output   folder for frequency_sweep.csv, .svg and the runs (results/<case>_frequencies)
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

mapfile -t speeds < <(awk -v a="$from" -v b="$to" -v n="$points" \
    'BEGIN { for (i = 0; i < n; i++) printf "%.6g\n", a * (b / a) ^ (i / (n - 1)) }')

# resolve SPEED: the case at this speed as the program understands it; the program says what is wrong.
resolve() {
    "$program" check "$case_file" "${settings[@]}" --set "rolling.speed=$1 mm/s"
}
resolved=$(resolve "$from") || exit $?
resolve "$to" >/dev/null || exit $?
[ -n "$model" ] || model=$(sed -n 's/^models = *\[ *['\''"]\([^'\''"]*\).*/\1/p' <<<"$resolved")
settings+=(--set "models=[\"$model\"]")
resolve "$from" >/dev/null || exit $?
if [ -z "$output" ]; then
    name=$(basename "$case_file")
    output=results/${name%.toml}_frequencies
fi
mkdir -p "$output" || exit 2

# is_finished DIR SPEED: numbers stand there, they are those of this case and of this program.
is_finished() {
    [ -s "$1/summary.json" ] && [ -s "$1/case.toml" ] || return 1
    grep -qF "\"version\": \"$("$program" --version | sed 's/.* //')\"" "$1/summary.json" || return 1
    resolve "$2" | cmp -s -n "$(stat -c %s "$1/case.toml")" - "$1/case.toml"
}

# value KEY: the first one of a key in the summary of the point; null is an empty field.
value() {
    grep -m1 "\"$1\": " "$point/summary.json" | sed 's/.*": //; s/,$//; s/^null$//; s/"//g'
}

columns="speed_m_per_s frequency_Hz largest_deborah_number storage_modulus_Pa loss_modulus_Pa"
columns+=" loss_tangent static_shift_ratio final_shift_ratio shift_increment_ratio state periods"
columns+=" limit_tangential_ratio"
table=$output/frequency_sweep.csv
tr ' ' ',' <<<"$columns" >"$table.new"
failed=0
for speed in "${speeds[@]}"; do
    point=$output/$speed
    if is_finished "$point" "$speed"; then
        printf '%s mm/s: finished before\n' "$speed"
    elif "$program" run "$case_file" "${settings[@]}" --set "rolling.speed=$speed mm/s" \
        --output "$point" --quiet --no-report --no-studies; then
        printf '%s mm/s: done\n' "$speed"
    else
        failed=$((failed + 1))
        printf '%s mm/s: failed, not in the table\n' "$speed" >&2
        continue
    fi
    row=$(awk -v v="$speed" 'BEGIN { printf "%.6g", v / 1000 }'),$(value frequency_Hz)
    # Of the slowest branch.
    row+=,$(sed -n '/"deborah_numbers"/,/\]/p' "$point/summary.json" | tr -d ' ,' |
        grep -E '^[0-9]' | sort -g | tail -n 1)
    for column in ${columns#* * * }; do row+=,$(value "$column"); done
    printf '%s\n' "$row" >>"$table.new"
done
mv "$table.new" "$table"
[ "$failed" -lt "${#speeds[@]}" ] || exit 1

gnuplot <<EOF
set terminal svg size 640,720 font "sans,12"
set output "$output/frequency_sweep.svg"
set datafile separator ","
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
plot "$table" using 2:7 with linespoints pointtype 7 linecolor rgb "#555555" title "static", \
    "" using 2:8 with lines linecolor rgb "#0072b2" title "after the last period", \
    "" using 2:(strcol(10) eq "shakedown" ? \$8 : NaN) with points pointtype 7 \
        linecolor rgb "#0072b2" title "shakedown", \
    "" using 2:(strcol(10) eq "ratcheting" ? \$8 : NaN) with points pointtype 9 \
        linecolor rgb "#d55e00" title "ratcheting", \
    "" using 2:(strcol(10) eq "undecided" ? \$8 : NaN) with points pointtype 6 \
        linecolor rgb "#0072b2" title "undecided"
set xlabel "frequency of the rolling [Hz]"
set ylabel "modulus [MPa]"
set logscale y
plot "$table" using 2:(\$4/1e6) with linespoints pointtype 7 linecolor rgb "#d55e00" title "G'", \
    "" using 2:(\$5/1e6) with linespoints pointtype 5 linecolor rgb "#0072b2" title "G''"
unset multiplot
EOF
printf 'table:   %s\npicture: %s\n' "$table" "$output/frequency_sweep.svg"
[ "$failed" -eq 0 ]
