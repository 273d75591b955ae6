#!/bin/sh
# Computes a study as an array job of SLURM, whose number it prints; the task that ends last merges the parts.
# Called again after a task failed, it computes only what is missing.
# usage: submit_sweep.sh STUDY.toml PARTS FOLDER [OPTION OF SBATCH]...
set -eu
study=$1 parts=$2 folder=$3
here=$(dirname -- "$0")
shift 3
mkdir -p "$folder"
rm -f "$folder"/part_*.done "$folder/merging"
sbatch --parsable --job-name=sweep --array="1-$parts" --output="$folder/part_%a.log" "$@" \
    "$here/sweep_part.sh" "$study" "$parts" "$folder"
