#!/usr/bin/env bash
# The page of tricontact predict: what its script reads in the atlases is what the program says; small, and written
# where a folder is named only.
# usage: predict_page.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
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

# same NAME CASE ARGUMENTS...: the page's script at the case's place beside the program.
same() {
    local name=$1 file=$2
    shift 2
    "$program" predict "$file" "$@" --output "$name" >/dev/null || complain "$name: predict"
    nodejs=$(command -v nodejs || command -v node) || { complain "no node"; return; }
    "$nodejs" - "$source_dir" "$name" <<'EOF' || complain "$name: the page differs from the program"
const fs = require("fs"), [, , root, folder] = process.argv;
const scripts = ["formulas", "maps"].map(part => fs.readFileSync(`${root}/atlas/page/atlas_${part}.js`, "utf8"));
const maps = new Function(scripts.join("") + "; return atlas_maps;")();
const page = fs.readFileSync(folder + "/atlas.html", "utf8");
const given = JSON.parse(page.match(/<script type="application\/json" id="atlas">([^]*?)<\/script>/)[1]);
const place = {equal_amplitude: "W", equal_load: "F_T", thickness_ratio: 1, ...given.case};
const at = maps.read_atlases(given).at(place);
const said = JSON.parse(fs.readFileSync(folder + "/prediction.json", "utf8")).models;
// At the same depth the half-space carries another force than the layer, which the page gives to both.
const is_deep = folder === "deep";
let n = 0;
for (const [model, body] of Object.entries(at)) {
    if (!body || !said[model] || is_deep && model !== "bem-layer") continue;
    for (const key of ["static_shift_ratio", "settled_shift_ratio", "kappa", "shift_increment_ratio", "eta"]) {
        const ours = said[model][key], theirs = body[key];
        if ((ours === undefined) !== (theirs === undefined)) throw new Error(`${model} ${key}: ${ours} ${theirs?.value}`);
        if (ours === undefined) continue;
        const close = (a, b, e) => Math.abs(a - b) <= e * Math.max(Math.abs(b), 1e-6);
        if (!close(theirs.value, ours, 1e-6)) throw new Error(`${model} ${key}: ${theirs.value} ${ours}`);
        if (!close(theirs.error, said[model][key + "_error"], 1e-6))
            throw new Error(`${model} ${key}: errors ${theirs.error} ${said[model][key + "_error"]}`);
        ++n;
    }
    const by_key = {limit_tangential_ratio: body.limit, amplitude_ratio: body.w, tangential_ratio: body.f};
    for (const [key, {value}] of Object.entries(by_key)) {
        const ours = said[model][key];
        if (ours === undefined) continue;
        if (!(Math.abs(value / ours - 1) < 1e-6)) throw new Error(`${model} ${key}: ${value} ${ours}`);
        ++n;
    }
    if (body.scale && said.mdr && !is_deep) {
        const radius = said[model].contact_radius_m / said.mdr.contact_radius_m;
        if (!(Math.abs(body.scale.contact_radius_m.value / radius - 1) < 1e-6)) throw new Error(`${model}: radius ${radius}`);
    }
}
if (n < 3) throw new Error(`only ${n} numbers are compared`);
EOF
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

# The report of a run shows where its case lies, of what the maps are about; of other bodies, and without rolling, it
# does not speak of them.
"$program" run "$sphere" --models mdr --output run --quiet --no-studies || complain "a run"
grep -q 'The case in the maps' run/report.html || complain "no place in the maps"
[ "$(grep -c . run/plots/place_in_maps.csv)" -gt 30 ] || complain "an empty picture of the maps"
"$program" run "$source_dir/examples/cases/body_cone.toml" --models mdr --output cone --quiet --no-studies || complain "a cone"
grep -q 'The case in the maps' cone/report.html && complain "maps of a cone"

finish
