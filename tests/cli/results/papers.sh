#!/usr/bin/env bash
# What --export writes for papers, of each kind of command; archives that run again, here and with something
# changed: the place is told, and exit code 3.
# usage: papers.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
papers=$source_dir/tests/cli/results/papers.py
examples=$source_dir/examples

# exported NAME ARGUMENTS...: into the folder NAME, checked; its archive runs again elsewhere with the same numbers.
exported() {
    local name=$1 said
    shift
    "$program" "$@" --output "out_$name" --export "$name" >/dev/null 2>err ||
        complain "$name: $(cat err)"
    "$python" "$papers" check "$name" || complain "$name"
    mkdir -p elsewhere
    said=$(cd elsewhere && "$program" reproduce "$work/$name/archive.zip" --quiet 2>&1)
    [ $? -eq 0 ] || complain "$name: exit code of reproduce"
    [[ $said == "same bytes: "* ]] || complain "$name: $said"
    [ -z "$(ls -A elsewhere)" ] || complain "$name: files left behind"
}

# 1. One of each kind, and how numbers and words stand in its files.
coarse=(--set rolling.steps=turning-points --set rolling.periods=2 --set bem.cells_per_radius=6
    --set mdr.springs=500 --set output.vtk=none)
exported run run "$examples/cases/rig_sphere_parallel.toml" "${coarse[@]}"
exported walk run "$examples/cases/walking_set_b.toml" --set output.frames=0 --set time.end=2000
for former in walk roll; do # archives of earlier versions call it so
    [ $former = walk ] || exported roll run "$examples/cases/rolling_sphere.toml" --models mdr --points 2
    "$python" "$papers" change $former/archive.zip $former.zip archive.json '"command": "run"' \
        "\"command\": \"$former\"" || complain "no archive of $former"
    said=$("$program" reproduce $former.zip --quiet 2>&1) || complain "$former: exit code of reproduce"
    [[ $said == "same bytes: "* ]] || complain "an archive of $former: $said"
done
exported experiment experiment "$examples/records/synthetic_shakedown.toml" --set 'models=["mdr"]'
exported rig rig "$examples/rigs/sphere_parallel.toml"
exported design design "$examples/rigs/design_resolution.toml"
exported identify identify "$examples/measurements/rig_indentation.toml"
exported limit limit "$examples/cases/rig_sphere_parallel.toml" --models mdr --tolerance 0.05
exported deviation deviation "$examples/cases/rig_layer_parallel.toml" --no-runs
exported refine refine "$examples/cases/rig_sphere_parallel.toml" --models bem "${coarse[@]}"
# An earlier version called it --model.
"$python" "$papers" change refine/archive.zip model.zip archive.json '"--models"' '"--model"' || complain "no archive of --model"
said=$("$program" reproduce model.zip --quiet 2>&1) || complain "--model: exit code of reproduce"
[[ $said == "same bytes: "* ]] || complain "an archive with --model: $said"
with_surfaces=("${coarse[@]/vtk=none/vtk=quarters}")
for springs in 400 500; do
    "$program" run "$examples/cases/rig_sphere_parallel.toml" "${with_surfaces[@]/springs=500/springs=$springs}" \
        --output runs/$springs --no-studies --no-report --quiet >/dev/null || complain "run with $springs springs"
done
exported compare compare runs/400 runs/500/
exported itself compare runs/400 runs/400
mkdir studies && cp "$examples/cases/rig_sphere_parallel.toml" ball.toml
cat >studies/amplitudes.toml <<'TOML'
case = "../ball.toml"
models = ["mdr", "bem"]
levels = 3
[set]
rolling.steps = "turning-points"
rolling.periods = 40
mdr.springs = 500
bem.cells_per_radius = 4
[vary]
rolling.amplitude_ratio = [0.1, 0.2, 0.3]
TOML
exported sweep sweep studies/amplitudes.toml
mv out_sweep out_fit
exported fit fit studies/amplitudes.toml
cp "$examples/cases/walking_set_b.toml" slider.toml
cat >studies/walking.toml <<TOML
case = "../slider.toml"
[vary]
machine.kappa7 = [0.3, 0.42]
TOML
exported walk_sweep sweep studies/walking.toml

# 2. Inputs by relative and absolute paths, also as overrides.
cp "$examples"/cases/body_profile.* . && cp body_profile.csv heights.csv
exported profile run body_profile.toml "${coarse[@]}" --models mdr
exported override run body_profile.toml "${coarse[@]}" --models mdr --set indenter.file=heights.csv
"$program" check body_profile.toml | sed '/^#/d' >studies/resolved.toml
grep -q "$work/body_profile.csv" studies/resolved.toml || complain "no absolute path"
exported absolute run studies/resolved.toml "${coarse[@]}" --models mdr

# 3. Numbers of the figures are those of summary and history.
"$python" - <<'PYTHON' || complain "numbers of the figures"
import csv, json
models = json.load(open("out_run/summary.json"))["models"]
lines = list(csv.reader(open("run/data/shift.csv", encoding="utf-8")))
heading = lines[0]
for model, name in (("mdr", "MDR"), ("bem", "BEM")):
    column = next(i for i, text in enumerate(heading) if text.startswith(name + ":"))
    last = [line[column] for line in lines[1:] if line and line[column]][-1]
    assert "[µm]" in heading[column], heading[column]
    # Digits of a report's data: all of them, in another unit.
    assert abs(float(last) * 1e-6 / models[model]["final_shift_m"] - 1) < 1e-12, (model, last)
    history = list(csv.DictReader(open(f"out_run/{model}/history.csv")))
    assert float(history[-1]["shift_x_m"]) == models[model]["final_shift_m"], model
PYTHON
for key in Johnson1985 Wetter2016 PopovHess2015 PolonskyKeer1999 Roache1998; do
    grep -q "{$key," run/references.bib || complain "references.bib of run: no $key"
done
# The program's own entry stands in the documents, with the year of its release.
diff <(sed -n '/^@misc{Tricontact/,/^}/p' "$source_dir/docs/how-to/papers.md") \
    <(sed -n '/^@misc{Tricontact/,/^}/p' run/references.bib) || complain "the program's entry"
grep -q "^  year = {20[0-9][0-9]},$" run/references.bib || complain "the program's entry has no year"
grep -q "{BrezziFortin1991," run/references.bib && complain "references.bib has what the run did not use"

"$python" "$papers" cited "$source_dir" || complain "citations without an entry"

# 4. Same call, same bytes; what an earlier export left goes, what others put there stays.
cp -r run again && echo mine >again/tables/mine.tex && cp again/figures/shift.svg again/figures/old.svg &&
    cp again/data/shift.csv again/data/old.csv
"$program" run "$examples/cases/rig_sphere_parallel.toml" "${coarse[@]}" --output out_again --export again \
    --quiet >/dev/null
[ -e again/figures/old.svg ] || [ -e again/data/old.csv ] && complain "an old figure is left"
[ "$(cat again/tables/mine.tex)" = mine ] || complain "a table of another is gone"
rm again/tables/mine.tex
for file in $(cd run && find figures data tables references.bib -type f); do
    [ "$file" = tables/cost.tex ] || cmp -s "run/$file" "again/$file" || complain "$file differs"
done

# 5. What differs is told: quantity, place, sizes; exit code 3.
differs() {
    local expected=$1 said code
    shift
    "$python" "$papers" change run/archive.zip changed.zip "$@" || complain "change $*"
    said=$("$program" reproduce changed.zip --quiet 2>&1)
    code=$?
    [ "$code" -eq 3 ] || complain "exit code $code: $*: $said"
    grep -qE -- "$expected" <<<"$said" || complain "$*: expected $expected, got $said"
}
shift_of_mdr=$(sed -n 's/^ *"static_shift_m": \(.*\),/\1/p' out_run/summary.json | head -1)
differs "^differs results/summary.json: models/mdr/static_shift_m: 1\.00e\+00 relative .1 was kept, now ${shift_of_mdr:0:8}" \
    results/summary.json "\"static_shift_m\": $shift_of_mdr" '"static_shift_m": 1.0'
differs '"ratcheting" was kept, now it is "shakedown"' results/summary.json '"state": "shakedown"' \
    '"state": "ratcheting"'
differs "not reproduced, tolerance 1e-06" results/summary.json "\"static_shift_m\": $shift_of_mdr" \
    '"static_shift_m": 1.0'
differs "^differs results/summary.json: models/mdr/dissipation_ratio" inputs/rig_sphere_parallel.toml 0.24 0.2
# Within the tolerance it is reproduced, and what differs is told all the same.
"$python" "$papers" change run/archive.zip changed.zip results/summary.json \
    "\"static_shift_m\": $shift_of_mdr" "\"static_shift_m\": ${shift_of_mdr}1" || complain "last digit"
said=$("$program" reproduce changed.zip --output kept --quiet) || complain "last digit: exit code"
[[ $said == *"agrees results/summary.json: models/mdr/static_shift_m"*"reproduced"* || $said == "same bytes"* ]] ||
    complain "last digit: $said"
[ -s kept/reproduction.json ] && [ -s kept/results/summary.json ] && [ -s kept/inputs/rig_sphere_parallel.toml ] ||
    complain "reproduce --output keeps $(find kept)"
# Another version is told.
"$python" "$papers" change run/archive.zip changed.zip archive.json '"version": "0.' '"version": "99.' ||
    complain "another version"
said=$("$program" reproduce changed.zip --quiet) || complain "another version: exit code"
[[ $said == "made by version 99."*", run again by "*"same bytes"* ]] || complain "another version: $said"

# Numbers alone need no gnuplot; an export that cannot draw exports nothing.
said=$(PATH=/nowhere "$program" reproduce run/archive.zip --quiet) || complain "without gnuplot: exit code"
[[ $said == "same bytes"* ]] || complain "without gnuplot: $said"
PATH=/nowhere "$program" run slider.toml --output out_undrawn --export undrawn --quiet 2>told.txt
[ $? -eq 1 ] && [ ! -e undrawn ] && [ ! -e out_undrawn ] || complain "an export without gnuplot, or computed in vain"
[ "$(wc -l <told.txt)" -eq 1 ] && grep -q "gnuplot-nox" told.txt || complain "an export without gnuplot: $(cat told.txt)"

# 6. Half of it is refused.
refused "--export: its figures and tables are those of the report; drop --no-report" \
    run "$work/ball.toml" --export x --no-report
mkdir taken && echo mine >taken/archive.zip
refused "taken/archive.zip: is there already, and tricontact did not write it" \
    run "$work/ball.toml" --output out_taken --export "$work/taken"
finish
