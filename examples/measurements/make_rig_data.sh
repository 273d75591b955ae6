#!/usr/bin/env bash
# Writes the tables of this folder, none of them measured: runs of bem-layer on the rig of thesis
# table 5.1.1 with the E and mu stated below and noise from a stated seed; and the curve that the
# thesis fitted to its measurement, whose readings are not published.
# usage: make_rig_data.sh PROGRAM [FOLDER]
set -euo pipefail
program=$(realpath "$1")
folder=$(realpath "${2:-$(dirname "$0")}")
case_file=$(realpath "$(dirname "$0")/../cases/rig_layer_parallel.toml")
young="4.22 MPa" friction=0.57
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# value KEY SETTINGS...: a result of the static case.
value() {
    local key=$1 setting arguments=()
    shift
    for setting in "$@"; do arguments+=(--set "$setting"); done
    grep -v '^\[rolling\]\|^amplitude_ratio\|^periods\|^increment' "$case_file" >"$work/case.toml"
    "$program" run "$work/case.toml" --models bem-layer --output "$work/out" --quiet --no-report \
        --no-studies --set "substrate.young=$young" --set "friction.coefficient=$friction" \
        --set bem.cells_per_radius=22.5 --set output.vtk=none "${arguments[@]}"
    grep -m 1 -oP "\"$key\": \K[^,]*" "$work/out/summary.json"
}

# noisy SEED ERROR SCALE: reads "x value", writes "x, value * scale + noise, ERROR". Normal numbers
# by Box and Muller from Park and Miller's generator: the same on every computer.
noisy() {
    awk -v seed="$1" -v error="$2" -v scale="$3" '
        function uniform() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
        BEGIN { for (i = 0; i < 10; i++) uniform() }  # of a small seed the first are small
        { n = sqrt(-2 * log(uniform())) * cos(2 * atan2(0, -1) * uniform())
          printf "%s, %.4g, %s\n", $1, $2 * scale + error * n, error }'
}

{
    echo "# Synthetic, no measurement: bem-layer, E = $young, mu = $friction, noise 0.5 um, seed 1;"
    echo "# made by make_rig_data.sh."
    echo "tangential_force [N], shift [um], shift_error [um]"
    for force in 1 2 3 4 5 6 7 8 9 10 11; do
        echo "$force $(value static_shift_m "load.tangential_force=$force N")"
    done | noisy 1 0.5 1e6
} >"$folder/rig_static_shift.csv"

{
    echo "# Synthetic, no measurement: bem-layer, E = $young, noise 0.05 N, seed 2;"
    echo "# made by make_rig_data.sh."
    echo "indentation [um], normal_force [N], normal_force_error [N]"
    for depth in 100 150 200 250 300 350 400; do
        echo "$depth $(value normal_force_N "load.indentation=$depth um" load.press=frictionless)"
    done | noisy 2 0.05 1
} >"$folder/rig_indentation.csv"

{
    echo "# Synthetic, no measurement: bem-layer, relaxed E = $young, held at 0.3 mm; times G(t)/G_inf of"
    echo "# g = G_1/G_0 = 0.3, tau = 10 s; noise 0.05 N, seed 3; made by make_rig_data.sh."
    echo "time [s], normal_force [N], normal_force_error [N]"
    relaxed=$(value normal_force_N "load.indentation=300 um" load.press=frictionless)
    for time in 0.5 1 2 4 6 8 10 15 20 30 40 60 80; do
        awk -v t="$time" -v F="$relaxed" 'BEGIN { print t, F * (1 + 0.3 / 0.7 * exp(-t / 10)) }'
    done | noisy 3 0.05 1
} >"$folder/rig_relaxation.csv"

{
    echo "# Synthetic, no measurement: bem-layer, E = $young, mu = $friction, rolled to and fro by 1 mm without tangential"
    echo "# force, third period; a pivot 60 um too high, shifts counted from 25 um, noise 0.2 um, seed 4; made by"
    echo "# make_rig_data.sh."
    echo "offset [mm], shift [um], shift_error [um]"
    value normal_force_N load.tangential_ratio=0 rolling.amplitude="1 mm" rolling.periods=3 \
        rolling.run_all=true >/dev/null
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        $column["phase"] > 2.001 { W = $column["offset_x_m"]
            printf "%.6g %.6e\n", 1e3 * W + 0, $column["shift_x_m"] + 60e-6 / 0.04 * W + 25e-6 }' \
        "$work/out/bem-layer/history.csv" | noisy 4 0.2 1e6
} >"$folder/rig_rolling_shift.csv"

{
    echo "# Synthetic, no measurement: a small ball on soft rubber by fem, neo-hookean, E = 0.6 MPa, elements of"
    echo "# 0.9 mm; noise 0.01 N, seed 5; made by make_rig_data.sh."
    echo "indentation [um], normal_force [N], normal_force_error [N]"
    for depth in 450 550 650 750 850; do
        "$program" run "$folder/soft_indentation.toml" --output "$work/out" --quiet --no-report --no-studies \
            --set 'models=["fem"]' --set substrate.young="0.6 MPa" --set friction.coefficient=0.5 \
            --set load.press=frictionless --set load.tangential_ratio=0 --set load.indentation="$depth um" \
            --set fem.size="0.9 mm" --set output.vtk=none
        echo "$depth $(grep -m 1 -oP '"normal_force_N": \K[^,]*' "$work/out/summary.json")"
    done | noisy 5 0.01 1
} >"$folder/soft_indentation.csv"

{
    echo "# Not measured: equation (2.1.18) of the thesis with its E = 5.2 MPa, mu = 0.57, nu = 1/2,"
    echo "# R = 40 mm, F_N = 21.1 N; made by make_rig_data.sh."
    echo "tangential_force [N], shift [um]"
    awk 'BEGIN { E = 5.2e6; mu = 0.57; F_N = 21.1; R = 0.04
        d = (3 * F_N / (4 * E / 0.75 * sqrt(R)))^(2 / 3)
        for (F = 1; F <= 11; F++)
            printf "%d, %.4f\n", F, 1e6 * mu * 1.5 * d * (1 - (1 - F / (mu * F_N))^(2 / 3)) }'
} >"$folder/thesis_static_shift.csv"
