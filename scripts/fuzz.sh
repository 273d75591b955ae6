#!/usr/bin/env bash
# Feeds the reader of cases, then that of input files of CONTACT and those of other codes' results, with mutilated
# files, under address and undefined sanitizers.
# usage: fuzz.sh [SECONDS]   (60; of the others a third each)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
seconds=${1:-60}

"$root/scripts/setup.sh" no-fem fuzz
cmake -S "$root" --preset fuzz --log-level=NOTICE
cmake --build "$root/build/fuzz" --target case_reader_fuzz contact_program_fuzz benchmark_results_fuzz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for folder in bad bad_walk bad_contact; do
    /usr/bin/python3 "$root/tests/cli/bad_inputs.py" "$root/tests/cli/$folder" "$work/$folder"
done
mkdir "$work/new" "$work/new_contact" "$work/new_results"
# New inputs go to the first folder; what crashes stays in build/fuzz.
"$root/build/fuzz/tests/fuzz/case_reader_fuzz" -dict="$root/tests/fuzz/case_reader.dict" \
    -max_len=3000 -max_total_time="$seconds" -artifact_prefix="$root/build/fuzz/" \
    -print_final_stats=1 -print_funcs=0 -verbosity=0 "$work/new" "$root/examples/cases" \
    "$work/bad" "$work/bad_walk"
"$root/build/fuzz/tests/fuzz/contact_program_fuzz" -max_len=4000 -max_total_time="$((seconds / 3 + 1))" \
    -artifact_prefix="$root/build/fuzz/" -print_final_stats=1 -print_funcs=0 -verbosity=0 \
    "$work/new_contact" "$work/bad_contact" "$root/tests/contact_program"
"$root/build/fuzz/tests/fuzz/benchmark_results_fuzz" -max_len=40000 -max_total_time="$((seconds / 3 + 1))" \
    -artifact_prefix="$root/build/fuzz/" -print_final_stats=1 -print_funcs=0 -verbosity=0 \
    "$work/new_results" "$root/tests/benchmarks/formats" "$root/tests/benchmarks/foreign"
