#!/usr/bin/env bash
# The page of tricontact predict: what its script reads in the atlases is what the program says; small, and written
# where a folder is named only.
# usage: predict_page.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
sphere=$source_dir/examples/cases/rig_sphere_parallel.toml
layer=$source_dir/examples/cases/rig_layer_parallel.toml

"$program" predict "$layer" --output page >said || complain "a page"
grep -q '^page: page/atlas.html$' said || complain "no path of the page: $(cat said)"
[ "$(stat -c %s page/atlas.html)" -lt 3000000 ] || complain "the page has $(stat -c %s page/atlas.html) bytes"
grep -qE 'https?://[a-z]' <(sed '/<script>/,$d' page/atlas.html) && complain "the page asks the network"
"$program" predict "$layer" --json >said || complain "JSON"
cmp -s said page/prediction.json || complain "prediction.json is another text than --json"
mkdir alone && (cd alone && "$program" predict "$layer" >/dev/null)
[ -z "$(ls alone)" ] || complain "files without --output: $(ls alone)"

nodejs=$(command -v nodejs || command -v node) || complain "no node"

# same NAME CASE ARGUMENTS...: the page's script at the case's place beside the program.
same() {
    local name=$1 file=$2
    shift 2
    "$program" predict "$file" "$@" --output "$name" >/dev/null || complain "$name: predict"
    "$nodejs" "$source_dir/tests/cli/atlas/predict_page.js" at "$name" || complain "$name: the page differs from the program"
}
same along "$sphere"
same across "$sphere" --set "rolling.angle=60 deg" --set load.tangential_ratio=0.2 --set rolling.amplitude_ratio=0.5
same compressible "$sphere" --set contact.coupling=false --set substrate.poisson=0.2
same small "$sphere" --set load.tangential_ratio=0.05
same layer "$layer" --set load.tangential_ratio=0.3
same thick "$layer" --set load.tangential_ratio=0.4 --set "substrate.thickness=40 mm" --set "rolling.angle=90 deg"
same own "$layer" --set rolling.amplitude_reference=model --set rolling.amplitude_ratio=0.4 --set load.limit_fraction=0.5
same deep "$layer" --set "load.indentation=0.4 mm" --set load.tangential_ratio=0.3
same exact "$sphere" --set indenter.shape=sphere
same beyond "$sphere" --set load.tangential_ratio=0.8
same excess "$sphere" --set load.limit_excess=0.3 --set rolling.amplitude_ratio=0.3
same resting "$source_dir/examples/cases/rig_sphere_parallel_shakedown.toml"
# Thinner than the maps reach: the place is that of the half-space.
same thin "$layer" --set "substrate.thickness=2 mm"
# random CASE BODY: the same at points drawn at random.
random() {
    "$nodejs" "$source_dir/tests/cli/atlas/predict_page.js" random "$program" "$1" "$2" 43 60 ||
        complain "$2: the page differs from the program"
}
random "$sphere" half-space
random "$layer" layer

# The report of a run shows where its case lies, of what the maps are about; of other bodies, and without rolling, it
# does not speak of them.
"$program" run "$sphere" --models mdr --output run --quiet --no-studies || complain "a run"
grep -q 'The case in the maps' run/report.html || complain "no place in the maps"
[ "$(grep -c . run/plots/place_in_maps.csv)" -gt 30 ] || complain "an empty picture of the maps"
"$program" run "$source_dir/examples/cases/body_cone.toml" --models mdr --output cone --quiet --no-studies || complain "a cone"
grep -q 'The case in the maps' cone/report.html && complain "maps of a cone"

finish
