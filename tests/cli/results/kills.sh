#!/usr/bin/env bash
# Commands that are killed at any time: the next call makes the same files as one that was not, and
# nothing else is left behind. A kill that comes too late is repeated until KILLS have met a command at work.
# usage: kills.sh PROGRAM SOURCE_DIR [KILLS [SEED]]
source "$(dirname -- "${BASH_SOURCE[0]}")/../at_random.bash"
kills=${3:-5}

# The commands run here, alone with their files; what this script keeps stands above.
mkdir calls temporary
cd calls || exit 1
export TMPDIR=$work/temporary
cat >study.toml <<EOF
case = "$source_dir/examples/cases/rig_sphere_parallel.toml"
models = ["mdr"]
[set]
mdr.springs = 2000
rolling.periods = 2
rolling.run_all = true
output.vtk = "quarters"
[vary]
rolling.amplitude_ratio = [0.1, 0.3]
load.tangential_ratio = [0.1, 0.2, 0.3]
EOF
sed '/^\[rolling\]/,/^$/d; /^\[fem\]/,$d' "$source_dir/examples/cases/rig_layer_parallel.toml" >static.toml
sphere=$source_dir/examples/cases/rig_sphere_parallel.toml
layer=$source_dir/examples/cases/rig_layer_parallel.toml

# Each writes into the folder of its name, from the folder above.
sweep=(sweep study.toml --output sweep --jobs 2 --vtk)
deviation=(deviation static.toml --set load.press=frictionless --set bem.cells_per_radius=6
    --output deviation --jobs 2)
limit=(limit "$sphere" --set rolling.amplitude_ratio=0.51 --set mdr.springs=2000
    --set "bem.spacing=0.8 mm" --tolerance 0.01 --output limit --threads 1)
refine=(refine "$sphere" --models bem --output refine --set "bem.spacing=0.8 mm" --set rolling.periods=2
    --threads 1)
run=(run "$sphere" --models mdr,bem --set "bem.spacing=0.8 mm" --set output.vtk=quarters --set rolling.periods=2
    --output run --threads 1 --no-report)
commands=(sweep deviation limit refine run)
if has_fem; then
    condense=(cache condense "$layer" --set 'fem.size="2 mm"' --set fem.cache=condense)
    run_fem=(run "$layer" --models fem --no-studies --no-report --set 'fem.size="2 mm"' --set fem.cache=run_fem/cache
        --output run_fem)
    commands+=(condense run_fem)
fi
# They take turns: of fewer kills the last ones do not get one (fem_faults.sh kills finite elements).
[ "$kills" -ge "${#commands[@]}" ] || commands=("${commands[@]:0:kills}")

milliseconds() { date +%s%3N; }
# start NAME: in the background, not by way of a shell that would be killed in its place.
start() {
    local -n arguments=$1
    "$program" "${arguments[@]}" >../out.txt 2>../err.txt &
    child=$!
}
# Its files with what they hold, but for those that differ between two calls that nobody disturbs: in
# times. Of these only the names.
contents() {
    (cd "$1" && find . -type f | LC_ALL=C sort >../../names
        grep -xFf "../../$1.times" ../../names
        grep -vxFf "../../$1.times" ../../names | xargs -d '\n' -r sha256sum)
}
# Processes, other than this script, that were started in this folder.
processes() {
    for process in /proc/[0-9]*; do
        [ "$(readlink "$process/cwd")" = "$work/calls" ] && [ "$(readlink "$process/exe")" = "$program" ] &&
            echo "${process#/proc/}"
    done 2>/dev/null
}

# timed NAME: a call that nobody disturbs; sets its milliseconds.
timed() {
    local began
    began=$(milliseconds)
    start "$1"
    wait "$child" || complain "$1: $(tail -n 1 ../err.txt)"
    milliseconds=$(($(milliseconds) - began))
}

# How long each takes into an empty folder, and into one in which all is done.
declare -A into_empty into_whole
for name in "${commands[@]}"; do
    timed "$name"
    mv "$name" "../$name.first"
    timed "$name"
    into_empty[$name]=$milliseconds
    comm -3 <(cd "$name" && find . -type f -exec sha256sum {} + | sort) \
        <(cd "../$name.first" && find . -type f -exec sha256sum {} + | sort) |
        awk '{ print $NF }' | sort -u >"../$name.times"
    contents "$name" >"../$name.due"
    cp -r "$name" "../$name.whole"
    timed "$name"
    into_whole[$name]=$milliseconds
done

# killed NAME MILLISECONDS: the call, killed at any moment of these; fails where it was over before.
killed() {
    delay=$((RANDOM * $2 / 32768))
    start "$1"
    sleep "$(printf '%d.%03d' $((delay / 1000)) $((delay % 1000)))"
    kill -9 "$child" 2>/dev/null
    { wait "$child"; } 2>/dev/null
    [ $? -eq 137 ]
}

n_met=0 n_late=0
while [ "$n_met" -lt "$kills" ]; do
    name=${commands[n_met % ${#commands[@]}]}
    rm -rf "$name"
    milliseconds=${into_empty[$name]}
    if [ $((RANDOM % 2)) -eq 0 ]; then
        cp -r "../$name.whole" "$name"
        milliseconds=${into_whole[$name]}
    fi
    if ! killed "$name" "$milliseconds"; then
        n_late=$((n_late + 1))
        [ "$n_late" -lt $((10 * kills)) ] && continue
        complain "$n_late kills came too late"
        break
    fi
    n_met=$((n_met + 1))
    delays=$delay
    # Every third one is killed once more before it may go on.
    if [ $((RANDOM % 3)) -eq 0 ] && killed "$name" "$milliseconds"; then delays="$delays and $delay"; fi
    for _ in $(seq 1 50); do
        [ -n "$(processes)" ] || break
        sleep 0.02
    done
    [ -z "$(processes)" ] || complain "$name, killed after $delays ms: processes outlive it"
    start "$name"
    wait "$child" || complain "$name, killed after $delays ms: the next call: $(tail -n 1 ../err.txt)"
    contents "$name" >../now
    diff "../$name.due" ../now >../difference.txt ||
        complain "$name, killed after $delays ms: $(head -n 6 ../difference.txt)"
done
printf '%d kills met a command at work, %d came too late and were repeated\n' "$n_met" "$n_late"
left=$(ls -A "$TMPDIR"; ls -A | grep -vxF "$(printf '%s\n' "${commands[@]}" study.toml static.toml)")
[ -z "$left" ] || complain "left beside the results: $left"

finish
