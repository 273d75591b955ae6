#!/usr/bin/env bash
# tricontact run: two bodies of finite size roll on, by what finite elements say of one cell; beside
# closed forms and boundary elements; what is refused.
# usage: fem_rolls_on.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

cylinder=$source_dir/examples/cases/rolling_hub.toml

# steady FOLDER CASE OPTIONS...: creepage over mu a/R (mu a/R = .025), share that sticks, variation, its cells' error
steady() {
    local folder=$1
    "$program" run "${@:2}" --points 0 --no-report --quiet --set tractive_rolling.distance=0.1 --output "$folder" \
        >"$folder.txt" 2>&1 || complain "$folder: $(cat "$folder.txt")"
    "$python" - "$folder/summary.json" <<'END'
import json, sys
for model in json.load(open(sys.argv[1]))["models"]:
    steady = model["steady"]
    print(steady["longitudinal_creepage"] / .025, steady["stick_share"], model["response_variation"],
          model["numerical_error"]["half_widths"]["longitudinal_creepage"] / .025)
END
}

# Carter (1926): two cylinders of one material. Half the difference of creep under F_T and -F_T knows
# no creep without a force, which bodies of finite size have: 0.9 (a/R)^2, an independent program's
# 0.89. First order in the cell, so that two sizes give the limit; bodies of a = R/20 are
# 0.5 % stiffer (docs/explanation/two-bodies.md).
for cells in 8 16; do
    size="$(awk "BEGIN { print 0.5 / $cells }") mm"
    read -r braked stuck variation error < <(steady "braked$cells" "$cylinder" --set "fem.size=\"$size\"")
    read -r driven _ < <(steady "driven$cells" "$cylinder" --set "fem.size=\"$size\"" --set load.tangential_ratio=-0.5)
    echo "$braked $driven $stuck $variation $error"
done >creeps.txt
awk '{ creep[NR] = ($1 - $2) / 2; free = ($1 + $2) / 2 * .025 / .0025; stuck = $3; variation = $4; error = $5 }
    END {
        limit = 2 * creep[2] - creep[1]
        off = limit / .2928932 - 1
        exit !(off < .01 && off > -.01 && creep[1] < creep[2] && stuck > .66 && stuck < .75 &&
               free > .8 && free < 1 && variation < 2e-3 && error > 0)
    }' creeps.txt || complain "Carter: $(cat creeps.txt)"
grep -q 'the response of a cell varies' driven16.txt && complain "--quiet is not quiet"

# A rigid cylinder on a layer, beside boundary elements on the layer's own transform and the same cells.
"$python" - "$source_dir/examples/cases/rolling_cylinder.toml" >layer.toml <<'END'
import sys
text = open(sys.argv[1]).read().replace('models = ["bem"]', 'models = ["bem-layer", "fem-plane"]')
text = text[:text.index("[bem]")].replace('poisson = 0.5', 'poisson = 0.3\nthickness = "5 mm"')
print(text + '[bem]\nspacing = "0.1 mm"\n[fem]\nsize = "0.1 mm"')
END
steady layer layer.toml >layer_creeps.txt
awk '{ xi[NR] = $1; stuck[NR] = $2 } END { exit !((xi[2] / xi[1] - 1) ^ 2 < 1e-4 && (stuck[2] - stuck[1]) ^ 2 < 1e-3) }' \
    layer_creeps.txt || complain "on a layer: $(cat layer_creeps.txt)"

refused 'fem-plane rolls on by the response of one cell: its accuracy is that of the cells; give their size, fem.size' \
    check "$cylinder" --set fem.accuracy=0.01
refused 'how bodies creep along the way is not computed' check "$cylinder" --set substrate.relaxation.moduli='["1 MPa"]' \
    --set substrate.relaxation.times='["1 s"]' --set tractive_rolling.speed='"1 mm/s"'
sed 's/"hub"/"plates"/; /^hub_radius/d' "$cylinder" >plates.toml
refused 'presses bodies where they are, but for a cylinder on a hub: takes no [tractive_rolling]' \
    check "$work/plates.toml"
refused 'fem-axisymmetric has no grid along which the contact could move by whole cells' \
    check "$cylinder" --set models='["fem-axisymmetric"]'
sed "/^accuracy/d" "$source_dir/examples/cases/hemisphere.toml" >hemisphere.toml
refused "fem rolls a cylinder or ball on a hub on; a hemisphere held by a rigid holder has another stiffness" \
    check "$work/hemisphere.toml" --set models='["fem"]' --set tractive_rolling.distance=1
finish
