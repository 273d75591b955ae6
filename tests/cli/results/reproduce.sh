#!/usr/bin/env bash
# A run's case.toml reproduces the run byte for byte, whatever the number of threads and wherever
# it is started; only the times taken may differ.
# usage: reproduce.sh PROGRAM SOURCE_DIR
set -euo pipefail
program=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# A file without the times of the computation and the name of the folder.
timeless() {
    case $1 in
        */summary.json) sed '/^ *"\(cpu_s\|wall_s\)": [-0-9.e+]*,$/d' "$1" ;;
        */report.html) sed '/<th scope="row"[^>]*>CPU time\( per step\)\?<\/th>/d; /download="cost.csv"/d' "$1" ;;
        *) cat "$1" ;;
    esac
}

# same_results FOLDER FOLDER: same names, same bytes.
same_results() {
    local file
    diff <(cd "$1" && find . | sort) <(cd "$2" && find . | sort) ||
        complain "$1 and $2 hold different files"
    while read -r file; do
        cmp -s <(timeless "$1/$file") <(timeless "$2/$file") || complain "$1/$file differs in $2"
    done < <(cd "$1" && find . -type f)
}

# The filter takes out the times and nothing else: two per model, their row and its table as CSV.
lines_taken_out() {
    echo $(($(wc -l <"$1") - $(timeless "$1" | wc -l)))
}

# 1. Both models over some rolling, all files and the report; again from the resolved case.
cd "$work"
"$program" run "$source_dir/examples/cases/rig_sphere_perpendicular.toml" --output first --threads 1 \
    --quiet --set rolling.periods=2 --set "rolling.increment=0.5 mm" --set "bem.spacing=0.4 mm" \
    --set mdr.springs=2000
[ "$(lines_taken_out first/summary.json)" -eq 4 ] || complain "summary.json holds other times"
[ "$(lines_taken_out first/report.html)" -eq 2 ] || complain "report.html holds other times"
[ "$(find first -type f | wc -l)" -ge 30 ] || complain "only $(find first -type f | wc -l) files"
(cd first && "$program" run case.toml --output "$work/again" --threads 1 --quiet)
"$program" run "$work/first/case.toml" --output "$work/threaded" --threads 2 --quiet
same_results first again
same_results first threaded

# 2. A grid that is worth threads.
cat >large.toml <<'TOML'
models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.3
[bem]
spacing = "0.03 mm"
tolerance = 1e-4
TOML
for threads in 1 2 3; do
    "$program" run large.toml --output "large$threads" --threads "$threads" --quiet --no-report
done
cells=$(($(stat -c %s large1/bem/surface.ex2) / 100))  # at least: a cell has fewer bytes in a file of one state
[ $((cells)) -gt 100000 ] || complain "$cells cells: too few for threads to be used"
same_results large1 large2
same_results large1 large3

# 3. The comparison notices a difference in the last digits.
sed 's/"final_shift_m": \(.*\)[0-9],/"final_shift_m": \1x,/' first/summary.json >again/summary.json
cmp -s <(timeless first/summary.json) <(timeless again/summary.json) &&
    complain "a changed number goes unnoticed"

printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
