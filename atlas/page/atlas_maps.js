"use strict";
// The atlases of the page at one place: the maps with their error bars, and what they state for a half-space and a layer
// side by side. There is no formula of mechanics here: those of `atlas_theory` are the program's, translated when it is
// built (cmake/page_formulas.cmake). It draws nothing and does not touch the page: tests/cli/atlas/predict_page.sh compares it
// with `tricontact predict`.

const atlas_maps = (() => {

// A root between low and high, where the values differ in sign: regula falsi, Illinois' variant (Dowell and Jarratt 1971).
function bracketed_root(value, low, high) {
    let at_low = value(low), at_high = value(high), root = low;
    if (at_low === 0) return low;
    if (at_high === 0) return high;
    for (let i = 0; i < 200; ++i) {
        const before = root;
        root = (low * at_high - high * at_low) / (at_high - at_low);
        const at = value(root);
        if (at === 0 || Math.abs(root - before) <= 1e-15 * Math.abs(root)) break;
        if (at > 0 !== at_high > 0) [low, at_low] = [high, at_high];
        else at_low /= 2;
        [high, at_high] = [root, at];
    }
    return root;
}
const theory = atlas_theory(bracketed_root);

// ---- What maps are multiples of: atlas/baseline.cc ----

// Their ranges: beyond, the value at the end.
const mapped = p => ({amplitude_ratio: Math.min(p.w, theory.largest_amplitude), tangential_ratio: p.f, angle: p.angle,
                      poisson: p.poisson});
const layer_of = p => ({thickness_ratio: Math.max(p.thickness_ratio, theory.least_thickness), poisson: p.poisson});
// The load by the layer's own limit.
const with_layer_load = p => ({...p, f: p.load_at(theory.layer_shakedown_limit(layer_of(p), mapped(p).amplitude_ratio))});
const is_beyond = p => p.f > p.limit;

// By the names in the files of the atlases; NaN where undefined. A point: see Reader.point.
const closed_forms = {
    "": () => 1,
    "u_stat of Cattaneo and Mindlin": p => theory.static_shift_ratio(p.f),
    "u_sd of the mapped formula": p =>
        p.f < p.limit ? theory.settled_shift_ratio(p.w, p.f, theory.half_space_mapping(mapped(p))) : NaN,
    "kappa of the mapped formula": p => p.f < p.limit ? theory.half_space_mapping(mapped(p)) : NaN,
    "u_stat of a lifted contact": p => theory.layer_static_shift_ratio(layer_of(p), with_layer_load(p).f),
    "u_sd of a lifted contact": p => theory.layer_settled_shift_ratio(
        layer_of(p), mapped(with_layer_load(p)), Math.max(p.friction, theory.least_friction)),
    "1/w": p => 1 / p.w,
    "f_T,lim of Hertz' pressure": p => p.limit,
    "Delta u of the formula": p => is_beyond(p) ? theory.half_space_shift_increment_ratio(mapped(p)) : NaN,
    "eta of the formula": p => is_beyond(p) ? theory.half_space_ratcheting_slope(mapped(p)) : NaN,
    "w - w_lim": p => is_beyond(p) ? p.w - theory.amplitude_limit(p.f) : NaN,
};

// ---- Maps: atlas/atlas.h ----

const by_ratio = "load.tangential_ratio", by_fraction = "load.limit_fraction", by_excess = "load.limit_excess";

// Of a value in [from, to], in [0, 1]: io::Study::Range.
function fraction_of({from, to, scale}, value) {
    const share = (value - from) / (to - from);
    switch (scale) {
    case "log": return Math.log(value / from) / Math.log(to / from);
    case "cosine": return (1 - Math.cos(Math.PI * share)) / 2;
    case "root-from": return Math.sqrt(share);
    case "root-to": return 1 - Math.sqrt(1 - share);
    default: return share;
    }
}

// Where the maps say something: the range, but for ends at which quantities were undefined.
const ends_of = axis => [axis.said_from ?? axis.from, axis.said_to ?? axis.to];
function is_inside(axis, value) {
    const tolerance = 1e-9 * (axis.to - axis.from), [from, to] = ends_of(axis);
    return value >= from - tolerance && value <= to + tolerance;
}

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const unit_of = (axis, value) => clamp(2 * fraction_of(axis, clamp(value, axis.from, axis.to)) - 1, -1, 1);

// T_0 ... T_largest at x.
function chebyshev(x, largest) {
    const row = [1, x];
    for (let k = 2; k <= largest; ++k) row.push(2 * x * row[k - 1] - row[k - 2]);
    return row;
}

// A polynomial of n variables where all but the first n_head stand still: one of those.
function slice(polynomial, n, n_head, tail) {
    const {degrees, coefficients} = polynomial;
    const largest = Math.max(1, ...degrees);
    const rows = tail.map(x => chebyshev(x, largest));
    const sums = new Map();
    for (let t = 0; t < coefficients.length; ++t) {
        let product = coefficients[t], key = 0;
        for (let d = 0; d < n_head; ++d) key = key * 256 + degrees[t * n + d];
        for (let d = n_head; d < n; ++d) product *= rows[d - n_head][degrees[t * n + d]];
        sums.set(key, (sums.get(key) ?? 0) + product);
    }
    const terms = [...sums].map(([key, coefficient]) => n_head === 2 ? [key >> 8, key & 255, coefficient]
                                                                     : [key, 0, coefficient]);
    return {terms, largest: [0, 1].map(d => Math.max(1, ...terms.map(term => term[d])))};
}

function sum_of({terms}, [first, second]) {
    let sum = 0;
    for (const [i, j, coefficient] of terms) sum += coefficient * first[i] * second[j];
    return sum;
}

const names = {
    "rolling.amplitude_ratio": "w", [by_ratio]: "f_T", [by_fraction]: "f_T/f_T,lim",
    [by_excess]: "(f_T − f_T,lim)/(1 − f_T,lim)", "rolling.angle": "the angle",
    "substrate.poisson": "ν", "substrate.thickness_ratio": "b/D_c", "friction.coefficient": "μ",
};
const degrees_of = radian => radian * 180 / Math.PI;

// "outside the atlas: w from 0.02 to 0.85"
function outside(axis) {
    const is_angle = axis.key === "rolling.angle";
    const [from, to] = ends_of(axis).map(end => Number((is_angle ? degrees_of(end) : end).toPrecision(4)));
    return `outside the atlas: ${names[axis.key] ?? axis.key} from ${from} to ${to}${is_angle ? "°" : ""}`;
}

// Reads the maps of one atlas. Axes of amplitude and load, which stand first, are those that a
// picture goes over: for the others the polynomials are added up once.
class Reader {
    constructor(atlas) {
        this.axes = atlas.axes;
        this.largest_error = atlas.largest_error ?? 1;
        this.safety_factor = atlas.safety_factor ?? 1;
        this.maps = new Map(atlas.maps.map(map => [map.quantity, map]));
        for (const map of atlas.maps)
            if (!(map.over in closed_forms)) throw new Error(`${map.quantity}: no closed form "${map.over}"`);
        const is_head = ({key}) => key === "rolling.amplitude_ratio" || key.startsWith("load.");
        this.n_head = this.axes.slice(0, 2).filter(is_head).length;
        this.load = this.axes.find(({key}) => key.startsWith("load."))?.key;
        this.kept = atlas.kept ?? {};
    }
    has(quantity) { return this.maps.has(quantity); }
    axis(key) { return this.axes.find(axis => axis.key === key); }
    // The axis that the point leaves; undefined inside.
    outside(coordinates) { return this.axes.find((axis, d) => !is_inside(axis, coordinates[d])); }

    slices(map, unit) {
        const tail = unit.slice(this.n_head), key = tail.join();
        if (map.sliced_at !== key) {
            map.sliced_at = key;
            map.slices = ["polynomial", "log_error", "correction"]
                .map(part => slice(map[part], this.axes.length, this.n_head, tail));
        }
        return map.slices;
    }
    // The point of closed forms that a place in the atlas has; load_at: f at another limit.
    point(coordinates) {
        const value = Object.fromEntries(this.axes.map(({key}, d) => [key, coordinates[d]]));
        const w = value["rolling.amplitude_ratio"] ?? 0, limit = theory.shakedown_limit(w), load = value[this.load];
        const load_at = at => this.load === by_fraction ? load * at
            : this.load === by_excess ? at + load * (1 - at) : this.load === by_ratio ? load : NaN;
        return {w, limit, load_at, f: load_at(limit), angle: value["rolling.angle"] ?? 0,
                poisson: value["substrate.poisson"] ?? this.kept["substrate.poisson"],
                thickness_ratio: value["substrate.thickness_ratio"], friction: value["friction.coefficient"] ?? this.kept["friction.coefficient"]};
    }
    // {value, error}, the half width of its bar of 95 %; of a point that is taken into the domain.
    read(quantity, coordinates) {
        const map = this.maps.get(quantity);
        const unit = this.axes.map((axis, d) => unit_of(axis, coordinates[d]));
        const slices = this.slices(map, unit);
        const largest = d => Math.max(...slices.map(part => part.largest[d]));
        const rows = [chebyshev(unit[0], largest(0)),
                      this.n_head === 2 ? chebyshev(unit[1], largest(1)) : [1]];
        const [fitted, log_error, correction] = slices.map(part => sum_of(part, rows));
        const form = closed_forms[map.over](this.point(coordinates));
        const factor = Number.isFinite(form) ? form : 1;
        const error = Math.hypot(map.error_factor * Math.exp(log_error), this.safety_factor * correction);
        const quotient = fitted + correction;
        if (!map.logarithmic) return this.said({value: factor * quotient, error: Math.abs(factor) * error});
        const value = factor * Math.exp(quotient);
        return this.said({value, error: Math.abs(value) * Math.expm1(error)});
    }
    // NaN with its bar where that is too long for a value.
    said({value, error}) {
        return {value: error > this.largest_error * Math.abs(value) ? NaN : value, error};
    }
    // With what errors of the first coordinates add to the bar.
    read_with_errors(quantity, coordinates, errors) {
        const result = this.read(quantity, coordinates);
        errors.forEach((error, d) => {
            if (!(error > 0)) return;
            const axis = this.axes[d], there = [...coordinates];
            there[d] += coordinates[d] < (axis.from + axis.to) / 2 ? error : -error;
            result.error = Math.hypot(result.error, this.read(quantity, there).value - result.value);
        });
        return result;
    }
}

// ---- Bodies side by side: atlas/prediction.cc ----

const exact = value => ({value, error: 0});
const ratio = (a, b) => {
    const value = a.value / b.value;
    return {value, error: Math.hypot(a.error, value * b.error) / Math.abs(b.value)};
};
const product = (a, b) => ({value: a.value * b.value, error: Math.hypot(a.error * b.value, b.error * a.value)});

const scales = ["indentation_m", "contact_radius_m", "peak_pressure_Pa", "unit_shift_m"];
const results = ["static_shift_ratio", "settled_shift_ratio", "kappa", "shift_increment_ratio", "eta"];
const symbols = {static_shift_ratio: "u_stat", settled_shift_ratio: "u_sd", kappa: "κ", shift_increment_ratio: "Δu", eta: "η"};

// `given`: {atlases: {name: atlas}, shape_error}, the latter what an exact sphere adds to the bars of
// a paraboloid, as a share.
//
// A place: {w: W/a and f: F_T/(mu F_N) of the half-space, angle [rad], poisson, common_poisson (both
// bodies together, of the half-space), is_layer, thickness_ratio: b over Hertz' diameter of contact,
// friction, equal_amplitude: "W" or "w", equal_load: "F_T" or "share" (of each body's own limit)}.
// w = 0: no rolling.
function read_atlases(given) {
    const readers = Object.fromEntries(Object.entries(given.atlases).map(([name, atlas]) => [name, new Reader(atlas)]));
    const shape_error = given.shape_error ?? 0;
    const with_shape = ({value, error}) => ({value, error: Math.hypot(error, shape_error * value)});
    const pressed = readers.sphere_layer_pressed;
    const has_layer = Boolean(pressed);
    const limits = new Map();  // of the layer, as found before: a picture asks for each many times

    // Scales of the layer over those of the half-space at the same force; {gap} outside.
    function pressed_layer(place) {
        const rest = [place.thickness_ratio, place.poisson], least = pressed.axes[0].from;
        const axis = pressed.outside([least, ...rest]);
        if (axis) return {gap: outside(axis)};
        return Object.fromEntries(scales.map(key => [key, with_shape(pressed.read(key, [least, ...rest]))]));
    }
    // f_T,lim of the layer at its own amplitude; below the atlas it falls from 1 in proportion.
    function layer_limit(place, w) {
        const key = [w.value, w.error, place.thickness_ratio, place.poisson].join();
        if (limits.size > 500) limits.clear();
        if (!limits.has(key)) limits.set(key, find_layer_limit(place, w));
        return limits.get(key);
    }
    function find_layer_limit(place, w) {
        const key = "limit_tangential_ratio", least = pressed.axes[0].from;
        const at = (value, errors) => pressed.read_with_errors(
            key, [value, place.thickness_ratio, place.poisson], errors);
        if (w.value < least) {
            const there = at(least, []), share = w.value / least;
            return {value: 1 + share * (there.value - 1), error: share * there.error};
        }
        return is_inside(pressed.axes[0], w.value) ? at(w.value, [w.error]) : exact(NaN);
    }
    // A load as its share of the limit: below it a quotient, beyond it the share of the way to 1.
    const by_limit = (f, from, to) => f <= from ? f / from * to : to + (f - from) / (1 - from) * (1 - to);

    // Coordinates by their keys, but amplitude and load.
    const rest_of = (place, is_layer) => is_layer
        ? {"rolling.angle": place.angle, "substrate.thickness_ratio": place.thickness_ratio,
           "substrate.poisson": place.poisson, "friction.coefficient": place.friction}
        : {"rolling.angle": place.angle, "substrate.poisson": place.common_poisson};
    // Of an atlas, the first of them given; {gap} outside.
    function coordinates_in(reader, first, rest) {
        for (const [key, kept] of Object.entries(reader.kept))
            if (key in rest && Math.abs(rest[key] - kept) > 1e-9)
                return {gap: `outside the atlas: it is about ${names[key]} = ${kept}`};
        const coordinates = [...first, ...reader.axes.slice(first.length).map(({key}) => rest[key])];
        const axis = reader.outside(coordinates);
        return axis ? {gap: outside(axis)} : {coordinates};
    }
    // What an atlas says of the body; false where it does not reach it.
    function read_into(body, name, first, errors, rest, keys) {
        const reader = readers[name];
        if (!reader) {
            body.gap ||= name.endsWith("_ratcheting") ? "no atlas of its ratcheting" : `no atlas ${name}`;
            return;
        }
        const {gap, coordinates} = coordinates_in(reader, first, rest);
        if (gap) {
            body.gap ||= gap;
            return;
        }
        for (const key of keys) {
            if (!reader.has(key)) continue;
            const found = reader.read_with_errors(key, coordinates, errors);
            if (Number.isFinite(found.value)) body[key] = with_shape(found);
            else body.unsure.push(key);
        }
        if (body.unsure.length)
            body.gap ||= `without ${body.unsure.map(key => symbols[key]).join(", ")}, whose bar is longer than ` +
                `${Number((100 * reader.largest_error).toPrecision(3))} % of the value`;
    }
    // What the maps say where a body has amplitude, load, limit and other coordinates.
    function add_maps(body, name, rest, limit_at, keys) {
        const ratchets = body.state === "ratcheting";
        body.atlas = ratchets ? name + "_ratcheting" : body.is_at_rest ? name + "_static" : name;
        read_into(body, name + "_static", [body.f.value], [body.f.error], rest, keys);
        if (body.is_at_rest) return;
        const limit = limit_at(body.w.value), way = 1 - limit.value;
        const load = ratchets ? {value: (body.f.value - limit.value) / way,
                                 error: Math.hypot(body.f.error, limit.error) / way}
                              : ratio(body.f, limit);
        read_into(body, body.atlas, [body.w.value, load.value], [body.w.error, load.error], rest, keys);
    }
    function begin(w, f, limit) {
        const body = {w, f, limit, is_at_rest: w.value === 0, gap: "", unsure: []};
        if (!(f.value >= 0 && f.value <= 1 && w.value >= 0 && w.value <= 1)) body.state = "none";
        else if (body.is_at_rest) body.state = "at rest";
        else if (Number.isNaN(limit.value)) body.state = "unknown";
        else body.state = f.value > limit.value ? "ratcheting" : "shakedown";
        return body;
    }

    function springs(place) {
        const body = begin(exact(place.w), exact(place.f), exact(theory.shakedown_limit(place.w)));
        if (body.state === "none") return body;
        body.static_shift_ratio = exact(theory.static_shift_ratio(place.f));
        if (body.state === "shakedown") {
            body.settled_shift_ratio = exact(theory.settled_shift_ratio(place.w, place.f));
            body.kappa = exact(theory.mdr_mapping);
        } else if (body.state === "ratcheting") {
            const excess = (place.f - body.limit.value) / (1 - body.limit.value);
            read_into(body, "sphere_springs_ratcheting", [place.w, excess], [], {}, results);
        }
        return body;
    }
    // `keys`: of the results that are wanted.
    function half_space(place, keys = results) {
        const body = begin(exact(place.w), exact(place.f), exact(theory.shakedown_limit(place.w)));
        if (body.state !== "none")
            add_maps(body, "sphere_half_space", rest_of(place, false),
                     w => exact(theory.shakedown_limit(w)), keys);
        return body;
    }
    // Where the layer is, without its shifts. `scale`: of pressed_layer, which a picture asks once.
    function layer_place(place, scale) {
        const w = place.equal_amplitude === "W" ? ratio(exact(place.w), scale.contact_radius_m) : exact(place.w);
        const limit = place.w === 0 ? exact(1) : layer_limit(place, w);
        if (place.equal_load !== "share") return begin(w, exact(place.f), limit);
        const f = by_limit(place.f, theory.shakedown_limit(place.w), limit.value);
        const above = by_limit(place.f, theory.shakedown_limit(place.w), limit.value + limit.error);
        return begin(w, {value: f, error: Math.abs(above - f)}, limit);
    }
    function layer(place, scale = pressed_layer(place), keys = results) {
        if (scale.gap) return {state: "unknown", gap: scale.gap, scale: null};
        const body = layer_place(place, scale);
        body.scale = scale;
        if (body.state === "unknown") body.gap = outside(pressed.axes[0]);
        if (body.state === "none" || body.state === "unknown") return body;
        add_maps(body, "sphere_layer", rest_of(place, true),
                 w => layer_limit(place, exact(w)), keys);
        return body;
    }
    // Shift of the body over U_max of the half-space; undefined where it has none.
    function common_shift(body, key) {
        if (!body?.[key]) return undefined;
        return body.scale ? product(body[key], body.scale.unit_shift_m) : body[key];
    }
    // f_T of the half-space at which the layer is at its limit, at this w.
    function layer_limit_line(place, scale) {
        if (place.equal_load === "share") return theory.shakedown_limit(place.w);
        return layer_place({...place, f: 0}, scale).limit.value;
    }

    // Where a picture over w and f_T of the half-space has values: of the atlas with this ending, the
    // amplitudes from .. to and the loads low .. high, shares of the limit or of the way from it to 1.
    // {gap} where its other coordinates lie outside, null if there is no such atlas.
    function domain(place, is_layer, ending, scale) {
        const reader = readers[(is_layer ? "sphere_layer" : "sphere_half_space") + ending];
        if (!reader) return null;
        const [[from, to], [low, high]] = reader.axes.map(ends_of);
        const {gap} = coordinates_in(reader, [from, low], rest_of(place, is_layer));
        if (gap) return {gap};
        const size = is_layer && place.equal_amplitude === "W" ? scale.contact_radius_m.value : 1;
        const most = is_layer ? Math.min(to, pressed.axes[0].to) : to;
        return {from: from * size, to: most * size, low, high};
    }

    return {
        readers, has_layer, domain, springs, half_space, layer, pressed_layer, layer_limit_line, common_shift,
        at: place => ({mdr: springs(place), bem: half_space(place),
                       "bem-layer": place.is_layer && has_layer ? layer(place) : null}),
    };
}

return {read_atlases, shakedown_limit: w => theory.shakedown_limit(w), ratio, degrees_of};
})();
