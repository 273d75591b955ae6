#!/usr/bin/env bash
# Cases become input of the program CONTACT and come back; what is none is refused with its line.
# usage: contact_program.sh PROGRAM SOURCE_DIR
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
press_steps = 2
[rolling]
amplitude = "1.3 mm"
periods = 2
run_all = true
steps = "turning-points"
[bem]
spacing = "0.5 mm"
TOML

# shift_of FOLDER: the last one in a model's folder [m].
shift_of() { column shift_x_m "$1/history.csv" | tail -n 1; }
# last_shift FOLDER: over U_max.
last_shift() { sed -n 's/^ *"final_shift_ratio": \(.*\),/\1/p' "$1/summary.json"; }

# 1. Written and read again: the case itself, whatever it is; from the numbers alone, where the file
# has been changed, the same input but for the last digits, and a run of the same numbers.
"$program" contact export ball.toml --output out >told.txt || complain "export: $(cat told.txt)"
grep -q "^cases of CONTACT     10$" told.txt || complain "export says: $(cat told.txt)"
[ "$(grep -c MODULE out/ball.inp)" -eq 11 ] || complain "steps: $(grep -c MODULE out/ball.inp)"
"$program" contact import out/ball.inp --output whole >told.txt || complain "import: $(cat told.txt)"
grep -q "the case that they were written of" told.txt || complain "import says: $(cat told.txt)"
"$program" check ball.toml >ball.txt
"$program" check whole/ball.toml >whole.txt
cmp -s ball.txt whole.txt || complain "another case came back"
sed 's/^% Body 1 is the indenter.*/% by hand/' out/ball.inp >back.inp
"$program" contact import back.inp --output by_numbers >told.txt || complain "import: $(cat told.txt)"
grep -q "^cases 1 to 10 .*for tricontact run$" told.txt || complain "import says: $(cat told.txt)"
"$program" contact export by_numbers/back.toml --output again >/dev/null || complain "export of the import"
awk '/^% Case of Tricontact/ { nextfile } NR == FNR { line[FNR] = $0; next } FNR > 2 { n = split(line[FNR], a); m = split($0, b)
        same = n == m
        for (k = 1; k <= n; k++) if (a[k] != b[k] && (a[k] - b[k]) ^ 2 > 1e-24 * (a[k] ^ 2 + 1)) same = 0
        if (!same) print FNR ": " line[FNR] " | " $0 }' out/ball.inp again/back.inp >differences
[ ! -s differences ] || complain "import and export: $(head -3 differences)"
for name in ball by_numbers/back; do
    "$program" run $name.toml --output "run_${name##*/}" --quiet --no-report || complain "run of $name"
done
awk -v a="$(last_shift run_ball)" -v b="$(last_shift run_back)" 'BEGIN { exit !(a > 0.1 && (a / b - 1) ^ 2 < 1e-16) }' ||
    complain "shifts $(last_shift run_ball) and $(last_shift run_back)"

# A body by its heights comes back as such: the same shift, but for the map's bilinear parts.
sed '/^\[rolling\]/,/^steps/d; s/^models.*/&/' ball.toml >still.toml
"$program" contact export still.toml --set indenter.shape=sphere --output still >/dev/null || complain "export of a sphere"
sed '/^% Case of Tricontact/,$d' still/still.inp >still/plain.inp
"$program" contact import still/plain.inp --output map >told.txt || complain "import of heights: $(cat told.txt)"
grep -q '^shape = "height-map"' map/plain.toml || complain "heights are no map"
"$program" run map/plain.toml --output run_map --quiet --no-report || complain "run of a height map"
"$program" run still.toml --set indenter.shape=sphere --output run_still --quiet --no-report || complain "run of a sphere"
awk -v a="$(shift_of run_still/bem)" -v b="$(shift_of run_map/bem)" \
    'BEGIN { exit !(a > 0 && (a / b - 1) ^ 2 < 1e-8) }' ||
    complain "shifts $(shift_of run_still/bem) and $(shift_of run_map/bem)"

# A path comes back from its numbers alone: the same forces, work and energy, step by step. Shifts and torque are about
# the file's origin there, about the moving lowest point here.
cases=$source_dir/examples/cases
coarse=(--set bem.cells_per_radius=6 --set output.vtk=none)
"$program" contact export "$cases/path_twist.toml" --models bem "${coarse[@]}" --output path >told.txt ||
    complain "export of a path: $(cat told.txt)"
grep -q "CPHI, SPINXO, SPINYO$" path/path_twist.inp || complain "the twist's centre is not written"
sed '/^% Case of Tricontact/,$d' path/path_twist.inp >path/plain.inp
"$program" contact import path/plain.inp --output path_back >told.txt || complain "import of a path: $(cat told.txt)"
grep -q '^centre_of_rotation = "substrate"' path_back/plain.toml || complain "the centre of rotation: $(cat path_back/plain.toml)"
"$program" run "$cases/path_twist.toml" --models bem "${coarse[@]}" --output run_path --quiet --no-report || complain "run of a path"
# CONTACT's cases act at once; each in proportion they are the steps of the path.
grep -q '^steps = 0$' path_back/plain.toml || complain "the steps: $(grep steps path_back/plain.toml)"
sed -i 's/^steps = 0$/steps = 1/' path_back/plain.toml
"$program" run path_back/plain.toml --output run_path_back --quiet --no-report || complain "run of an imported path"
for name in normal_force_N tangential_force_x_N tangential_force_y_N dissipation_J stored_energy_J; do
    paste <(column "$name" run_path/bem/history.csv) <(column "$name" run_path_back/bem/history.csv) |
        awk 'NF == 2 { n++; if (($1 - $2) ^ 2 > 1e-12 * ($1 ^ 2 + 1e-12)) bad = 1 } END { exit !(n > 20 && !bad) }' ||
        complain "$name differs: $(paste <(column "$name" run_path/bem/history.csv) <(column "$name" run_path_back/bem/history.csv) | head -5)"
done
# What rolls on comes back as its steps from rest and its steady state.
"$program" contact export "$cases/rolling_spin.toml" --models bem --set bem.cells_per_radius=6 --output roll >told.txt ||
    complain "export of rolling on: $(cat told.txt)"
sed '/^% Case of Tricontact/,$d' roll/rolling_spin.inp >roll/plain.inp
"$program" contact import roll/plain.inp --output roll_back >told.txt || complain "import of rolling on: $(cat told.txt)"
[ "$(grep -c "for tricontact run$" told.txt)" -eq 2 ] || complain "rolling on became: $(cat told.txt)"

# 2. The layer: coefficients beside the input, its own at zero positive, as many lines as it says.
"$program" contact export ball.toml --models bem-layer --output layer >/dev/null || complain "export of the layer"
grep -q "^ 'ball.influence' " layer/ball.inp || complain "the file of coefficients is not named"
grep -q '^ 0029020' layer/ball.inp || complain "C = 9 is missing"
awk 'NR == 4 { mx = $1; my = $2 } NR > 4 && !/%/ { lines++; if (NF != 11) bad = 1; if ($1 == 0 && $3 > top) { top = $3; at = lines } }
    END { exit !(lines == mx * (2 * my - 1) && !bad && at == mx * (my - 1) + 1) }' layer/ball.influence ||
    complain "coefficients of the layer"
grep -q '^ 999 999 50 50 ' layer/ball.inp ||
    complain "coupled bodies need outer iterations: $(grep MAXOUT layer/ball.inp)"
# No matrices in files of their own, one per step.
[ "$(grep -c '0211   H-G-I-A-O-W-R' layer/ball.inp)" -eq "$(($(grep -c MODULE layer/ball.inp) - 1))" ] ||
    complain "A is not 0"
# A file's coefficients of a layer couple under bem too, those of an uncoupled half-space do not.
for model in bem-layer bem; do
    "$program" influence ball.toml --models "$model" --output "$model.txt" >/dev/null ||
        complain "influence of $model"
    "$program" contact export ball.toml --set "bem.influence=$model.txt" --output "by_$model" >/dev/null ||
        complain "export with coefficients of $model"
done
grep -q '^ 999 999 50 50 ' by_bem-layer/ball.inp || complain "the layer's coefficients do not couple"
cmp -s by_bem-layer/ball.influence layer/ball.influence || complain "the layer's coefficients change"
grep -q '^ 999 999 50 1 ' by_bem/ball.inp || complain "the half-space's coefficients couple"
awk 'NR > 4 && !/%/ && ($4 != 0 || $5 != 0 || $6 != 0 || $9 != 0) { bad = 1 } END { exit bad }' \
    by_bem/ball.influence || complain "coefficients of a coupling that there is not"
# Read without the case, the layer's coefficients come back as a file of our own: the same shift.
sed '/^% Case of Tricontact/,$d' layer/ball.inp >layer/plain.inp
"$program" contact import layer/plain.inp --output plain >told.txt || complain "import of the layer: $(cat told.txt)"
"$program" run plain/plain.toml --output run_plain --quiet --no-report || complain "run by coefficients"
"$program" run ball.toml --models bem-layer --output run_layer --quiet --no-report || complain "run of the layer"
awk -v a="$(shift_of run_layer/bem-layer)" -v b="$(shift_of run_plain/bem)" \
    'BEGIN { exit !(a > 0 && (a / b - 1) ^ 2 < 1e-10) }' ||
    complain "shifts $(shift_of run_layer/bem-layer) and $(shift_of run_plain/bem)"
rm layer/ball.influence
refused "layer/ball.influence: cannot be read" contact import "$work/layer/plain.inp" --output case

# 3. Bad input files state their message in the first line.
$python "$source_dir/tests/cli/bad_inputs.py" "$source_dir/tests/cli/bad_contact" "$work/bad_contact" ||
    complain "the table of bad_contact"
for file in "$work"/bad_contact/*.inp; do
    expected=$(head -n 1 "$file" | sed 's/^% expect: //')
    refused "$file$expected" contact import "$file" --output case
done
refused "the file cannot be read (No such file or directory)" contact import none.inp --output case

# FX = -1 slides: a file of CONTACT, but no case.
sed 's/-0.875/-1/' "$source_dir/tests/cli/bad_contact/good.inp" >slides.inp
refused "reaches the friction limit mu F_N" contact import "$work/slides.inp" --output case

# 4. Cases that no such input says.
refused "ball.toml: load.indentation: CONTACT takes F_T over the F_N of each step" \
    contact export "$work/ball.toml" --set "load.indentation=0.4 mm"
refused "no boundary elements, which this needs, are among them" contact export "$work/ball.toml" \
    --set 'models=["mdr"]'

finish
