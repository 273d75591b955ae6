#!/usr/bin/env bash
# What commands may write, and where: only files of their own making, never through a link, never over an
# input; what is refused leaves nothing behind; a full standard output and a rerun that fails are told.
# usage: outputs.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

cat >ball.toml <<'TOML'
models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "6 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
press_steps = 1
[rolling]
amplitude_ratio = 0.24
periods = 1
steps = "turning-points"
[bem]
cells_per_radius = 5
[mdr]
springs = 200
[output]
vtk = "none"
TOML
sed '/^\[rolling\]/,/^steps/d; /^press_steps/d' ball.toml >rolls.toml
printf '[tractive_rolling]\ndistance = 1\n' >>rolls.toml
sed 's/"bem"/"fem"/; /^\[bem\]/,+1d' ball.toml >layer.toml
cat >study.toml <<TOML
case = "ball.toml"
models = ["mdr"]
[vary]
rolling.amplitude_ratio = [0.1, 0.2]
TOML
sed 's/^end = .*/end = 2000/' "$source_dir/examples/cases/walking_set_b.toml" >slider.toml
sed 's|\.\./measurements/||' "$source_dir"/examples/rigs/sphere_parallel.toml >rig.toml
cp "$source_dir"/examples/measurements/thesis_static_shift.csv .
experiment=$source_dir/examples/records/synthetic_shakedown.toml
has_fem=$("$program" list | grep -c '^  fem ')

# Each command with a folder: a name that it writes there, and its arguments without --output.
"$program" sweep study.toml --output done --quiet --no-report || complain "sweep"
commands=(
    "summary.json run ball.toml" "limit.csv limit ball.toml" "creep.csv run rolls.toml"
    "motion.csv run slider.toml" "ball.inp contact export ball.toml" "refinement.csv refine ball.toml --models bem"
    "deviation.json deviation ball.toml --no-runs" "experiment.json experiment $experiment --set models=['mdr']"
    "rig.json rig rig.toml" "identify.json identify rig.toml"
    "results.csv sweep study.toml" "results.sqlite sweep study.toml" "results.sqlite-journal sweep study.toml"
    "verification.json verify --short" ".tricontact limit ball.toml" "case.toml run ball.toml")
((has_fem)) && commands+=("mesh.msh mesh layer.toml")

# state FOLDER: of every name with its kind, the content of files.
state() {
    tar --create --sort=name --mtime=@0 --directory="$1" . | cksum
}
# stays TEXT ARGUMENTS...: refused with the text in one line, and the folder `out` stays as it was.
stays() {
    local text=$1 before message code
    shift
    before=$(state .)
    message=$("$program" "$@" 2>&1 </dev/null)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code: $*"
    [[ $message == "error: "*"$text"* && $message != *$'\n'* ]] || complain "$*: expected $text, got $message"
    [ "$(state .)" == "$before" ] || complain "$*: something was written"
}

# 1. Links, named pipes, devices and files of others under the names of results; links to nowhere. A link for each
# command, the others in turn: all commands ask one function what stands in their way.
echo precious >precious
others=(dangling pipe device foreign)
n=0
for entry in "${commands[@]}"; do
    read -r name arguments <<<"$entry"
    # shellcheck disable=SC2086  # words of a command
    for obstacle in link "${others[n++ % 4]}"; do
        mkdir out
        case $obstacle in
            link) ln -s ../precious "out/$name" ;;
            dangling) ln -s nowhere "out/$name" ;;
            pipe) mkfifo "out/$name" ;;
            device) mknod "out/$name" c 1 3 2>/dev/null || mkfifo "out/$name" ;;
            foreign) echo mine >"out/$name" ;;
        esac
        stays "out/$name: is " $arguments --output out
        rm -rf out
    done
done

# 2. Folders of results that are links, or somebody's.
mkdir elsewhere && echo precious >elsewhere/history.csv
for name in bem plots; do
    mkdir out && ln -s ../elsewhere "out/$name"
    stays "out/$name: is a link" run ball.toml --output out
    rm "out/$name" && cp -r elsewhere "out/$name"
    stays "out/$name: is there already, and tricontact did not make it" run ball.toml --output out
    rm -rf out
done
# One's own folder in which somebody put something.
"$program" run ball.toml --output out --quiet --no-report || complain "run"
for put in "ln -s ../../precious" "ln -s nowhere" mkfifo; do
    rm -f out/bem/history.csv && $put out/bem/history.csv
    stays "out/bem/history.csv: is a" run ball.toml --output out
done
rm out/bem/history.csv
mkdir out/fem && echo precious >out/fem/steps.journal
((has_fem)) && stays "out/fem: is there already" run layer.toml --output out
rm -rf out/fem
"$program" run ball.toml --output out --quiet --no-report || complain "run once more"
[ "$(cat out/.tricontact | wc -l)" -eq 7 ] || complain "the list: $(cat out/.tricontact)"
cp -r done fitted && rm -f fitted/fit.json && ln -s ../precious fitted/fit.json
stays "fitted/fit.json: is a link" fit study.toml --output fitted
mkdir merged && ln -s ../precious merged/results.sqlite
stays "merged/results.sqlite: is a link" sweep merge merged done
rm merged/results.sqlite
stays "is the output folder too" sweep merge done done
# A store says itself whose it is: copied elsewhere, a sweep goes on from it.
cp done/results.sqlite merged/ && "$program" sweep study.toml --output merged --quiet --no-report ||
    complain "a store in another folder"

# 3. Inputs.
mkdir own && cp ball.toml own/case.toml
stays "own/case.toml: is an input" run own/case.toml --output own
stays "own/case.toml: is an input" limit own/../own/case.toml --output own
cp thesis_static_shift.csv own && cp rig.toml own/identify.json
stays "own/identify.json: is an input" identify own/identify.json --output own
rm own/identify.json
stays "ball.toml: is an input" influence ball.toml --output ball.toml
stays "ball.toml: is an input" influence ball.toml --output "$work/ball.toml"
"$program" influence ball.toml --output table.txt >/dev/null || complain "influence"
stays "table.txt: is an input" influence ball.toml --set bem.influence=table.txt --output table.txt
"$program" contact export ball.toml --output program >/dev/null || complain "export"
mkdir imported && echo precious >imported/ball.toml
stays "imported/ball.toml: is there already" contact import program/ball.inp --output imported
if ((has_fem)); then
    "$program" mesh layer.toml --set "fem.size=0.5 mm" --set "substrate.width=30 mm" \
        --set "substrate.depth=30 mm" --output meshed >/dev/null 2>&1 || complain "mesh"
    stays "meshed/mesh.msh: is an input" mesh layer.toml --set fem.mesh=meshed/mesh.msh --output meshed
fi

# 4. Files that the user names.
for obstacle in "ln -s precious" "ln -s nowhere" mkfifo "cp precious" mkdir; do
    $obstacle target
    stays "target: " influence ball.toml --output target
    rm -rf target
done
stays "missing/target: cannot be written" influence ball.toml --output missing/target
for time in first second; do
    "$program" influence ball.toml --output kept.txt >/dev/null || complain "influence, the $time time"
    "$program" contact import program/ball.inp --output kept >/dev/null || complain "import, the $time time"
done
rm -r kept.txt kept
[ "$(cat precious)" == precious ] || complain "the target of links was written to"

# 5. Standard output on a full disk.
for arguments in --help --version "run --help" list keys "keys walking" "check ball.toml" "check slider.toml" \
    "rig rig.toml" "run slider.toml" "limit ball.toml --models mdr --tolerance 0.1 --quiet" \
    "run rolls.toml --models mdr --points 0 --quiet --no-report" "contact export ball.toml" \
    "influence ball.toml --output again.txt" "deviation ball.toml --no-runs --quiet" \
    "experiment $experiment --quiet" "sweep merge whole done"; do
    # shellcheck disable=SC2086
    message=$("$program" $arguments 2>&1 >/dev/full)
    code=$?
    [ "$code" -eq 1 ] || complain "exit code $code on a full disk: $arguments"
    [[ ${message##*$'\n'} == "error: standard output cannot be written (No space left on device)" ]] ||
        complain "$arguments, on a full disk: $message"
done

# 6. A rerun that fails leaves no results of the run before.
for command in run limit "refine --models bem"; do
    read -r name options <<<"$command"
    # shellcheck disable=SC2086
    "$program" "$name" ball.toml $options --output "rerun_$name" --quiet >/dev/null || complain "$command"
    rm -rf failed && cp -r "rerun_$name" failed
    [ -d failed/plots ] && echo 1,2 >failed/plots/mine.csv
    # shellcheck disable=SC2086
    "$program" "$name" ball.toml $options --output failed --quiet --set bem.tolerance=1.1e-14 \
        >/dev/null 2>&1
    [ $? -eq 1 ] || complain "$command converges to rounding"
    # Levels are taken over by what they hold; a file of the user's among the figures stays.
    left=$(find failed \( -name '*.json' -o -name '*.csv' -o -name 'report.html' -o -path '*/plots/*' \) \
        -not -path '*/level_*' -not -name 'mine.*')
    [ "$name" = limit ] || [ "$(ls failed/plots)" == mine.csv ] || complain "$command took mine.csv"
    [ -z "$left" ] || complain "$command leaves" $left
done

# 7. Memory is asked for before it is taken.
for arguments in "run ball.toml" "limit ball.toml" "run rolls.toml" "influence ball.toml"; do
    # shellcheck disable=SC2086
    message=$(ulimit -v 3000000 && "$program" $arguments --output large \
        --set bem.cells_per_radius=1400 2>&1)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code of a large grid: $arguments: $message"
    [[ $message == "error: bem: a grid of "*" cells needs "*" GB of memory, "*" GB are there; "* ]] ||
        complain "$command of a large grid: $message"
    [ -e large ] && complain "$command: a folder in spite of the refusal"
done

# 8. Names of files with line ends stay in one line.
stays "cannot be read (No such file or directory)" run $'no\nsuch.toml' --output out
stays "is an input" influence ball.toml --output $'ball.toml' --set $'title="a\\nb"'

finish
