#!/usr/bin/env bash
# What docs/how-to/scaling.md says was measured: the layer of a case condensed by one and more processes.
# usage: scaling.sh PROGRAM CASE.toml "SIZES in mm" "RANKS"
#   e.g. speed/scaling.sh build/release/app/tricontact examples/cases/rig_layer_parallel.toml "1 0.7 0.5" "1 2"
# For each size and number of ranks: the stages' time, processor seconds of all ranks together
# (waiting for each other counts), and the largest process so far.
set -euo pipefail
program=$1 case=$2 sizes=$3 ranks=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
TIMEFORMAT='whole command: %U + %S s of processors, %R s'
export OPENBLAS_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1

# The coarse layer that fits the mesh to its contact is made beforehand.
"$program" mesh "$case" --output "$folder" --set fem.cache="$folder/probe" >/dev/null 2>&1
for size in $sizes; do
    for n in $ranks; do
        rm -rf "$folder/cache"
        cp -r "$folder/probe" "$folder/cache"
        printf '\nh = %s mm, %s ranks\n' "$size" "$n"
        time mpirun -n "$n" "$program" cache condense "$case" --set fem.size="$size mm" \
            --set fem.cache="$folder/cache" 2>&1 | sed -n 's/^fem: \(.*\), kept in .*/\1/p; s/^fem: \(.*processors.*\)/\1/p'
    done
    rm -rf "$folder/cache"
    cp -r "$folder/probe" "$folder/cache"
    printf '\nh = %s mm, without MPI (CHOLMOD)\n' "$size"
    time "$program" cache condense "$case" --set fem.size="$size mm" --set fem.cache="$folder/cache" \
        2>&1 | sed -n 's/^fem: \(.*\), kept in .*/\1/p'
done
