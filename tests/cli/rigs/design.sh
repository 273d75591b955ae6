#!/usr/bin/env bash
# tricontact design: a force by the resolution of a comparison, a resolution out of reach, what is refused. Only
# what reads maps: the check of assumptions takes a fifth of a second at each place.
# usage: design.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

file=$source_dir/examples/rigs/design_resolution.toml
"$program" design "$file" --output met >met.txt || complain "$(cat met.txt)"
grep -q '^All requirements can be met\.' met.txt || complain "not met: $(cat met.txt)"
[ -s met/report.html ] || complain "no report"
"$program" design "$file" --output again >/dev/null
cmp -s met/design.json again/design.json && cmp -s met/report.html again/report.html || complain "other bytes"

# Half as much cannot be seen: E alone is uncertain by 3 %, and the static shift goes with E^(-2/3) or so: 7 %.
"$program" design "$file" --set design.resolution=0.03 --output missed >missed.txt || complain "exit code $?"
grep -q '^Nothing within the bounds meets all requirements\.' missed.txt || complain "met: $(cat missed.txt)"
grep -q '^All requirements' missed.txt && complain "both sentences"
grep -q '"feasible": false' missed/design.json || complain "design.json"

# refuses NAME MESSAGE SED: the file changed so.
refuses() {
    sed "$3" "$file" >"$1.toml"
    refused "$2" design "$work/$1.toml"
}
refuses nothing 'design.deviation = 0.1: has no effect without design.assumptions' '/^resolution/d; /^quantity/d; /^scatter/d; /^repeats/d; s/^\[design\]/[design]\ndeviation = 0.1/'
refuses list 'must be a range' 's/= {from.*/= ["2 N", "3 N"]/'
refuses points 'has points' 's/to = "20 N"/to = "20 N", points = 4/'
refuses setting 'is no number of the rig' 's/^load.normal_force = {.*/bem.cells_per_radius = {from = 8, to = 20}/'
refuses unknown 'did you mean half_space?' 's/^resolution/assumptions = ["half_spaec"]\nresolution/'
refuses quantity 'is not one of "static_shift"' 's/^quantity.*/quantity = "shift"/'
refused 'missing section [design]' design "$source_dir/examples/rigs/sphere_parallel.toml"
finish
