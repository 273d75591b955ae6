#!/usr/bin/env bash
# tricontact run: files and numbers of a case that rolls on, the same each time; who else refuses
# it, and what it refuses.
# usage: roll.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

sphere=$source_dir/examples/cases/rolling_sphere.toml
coarse=(--set bem.cells_per_radius=8 --set mdr.springs=400 --set tractive_rolling.distance=5
    --points 3 --threads 1 --quiet)

"$program" run "$sphere" "${coarse[@]}" --output once >out 2>&1 || complain "$(cat out)"
for file in summary.json creep.csv case.toml report.html mdr/history.csv bem/history.csv \
    bem/surface.ex2 bem/steady.ex2 mdr/steady.ex2; do
    [ -s "once/$file" ] || complain "no $file"
done
grep -q '^Vermeulen and Johnson ' out || complain "the terminal lacks a theory: $(cat out)"

# numbers FOLDER: name, creepage and force over mu F_N of each model, and of each closed form.
numbers() {
    "$python" -S - "$1/summary.json" <<'END'
import json, sys
found = json.load(open(sys.argv[1]))
for model in found["models"]:
    print(model["model"], model["steady"]["longitudinal_creepage"], model["steady"]["force_ratio"])
for form in found["theories"]:
    print(form["theory"], form["longitudinal_creepage"], found["models"][0]["steady"]["force_ratio"])
END
}
numbers once >table.txt
# creepage MODEL: of its steady state.
creepage() { awk -v model="$1" '$1 == model { print $2 }' table.txt; }
# Springs rolled on follow their closed form to the spacing of 400 of them: 34 in the radius.
awk -v bed="$(creepage mdr)" -v exact="$(creepage mdr_closed_form)" \
    'BEGIN { exit !(bed / exact > 0.95 && bed / exact < 1.05) }' || complain "MDR: $(cat table.txt)"
# The force is the one of the case, in the last row as in the first.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "tangential_force_x_N") k = i; next }
    $k < 6.72 || $k > 6.75 { bad = 1 } END { exit bad }' once/bem/history.csv ||
    complain "F_T varies"
# A step per cell from rest on, and the steady state.
[ "$(wc -l <once/bem/history.csv)" -eq 43 ] || complain "rows: $(wc -l <once/bem/history.csv)"

# It says beforehand how many states there may be: one at rest and one per cell, eight of which are a.
"$program" run "$sphere" --models bem --set bem.cells_per_radius=8 --set tractive_rolling.distance=2 --points 0 \
    --no-report --output told >/dev/null 2>told.txt || complain "$(cat told.txt)"
grep -q 'bem: up to 17 states for ParaView, [0-9.]* MB' told.txt || complain "it does not say its size: $(cat told.txt)"
states=$(od -An -j4 -N4 -tu4 --endian=big told/bem/surface.ex2)  # of netCDF's classic format
[ "$states" -eq 17 ] || complain "$states states, not 17"

# Run again from the resolved case: the same bytes.
"$program" run once/case.toml --points 3 --threads 1 --quiet --output twice >/dev/null
for file in summary.json creep.csv report.html bem/history.csv mdr/history.csv bem/steady.ex2; do
    cmp -s "once/$file" "twice/$file" || complain "$file differs"
done

# Driven instead of braked: the mirror image without coupling.
"$program" run "$sphere" "${coarse[@]}" --set load.tangential_ratio=-0.56 --output driven \
    >out 2>&1 || complain "driven: $(cat out)"
numbers driven >driven.txt
for model in mdr bem; do
    awk -v model=$model '$1 == model { if (NR == FNR) { xi = $2; f = $3 } else { found = 1
        if ((xi / $2 + 1) ^ 2 > 1e-10 || (f / $3 + 1) ^ 2 > 1e-10) bad = 1 } } END { exit !found || bad }' \
        table.txt driven.txt || complain "driven is not braked mirrored: $(cat table.txt driven.txt)"
done

awk -F, '$1 == "bem" || $1 == "mdr" || $1 == "vermeulen_johnson" { n++; if ($2 > 0 || $3 > 0 || $3 < -1.000001) bad = 1 }
    END { exit bad || n < 9 }' driven/creep.csv || complain "the creep curve is not the driven one: $(cat driven/creep.csv)"
"$program" run "$sphere" "${coarse[@]}" --set load.tangential_ratio=1e-7 --no-report --output small \
    >out 2>&1 || complain "a small force: $(cat out)"
numbers small >small.txt
awk '$1 == "mdr" || $1 == "bem" || $1 == "vermeulen_johnson" { n++; if (($3 / 1e-7 - 1) ^ 2 > 1e-4) bad = 1 }
    END { exit bad || n != 3 }' small.txt || complain "a small force is not told: $(cat small.txt)"

# Friction that moves a coupled contact beside the grid that was made for it.
"$program" run "$source_dir/examples/cases/rolling_dissimilar.toml" --set friction.coefficient=10 \
    --set bem.cells_per_radius=12 --set tractive_rolling.distance=2 --points 2 --quiet --no-report \
    --output far >far.txt 2>&1 || complain "mu = 10: $(cat far.txt)"

# The exact sphere by depth: its bed is not to the last digit as wide as the half-space's contact.
"$program" run "$sphere" "${coarse[@]}" --models mdr --set 'indenter.shape="sphere"' \
    --set 'substrate.poisson=0.5' --set 'load.indentation="0.3 mm"' --no-report --output deep >deep.txt 2>&1 ||
    complain "sphere by depth: $(cat deep.txt)"

# Dundurs' beta of a rigid body may exceed 1/2.
"$program" run "$source_dir/examples/cases/rolling_dissimilar.toml" --set substrate.poisson=-0.3 \
    --set indenter.young='"1e15 Pa"' --set friction.coefficient=1 --set bem.cells_per_radius=8 \
    --set tractive_rolling.distance=1 --points 1 --quiet --output auxetic >auxetic.txt 2>&1 ||
    complain "nu = -0.3: $(cat auxetic.txt)"

refused "a case that rolls on has no --no-studies; leave it out" run "$sphere" --no-studies
refused "tricontact run computes such a case" refine "$sphere" --models bem
refused "a case without [tractive_rolling] has no --points; leave it out" run --points 3 "$source_dir/examples/cases/rig_sphere_parallel.toml"
refused "mdr is a line of springs" run "$source_dir/examples/cases/rolling_spin.toml" --models mdr

finish
