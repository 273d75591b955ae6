#!/usr/bin/env bash
# tricontact compare: two folders of results side by side, by closed forms; differences of fields of a run; bad input.
# usage: compare.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# expect CODE ARGUMENTS...: output goes to the files out and err.
expect() {
    local code=$1 got
    shift
    "$program" "$@" >out 2>err
    got=$?
    [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*: $(cat err)"
}

# says TEXT FILE
says() {
    grep -qF -- "$1" "$2" || complain "no '$1' in $2: $(head -c 800 "$2")"
}

# turned_down TEXT ARGUMENTS...: in one line, and nothing is written.
turned_down() {
    expect 2 compare "${@:2}" --output turned_down
    says "$1" err
    [ "$(wc -l <err)" -eq 1 ] || complain "not one line: $(cat err)"
    [ ! -e turned_down ] || complain "something was written: ${*:2}"
}

cat >case.toml <<'END'
models = ["mdr", "bem"]
indenter.radius = "40 mm"
substrate.young = "5.2 MPa"
substrate.poisson = 0.3
friction.coefficient = 0.57
contact.coupling = false
load.indentation = "0.1 mm"
load.tangential_ratio = 0.5
rolling.amplitude_ratio = 0.1
rolling.steps_per_quarter = 1
rolling.periods = 1
mdr.springs = 1000
bem.cells_per_radius = 8
END
run() { "$program" run case.toml --quiet --no-report "$@" || complain "run $*"; }
run --output a --no-studies
run --output b --no-studies --set 'load.indentation="0.2 mm"'
run --output flat --no-studies --models bem --set output.vtk=none
run --output bars --models bem
run --output finer --models bem --set bem.cells_per_radius=12

# 1. Hertz: the force grows as d^(3/2), a as d^(1/2), p_0 as d^(1/2).
expect 0 compare a b --output ab
says "load.indentation" out
$python -S - <<'END' || complain "no Hertz in ab/compare.json"
import json
found = json.load(open("ab/compare.json"))
assert [one["key"] for one in found["case_differences"]] == ["load.indentation"], found["case_differences"]
mdr, bem = found["pairs"]
assert (mdr["a"], mdr["b"], bem["a"]) == ("mdr", "mdr", "bem")
for pair, within in (mdr, 1e-6), (bem, .02):  # cells cut the edge of the contact
    for key, power in ("normal_force_N", 1.5), ("peak_pressure_Pa", .5), ("contact_radius_m", .5):
        relative = pair["quantities"][key]["relative"]
        assert abs(relative - (.5 ** power - 1)) < within, (pair["a"], key, relative)
    # p(0) of b is 2^(1/2) times that of a; farther out a has none: 1 of p_0 at r = a of it, 0.71 there.
    last = pair["fields"][-1]["pressure"]
    assert -.8 < last["largest_Pa"] / last["over_Pa"] < -.6, last
assert bem["history"]["indentation_m"]["largest"] == -1e-4
END
for file in ab/report.html ab/difference_mdr.vti ab/difference_bem.vti; do [ -s "$file" ] || complain "no $file"; done

# 2. A folder beside itself: nothing differs.
expect 0 compare a a/ --output aa --quiet
says "the cases are the same" out
$python -S - <<'END' || complain "a differs from itself"
import json
for pair in json.load(open("aa/compare.json"))["pairs"]:
    assert all(not one["difference"] for one in pair["quantities"].values())
    assert all(one[field]["largest_Pa"] == 0 for one in pair["fields"] for field in ("pressure", "traction"))
END
[ -s err ] && complain "--quiet is not silent: $(cat err)"

# 3. Bars of either; a run without surfaces; models of other names; models that are in one only.
expect 0 compare bars finer --output bars_finer
$python -S - <<'END' || complain "no bars"
import json
found = json.load(open("bars_finer/compare.json"))["pairs"][0]["quantities"]["static_shift_m"]
assert found["bar_a"] > found["bar_b"] > 0 and found["bars_overlap"] is True, found
END
expect 0 compare flat a --output flat_a
says "surfaces were not written" out
says "mdr is in B only." out
[ ! -e flat_a/difference_bem.vti ] || complain "a difference of no surfaces"
run --output springs --no-studies --models mdr
expect 0 compare springs bars --output mixed
says "No model is in both" out
[ -s mixed/difference_mdr_bem.vti ] || complain "no difference of mdr and bem"

# 4. run has the difference of its own models, and leaves none behind where there are no surfaces.
[ -s a/difference_bem_mdr.vti ] || complain "run has no difference"
run --output a2 --no-studies --models mdr
[ ! -e a2/difference_bem_mdr.vti ] || complain "a difference of one model"

# 5. Bad input.
turned_down "nowhere: has no summary.json; give a folder that tricontact run has filled" a nowhere
mkdir bad && printf '{' >bad/summary.json
turned_down "bad/summary.json: has no case and no models" a bad
printf '{"case": {}, "models": {"../a": {}}}' >bad/summary.json
turned_down "is no model of a run" a bad
# A folder of an earlier version, with a file for each state, is refused by its list.
cp -r a former && echo '<VTKFile type="Collection"/>' >former/bem/surface.pvd
turned_down "former/bem/surface.pvd: is of an earlier version, which wrote a file for each state; compute the case anew" a former
cp -r a cut && head -c 30000 a/bem/surface.ex2 >cut/bem/surface.ex2
turned_down "compute the case anew with tricontact run" a cut
finish
