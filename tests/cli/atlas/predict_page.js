// What the script of the page of `tricontact predict` computes, beside the program.
// usage: predict_page.js at FOLDER
//        predict_page.js random PROGRAM CASE layer|half-space SEED POINTS
const fs = require("fs"), {spawnSync} = require("child_process");

function page_of(folder) {
    const page = fs.readFileSync(folder + "/atlas.html", "utf8");
    const script = page.slice(page.indexOf("const atlas_theory ="), page.indexOf("const atlas_charts ="));
    const given = JSON.parse(page.match(/<script type="application\/json" id="atlas">([^]*?)<\/script>/)[1]);
    return {script, given, said: JSON.parse(fs.readFileSync(folder + "/prediction.json", "utf8")).models};
}
const maps_of = script => new Function(script.slice(0, script.lastIndexOf('"use strict"')) + "; return atlas_maps;")();

// Formulas and polynomials are the same: what differs is rounding and the width to which roots are found, over the
// slope there; the shift is steep in the load near the limit.
const tolerance = 1e-9;
const close = (a, b) => Math.abs(a - b) <= tolerance * Math.max(Math.abs(b), 1e-6);

// How many numbers agree; throws at the first that does not.
function compare(maps, {given, said}, is_deep = false) {
    const place = {equal_amplitude: "W", equal_load: "F_T", thickness_ratio: 1, ...given.case};
    const at = maps.read_atlases(given).at(place);
    let n = 0;
    for (const [model, body] of Object.entries(at)) {
        // At the same depth the half-space carries another force than the layer, which the page gives to both.
        if (!body || !said[model] || is_deep && model !== "bem-layer") continue;
        for (const key of ["static_shift_ratio", "settled_shift_ratio", "kappa", "shift_increment_ratio", "eta"]) {
            const ours = said[model][key], theirs = body[key];
            if ((ours === undefined) !== (theirs === undefined)) throw new Error(`${model} ${key}: ${ours} ${theirs?.value}`);
            if (ours === undefined) continue;
            if (!close(theirs.value, ours)) throw new Error(`${model} ${key}: ${theirs.value} ${ours}`);
            if (!close(theirs.error, said[model][key + "_error"] ?? 0))
                throw new Error(`${model} ${key}: errors ${theirs.error} ${said[model][key + "_error"]}`);
            ++n;
        }
        const by_key = {limit_tangential_ratio: body.limit, amplitude_ratio: body.w, tangential_ratio: body.f};
        for (const [key, {value} = {}] of Object.entries(by_key)) {
            const ours = said[model][key];
            if (ours === undefined || value === undefined) continue;
            if (!close(value, ours)) throw new Error(`${model} ${key}: ${value} ${ours}`);
            ++n;
        }
        if (!body.scale || !said.mdr || is_deep) continue;
        for (const key of ["contact_radius_m", "indentation_m", "peak_pressure_Pa", "unit_shift_m"]) {
            if (!close(body.scale[key].value, said[model][key] / said.mdr[key])) throw new Error(`${model}: ${key}`);
            ++n;
        }
    }
    return n;
}

// Points over the maps and a little beyond them.
function random_points(program, file, body, seed, n_points) {
    let state = Number(seed);
    const draw = (low, high) => {  // Park and Miller (1988)
        state = state * 48271 % 2147483647;
        return low + (high - low) * state / 2147483647;
    };
    let maps;
    const n_kept = {settled_shift_ratio: 0, shift_increment_ratio: 0};
    for (let i = 0; i < n_points; ++i) {
        const is_layer = body === "layer";
        const sets = ["rolling.amplitude_ratio=" + draw(0.005, is_layer ? 0.55 : 0.9), `rolling.angle=${draw(0, 90)} deg`,
                      "substrate.poisson=" + (is_layer && draw(0, 1) < 0.5 ? 0.5 : draw(is_layer ? 0.25 : 0, 0.5))];
        const load = draw(0, is_layer ? 4 : 3);
        if (load < 1.5) sets.push("load.limit_fraction=" + draw(0.01, 0.99));
        else if (load < 2) sets.push("load.tangential_ratio=" + draw(0.01, 0.99));
        else sets.push("load.limit_excess=" + draw(0.02, 0.9));
        if (is_layer)
            sets.push(`substrate.thickness=${4 * Math.exp(draw(0, 3))} mm`, "friction.coefficient=" + draw(0.45, 1.2),
                      "rolling.amplitude_reference=" + (draw(0, 1) < 0.5 ? "model" : "hertz"), "models=[\"bem-layer\"]");
        else sets.push("contact.coupling=false");
        const call = ["predict", file, ...sets.flatMap(set => ["--set", set]), "--output", "random"];
        const ran = spawnSync(program, call, {encoding: "utf8"});
        if (ran.status !== 0) throw new Error(`${call.join(" ")}: ${ran.stderr}`);
        const page = page_of("random");
        maps ??= maps_of(page.script);
        if (!page.given.case) continue;  // beyond the page's picture
        try {
            compare(maps, page);
        } catch (error) {
            throw new Error(`${call.join(" ")}: ${error.message}`);
        }
        for (const key in n_kept) n_kept[key] += key in (page.said[is_layer ? "bem-layer" : "bem"] ?? {});
    }
    console.log(n_kept);
    for (const [key, count] of Object.entries(n_kept))
        if (count < n_points / 10) throw new Error(`only ${count} of ${n_points} points have ${key}`);
}

const [, , kind, ...rest] = process.argv;
if (kind === "random") random_points(...rest);
else {
    const page = page_of(rest[0]);
    if (compare(maps_of(page.script), page, rest[0] === "deep") < 3) throw new Error("hardly a number is compared");
}
