#!/usr/bin/env bash
# --json: every command of the program gives its answer as JSON and nothing else on standard output, the numbers those
# of its file, or refuses the option by name.
# usage: json_answers.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
examples=$source_dir/examples
sphere=$examples/cases/rig_sphere_parallel.toml
coarse=(--set mdr.springs=200 --set rolling.periods=1 --set rolling.steps=turning-points --set bem.cells_per_radius=4)

# json FILE CODE COMMAND...: that exit code, JSON on standard output, which is FILE of its folder (-: none is written).
declare -A tried
n_answers=0
json() {
    local file=$1 due=$2 code
    shift 2
    "$program" "$@" --json >answer.json 2>said.txt
    code=$?
    [ "$code" -eq "$due" ] || complain "$*: exit code $code: $(tail -1 said.txt)"
    # Read at the end, all by one process.
    n_answers=$((n_answers + 1))
    cp answer.json "answer_$n_answers.json"
    [ "$file" = - ] || cp "$file" "kept_$n_answers.json" || complain "$*: no $file"
    printf '%s\t%s\n' "$file" "$*" >>answers.txt
    case "$1 $2" in benchmark* | contact* | "sweep merge") tried["$1 $2"]=1 ;; *) tried[$1]=1 ;; esac
}
json run/summary.json 0 run "$sphere" --models mdr "${coarse[@]}" --no-studies --no-report -q -o run
json - 0 run "$examples/cases/walking_set_b.toml" --set time.end=20 --no-report --quiet --output walk
json - 0 run "$examples/cases/rolling_sphere.toml" --models mdr --set mdr.springs=200 --points 0 --no-report --quiet --output roll
json - 0 predict "$sphere"
json limit/limit.json 0 limit "$sphere" -m mdr --set mdr.springs=200 --tolerance 0.1 -o limit
json refine/refinement.json 0 refine "$sphere" --models mdr "${coarse[@]}" -o refine
json rig/rig.json 0 rig "$examples/rigs/cylinder_parallel.toml" -o rig
json identify/identify.json 0 identify "$examples/measurements/rig_indentation.toml" -q -o identify
json design/design.json 0 design "$examples/rigs/design_resolution.toml" -o design
json experiment/experiment.json 0 experiment "$examples/records/synthetic_shakedown.toml" --set 'models=["mdr"]' -q -o experiment
json - 0 benchmark list
json - 0 benchmark show wedge
json - 0 check "$sphere"
json - 0 check "$examples/cases/walking_set_b.toml"
json - 0 list "$examples/cases"
json - 0 new --list
json - 0 new --example rig_sphere_parallel -o new.toml
json - 0 influence "$examples/cases/rig_layer_parallel.toml" --models bem-layer --set bem.cells_per_radius=4 -o influence.txt
json - 0 contact export "$sphere" --models bem --set rolling.periods=1 --set bem.cells_per_radius=4 -o exported
json - 0 contact import exported/rig_sphere_parallel.inp -o imported
"$program" run "$sphere" --models mdr "${coarse[@]}" --no-studies --no-report -q --output other --set load.tangential_ratio=0.3
json compare/compare.json 0 compare run other -o compare
printf 'case = "%s"\nmodels = ["mdr"]\n[set]\nmdr.springs = 200\nrolling.steps = "turning-points"\n[vary]\nload.tangential_ratio = [0.1, 0.2]\n' \
    "$sphere" >few.toml
json - 0 sweep few.toml -j 1 --no-report -q -o few
"$python" -S -c 'import json; d = json.load(open("answer.json")); assert (d["points"], d["failed"]) == (2, 0), d' ||
    complain "sweep counts $(cat answer.json)"
json - 0 sweep merge merged few
"$python" -S -c 'import json; d = json.load(open("answer.json"))["merged"][0]; assert (d["points"], d["failures"]) == (2, 0), d' ||
    complain "sweep merge counts $(cat answer.json)"
sed 's/tangential_ratio = .*/tangential_ratio = {from = 0.1, to = 0.2}/' few.toml >map.toml
printf '[atlas]\npoints = 20\nerror = 0.5\nquantities = ["final_shift_ratio"]\n' >>map.toml
json - 0 atlas map.toml -j 1 --check 5 -q -o map
"$python" -S -c 'import json; d = json.load(open("answer.json")); assert d["checks"][0]["points"] == 5 and d["checks"][0]["passed"], d' ||
    complain "atlas --check $(cat answer.json)"
json few/fit.json 0 fit few.toml -o few -q
"$program" rig "$examples/rigs/cylinder_parallel.toml" -o rig --export papers >/dev/null 2>&1 || complain "no export"
json - 0 reproduce papers/archive.zip -q

if has_fem; then
    json - 0 mesh "$examples/cases/rig_layer_parallel.toml" --set fem.size="2 mm" -o mesh
    json - 0 cache --folder nothing_kept
fi

# Each is JSON, and the numbers of its file but for the notes, which the text says beside it.
"$python" -S - <<'PYTHON' || complain "answers, see above"
import json, sys
lines = open("answers.txt").read().splitlines()
failed = len(lines) < 26
for k, line in enumerate(lines, 1):
    file, command = line.split("\t")
    try:
        answer = json.load(open(f"answer_{k}.json"))
        if file != "-":
            kept = json.load(open(f"kept_{k}.json"))
            answer["notes"] = kept["notes"] = None
            assert answer == kept, "not the numbers of " + file
    except Exception as error:
        failed = True
        print(f"{command}: {error!r}")
sys.exit(failed)
PYTHON

# The help of each says what it does.
"$program" --help | sed -n '/^Compute:/,$s/^  \([a-z]\+\) .*/\1/p' >whole
while read -r command; do
    echo "$command"
    "$program" "$command" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]\+ [a-z]\+\) .*/\1/p'
done <whole >all
[ "$(wc -l <all)" -gt 28 ] || complain "only $(wc -l <all) commands"
while read -r command; do
    # shellcheck disable=SC2086
    "$program" $command --help >help.txt
    if grep -q -- ' --json' help.txt; then
        # Long ones are tried where they run already: tests/cli/codes/benchmark.sh, runs/deviation.sh, answers/verify.sh.
        [[ $command == @(benchmark compare|deviation|verify) ]] || [ -n "${tried[$command]:-}" ] ||
            complain "$command --json is not tried"
    else
        # shellcheck disable=SC2086
        "$program" $command --json >out.txt 2>said.txt
        [ $? -eq 2 ] && grep -q -- '--json\|is required' said.txt && [ ! -s out.txt ] ||
            complain "$command neither has --json nor refuses it: $(cat said.txt)"
    fi
done <all

finish
