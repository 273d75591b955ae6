#!/usr/bin/env bash
# Each block of docs/tutorials/tutorial.md works: files are written, commands end with the code they should, and
# what is said of their numbers is so.
# usage: tutorial.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
source "$source_dir/tests/documents/document_blocks.bash"

run_blocks tutorials/tutorial.md
[ "$blocks" -ge 9 ] || complain "only $blocks blocks"

grep -q 'a        =        2.657 mm' 2.out || complain "the contact radius is another: $(grep 'a  *=' 2.out)"
grep -q 'did you mean' 3.out || complain "no remedy: $(cat 3.out)"
for shift in 'mdr 0.275' 'bem 0.247' 'bem-layer 0.240'; do
    read -r model due <<<"$shift"
    found=$(awk -v model="\"$model\":" '/^ *"models": {/ { models = 1 } models && $1 == model { here = 1 } here && /"final_shift_ratio"/ {
        print $2 + 0; exit }' results/ball/summary.json)
    [[ $(printf %.3f "$found") == "$due" ]] || complain "$model settles at $found, not $due"
done
# What the figure draws is the settled shift and its error, by the names of the columns; they moved once.
column() { head -1 results/amplitudes/points.csv | tr , '\n' | grep -nx "$1" | cut -d: -f1; }
due="using $(column amplitude_ratio):$(column settled_shift_ratio):$(column settled_shift_ratio_error) with"
[ "$(grep -c "$due" figure.gp)" -eq 3 ] || complain "the figure draws other columns than $due: $(grep using figure.gp)"
# Bars within a symbol of the figure; half-space below MDR, layer below half-space up to w = 0.3; MDR by its closed form
# f_T = 1 - 3/2 w u - (1 - u)^(3/2), 1e-4 being far above its springs' error.
awk -F, -v u_at="$(column settled_shift_ratio)" -v error_at="$(column settled_shift_ratio_error)" '
    NR == 1 { next }
    { w = sprintf("%.2f", $3); u[$1, w] = $u_at; all[w] = 1 }
    !($error_at < .002) { bad = 1 }
    $1 == "mdr" && (1 - 1.5 * $3 * $u_at - (1 - $u_at) ^ 1.5 - .3) ^ 2 > 1e-8 { bad = 1 }
    END { for (w in all) {
        n++
        if (!(u["mdr", w] > u["bem", w])) bad = 1
        if ((u["bem", w] > u["bem-layer", w]) != (w + 0 < .3)) bad = 1 }
        exit bad || n != 6 }' results/amplitudes/points.csv || complain "the bars or the curves"
[ "$(head -c 4 figure.pdf)" = %PDF ] || complain "no figure"

finish
