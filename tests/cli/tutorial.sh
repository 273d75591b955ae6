#!/usr/bin/env bash
# Each block of docs/tutorial.md works: files are written, commands end with the code they should, and
# what is said of their numbers is so.
# usage: tutorial.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
source "$source_dir/tests/cli/document_blocks.bash"

run_blocks tutorial.md
[ "$blocks" -ge 9 ] || complain "only $blocks blocks"

grep -q 'a        =      2.65665 mm' 2.out || complain "the contact radius is another: $(grep 'a  *=' 2.out)"
grep -q 'did you mean' 3.out || complain "no remedy: $(cat 3.out)"
for shift in 'mdr 0.275' 'bem 0.247' 'bem-layer 0.240'; do
    read -r model due <<<"$shift"
    found=$(awk -v model="\"$model\":" '/^ *"models": {/ { models = 1 } models && $1 == model { here = 1 } here && /"final_shift_ratio"/ {
        print $2 + 0; exit }' results/ball/summary.json)
    [[ $(printf %.3f "$found") == "$due" ]] || complain "$model settles at $found, not $due"
done
# Bars within a symbol of the figure; half-space below MDR, layer below half-space up to w = 0.3.
awk -F, 'NR == 1 { next } !($9 < .002) { bad = 1 } { u[$1, sprintf("%.2f", $3)] = $8; w[sprintf("%.2f", $3)] }
    END { for (at in w) {
        n++
        if (!(u["mdr", at] > u["bem", at])) bad = 1
        if (u["bem", at] > u["bem-layer", at] != at < .3) bad = 1 }
        exit bad || n != 6 }' results/amplitudes/points.csv || complain "the bars or the curves"
[ "$(head -c 4 figure.pdf)" = %PDF ] || complain "no figure"

finish
