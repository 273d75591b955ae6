#!/bin/sh
# Brings the parts of a study together, and writes its table and its report.
# usage: sweep_merge.sh STUDY.toml FOLDER
set -eu
study=$1 folder=$2
tricontact sweep merge "$folder" "$folder"/part_*/
tricontact sweep "$study" --output "$folder"
