#!/usr/bin/env bash
# Cases become input of the program CONTACT and come back; what is no case is refused with its line.
# usage: contact_program.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"

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

# last_shift FOLDER: over U_max.
last_shift() { sed -n 's/^ *"final_shift_ratio": \(.*\),/\1/p' "$1/summary.json"; }

# 1. Written and read again: the same input but for the last digits, and a run of the same numbers.
"$program" export ball.toml --output out >told.txt || complain "export: $(cat told.txt)"
grep -q "^cases of CONTACT     10$" told.txt || complain "export says: $(cat told.txt)"
[ "$(grep -c MODULE out/ball.inp)" -eq 11 ] || complain "steps: $(grep -c MODULE out/ball.inp)"
"$program" import out/ball.inp --output back.toml >told.txt || complain "import: $(cat told.txt)"
"$program" export back.toml --output again >/dev/null || complain "export of the import"
awk 'NR == FNR { line[FNR] = $0; next } FNR > 1 { n = split(line[FNR], a); m = split($0, b)
        same = n == m
        for (k = 1; k <= n; k++) if (a[k] != b[k] && (a[k] - b[k]) ^ 2 > 1e-24 * (a[k] ^ 2 + 1)) same = 0
        if (!same) print FNR ": " line[FNR] " | " $0 }' out/ball.inp again/back.inp >differences
[ ! -s differences ] || complain "import and export: $(head -3 differences)"
for name in ball back; do
    "$program" run $name.toml --output run_$name --quiet --no-report || complain "run of $name"
done
awk -v a="$(last_shift run_ball)" -v b="$(last_shift run_back)" 'BEGIN { exit !(a > 0.1 && (a / b - 1) ^ 2 < 1e-16) }' ||
    complain "shifts $(last_shift run_ball) and $(last_shift run_back)"

# 2. The layer: coefficients beside the input, its own at zero positive, as many lines as it says.
"$program" export ball.toml --model bem-layer --output layer >/dev/null || complain "export of the layer"
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
    "$program" influence ball.toml --model "$model" --output "$model.txt" >/dev/null ||
        complain "influence of $model"
    "$program" export ball.toml --set "bem.influence=$model.txt" --output "by_$model" >/dev/null ||
        complain "export with coefficients of $model"
done
grep -q '^ 999 999 50 50 ' by_bem-layer/ball.inp || complain "the layer's coefficients do not couple"
cmp -s by_bem-layer/ball.influence layer/ball.influence || complain "the layer's coefficients change"
grep -q '^ 999 999 50 1 ' by_bem/ball.inp || complain "the half-space's coefficients couple"
awk 'NR > 4 && !/%/ && ($4 != 0 || $5 != 0 || $6 != 0 || $9 != 0) { bad = 1 } END { exit bad }' \
    by_bem/ball.influence || complain "coefficients of a coupling that there is not"
refused "C = 9" import "$work/layer/ball.inp" --output case.toml

# 3. Bad input files state their message in the first line.
$python "$source_dir/tests/cli/bad_inputs.py" "$source_dir/tests/cli/bad_contact" "$work/bad_contact" ||
    complain "the table of bad_contact"
for file in "$work"/bad_contact/*.inp; do
    expected=$(head -n 1 "$file" | sed 's/^% expect: //')
    refused "$file$expected" import "$file" --output case.toml
done
refused "the file cannot be read (No such file or directory)" import none.inp --output case.toml

# 4. Cases that no such input says.
refused "ball.toml: load.indentation: CONTACT takes F_T over the F_N of each step" \
    export "$work/ball.toml" --set "load.indentation=0.4 mm"
refused "no boundary elements, which this needs, are among them" export "$work/ball.toml" \
    --set 'models=["mdr"]'

finish
