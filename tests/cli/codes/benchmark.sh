#!/usr/bin/env bash
# The catalogue of problems for contact codes: its list, its pages, and its cases, which the program reads.
# usage: benchmark.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

"$program" benchmark list >list.txt || complain "no list"
"$program" benchmark list --json >list.json || complain "no list as JSON"
"$python" -c 'import json; print("\n".join(one["name"] for one in json.load(open("list.json"))))' >names
n=$(wc -l <names)
[ "$n" -ge 18 ] || complain "only $n problems"
[ "$(tail -n +2 list.txt | wc -l)" -eq "$n" ] || complain "list and JSON differ"
"$program" benchmark list --tests LOCKING | grep -q '^layer_pressed_nearly_incompressible ' || complain "who tests locking"
refused 'no problem tests it' benchmark list --tests nonsense
refused 'did you mean layer_pressed' benchmark show layer_presed
refused 'has no case' benchmark show wedge --case
refused 'no part is given' benchmark

# Each has its file of the same name, and a case that the program takes or none.
diff <(sort names) <(cd "$source_dir/benchmarks/problems/data" && ls -- *.toml | sed 's/\.toml$//' | sort) ||
    complain "files and problems differ"
while read -r name; do
    [ -e "$source_dir/benchmarks/problems/data/$name.toml" ] || continue
    if grep -q "^case = " "$source_dir/benchmarks/problems/data/$name.toml"; then
        "$program" benchmark show "$name" --case >case.toml || complain "$name: no case"
        "$program" check case.toml >checked.txt 2>err.txt || complain "$name: $(cat err.txt)"
    fi
done <names

# What is shown.
"$program" benchmark show two-spheres >page.txt || complain "no page"
for words in 'Published, of other problems' '3176.3 MPa' 'What can go wrong' 'peak pressure p0'; do
    grep -q "$words" page.txt || complain "the page has no $words"
done
"$program" benchmark show two_spheres --json >page.json || complain "no page as JSON"
"$python" - <<'END' || complain "the JSON of a page"
import json
page = json.load(open("page.json"))
values = {t["value"] for t in page["targets"] if t["quantity"] == "peak_pressure"}
assert any(abs(v - 2798.3e6) < 1e3 for v in values) and any(abs(v - 3176.3e6) < 1e3 for v in values), values
assert page["case"].startswith("title"), page["case"]
END

# Problems with a closed form and ratios: what is exact passes, what is wrong fails, what cannot be judged is refused by name.
verdict() {
    local expected=$1 status=0
    shift
    "$program" benchmark compare "$@" --output out >said.txt 2>err.txt || status=$?
    [ "$status" -eq "$expected" ] || complain "$*: exit code $status: $(cat err.txt)"
}
printf '%s\n' 'x [mm], p [MPa]' 0,.1 333,.1 666,.1 1000,.1 >uniform.csv
sed 's/^333,.1/333,.11/' uniform.csv >node.csv
verdict 0 --case patch_test uniform.csv
verdict 3 --case patch-test uniform.csv node.csv
grep -q 'no refinement removes' said.txt || complain "no diagnosis of the patch test"
[ -s out/comparison.json ] && [ -s out/report.html ] && [ -s out/junit.xml ] || complain "files of the patch test"
[ ! -e out/case.toml ] || complain "a closed form has a case"
printf '# force_ratio = 0.412371\n' >wedge.csv
verdict 0 --case wedge wedge.csv
printf '# force_ratio = 0.4\n' >wedge.csv
verdict 3 --case wedge wedge.csv
for h in .4 .2 .1; do printf '# size = %s mm\n# stick_ratio = 0.746\n' "$h" >"c_$h.csv"; done
verdict 0 --case spence c_.4.csv c_.2.csv c_.1.csv --tolerance .02
refused 'judged by F/G' benchmark compare --case wedge "$PWD/uniform.csv" --output out
printf '# normal_force = 100 N/mm\n' >force.csv
refused 'judged by the pressures' benchmark compare --case patch_test "$PWD/force.csv" --output out
refused 'is no target of layer_pressed' benchmark compare --case layer_pressed "$PWD/wedge.csv" --output out
cat >submission.toml <<'END'
case = "complete_punch"
[tolerance]
pressure_l2 = 0.1
[[mesh]]
normal_force = "20 N"
END
refused 'nothing of this name is compared' benchmark compare "$PWD/submission.toml" --output out

# Surfaces of the program's own runs as a code's: boundary elements on three grids beside Hertz; a substrate that is a tenth stiffer fails.
"$program" benchmark show hertz_sphere --case >hertz.toml || complain "no case of Hertz"
own() { "$program" run hertz.toml --models bem --no-report --no-studies --quiet --output "$@" || complain "run $*"; }
for n in 10 20 40; do
    own "own_$n" --set "bem.cells_per_radius=$n"
    own "stiff_$n" --set "bem.cells_per_radius=$n" --set 'substrate.young="15 MPa"'
done
verdict 0 --case hertz_sphere own_10/bem/surface.ex2 own_20/bem/surface.ex2 own_40/bem/surface.ex2
grep -q 'own_10/bem/surface.ex2: a surface of tricontact run' said.txt || complain "own surface: $(cat said.txt)"
grep -q '^peak pressure p0.* kPa .*954.9' said.txt || complain "own surface: $(cat said.txt)"
verdict 3 --case hertz_sphere stiff_10/bem/surface.ex2 stiff_20/bem/surface.ex2 stiff_40/bem/surface.ex2
cp own_40/bem/indenter.ex2 . && refused 'indenter.ex2' benchmark compare --case hertz_sphere "$PWD/indenter.ex2" --output out
finish
