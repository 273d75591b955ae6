"use strict";
// Shows what the atlases state at the marker: sentence, table and pictures. Numbers come from atlas_maps.js, pictures from atlas_charts.js.

(() => {
const given = JSON.parse(document.getElementById("atlas").textContent);
const maps = atlas_maps.read_atlases(given);
const part = id => document.getElementById(id);
const drawing = {map: {width: 720, height: 640}, curve: {width: 720, height: 420}};
const models = ["mdr", "bem", "bem-layer"];
const start = {w: 0.3, f: 0.3, angle: 0, poisson: 0.5, common_poisson: 0.5, is_layer: false, thickness_ratio: 1,
               friction: 0.5, equal_amplitude: "W", equal_load: "F_T"};
const home = {...start, ...given.case};
let place = {...home}, quantity = "settled", bodies = null;

// ---- Numbers as text ----

const minus = text => text.replace("-", "−");
const short = (value, digits = 4) => minus(String(Number(value.toPrecision(digits))));
const decimals_of = error => {
    const power = Math.floor(Math.log10(error));
    return error / 10 ** power < 3 ? 1 - power : -power;  // two digits of an error of 1 or 2
};
// [value, error] with the digits that the error leaves.
function rounded({value, error}) {
    if (!(error > 0)) return [minus(value.toPrecision(4)), ""];
    const decimals = Math.min(Math.max(decimals_of(error), 0), 5);
    return [minus(value.toFixed(decimals)), Math.max(error, 10 ** -decimals).toFixed(decimals)];
}
function with_error(number) {
    const [value, error] = rounded(number);
    return error ? `${value} ± ${error}` : value;
}
const percent = ({value, error}) => with_error({value: 100 * value, error: 100 * error}) + " %";

// ---- The table ----

const ratio_of = (body, above, below) =>
    body[above] && body[below] ? atlas_maps.ratio(body[above], body[below]) : undefined;
const scale_of = key => body => body.scale?.[key];
// Where the load is the limit within the error bar, its side is unknown.
const is_at_limit = body => ["shakedown", "ratcheting"].includes(body.state) &&
    Math.abs(body.f.value - body.limit.value) <= Math.hypot(body.f.error, body.limit.error) && body.limit.error > 0;
// The layer's limit is that of uncoupled contact, and coupling may lower it: what it does is known
// where a map of runs says so.
const is_known = (body, key) => !body.scale || Boolean(body[key]);
const settles = body => body?.state === "shakedown" && !is_at_limit(body) && is_known(body, "settled_shift_ratio");
const ratchets = body => body?.state === "ratcheting" && !is_at_limit(body) && is_known(body, "shift_increment_ratio");
function state_of(body) {
    if (is_at_limit(body)) return ["at its limit", ""];
    if (body.state === "shakedown") return settles(body) ? ["settles", "settles"] : ["below the limit", ""];
    if (body.state === "ratcheting") return ratchets(body) ? ["ratchets", "ratchets"] : ["above the limit", ""];
    return [{"at rest": "no rolling", none: "no contact"}[body.state] ?? "–", ""];
}

const rows = [
    {name: "amplitude <i>w</i>", of: body => body.w},
    {name: "load <i>f</i><sub>T</sub>", of: body => body.f},
    {name: "limit <i>f</i><sub>T,lim</sub>", of: body => body.is_at_rest ? undefined : body.limit},
    {name: "static shift <i>u</i><sub>stat</sub>", of: body => body.static_shift_ratio},
    {name: "settled shift <i>u</i><sub>sd</sub>", of: body => body.settled_shift_ratio},
    {name: "<i>U</i><sub>sd</sub>/<i>U</i><sub>stat</sub>",
     of: body => ratio_of(body, "settled_shift_ratio", "static_shift_ratio")},
    {name: "mapping κ", of: body => body.kappa},
    {name: "shift per period Δ<i>u</i>", of: body => body.shift_increment_ratio, needs: "ratcheting"},
    {name: "slope η", of: body => body.eta, needs: "ratcheting"},
    {group: "Against the half-space at the same force", layer: true},
    {name: "contact radius <i>a</i>/<i>a</i><sub>H</sub>", of: scale_of("contact_radius_m"), layer: true},
    {name: "indentation <i>d</i>/<i>d</i><sub>H</sub>", of: scale_of("indentation_m"), layer: true},
    {name: "peak pressure <i>p</i><sub>0</sub>/<i>p</i><sub>0,H</sub>", of: scale_of("peak_pressure_Pa"), layer: true},
    {name: "<i>U</i><sub>max</sub>/<i>U</i><sub>max,H</sub>", of: scale_of("unit_shift_m"), layer: true},
    {name: "<i>U</i><sub>sd</sub>/<i>U</i><sub>max,H</sub>",
     of: body => maps.common_shift(body, "settled_shift_ratio"), layer: true},
];

function element(name, text, more = {}) {
    const made = document.createElement(name);
    if (text) made.innerHTML = text;
    return Object.assign(made, more);
}

function cell_of(number) {
    if (!number || !Number.isFinite(number.value)) return element("td", "–", {className: "gap"});
    const [value, error] = rounded(number);
    return element("td", value + (error ? `<span class="error">± ${error}</span>` : ""));
}

function fill_table() {
    const shown = models.filter(model => bodies[model]), body = part("numbers").tBodies[0];
    for (const heading of part("numbers").tHead.rows[0].cells)
        heading.hidden = heading.className !== "" && !shown.includes(heading.className);
    const state = element("tr", "", {className: "state"});
    state.append(element("th", "state", {scope: "row"}));
    for (const model of shown) {
        const [word, kind] = state_of(bodies[model]);
        state.append(element("td", word, {className: kind}));
    }
    body.replaceChildren(state);
    const any_ratchets = shown.some(model => bodies[model].state === "ratcheting");
    for (const {name, of, group, layer, needs} of rows) {
        if (layer && !bodies["bem-layer"]?.scale || needs && !any_ratchets) continue;
        const row = body.insertRow();
        if (group) {
            row.append(element("th", group, {scope: "rowgroup", className: "group", colSpan: shown.length + 1}));
            continue;
        }
        row.append(element("th", name, {scope: "row"}));
        for (const model of shown) row.append(cell_of(of(bodies[model])));
    }
    part("gaps").textContent = shown.filter(model => bodies[model].gap)
        .map(model => `${atlas_charts.body_names[model]}: ${bodies[model].gap}.`).join(" ");
}

// ---- The sentence ----

const f_t = "<i>f</i><sub>T</sub>";

// Of MDR's settled shift against that of a body; "" where one of them has none.
function comparison(model, name) {
    const body = bodies[model], other = bodies.mdr;
    const [a, b] = [other, body].map(one => one && maps.common_shift(one, "settled_shift_ratio"));
    if (!a || !b || !settles(body) || !settles(other) || !(b.value > 0)) return "";
    const {value, error} = atlas_maps.ratio(a, b), off = value - 1;
    if (Math.abs(off) <= error)
        return `MDR agrees with the settled shift of the ${name} within the error bar of ${short(100 * error, 2)} %.`;
    return `MDR <b>${off > 0 ? "overstates" : "understates"}</b> the settled shift of the ${name} by ` +
        `<b>${percent({value: Math.abs(off), error})}</b>.`;
}

function ratcheting_words(model, name) {
    const body = bodies[model], increment = body.shift_increment_ratio;
    const excess = `${f_t} = ${short(body.f.value)} exceeds the limit ${short(body.limit.value)}`;
    return `The ${name} <b>ratchets</b>: ${excess}` +
        (increment ? `, and each period adds <b>${with_error(increment)}</b> <i>U</i><sub>max</sub>.` : ".");
}

function words() {
    const layer = bodies["bem-layer"], half_space = bodies.bem;
    if (half_space.state === "none") return "No sticking contact here.";
    if (half_space.is_at_rest) {
        const shift = (layer?.static_shift_ratio ? layer : half_space).static_shift_ratio ?? bodies.mdr.static_shift_ratio;
        return `Without rolling the shift stays the static one, <b>${with_error(shift)}</b> <i>U</i><sub>max</sub>.`;
    }
    const parts = [];
    if (ratchets(layer)) parts.push(ratcheting_words("bem-layer", "layer"));
    else if (ratchets(half_space)) parts.push(ratcheting_words("bem", "half-space"));
    if (ratchets(half_space) && settles(layer)) parts.push("The layer settles.");
    if (settles(half_space) && ratchets(layer)) parts.push("The half-space settles.");
    if (layer && is_at_limit(layer)) parts.push("The layer is at its limit of shakedown within the error bar.");
    else if (layer?.state === "ratcheting" && !ratchets(layer))
        parts.push(`On the layer ${f_t} = ${short(layer.f.value)} exceeds the limit of uncoupled contact, ` +
                   `${short(layer.limit.value)}.`);
    if (layer) parts.push(comparison("bem-layer", "layer"));
    if (!layer || !layer.settled_shift_ratio) parts.push(comparison("bem", "half-space"));
    const said = parts.filter(Boolean).join(" ");
    if (said) return said;
    const shift = bodies.mdr.settled_shift_ratio;
    if (!shift) return "No atlas covers this place.";
    return `MDR’s settled shift is ${short(shift.value)} <i>U</i><sub>max</sub>; ${half_space.gap || "no other model gives it here"}.`;
}

// ---- Pictures ----

// What the map needs but for colours and marker: sampled again where one of these differs.
let sampled = {key: "", shown: null};
const is_map_of_layer = () => place.is_layer && part("body").value === "bem-layer";
function shown_map() {
    const {w, f, ...rest} = place;
    const key = JSON.stringify([quantity, is_map_of_layer(), rest]);
    if (sampled.key !== key)
        sampled = {key, shown: atlas_charts.sample_map(maps, place, is_map_of_layer(), quantity)};
    return sampled.shown;
}
function other_limit() {
    if (!place.is_layer || place.equal_load === "share") return null;
    if (is_map_of_layer()) return atlas_maps.shakedown_limit;
    const scale = maps.pressed_layer(place);
    return scale.gap ? null : w => maps.layer_limit_line({...place, w}, scale);
}
const {draw, draw_all} = chart_page({
    map: theme => atlas_charts.draw_map(shown_map(), {quantity, is_layer: is_map_of_layer(), other_limit: other_limit(),
                                                      mark: given.case}, theme),
    curve: theme => atlas_charts.draw_curves(atlas_charts.sample_curves(maps, place), place, Object.fromEntries(
        models.map(model => [model, bodies[model] && maps.common_shift(bodies[model], "settled_shift_ratio")])), theme),
}, atlas_charts.height, drawing);

function csv_of() {
    const curves = atlas_charts.sample_curves(maps, place), lines = ["model,f_T,settled_shift,error"];
    for (const [model, {x, y, high}] of Object.entries(curves))
        x.forEach((f, i) => lines.push([model, ...[f, y[i], high[i] - y[i]].map(v => Number(v.toPrecision(6)))].join(",")));
    return lines.join("\n") + "\n";
}

// ---- The marker's place ----

const friction_axis = maps.readers.sphere_layer?.axis("friction.coefficient");
const sliders = [
    {key: "w", label: "<i>w</i>", name: "amplitude w", low: 0, high: 1, step: 0.005},
    {key: "f", label: "<i>f</i><sub>T</sub>", name: "load f_T", low: 0, high: 1, step: 0.005},
    {key: "angle", label: "angle [°]", name: "angle in degrees", low: 0, high: 90, step: 1,
     show: radian => Number(atlas_maps.degrees_of(radian).toFixed(9)), read: degrees => degrees * Math.PI / 180},
    {key: "poisson", label: "ν", name: "Poisson's ratio", low: 0, high: 0.5, step: 0.01},
    {key: "thickness_ratio", label: "<i>b</i>/<i>D</i><sub>c</sub>", name: "thickness of the layer over Hertz' contact diameter",
     low: 0.25, high: 40, step: 0.01, logarithmic: true, layer: true},
    {key: "friction", label: "μ", name: "coefficient of friction", low: 0.05, high: 1, step: 0.01, layer: true,
     is_missing: !friction_axis},
];

// Numbers are exact in their fields, where keys can be typed; sliders go in steps.
function add_slider(slider) {
    const {key, label, name, low, high, step, logarithmic, read = x => x} = slider;
    const id = "slider_" + key, to_slider = x => logarithmic ? Math.log(x) : x;
    slider.parts = [element("label", label, {htmlFor: id}),
                    element("input", "", {type: "range", id, min: to_slider(low), max: to_slider(high),
                                          step: logarithmic ? (Math.log(high) - Math.log(low)) / 200 : step}),
                    element("input", "", {type: "number", id: "value_" + key, min: low, max: high, step: "any"})];
    const [, range, field] = slider.parts;
    field.setAttribute("aria-label", name);
    range.setAttribute("aria-label", name);
    range.addEventListener("input", () => {
        const value = Number(range.value);
        change({[key]: read(logarithmic ? Number(Math.exp(value).toPrecision(3)) : value)});
    });
    field.addEventListener("change", () => {
        const value = Number(field.value);
        if (field.value !== "" && value >= low && value <= high) change({[key]: read(value)});
        else tell();
    });
    slider.tell = () => {
        const value = (slider.show ?? (x => x))(place[key]);
        range.value = to_slider(value);
        range.setAttribute("aria-valuetext", short(value));
        field.value = Number(value.toPrecision(7));
        for (const one of slider.parts) one.hidden = Boolean(slider.layer && !place.is_layer || slider.is_missing);
    };
    part("sliders").append(...slider.parts);
}

function add_layer_switch() {
    const row = element("div", '<input type="checkbox" id="is_layer"> <label for="is_layer">on a bonded layer</label>',
                        {className: "across"});
    const choices = element("div", "at equal <select id=\"equal_amplitude\" aria-label=\"Equal amplitude\">" +
        "<option value=\"W\">W (same rig)</option><option value=\"w\">w = W/a</option></select> and equal " +
        "<select id=\"equal_load\" aria-label=\"Equal load\"><option value=\"F_T\">F_T (same rig)</option>" +
        "<option value=\"share\">F_T/F_T,lim</option></select>", {className: "across", id: "equal"});
    part("sliders").append(row);
    for (const slider of sliders.filter(one => one.layer)) add_slider(slider);
    part("sliders").append(choices);
    row.hidden = !maps.has_layer;
    part("is_layer").addEventListener("change", event => {
        part("body").value = event.target.checked && maps.readers.sphere_layer ? "bem-layer" : "bem";
        change({is_layer: event.target.checked});
    });
    for (const key of ["equal_amplitude", "equal_load"])
        part(key).addEventListener("change", event => change({[key]: event.target.value}));
}

// Sentence, table, sliders: everything but the pictures.
function tell() {
    bodies = maps.at(place);
    for (const slider of sliders) slider.tell();
    part("is_layer").checked = place.is_layer;
    part("equal").hidden = part("choice_of_body").hidden = !place.is_layer;
    part("equal_amplitude").value = place.equal_amplitude;
    part("equal_load").value = place.equal_load;
    fill_table();
    const said = words(), plain = said.replace(/<[^>]*>/g, "");
    if (part("verdict").innerHTML !== said) part("verdict").innerHTML = said;
    const marker = part("map_marker");
    marker.setAttribute("aria-valuenow", short(place.f));
    marker.setAttribute("aria-valuetext", `w = ${short(place.w)}, f_T = ${short(place.f)}: ${plain}`);
    const other = is_map_of_layer() ? "the half-space" : "the layer";
    part("key_other").textContent = place.is_layer && place.equal_load === "F_T" ? `, dashed: that of ${other}` : "";
    const reader = maps.readers[(is_map_of_layer() ? "sphere_layer" : "sphere_half_space") + "_ratcheting"];
    part("key_hatched").textContent = reader ? "" : " (hatched)";
}

// Pictures follow once per frame, however fast the marker moves.
const frame = 16;  // ms
const waiting = new Set();
function redraw(...names) {
    if (!waiting.size)
        setTimeout(() => {
            const now = [...waiting];
            waiting.clear();
            for (const name of now) draw(name);
        }, frame);
    for (const name of names) waiting.add(name);
}
function change(what) {
    const there = {...place, ...what};
    if ("poisson" in what && !("common_poisson" in what)) there.common_poisson = what.poisson;
    if (JSON.stringify(there) === JSON.stringify(place)) return;
    const only_moves = Object.keys(what).every(key => key === "w" || key === "f");
    place = there;
    place_marker();
    tell();
    redraw("curve", ...(only_moves ? [] : ["map"]));
}

const inside = value => Math.min(Math.max(value, 0), 1);
const whole = value => Math.round(inside(value) * 1000) / 1000;
const place_marker = map_marker({
    margin: atlas_charts.margin.map, height: atlas_charts.height.map, far: 10,
    where: () => [place.w, place.f],
    go_to: ([w, f]) => change({w: whole(w), f: whole(f)}),
    step([right, up]) {
        const moved = (value, by) => by ? inside(Number((value + by * 0.005).toFixed(6))) : value;
        change({w: moved(place.w, right), f: moved(place.f, up)});
    },
});

function listen() {
    part("quantity").addEventListener("change", event => {
        quantity = event.target.value;
        redraw("map");
    });
    part("body").addEventListener("change", () => {
        tell();
        redraw("map");
    });
    part("to_case").addEventListener("click", () => change(home));
    // Made when it is asked for: as the marker moves, it would be made each time for nothing.
    const prepare = () => { part("data_curve").href = "data:text/csv;charset=utf-8," + encodeURIComponent(csv_of()); };
    for (const event of ["pointerenter", "focus", "click"]) part("data_curve").addEventListener(event, prepare);
}

for (const [key, {name}] of Object.entries(atlas_charts.quantities))
    part("quantity").append(element("option", name, {value: key, selected: key === quantity}));
for (const slider of sliders.filter(one => !one.layer)) add_slider(slider);
add_layer_switch();
part("to_case").hidden = part("key_case").hidden = !given.case;
part("body").value = place.is_layer && maps.readers.sphere_layer ? "bem-layer" : "bem";
tell();
draw_all(charts.screen());
place_marker();
listen();
})();
