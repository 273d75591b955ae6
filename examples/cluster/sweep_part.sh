#!/bin/sh
# One part of a study: a task of an array job of SLURM, or a rank of MPI. Called again it computes what is missing.
# Whoever ends last brings the parts together, and writes the study's table and report.
# usage: sweep_part.sh STUDY.toml PARTS FOLDER
#   FOLDER gets a folder per part; tricontact is in PATH.
#SBATCH --requeue --open-mode=append --signal=B:TERM@60
set -eu
study=$1 parts=$2 folder=$3
part=${SLURM_ARRAY_TASK_ID:-}
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:-}}}
[ -n "$part" ] || part=$((${rank:?neither a task of an array job nor a rank of MPI} + 1))
mkdir -p "$folder"
# What this part left when it was killed.
rm -f "$folder/part_$part.done"
[ "$(readlink "$folder/merging")" != "$part" ] || rm -f "$folder/merging"

# A minute before its time is over the queue sends TERM: what is finished is stored, and the task goes to the end of the queue.
trap 'kill $!; scontrol requeue "${SLURM_ARRAY_JOB_ID}_$part"; exit' TERM
run() {
    tricontact sweep "$@" --jobs "${SLURM_CPUS_PER_TASK:-1}" --quiet &
    wait $! || [ $? -eq 1 ]  # 1: points that did not converge, which the table names
}
run "$study" --shard "$part/$parts" --output "$folder/part_$part" --no-report
touch "$folder/part_$part.done"

set -- "$folder"/part_*.done
[ $# -eq "$parts" ] && ln -s "$part" "$folder/merging" 2>/dev/null || exit 0
tricontact sweep merge "$folder" "$folder"/part_*/
run "$study" --output "$folder"
rm "$folder/merging"
