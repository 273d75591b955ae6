#!/usr/bin/env bash
# A sweep that is killed over and over and goes on each time ends with the same table as one that is
# not: nothing is lost, nothing doubled, no process outlives its sweep. So does one on a full disk.
# usage: sweep_killed.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
child=
trap 'kill -9 $child 2>/dev/null; chmod -R u+w "$work"; rm -rf "$work"' EXIT

# Every fifth point fails: it would slide, which the model finds out when it knows F_N.
cat >study.toml <<EOF
case = "$source_dir/examples/cases/rig_sphere_parallel.toml"
models = ["mdr"]
[set]
load.indentation = "0.5 mm"
rolling.periods = 10
rolling.run_all = true
mdr.springs = 500
[vary]
rolling.amplitude_ratio = {from = 0.1, to = 0.5, points = 6}
load.tangential_force = ["1 N", "2 N", "3 N", "4 N", "4000 N"]
rolling.increment = ["0.1 mm", "0.15 mm"]
EOF
n_points=60
n_failed=12

sweep() {
    "$program" sweep "$work/study.toml" "$@"
}
# In the background; not by way of a shell that would be killed in its place.
start_sweep() {
    "$program" sweep "$work/study.toml" "$@" &
    child=$!
}
milliseconds() { date +%s%3N; }
pause() { sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"; }  # milliseconds
# Processes, other than this script, whose command line names the folder.
processes_of() {
    printf '%s' "$work/$1" >pattern  # not on the command line: grep would find itself
    grep -lFf pattern /proc/[0-9]*/cmdline 2>/dev/null | tr -dc '0-9\n'
}
same_table() {
    cmp -s "undisturbed/results.csv" "$1/results.csv" || complain "another table: $2"
    command -v sqlite3 >/dev/null || return
    local counts
    counts=$(sqlite3 "$1/results.sqlite" 'PRAGMA integrity_check;
        SELECT count(*), count(DISTINCT key), count(results) FROM points;')
    [ "$counts" = "ok"$'\n'"$n_points|$n_points|$((n_points - n_failed))" ] ||
        complain "rows of the store: $2: $counts"
}

start=$(milliseconds)
sweep --output "$work/undisturbed" --jobs 2 --quiet 2>undisturbed.txt
[ $? -eq 1 ] || complain "exit code of a sweep with failed points"
took=$(($(milliseconds) - start))
grep -q "^error: $n_failed of $n_points points failed" undisturbed.txt || complain "$(cat undisturbed.txt)"
[ "$(wc -l <undisturbed/results.csv)" -eq $((n_points + 1)) ] || complain "rows undisturbed"
sweep --output "$work/alone" --jobs 1 --quiet 2>/dev/null
same_table alone "one job instead of two"
sweep --output "$work/many" --jobs 7 --quiet 2>/dev/null
same_table many "seven jobs instead of two"

# 1. Twenty times kill -9; points found never get fewer. One that was done before it could be killed
#    is begun again.
RANDOM=20261121
found=0
kills=0
for _ in $(seq 1 20); do
    start_sweep --output "$work/killed" --jobs 2 2>log
    pause $((RANDOM * took / 7 / 32768))
    kill -9 "$child" 2>/dev/null
    wait "$child" 2>/dev/null
    if grep -q '^error' log; then
        same_table killed "after some of $kills kills"
        rm -rf killed
        found=0
        continue
    fi
    kills=$((kills + 1))
    now=$(sed -n 's/ of .* points are there already$//p' log)
    [ -n "$now" ] || continue  # none yet, or killed before it could say so
    [ "$now" -ge "$found" ] || complain "$found points were there, now $now"
    found=$now
done
[ "$kills" -ge 10 ] || complain "only $kills of 20 kills met a sweep"
sleep 0.5
[ -z "$(processes_of killed)" ] || complain "processes outlive their sweep: $(processes_of killed)"
sweep --output "$work/killed" --jobs 2 --quiet 2>/dev/null
same_table killed "after $kills kills, $found points found by the last"
printf '%d kills; %d of %d points before the last one\n' "$kills" "$found" "$n_points"

# 2. Killed processes of a sweep: their points are computed again, after the others and by then in peace.
start_sweep --output "$work/workers" --jobs 2 --quiet 2>/dev/null
for _ in $(seq 1 4); do
    pause $((took / 20))
    for process in $(processes_of workers); do
        [ "$process" -eq "$child" ] || kill -9 "$process" 2>/dev/null
    done
done
wait "$child"
same_table workers "after its processes were killed"

# 3. A process that crashes is a failed point with its signal; --retry-failed heals it.
start_sweep --output "$work/crashed" --jobs 1 --quiet 2>/dev/null
for _ in $(seq 1 200); do
    process=$(processes_of crashed | grep -vx "$child" | head -n 1)
    # Stopped first: a process that has just ended takes signals too, and leaves no trace of them.
    [ -n "$process" ] && kill -STOP "$process" 2>/dev/null &&
        grep -q '^State:.T' "/proc/$process/status" 2>/dev/null &&
        kill -SEGV "$process" && kill -CONT "$process" && break
    sleep 0.01
done
wait "$child"
[ "$(grep -c 'signal 11' crashed/results.csv)" -eq 1 ] || complain "no trace of the crash"
sweep --output "$work/crashed" --jobs 2 --quiet --retry-failed 2>/dev/null
cmp -s undisturbed/results.csv crashed/results.csv || complain "another table after --retry-failed"

# 4. A full disk: one clear error, and the sweep goes on when there is space. A limit on the size of
#    files acts like one.
message=$(ulimit -f 120 && sweep --output "$work/full" --jobs 2 --quiet 2>&1)
[ $? -eq 2 ] || complain "exit code on a full disk"
[[ $message == "error: $work/full/results.sqlite: cannot be written ("*"); free space on the disk"* &&
    $message != *$'\n'* ]] || complain "full disk: $message"
[ -e full/results.csv ] && complain "a table of a sweep that is not finished"
sweep --output "$work/full" --jobs 2 2>log
grep -q 'points are there already' log || complain "nothing kept on a full disk: $(cat log)"
same_table full "after a full disk"

# A real one, and a read-only one, where the system lets us mount them.
mkdir disk kept
mounted() {
    unshare --user --map-root-user --mount sh -c "mount -t tmpfs -o size=150k none disk && $1" \
        2>/dev/null
}
command="'$program' sweep study.toml --output disk --jobs 2 --quiet"
mounted "{ $command 2>full.txt; echo \$? >full_code; cp disk/results.sqlite* kept/; }"
if [ -e full_code ]; then
    [ "$(cat full_code)" -eq 2 ] || complain "exit code on a full file system"
    grep -q '^error: disk/results.sqlite: cannot be written (.*); free space' full.txt ||
        complain "full file system: $(cat full.txt)"
    sweep --output "$work/kept" --jobs 2 2>log
    grep -q 'points are there already' log || complain "nothing kept on a full file system"
    same_table kept "after a full file system"
fi
mounted "mount -o remount,ro disk && { $command 2>locked.txt; echo \$? >locked_code; }"
if [ -e locked_code ]; then
    [ "$(cat locked_code)" -eq 2 ] || complain "exit code on a read-only file system"
    grep -q '^error: disk: .* cannot be written to (Read-only file system); choose' locked.txt ||
        complain "read-only file system: $(cat locked.txt)"
fi

# 5. A folder in which nothing may be written, as root too.
message=$(sweep --output /proc/tricontact 2>&1)
[ $? -eq 2 ] || complain "exit code of a folder that cannot be made"
[[ $message == "error: /proc/tricontact: the output folder cannot be made"* ]] ||
    complain "read-only: $message"
if [ "$(id -u)" -ne 0 ]; then
    cp -r undisturbed locked
    chmod 500 locked
    message=$(sweep --output "$work/locked" 2>&1)
    [ $? -eq 2 ] || complain "exit code of a read-only folder"
    [[ $message == *"cannot be written to (Permission denied)"* ]] || complain "$message"
    chmod 700 locked
    chmod 400 locked/results.sqlite
    message=$(sweep --output "$work/locked" 2>&1)
    [[ $message == *"the file is read-only"* ]] || complain "read-only file: $message"
fi

# 6. Two sweeps at once in one folder: the second is told.
start_sweep --output "$work/twice" --jobs 1 --quiet 2>/dev/null
for _ in $(seq 1 200); do
    [ -s twice/results.sqlite ] && break
    sleep 0.01
done
kill -STOP "$child"  # or it might be done before the other loses patience
message=$(sweep --output "$work/twice" --jobs 1 --quiet 2>&1)
[ $? -eq 2 ] || complain "exit code of a second sweep: $message"
[[ $message == *"twice: is being filled by another run; wait until that has ended, or choose another"* ]] || complain "two sweeps: $message"
kill -CONT "$child"
wait "$child"
same_table twice "while a second sweep wanted to run"

finish
