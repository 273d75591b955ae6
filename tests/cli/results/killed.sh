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

# states FILE: how many a series has, -1 where the file ends before its last one. Bytes 4 to 7 of netCDF's classic format
# are their number.
states() {
    "$python" -S - "$1" <<'PYTHON'
import struct, sys
content = open(sys.argv[1], "rb").read()
at, n_states = 8, struct.unpack(">I", content[4:8])[0]

def word():
    global at
    at += 4
    return struct.unpack(">I", content[at - 4:at])[0]

def text():
    global at
    n = word()
    at += (n + 3) // 4 * 4

def attributes():
    global at
    word()
    for _ in range(word()):
        text()
        size = {2: 1, 5: 4, 4: 4, 6: 8}[word()] * word()
        at += (size + 3) // 4 * 4

word()
lengths = []
for _ in range(word()):
    text()
    lengths.append(word())
attributes()
word()
end = record = 0
for _ in range(word()):
    text()
    dimensions = [word() for _ in range(word())]
    attributes()
    word()
    size, begin = word(), struct.unpack(">Q", content[at:at + 8])[0]
    at += 8
    of_records = dimensions and lengths[dimensions[0]] == 0
    record += size if of_records else 0
    end = max(end, 0 if of_records else begin + size)
print(n_states if content[:4] == b"CDF\x02" and end + n_states * record <= len(content) else -1)
PYTHON
}

whole() {
    case $1 in
        *.ex2) [ "$(states "$1")" -ge 1 ] || complain "truncated: $1" ;;
        *.csv) whole_csv "$1" ;;
        *.toml) "$program" check "$1" >/dev/null || complain "cannot be read: $1" ;;
        */.tricontact) ends_with "$1" 'summary.json' ;;
        *) complain "unexpected file: $1" ;;
    esac
}

# kill_when FILE BYTES [PERIODS]: starts a run that takes long, kills it as soon as the file is so large.
kill_when() {
    rm -rf killed
    "$program" run "$source_dir/examples/cases/rig_sphere_parallel_ratcheting.toml" --output killed --quiet \
        --set rolling.periods="${3:-1000}" --set rolling.run_all=true --set output.vtk=all \
        --set "rolling.increment=0.5 mm" --set mdr.springs=300 &
    child=$!
    for _ in $(seq 1 2000); do
        [ "$(stat -c %s "killed/$1" 2>/dev/null || echo 0)" -ge "$2" ] && break
        kill -0 "$child" 2>/dev/null || { complain "ended before killed/$1 had $2 bytes"; return; }
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

# 1. While the first model writes, at three moments.
for size in 1000 100000 300000; do kill_when mdr/surface.ex2 "$size"; done

# 2. While the second one writes: the first has all its files.
kill_when bem/surface.ex2 100000 8
whole_csv killed/mdr/history.csv
n=$(states killed/mdr/surface.ex2)
steps=$(($(wc -l <killed/mdr/history.csv) - 1))
[ "$n" -eq "$steps" ] || complain "$n surfaces of $steps steps"
[ "$(states killed/mdr/indenter.ex2)" -eq "$n" ] || complain "indenter.ex2 has other states"

# 3. The same folder serves the next run.
"$program" run "$source_dir/examples/cases/rig_sphere_parallel_ratcheting.toml" --output killed --quiet \
    --models mdr --set rolling.periods=1 --no-report || complain "the folder of a killed run"
[ -s killed/summary.json ] || complain "no summary after the second run"

# 4. The check notices a truncated file.
head -c -20 killed/mdr/surface.ex2 >broken.ex2
[ "$(states broken.ex2)" -eq -1 ] || complain "a truncated file goes unnoticed"

finish
