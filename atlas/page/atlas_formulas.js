"use strict";
// Closed forms of MDR, and the formulas that maps of the page are multiples of. The numbers are those of
// `tricontact predict`.

const atlas_formulas = (() => {

// ---- Closed forms: theory/rolling/oscillating_rolling.h, theory/cattaneo_mindlin.h ----

// 1 - (1 - u)^(3/2) without cancellation at small u.
const static_force = u => u < 1 ? -Math.expm1(1.5 * Math.log1p(-u)) : 1;

// u_stat of Cattaneo and Mindlin: 1 - (1 - f)^(2/3).
const static_shift = f => f < 1 ? -Math.expm1(2 / 3 * Math.log1p(-f)) : 1;

// f_T,lim of Hertz' pressure: 1 - 3/2 w + 1/2 w^3, its factor (1 - w)^2 taken out.
const shakedown_limit = w => (1 - w) * (1 - w) * (1 + w / 2);

// w_lim of that, by bisection: it falls all the way from 1 to 0.
function amplitude_limit(f) {
    let low = 0, high = 1;
    for (let i = 0; i < 60; ++i) {
        const middle = (low + high) / 2;
        if (shakedown_limit(middle) > f) low = middle;
        else high = middle;
    }
    return (low + high) / 2;
}

// u_sd of f = 1 - kappa w u_sd - (1 - u_sd)^(3/2), kappa = 3/2 for MDR; NaN beyond the limit. The left
// side is concave in u: Newton's steps from 0 stay below the root.
function settled_shift(w, f, kappa = 1.5) {
    if (f > shakedown_limit(w)) return NaN;
    const lowest = kappa / 1.5 * w, highest = (1 - lowest) * (1 + lowest);
    let u = 0;
    for (let i = 0; i < 100; ++i) {
        const step = (f - static_force(u) + kappa * w * u) / (1.5 * Math.sqrt(1 - u) - kappa * w);
        if (!(step > 0)) break;
        u = Math.min(u + step, highest);
        if (u === highest || step < 1e-16 * u) break;
    }
    return u;
}

// ---- Formulas that maps are multiples of: atlas/baseline.h, theory/rolling/mapped_shakedown.h ----

// A point of the formulas: {w, f, limit, fraction, angle, poisson, thickness_ratio, friction}.
const largest_amplitude = .85, least_thickness = .25, least_friction = .4;

// kappa of the mapped formula.
function half_space_mapping({w, f, angle, poisson}) {
    const orientation = poisson / (2 - poisson) * Math.cos(2 * angle);
    const own = Math.min(w, largest_amplitude);
    const unloaded = 1 - Math.min(1, f / shakedown_limit(own)) * (1 - .06 * own);
    const deficit = 1.5 - 3 / Math.PI * (1 - orientation / 3);
    return 1.5 - deficit * Math.pow(1 - own, .42) * Math.pow(unloaded, .19 + .05 * own);
}
const mapped_shift = p => settled_shift(p.w, p.f, half_space_mapping(p));

// theory/layer/layer_forms.h: constants at the point's thickness and Poisson's ratio.
function layer_constants({thickness_ratio, poisson}) {
    const chi = 1 / (2 * Math.max(thickness_ratio, least_thickness));
    const s = Math.pow(poisson / (1 - poisson), 1.4), fourth = Math.pow(chi, 4);
    const tangential_lift = .325 - .1 * poisson + .07 * poisson * poisson;
    return {lift: tangential_lift * chi / (1 + chi / 2),
            shape: (.083 + .058 * s) * fourth * chi / (1 + 1.1 * fourth)};
}
// K = C13/(C11 mu) of a bonded layer at the wave number 2/a_H, x = k b: layer_compliance.cc.
function layer_coupling({thickness_ratio, poisson, friction}) {
    const x = 4 * Math.max(thickness_ratio, least_thickness), kappa = 3 - 4 * poisson, excess = 2 * (1 - 2 * poisson);
    const mu = Math.max(friction, least_friction);
    if (x > 40) return excess / 4 / ((1 - poisson) * mu);
    const y = 2 * x;
    const coupling = kappa * excess * (Math.cosh(y) - 1 - y * y / 2) + 2 * (1 - 4 * poisson) * (kappa + 1) * x * x;
    return coupling / 2 / ((1 - poisson) * (2 * kappa * Math.sinh(y) + 4 * x) * mu);
}
// The layer's formulas at its own load: u_stat and u_sd.
function lifted(p) {
    const {lift, shape} = layer_constants(p), w = Math.min(p.w, largest_amplitude);
    const limit = shakedown_limit(w) - .375 * shape * w * Math.pow((1 - w) * (1 + w), 2 + shape);
    const f = p.load_at(limit), coupling = layer_coupling(p);
    const lift_of = u => (u - lift * f) / (1 - lift);
    const settled = f > limit ? NaN : lift_of(mapped_shift({...p, w, f})) * (1 + coupling * coupling * w);
    return {at_rest: lift_of(static_shift(f)), settled};
}

// eta of theory/rolling/mapped_ratcheting.h; NaN below the limit.
function ratcheting_slope({w, f, angle, poisson}) {
    const own = Math.min(w, largest_amplitude), w_lim = amplitude_limit(f);
    if (!(own > w_lim)) return NaN;
    const o = poisson / (2 - poisson) * Math.cos(2 * angle);
    return 4 * (1 - Math.cbrt(1 - f)) * (1 - o / 2 - o * o / 8) /
        (0.98 - 0.964 * w_lim + 1.4 * Math.exp(-8.8 * own) * (w_lim / own) ** 2);
}

const closed_forms = {
    "": () => 1,
    "u_stat of Cattaneo and Mindlin": p => static_shift(p.f),
    "u_sd of the mapped formula": p => p.f < p.limit ? mapped_shift(p) : NaN,
    "kappa of the mapped formula": p => p.f < p.limit ? half_space_mapping(p) : NaN,
    "u_stat of a lifted contact": p => lifted(p).at_rest,
    "u_sd of a lifted contact": p => lifted(p).settled,
    "1/w": p => 1 / p.w,
    "f_T,lim of Hertz' pressure": p => p.limit,
    "Delta u of the formula": p => ratcheting_slope(p) * (p.w - amplitude_limit(p.f)),
    "eta of the formula": p => ratcheting_slope(p),
    "w - w_lim": p => p.f < p.limit ? NaN : p.w - amplitude_limit(p.f),
};

return {closed_forms, static_shift, shakedown_limit, amplitude_limit, settled_shift};
})();
