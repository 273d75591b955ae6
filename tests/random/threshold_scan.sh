#!/usr/bin/env bash
# What the chosen thresholds of the judge of walks decide: verdicts (regime, transient over or not) of 400 random machines
# that change where a threshold is half a decade smaller or larger.
# usage: tests/random/threshold_scan.sh, after the build; takes a quarter of an hour. Table in docs/explanation/walking.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=build/release
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# verdicts SOURCE EXPRESSION OUTPUT: of the program with a source changed by sed; the others come from the library.
verdicts() {
    sed -E "$2" "dynamics/$1" > "$work/changed.cc"
    c++ -std=c++20 -O2 -ffp-contract=off -I. tests/random/random_machines.cc "$work/changed.cc" \
        $build/dynamics/libtricontact_dynamics.a $build/contact/libtricontact_contact.a -lfmt -pthread -o "$work/program"
    for seed in 1 2; do "$work/program" $seed 200 20000 verdicts; done | sed 's/ mu_e.*//' > "$3"
}

# scan SOURCE BEFORE VALUE: the text before the number, and the number.
scan() {
    grep -qF "$2$3" "dynamics/$1" || { echo "dynamics/$1 has no \"$2$3\"" >&2; exit 1; }
    for factor in 0.316 3.16; do
        value=$(awk "BEGIN { print $3 * $factor }")
        verdicts "$1" "s/$2$3/$2$value/" "$work/now"
        echo "$2$3 -> $value: $(diff "$work/as_is" "$work/now" | grep -c '^>') of 400 change"
    done
}

verdicts walk_judge.cc '' "$work/as_is"
scan walk_judge.cc 'still = ' 0.01
scan walk_judge.cc 'even = ' 0.001
scan walk_judge.cc 'near = ' 0.01
scan walk_judge.cc 'growth = ' 0.1
scan limit_cycle.cc 'misses = ' 100
