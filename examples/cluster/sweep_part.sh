#!/bin/sh
# One part of a study: a task of an array job of SLURM, or a rank of MPI. Called again it computes what is missing.
# usage: sweep_part.sh STUDY.toml PARTS FOLDER
#   FOLDER holds a folder per part; tricontact is in PATH.
#SBATCH --requeue --open-mode=append --signal=B:TERM@60
set -eu
study=$1 parts=$2 folder=$3
part=${SLURM_ARRAY_TASK_ID:-}
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:-}}}
[ -n "$part" ] || part=$((${rank:?neither a task of an array job nor a rank of MPI} + 1))

tricontact sweep "$study" --shard "$part/$parts" --output "$folder/part_$part" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
    --quiet --no-report &
# A minute before its time is over the queue sends TERM: what is finished is stored, and the task goes to the end of the queue.
trap 'kill $!; scontrol requeue "${SLURM_ARRAY_JOB_ID}_$part"; exit' TERM
wait $! || [ $? -eq 1 ]  # 1: points that did not converge, which the merged table names
