#!/usr/bin/env bash
# One flipped bit in what is kept for later calls - rows of results, levels of a refinement, journals,
# condensed layers - gives the same numbers as before, or an error, and never another number.
# usage: corruption.sh PROGRAM SOURCE_DIR [FLIPS_EACH [SEED]]
source "$(dirname -- "${BASH_SOURCE[0]}")/../at_random.bash"
flips=${3:-3}

# flip FILE: one bit of it, any; tells which.
flip() {
    local size at bit byte
    size=$(stat -c %s "$1")
    at=$(((RANDOM << 30 | RANDOM << 15 | RANDOM) % size))
    bit=$((RANDOM % 8))
    byte=$(od -An -tu1 -j "$at" -N 1 "$1")
    printf "\\x$(printf %02x $((byte ^ 1 << bit)))" | dd of="$1" bs=1 seek="$at" conv=notrunc 2>/dev/null
    flipped="bit $bit of byte $at of $1"
}

# sound CODES COMMAND...: one of these exit codes; an error is one line about our file, in our words.
sound() {
    local codes=$1
    shift
    "$@" >out.txt 2>err.txt
    code=$?
    [[ " $codes " == *" $code "* ]] || complain "$flipped: exit code $code: $*: $(tail -n 1 err.txt)"
    [ "$code" -eq 0 ] || [ "$(grep -c '^error: ' err.txt)" -eq 1 ] || complain "$flipped: $(cat err.txt)"
    ! grep -qE 'json\.exception|terminate|what\(\)' err.txt || complain "$flipped: $(cat err.txt)"
}

refused=0 noticed=0 harmless=0
count() {
    if [ "$code" -ne 0 ]; then
        refused=$((refused + 1))
    elif grep -q "$1" err.txt; then
        noticed=$((noticed + 1))
    else
        harmless=$((harmless + 1))
    fi
}
tell() {
    printf '%s: %d refused, %d noticed and computed again, %d harmless\n' "$1" "$refused" "$noticed" "$harmless"
    refused=0 noticed=0 harmless=0
}

# 1. Rows of results: the sweep goes on, or is refused; what fit and merge take is the same.
cat >study.toml <<EOF
case = "$source_dir/examples/cases/rig_sphere_parallel.toml"
models = ["mdr"]
[set]
mdr.springs = 100
rolling.periods = 3
[vary]
rolling.amplitude_ratio = {from = 0.1, to = 0.5, points = 4}
load.tangential_ratio = [0.1, 0.2, 0.3]
EOF
"$program" sweep study.toml --output whole --quiet || complain "the plain sweep"
for _ in $(seq 1 "$flips"); do
    rm -rf damaged merged
    cp -r whole damaged
    flip damaged/results.sqlite
    cp damaged/results.sqlite kept.sqlite
    sound "0 2" "$program" sweep merge merged damaged
    if [ "$code" -eq 0 ]; then
        "$program" sweep study.toml --output merged --quiet --no-report || complain "$flipped: after merge"
        cmp -s whole/results.csv merged/results.csv || complain "$flipped: another table after merge"
    fi
    cp kept.sqlite damaged/results.sqlite
    sound "0 2" "$program" sweep study.toml --output damaged --no-report
    if [ "$code" -eq 0 ]; then
        cmp -s whole/results.csv damaged/results.csv || complain "$flipped: another table"
        grep -q '^12 of 12 points are there' err.txt || echo 'rows computed again' >>err.txt
    fi
    count 'computed again'
done
tell "results.sqlite"

# 2. Levels of a refinement, which the next call takes over.
refine() {
    "$program" refine "$source_dir/examples/cases/rig_sphere_parallel.toml" --models bem --output "$1" \
        --set "bem.spacing=1 mm" --set rolling.periods=1 --set rolling.steps=turning-points
}
refine levels >/dev/null 2>&1 || complain "the plain refinement"
for _ in $(seq 1 "$flips"); do
    rm -rf damaged
    cp -r levels damaged
    flip damaged/results.sqlite
    sound "0 2" refine damaged
    if [ "$code" -ne 0 ]; then
        count ''
        continue
    fi
    n_taken=$(grep -c 'taken from' err.txt)
    # Times of computing differ.
    diff <(cut -d, -f1-3 levels/refinement.csv) <(cut -d, -f1-3 damaged/refinement.csv) >/dev/null ||
        complain "$flipped: another refinement.csv"
    [ "$n_taken" -eq 3 ] || echo 'computed again' >>err.txt
    count 'computed again'
done
tell "results.sqlite of a refinement"

has_fem || finish
layer_command=("$program" run "$source_dir/examples/cases/rig_layer_parallel.toml" --models fem --no-report
    --set 'fem.size="2 mm"' --set fem.cache=cache --set output.volume=none --no-studies)
layer() {
    "${layer_command[@]}" "$@"
}
same() {
    cmp -s fem/fem/history.csv damaged/fem/history.csv || complain "$flipped: another history"
}

# 3. Condensed layers.
layer --output fem --quiet || complain "the plain run"
cp -r cache whole_cache
for _ in $(seq 1 "$flips"); do
    rm -rf damaged cache
    cp -r whole_cache cache
    layers=(cache/*.layer)
    flip "${layers[RANDOM % ${#layers[@]}]}"
    sound 0 layer --output damaged
    same
    diff -r whole_cache cache >/dev/null || complain "$flipped: not recomputed"
    count 'recomputed'
done
[ "$harmless" -eq 0 ] || complain "$harmless flipped bits of a layer went unnoticed"
tell "condensed layer"

# 4. Journals of a run that was killed.
rm -rf cache
cp -r whole_cache cache
"${layer_command[@]}" --output killed --quiet &
child=$!
for _ in $(seq 1 3000); do
    [ "$(stat -c %s killed/fem/steps.journal 2>/dev/null || echo 0)" -gt 100000 ] && break
    kill -0 "$child" 2>/dev/null || break
    sleep 0.01
done
kill -9 "$child" 2>/dev/null || complain "the run was over before it could be killed"
wait "$child" 2>/dev/null
rm -rf damaged
cp -r killed damaged
flipped="no bit"
layer --output damaged >/dev/null 2>err.txt || complain "the resumed run"
same
n_steps=$(sed -n 's/.*: \([0-9]*\) steps of an earlier run.*/\1/p' err.txt)
[ "${n_steps:-0}" -ge 1 ] || complain "nothing resumed: $(cat err.txt)"
for _ in $(seq 1 "$flips"); do
    rm -rf damaged
    cp -r killed damaged
    flip damaged/fem/steps.journal
    sound 0 layer --output damaged
    same
    [ ! -e damaged/fem/steps.journal ] || complain "$flipped: the journal is left"
    grep -q ": $n_steps steps of an earlier" err.txt || echo 'steps computed again' >>err.txt
    count 'computed again'
done
[ "$harmless" -eq 0 ] || complain "$harmless flipped bits of a journal went unnoticed"
tell "journal ($n_steps steps)"

finish
