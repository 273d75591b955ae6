#!/bin/sh
# Computes a study as an array job of SLURM, and merges its parts when all have ended; prints the numbers of both jobs.
# Called again after a part failed, it computes only what is missing.
# usage: submit_sweep.sh STUDY.toml PARTS FOLDER [OPTION OF SBATCH]...
set -eu
study=$1 parts=$2 folder=$3
here=$(dirname -- "$0")
shift 3
mkdir -p "$folder"
array=$(sbatch --parsable --job-name=sweep --array="1-$parts" --output="$folder/part_%a.log" "$@" \
    "$here/sweep_part.sh" "$study" "$parts" "$folder")
merge=$(sbatch --parsable --job-name=merge --dependency="afterok:$array" --kill-on-invalid-dep=yes --output="$folder/merge.log" "$@" \
    "$here/sweep_merge.sh" "$study" "$folder")
echo "$array $merge"
