#!/usr/bin/env bash
# Processes that begin together and need the same layer: one condenses it, the others wait for it, and all have the
# same numbers. When that one is killed another one does.
# usage: layer_once.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
export OPENBLAS_NUM_THREADS=1

start() {
    "$program" run "$source_dir/examples/cases/rig_layer_parallel.toml" --models fem --no-report --no-studies \
        --set fem.cache="$work/cache" --set output.volume=none --set output.vtk=none --set rolling.periods=1 \
        --set rolling.steps=turning-points --set fem.size="$2 mm" --output "$1" >/dev/null 2>"$1.txt" &
}
# together NUMBER SIZE: so many runs, of which the n-th writes into run_n and run_n.txt; sets their processes.
together() {
    rm -rf run_*
    processes=()
    for n in $(seq "$1"); do
        start "run_$n" "$2"
        processes[n]=$!
    done
}
condensed() { cat run_*.txt | grep -c ' condensed to '; }
reused() { cat run_*.txt | grep -c ' reused from '; }
only_layers() {
    [ -n "$(ls "$1")" ] && [ -z "$(ls -A "$1" | grep -v '\.layer$')" ] || complain "left in $1: $(ls -A "$1")"
}
kept() { find "$1" -mindepth 1 | wc -l; }

# A run alone tells how many layers it needs: its own, and a coarser one that shows the error of the mesh.
declare -a processes
together 1 2
wait
n_layers=$(condensed)
[ "$n_layers" -ge 1 ] && [ "$(kept cache)" -eq "$n_layers" ] || complain "no layer: $(cat run_1.txt)"
mv run_1 alone
rm -rf cache

together 3 2
wait
[ "$(condensed)" -eq "$n_layers" ] || complain "$n_layers layers condensed $(condensed) times"
[ "$(reused)" -eq $((2 * n_layers)) ] || complain "$n_layers layers reused $(reused) times"
for n in 1 2 3; do cmp alone/fem/history.csv "run_$n/fem/history.csv" || complain "run $n has other numbers"; done
only_layers cache

# The one that condenses is killed as soon as the other one waits for it.
together 2 1.5
for _ in $(seq 3000); do
    waits=$(grep -l 'is waited for' run_*.txt) && break
    sleep 0.01
done
case $waits in
    run_1.txt) kill -9 "${processes[2]}" ;;
    run_2.txt) kill -9 "${processes[1]}" ;;
    *) complain "nobody waited: $(cat run_*.txt)" ;;
esac
wait 2>/dev/null
[ -e "${waits%.txt}/summary.json" ] || complain "the run that waited has no results: $(cat "$waits")"
only_layers cache

# The points of a sweep have processes of their own.
cat >study.toml <<EOF
case = "$source_dir/examples/cases/rig_layer_parallel.toml"
models = ["fem"]
[set]
fem.cache = "$work/swept"
fem.size = "2 mm"
rolling.periods = 1
rolling.steps = "turning-points"
[vary]
load.tangential_ratio = [0.1, 0.2, 0.3]
EOF
"$program" sweep study.toml --jobs 3 --quiet --no-report || complain "the sweep"
[ "$(column error results/study/results.csv | tr -d '\n')" = "" ] || complain "points of the sweep failed"
only_layers swept

finish
