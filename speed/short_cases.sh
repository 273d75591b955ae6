#!/usr/bin/env bash
# Short cases in a series: processor time of a point of a sweep, pressed and loaded (2 steps), and rolled for a period
# (18 steps), by bem on 12 cells in the contact radius; without the start, which one point alone takes.
# usage: short_cases.sh PROGRAM...
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/loaded.toml" <<'END'
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
cells_per_radius = 12
END
{
    cat "$folder/loaded.toml"
    printf '[rolling]\namplitude_ratio = 0.2\nsteps_per_quarter = 4\nperiods = 1\nrun_all = true\n'
} >"$folder/rolled.toml"

# seconds PROGRAM CASE N: of processors, for N points
seconds() {
    {
        printf 'title = "short"\ncase = "%s.toml"\nmodels = ["bem"]\nlevels = 1\n[vary]\nload.tangential_ratio = [' "$2"
        for ((k = 0; k < $3; k++)); do printf '%s0.%05d' "${k:+, }" $((10000 + 200 * k)); done | sed 's/^, //'
        printf ']\n'
    } >"$folder/study.toml"
    rm -rf "$folder/out"
    TIMEFORMAT='%U %S'
    { time "$1" sweep "$folder/study.toml" --jobs 1 --output "$folder/out" --no-report --quiet; } 2>&1 | awk '{print $1 + $2}'
}

for program in "$@"; do
    for case in loaded rolled; do
        awk -v program="$program" -v case="$case" -v all="$(seconds "$program" "$case" 201)" -v one="$(seconds "$program" "$case" 1)" \
            'BEGIN { printf "%s, %s: %.1f ms of processors a point\n", program, case, (all - one) / 200 * 1e3 }'
    done
done
