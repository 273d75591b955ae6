#!/usr/bin/env bash
# tricontact refine: table and files, what is taken over after a kill or a second call, bad input.
# usage: refine.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
case_file=$source_dir/examples/cases/rig_layer_parallel.toml
child=
trap 'kill -9 $child 2>/dev/null; rm -rf "$work"' EXIT
export OPENBLAS_NUM_THREADS=1
coarse=(--set rolling.periods=1 --set rolling.steps=turning-points --set "fem.size=2 mm"
    --set load.press_steps=3 --set "fem.cache=$work/cache")

# expect CODE ARGUMENTS...: output goes to the files out and err.
expect() {
    local code=$1 got
    shift
    "$program" refine "$@" >out 2>err
    got=$?
    [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*: $(cat err)"
}

# says TEXT FILE
says() {
    grep -qF -- "$1" "$2" || complain "no '$1' in $2: $(head -c 600 "$2")"
}

bem() {
    expect 0 "$source_dir/examples/cases/rig_sphere_parallel.toml" --models bem --quiet --output "$1" \
        --set "bem.spacing=1 mm" --set rolling.periods=1 --set rolling.steps=turning-points
}

# resolved FOLDER SIZE: the case text of the level of that size, as the store has it.
resolved() {
    "$python" - "$1/results.sqlite" "$2" <<'END'
import sqlite3, sys
rows = sqlite3.connect(sys.argv[1]).execute("SELECT resolved_case FROM points").fetchall()
print(*(text for text, in rows if sys.argv[2] in text))
END
}

# 1. Another model: its own key, Hertz' theory, no block to widen.
bem bem
says "bem.spacing was refined" out
says "Hertz" out
[ -e bem/wide ] && complain "a wide block for a half-space"
[ -s err ] && complain "--quiet is not silent: $(cat err)"

# Ratios are multiples of U_max, not thousandths of it; the page tells the error of its headline.
grep -Eq '^static shift u_stat +U_max +0\.4' out || complain "u_stat is no ratio: $(grep u_stat out)"
grep -q "no-studies" bem/report.html && complain "a refinement asks for comparison runs"
grep -q "What the mesh leaves in it is told by\|the error of the finest mesh" bem/report.html || complain "no error on the page"
# The stiffness beside 2 E* a, and fields: what neighbouring levels differ by falls to the first order.
"$python" - bem <<'END' || complain "stiffness and fields: $(cat out)"
import json, sys
found = json.load(open(sys.argv[1] + "/refinement.json"))
stiffness = found["quantities"]["normal_stiffness_N_per_m"]
assert abs(stiffness["values"][-1] - stiffness["exact"]) <= stiffness["error_of_finest"] < .05 * stiffness["exact"], stiffness
pressure, traction = found["fields"]["normal_traction"], found["fields"]["tangential_traction"]
assert pressure["changes_l2"][1] < pressure["changes_l2"][0] < .2 and pressure["error_l2"] < .3, pressure
assert pressure["largest_error_Pa"] > 0 and traction["error_l2"] > pressure["error_l2"], traction
END
says "Fields of the last state on finer and finer levels" bem/report.html
says "normal_traction_change_l2" bem/refinement.csv
# Levels side by side are the same to the last digit, histories too; only times of computing differ.
expect 0 "$source_dir/examples/cases/rig_sphere_parallel.toml" --models bem --quiet --output side_by_side --jobs 2 \
    --set "bem.spacing=1 mm" --set rolling.periods=1 --set rolling.steps=turning-points
diff -r --exclude=results.sqlite --exclude=refinement.json --exclude=report.html bem side_by_side ||
    complain "--jobs changes results"
diff <(sed '/"cpu_s"/,/\]/d' bem/refinement.json) <(sed '/"cpu_s"/,/\]/d' side_by_side/refinement.json) ||
    complain "--jobs changes refinement.json"
says "--jobs" <("$program" refine --help)
# What stops a level is said of it, and nothing of it is kept.
expect 1 "$source_dir/examples/cases/rig_sphere_parallel.toml" --models bem --quiet --output stopped \
    --set "bem.spacing=1 mm" --set rolling.periods=1 --set bem.tolerance=1.1e-14
says "level_0 (bem.spacing = 1 mm): " err
[ -e stopped/refinement.json ] && complain "a refinement without its levels"

# The layer by boundary elements too; the pressure under a tip has no limit.
cat >cone.toml <<'END'
models = ["bem-layer"]
[indenter]
shape = "cone"
angle = "6 deg"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "20 N"
tangential_force = "0 N"
press = "frictionless"
[bem]
cells_per_radius = 5
END
expect 0 cone.toml --models bem-layer --quiet --output layer
says "bem.spacing was refined" out
says "p_0 of a mesh has no limit" out
grep -q '^peak pressure' out && complain "an infinite pressure is refined: $(grep p_0 out)"

# Springs, and the elements of mdr-layer: no order, the exact layer within the error.
cat >springs.toml <<'END'
models = ["mdr", "mdr-layer"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
indentation = "0.35 mm"
tangential_ratio = 0.3
[mdr]
springs = 300
elements_per_radius = 20
END
expect 0 springs.toml --models mdr --quiet --output springs
says "mdr.springs was refined on 3 levels, springs from" out
says "mdr leaves out substrate.thickness" out
says '"key": "mdr.springs"' springs/refinement.json
expect 0 springs.toml --models mdr-layer --quiet --output elements
says "mdr.elements_per_radius was refined on 3 levels" out
grep -q "^elements_per_radius = 40$" elements/case.toml || complain "elements of the finest level: $(cat elements/case.toml)"
"$python" - springs elements <<'END' || complain "springs beside theory"
import json, sys
for folder in sys.argv[1:]:
    quantities = json.load(open(folder + "/refinement.json"))["quantities"]
    force = quantities["normal_force_N"]
    assert force["convergence"] == "no order" and force["limit"] == force["values"][-1], force
    for key in "normal_force_N", "contact_radius_m", "peak_pressure_Pa":
        one = quantities[key]
        assert abs(one["values"][-1] - one["exact"]) <= one["error_of_finest"] < .01 * one["exact"], (folder, key, one)
    for key in "contact_area_m2", "stick_area_m2", "slip_area_m2", "stored_energy_J", "friction_energy_J", "end_normal_force_N":
        assert quantities[key]["error_of_finest"] > 0, (folder, key)
END

# A cylinder beside the closed forms of the line contact.
cat >line.toml <<'END'
models = ["bem"]
[indenter]
shape = "cylinder"
radius = "40 mm"
length = "100 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = 0.57
[load]
normal_force = "20 N"
tangential_ratio = 0.3
[bem]
cells_per_radius = 10
END
expect 0 line.toml --models bem --quiet --output line
says "Theory (half-space) lies within the estimated error of" out

# 2. Bad input.
expect 2 "$source_dir/examples/cases/rig_sphere_parallel.toml" --output none
says "models: fem is not among the models of the case" err
for levels in 2 9 many; do
    expect 2 "$case_file" --levels "$levels" --output none
    says "--levels" err
done
expect 2 "$case_file" --models atlas --output none
says "--models" err
expect 2 "$case_file" --models mdr-layer --output none
says "models: mdr-layer is not among the models of the case" err
[ -e none ] && complain "a folder in spite of bad input"

if ! has_fem; then
    expect 2 "$case_file" --output none
    printf '%d failures (built without fem)\n' "$failures"
    exit "$failures"
fi

touch layer.msh
expect 2 "$case_file" --set "fem.mesh=$work/layer.msh" --output none
says "a mesh from a file cannot be refined" err
expect 2 "$case_file" --set "fem.size=3 mm" --output none
says "too coarse" err
expect 2 "$case_file" --set "fem.size=0.1 mm" --set fem.solver=direct --levels 8 --output none
says "level_1 (fem.size = 0.07071 mm): " err
says "contact and rolling path need" err
[ -e none ] && complain "a folder in spite of bad input"

# 3. Three levels and a wide block.
expect 0 "$case_file" "${coarse[@]}" --output whole
for text in "quantity" "2.00 mm" "1.41 mm" "1.00 mm" "order" "exact layer" "wide block" "U_end" \
    "was refined on 3 levels"; do
    says "$text" out
done
for file in level_0/fem/history.csv level_1/fem/history.csv level_2/fem/history.csv wide/fem/history.csv \
    results.sqlite case.toml report.html refinement.json refinement.csv plots/shift.svg; do
    [ -s "whole/$file" ] || complain "no whole/$file"
done
says '<section id="refinement">' whole/report.html
says '"key": "fem.size"' whole/refinement.json
# The whole mesh is refined: growth 1.8^(1/sqrt 2) and 1.8^(1/2).
resolved whole 'size = "0.002 m"' | grep "growth = 1.8$" >/dev/null || complain "growth of level 0"
grep -q "growth = 1.34164" whole/case.toml || complain "growth of level 2"
# 96 mm are the block's own choice, 6 thicknesses to each side.
says 'width = "0.144' <(resolved whole 'width = ')

# 4. A second call takes everything over.
cp -r whole again
expect 0 "$case_file" "${coarse[@]}" --output again
[ "$(grep -c 'taken from' err)" -eq 4 ] || complain "not four levels taken over: $(cat err)"
grep -q "steps in" err && complain "steps in spite of finished levels"
diff -r whole again || complain "a second call changed the results"

# 5. Without its report the finest level is computed once more, a damaged level too, no other.
rm again/report.html
"$python" - again/results.sqlite <<'END'
import sqlite3, sys
with sqlite3.connect(sys.argv[1]) as store:
    store.execute("UPDATE points SET results = replace(results, '1', '2') WHERE resolved_case LIKE '%0.00141%m\"%'"
                  " AND resolved_case NOT LIKE '%width%'")
    assert store.execute("SELECT changes()").fetchone() == (1,)
END
expect 0 "$case_file" "${coarse[@]}" --output again
[ "$(grep -c 'steps in' err)" -eq 2 ] || complain "not two levels computed: $(cat err)"
says "level_0: fem.size = 2 mm: taken from" err
says "level_2: once more, for the report" err
cmp whole/refinement.csv again/refinement.csv || complain "other numbers the second time"
[ -s again/report.html ] || complain "no report"

# 6. A kill during the second level costs no more than that.
"$program" refine "$case_file" "${coarse[@]}" --output killed --quiet >/dev/null &
child=$!
for _ in $(seq 1 3000); do
    [ -e killed/level_1 ] && break
    kill -0 "$child" 2>/dev/null || break
    sleep 0.01
done
kill -9 "$child" || complain "the refinement was over before it could be killed"
wait "$child" 2>/dev/null
[ -n "$(resolved killed 'size = "0.002 m"')" ] || complain "the first level is lost"
[ -e killed/refinement.json ] && complain "a refinement of levels that were not computed"
expect 0 "$case_file" "${coarse[@]}" --output killed
says "level_0: fem.size = 2 mm: taken from" err
cmp whole/refinement.csv killed/refinement.csv || complain "other numbers after a kill"

# 7. Another case takes nothing over.
expect 0 "$case_file" "${coarse[@]}" --set load.tangential_ratio=0.3 --output again
grep -q "taken from" err && complain "levels of another case: $(cat err)"
cmp -s whole/refinement.csv again/refinement.csv && complain "the same numbers for another load"

# 8. A cylinder's substrate has no ends along y: its block is widened along x, from 8 thicknesses on.
expect 0 "$source_dir/examples/cases/rig_cylinder.toml" "${coarse[@]/2 mm/0.4 mm}" --output line
says 'width = "0.12' <(resolved line 'width = ')
resolved line 'width = ' | grep 'depth = ' >/dev/null && complain "a line contact in a block with ends"
says "fem.size was refined" out

finish
