#!/usr/bin/env bash
# The finite element layer when things go wrong: killed while condensing and while stepping, a
# cache that is damaged, foreign, full or read-only, too little memory, bad meshes.
# usage: fem_faults.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
child=
trap 'kill -9 $child 2>/dev/null; rm -rf "$work"' EXIT
export OPENBLAS_NUM_THREADS=1


# A coarse layer: a second to condense, another to step.
layer_command=("$program" run "$source_dir/examples/cases/rig_layer_parallel.toml" --models fem --no-report --no-studies
    --set 'fem.size="2 mm"' --set 'fem.cache="cache"' --set output.volume=none)
layer() {
    "${layer_command[@]}" "$@"
}

# refused PATTERN COMMAND...: exit code 2, one line that matches, nothing written as a result.
refused() {
    local pattern=$1
    shift
    rm -rf refused
    "$@" --output refused >out.txt 2>err.txt
    local code=$?
    [ "$code" -eq 2 ] || complain "exit code $code, not 2: $* ($(tail -n 1 err.txt))"
    grep -qE "^error: .*($pattern)" err.txt || complain "$(tail -n 1 err.txt): not like $pattern"
    [ "$(grep -c '^error' err.txt)" -eq 1 ] || complain "not one error: $*"
    [ ! -e refused/summary.json ] || complain "a summary of a refused case"
}

same() {
    cmp -s "$1" "$2" || complain "$1 differs from $2"
}

# 1. A complete run, then again from the cache: the same bytes, and it says what was reused.
layer --output whole 2>first.txt || complain "the plain run: $(tail -n 1 first.txt)"
grep -q 'kept in' first.txt || complain "nothing kept: $(cat first.txt)"
layer --output again 2>second.txt || complain "the run from the cache"
grep -q 'reused from' second.txt || complain "nothing reused: $(cat second.txt)"
same whole/fem/history.csv again/fem/history.csv
[ ! -e whole/fem/steps.journal ] || complain "a journal is left behind"

# 2. Killed while stepping: the next run goes on, with the same bytes.
"${layer_command[@]}" --output killed --quiet &
child=$!
for _ in $(seq 1 3000); do
    [ "$(stat -c %s killed/fem/steps.journal 2>/dev/null || echo 0)" -gt 100000 ] && break
    kill -0 "$child" 2>/dev/null || break
    sleep 0.01
done
kill -9 "$child" 2>/dev/null || complain "the run was over before it could be killed"
wait "$child" 2>/dev/null
[ ! -e killed/summary.json ] || complain "a summary of a killed run"
layer --output killed 2>resumed.txt || complain "the resumed run: $(tail -n 1 resumed.txt)"
grep -qE '[1-9][0-9]* steps of an earlier run' resumed.txt || complain "nothing resumed"
for file in whole/fem/*; do same "$file" "killed/fem/$(basename "$file")"; done

# 3. A journal of another case is not used.
"${layer_command[@]}" --output other --quiet --set load.tangential_ratio=0.3 &
child=$!
for _ in $(seq 1 3000); do
    [ "$(stat -c %s other/fem/steps.journal 2>/dev/null || echo 0)" -gt 100000 ] && break
    kill -0 "$child" 2>/dev/null || break
    sleep 0.01
done
kill -9 "$child" 2>/dev/null || complain "the other run was over before it could be killed"
wait "$child" 2>/dev/null
layer --output other 2>other.txt || complain "the run over another case's journal"
grep -q 'earlier run' other.txt && complain "steps of another case were taken"
same whole/fem/history.csv other/fem/history.csv

# 4. Killed while condensing: no file that looks like a layer is left, and the next run works.
rm -rf cache
"${layer_command[@]}" --output early --quiet &
child=$!
sleep 0.6
kill -9 "$child" 2>/dev/null
wait "$child" 2>/dev/null
layer --output early --quiet || complain "the run after a kill while condensing"
same whole/fem/history.csv early/fem/history.csv

# 5. Damaged, truncated and foreign layers are noticed and recomputed.
spoil() {
    for file in cache/*.layer; do "$@" "$file"; done
    layer --output spoiled 2>spoiled.txt || complain "the run over a spoilt cache ($*)"
    grep -q 'recomputed' spoiled.txt || complain "not noticed ($*): $(cat spoiled.txt)"
    same whole/fem/history.csv spoiled/fem/history.csv
}
flip() { printf '\xff' | dd of="$1" bs=1 seek=50000 conv=notrunc 2>/dev/null; }
cut_off() { truncate -s 3000 "$1"; }
foreign() { printf 'another program' | dd of="$1" bs=1 conv=notrunc 2>/dev/null; }
spoil flip
spoil cut_off
spoil foreign

# 6. A cache that cannot be written: said, and the run goes on. A file size limit of 200 kB acts like a
# full disk for layers and journal; results are smaller than it.
rm -rf cache
(ulimit -f 200 && layer --set output.vtk=none --output full 2>full.txt) || complain "full disk: $(tail -n 1 full.txt)"
grep -q 'not kept' full.txt || complain "a full disk goes unnoticed: $(cat full.txt)"
[ -z "$(find cache -type f 2>/dev/null)" ] || complain "half a layer is left on a full disk"
same whole/fem/history.csv full/fem/history.csv
rm -rf cache && touch cache
layer --output no_folder 2>no_folder.txt || complain "a file where the cache should be"
grep -q 'not kept' no_folder.txt || complain "no cache goes unnoticed"
rm -f cache

# 7. Too little memory is refused before it is taken. The libraries alone have 0.9 GB of addresses. Where no
# solver is asked for, the iterative one takes over.
refused 'memory' bash -c "ulimit -v 1100000; exec \"\$@\"" limited "$program" run \
    "$source_dir/examples/cases/rig_layer_parallel.toml" --models fem --no-report --quiet \
    --set 'fem.size="0.8 mm"' --set 'fem.cache="none"' --set fem.solver=direct
pressed() {
    bash -c "ulimit -v $1; exec \"\$@\"" limited "$program" run "$source_dir/examples/cases/rig_layer_parallel.toml" \
        --models fem --no-report --no-studies --set 'fem.size="0.7 mm"' --set 'fem.cache="none"' --set output.vtk=none \
        --set output.volume=none --set load.press_steps=1 --set rolling.periods=1 --set rolling.increment="2 mm" "${@:2}"
}
pressed 1200000 --output by_iteration >by_iteration.txt 2>&1 || complain "no solution by iteration: $(tail -n 1 by_iteration.txt)"
grep -q 'solved for by iteration' by_iteration.txt || complain "too little memory is enough: $(cat by_iteration.txt)"

# 8. Meshes: written, read again to the same answer; a missing and a misnamed boundary are refused.
"$program" mesh "$source_dir/examples/cases/rig_layer_parallel.toml" --output meshed \
    --set 'fem.size="2 mm"' --set 'fem.cache="none"' >mesh.txt 2>&1 || complain "tricontact mesh"
for file in mesh.msh mesh.geo mesh.vtu; do [ -s meshed/$file ] || complain "no meshed/$file"; done
own() {
    sed "s|^size = .*|mesh = \"$1\"|" "$source_dir/examples/cases/rig_layer_parallel.toml" >own.toml
    shift
    "$program" run own.toml --models fem --no-report --no-studies --set 'fem.cache="none"' \
        --set output.volume=none "$@"
}
own "$work/meshed/mesh.msh" --output own --quiet || complain "a mesh of one's own"
# the file has 16 digits: the last ones of the answer differ
awk -F, 'NR == FNR { last = $0; next } { now = $0 }
    END { n = split(last, a, ","); split(now, b, ",")
          for (k = 1; k <= 8; ++k) { d = a[k] - b[k]; s = (a[k] < 0 ? -a[k] : a[k])
              if (d < 0) d = -d
              if (d > 1e-6 * s + 1e-12) exit 1 } }' \
    whole/fem/history.csv own/fem/history.csv || complain "another answer on the written mesh"
sed 's/"base"/"ground"/' meshed/mesh.msh >misnamed.msh
refused 'ground' own "$work/misnamed.msh"
sed '/"base"/d' meshed/mesh.msh >missing.msh
refused 'missing.msh' own "$work/missing.msh"
head -c 20000 meshed/mesh.msh >short.msh
refused 'short.msh' own "$work/short.msh"

# 9. An archive of others leaves no layer in the user's folder, nor is one from there taken for what is computed again.
export XDG_CACHE_HOME=$work/users
"$program" run "$source_dir/examples/cases/rig_layer_parallel.toml" --models fem --no-studies --set 'fem.size="2 mm"' \
    --set rolling.periods=1 --set rolling.steps=turning-points --output exported --export paper --quiet >/dev/null 2>&1 ||
    complain "the archive"
[ -n "$(ls users/tricontact)" ] || complain "the run keeps no layer"
rm -r users
"$program" reproduce paper/archive.zip --quiet >said.txt 2>&1 || complain "reproduce: $(cat said.txt)"
[ ! -e users ] || complain "reproduce fills the user's folder: $(find users)"

finish
