#!/usr/bin/env bash
# Writes records as a vibrometer would give them, from what a model says about a case: truth plus
# drift, a table that wobbles with the drive, noise, rounding, and contacts that differ by 1 % from
# run to run. Equal seeds, equal bytes, whatever the awk.
# usage: synthetic_records.sh PROGRAM CASE.toml MODEL FOLDER [SPEED in m/s, else 1e-3]
set -euo pipefail
[ $# -eq 4 ] || [ $# -eq 5 ] || { sed -n '/^# usage/s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
program=$1 case_file=$2 model=$3 folder=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$folder"

"$program" run "$case_file" --models "$model" --output "$work" --no-report --no-studies --quiet \
    --set output.vtk=none --set rolling.run_all=true
for run in 1 2 3; do
    awk -F, -v speed="${5:-1e-3}" -v seed="$run" -v case_file="$(basename "$case_file")" -v model="$model" '
        # Park and Miller (1988): exact in double precision.
        function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
        function gauss() { return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform()) }
        BEGIN {
            sampling = 0.05; rest = 30; drift = 1e-9    # SI units
            noise = 60e-9; resolution = 80e-9; wobble = 1.5e-3; spread = 0.01
            state = 1000 + seed
            for (i = 0; i < 10; i++) uniform()
            scale = 1 + spread * gauss()
        }
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        {
            phase = $column["phase"]; n = (phase > 0) ? n + 1 : 0    # the last before rolling
            phases[n] = phase; shift[n] = $column["shift_x_m"]; offset[n] = $column["offset_x_m"]
            if (offset[n] > amplitude) amplitude = offset[n]
        }
        END {
            period = 4 * amplitude / speed
            printf "# SYNTHETIC, no measurement: %s by %s, seed %d: truth times %.5f,\n", \
                case_file, model, seed, scale
            printf "# drift %g nm/s, wobble %g, noise %g nm, steps of %g nm; examples/scripts/synthetic_records.sh\n", \
                drift * 1e9, wobble, noise * 1e9, resolution * 1e9
            print "time [s],shift [um],drive [mm]"
            end = 2 * rest + phases[n] * period; k = 0
            for (t = 0; t < end; t += sampling) {
                p = (t - rest) / period
                if (p < 0) p = 0
                if (p > phases[n]) p = phases[n]
                while (k < n - 1 && phases[k + 1] < p) k++
                part = (p - phases[k]) / (phases[k + 1] - phases[k])
                u = scale * (shift[k] + part * (shift[k + 1] - shift[k]))
                w = offset[k] + part * (offset[k + 1] - offset[k])
                u += drift * (t - rest) + wobble * w + noise * gauss()
                steps = int(u / resolution + 1000.5) - 1000    # rounds negative ones too
                printf "%.2f,%.2f,%.4f\n", t, steps * resolution * 1e6, w * 1e3
            }
        }' "$work/$model/history.csv" >"$folder/run_$run.csv"
done
