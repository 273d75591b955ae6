#!/usr/bin/env bash
# A run that is killed leaves whole files only: what has a final name is complete, and a model that
# had finished has all its results.
# usage: killed.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
child=
trap 'kill -9 $child 2>/dev/null; rm -rf "$work"' EXIT

ends_with() {
    tail -c 40 "$1" | tr -d '\n\0' | grep -aq "$2\$" || complain "truncated: $1"
}

# Every line of a CSV file has as many values as the first, and the last one ends.
whole_csv() {
    awk -F, 'NR == 1 { n = NF } NF != n { bad = 1 } END { exit bad || NR < 2 }' "$1" ||
        complain "ragged or empty: $1"
    [ "$(tail -c 1 "$1" | od -An -tx1 | tr -d ' ')" = 0a ] || complain "truncated: $1"
}

whole() {
    case $1 in
        *.vti | *.vtp | *.vtu | *.vts | *.pvd) ends_with "$1" '</VTKFile>' ;;
        *.csv) whole_csv "$1" ;;
        *.toml) "$program" check "$1" >/dev/null || complain "cannot be read: $1" ;;
        */.tricontact) ends_with "$1" 'summary.json' ;;
        *) complain "unexpected file: $1" ;;
    esac
}

# kill_when FILE [PERIODS]: starts a run that takes long, kills it as soon as the file is there.
kill_when() {
    rm -rf killed
    "$program" run "$source_dir/examples/cases/rig_sphere_parallel_ratcheting.toml" --output killed --quiet \
        --set rolling.periods="${2:-1000}" --set rolling.run_all=true --set output.vtk=all \
        --set "rolling.increment=0.5 mm" --set mdr.springs=300 &
    child=$!
    for _ in $(seq 1 2000); do
        [ -e "killed/$1" ] && break
        kill -0 "$child" 2>/dev/null || { complain "ended before killed/$1 came"; return; }
        sleep 0.01
    done
    kill -9 "$child" || complain "the run was over before it could be killed"
    wait "$child" 2>/dev/null
    [ -e "killed/$1" ] || complain "killed/$1 did not come"
    [ -e killed/summary.json ] && complain "the summary of a run that was killed"
    local file n=0
    while read -r file; do
        whole "$file"
        n=$((n + 1))
    done < <(find killed -type f ! -name '.*.partial-*')
    [ "$n" -ge 2 ] || complain "only $n files"
}

# 1. While the first model writes.
kill_when mdr/surface_000010.vtp

# 2. While the second one writes: the first has all its files.
kill_when bem/surface_000005.vti 8
whole_csv killed/mdr/history.csv
n=$(find killed/mdr -name '*.vtp' | wc -l)
steps=$(($(wc -l <killed/mdr/history.csv) - 1))
[ "$n" -eq "$steps" ] || complain "$n surfaces of $steps steps"
[ "$(grep -c '<DataSet ' killed/mdr/surface.pvd)" -eq "$n" ] || complain "surface.pvd is not whole"

# 3. The same folder serves the next run.
"$program" run "$source_dir/examples/cases/rig_sphere_parallel_ratcheting.toml" --output killed --quiet \
    --models mdr --set rolling.periods=1 --no-report || complain "the folder of a killed run"
[ -s killed/summary.json ] || complain "no summary after the second run"

# 4. The check notices a truncated file.
head -c -20 killed/mdr/surface_000000.vtp >broken.vtp
(ends_with broken.vtp '</VTKFile>' >/dev/null; exit "$failures")
[ $? -gt "$failures" ] || complain "a truncated file goes unnoticed"

finish
