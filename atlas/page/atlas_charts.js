"use strict";
// The pictures of the page: a map over amplitude and load, and the shift over the load.

const atlas_charts = (() => {

const n_cells = 90, n_line = 161;
const margin = {map: {l: 54, r: 14, t: 78, b: 48}, curve: {l: 58, r: 14, t: 58, b: 46}};
const height = {map: 500, curve: 330};
// Light where little happens, away from the colours of the settled side.
const warm = ["#fff1dc", "#fdcc8f", "#f59a5b", "#d9603b", "#9e2f3f", "#5d1a45"]
    .map((colour, i, all) => [i / (all.length - 1), colour]);
const ends = (from, to, n) => Array.from({length: n}, (_, i) => from + (to - from) * i / (n - 1));

// Colours of the bodies: the page's, or those for paper.
function colours(theme) {
    const style = theme === charts.paper ? null : getComputedStyle(document.documentElement);
    const colour = (name, on_paper) => style?.getPropertyValue("--" + name).trim() || on_paper;
    return {mdr: colour("mdr", "#b84a00"), bem: colour("half-space", "#1a5fb4"), "bem-layer": colour("layer", "#008048")};
}

// What the ground of the map may show. `of`: of a body and MDR at the same place; `keys`: of the
// maps that this needs.
const quantities = {
    kappa: {name: "mapping parameter κ", title: "κ", keys: ["kappa"], of: body => body.kappa?.value},
    settled: {name: "settled shift u_sd = U_sd/U_max", title: "<i>u</i><sub>sd</sub>",
              keys: ["settled_shift_ratio"], of: body => body.settled_shift_ratio?.value},
    growth: {name: "settled over static shift, U_sd/U_stat", title: "<i>U</i><sub>sd</sub>/<i>U</i><sub>stat</sub>",
             keys: ["settled_shift_ratio", "static_shift_ratio"],
             of: body => body.settled_shift_ratio?.value / body.static_shift_ratio?.value},
    mdr: {name: "error of MDR, U_MDR/U_sd − 1", title: "<i>U</i><sub>MDR</sub>/<i>U</i><sub>sd</sub> − 1 [%]",
          keys: ["settled_shift_ratio"],
          of: (body, mdr, maps) => 100 * (mdr.settled_shift_ratio?.value /
                                          maps.common_shift(body, "settled_shift_ratio")?.value - 1)},
};

// Low and high of the numbers but for the outermost of a hundred.
function range_of(rows) {
    const sorted = rows.flat().filter(Number.isFinite).sort((a, b) => a - b);
    if (!sorted.length) return null;
    const at = share => sorted[Math.round(share * (sorted.length - 1))];
    const [low, high] = [at(0.01), at(0.99)];
    return high > low ? [low, high] : [low - 0.5, low + 0.5];
}

// Everything that the map of a place shows; kept apart from its colours.
function sample_map(maps, place, is_layer, quantity) {
    const scale = is_layer ? maps.pressed_layer(place) : null;
    if (scale?.gap) return {gap: scale.gap};
    const limit_at = w => is_layer ? maps.layer_limit_line({...place, w}, scale) : atlas_maps.shakedown_limit(w);
    const settled = maps.domain(place, is_layer, "", scale);
    const ratcheting = maps.domain(place, is_layer, "_ratcheting", scale);
    const cells = ends(0, 1, n_cells), step = 1.5 / (n_cells - 1);
    const body_at = (w, f, keys) => is_layer ? maps.layer({...place, w, f}, scale, keys)
                                             : maps.half_space({...place, w, f}, keys);
    // Values reach a cell beyond the domain, where they are those of its edge: the picture cuts there.
    // That of ratcheting lies on top and stays on its side of the limit.
    function rows_of(domain, edges, keys, value, is_beyond) {
        const rows = cells.map(() => cells.map(() => null));
        if (!domain || domain.gap) return rows;
        cells.forEach((at_w, column) => {
            const w = Math.min(Math.max(at_w, domain.from), domain.to);
            if (Math.abs(w - at_w) > step) return;
            const [low, high] = edges(domain, limit_at(w)), least = is_beyond ? limit_at(at_w) : 0;
            cells.forEach((at_f, row) => {
                const f = Math.min(Math.max(at_f, low + 1e-9), high - 1e-9);
                // The limit is steep at small amplitudes: look a few cells beyond.
                if (at_f < least || Math.abs(f - at_f) > 3 * step || high - low < 3e-9) return;
                const found = value(body_at(w, f, keys), maps.springs({...place, w, f}), maps);
                rows[row][column] = Number.isFinite(found) ? found : null;
            });
        });
        return rows;
    }
    const {keys, of} = quantities[quantity];
    const settled_edges = ({low, high}, limit) => [low * limit, high * limit];
    const ratcheting_edges = ({low, high}, limit) => [limit + low * (1 - limit), limit + high * (1 - limit)];
    return {
        cells, settled, ratcheting, limit_at, settled_edges, ratcheting_edges,
        rows: rows_of(settled, settled_edges, keys, of),
        increments: rows_of(ratcheting, ratcheting_edges, ["shift_increment_ratio"],
                            body => body.shift_increment_ratio?.value, true),
        gap: settled?.gap ?? (settled ? "" : "no atlas of its shakedown"),
    };
}

// ---- The map ----

function colour_bar(title, theme, x, len) {
    return {orientation: "h", x, xanchor: "left", y: 1.015, yanchor: "bottom", len, thickness: 11, outlinewidth: 0,
            title: {text: title, side: "top", font: {size: 13}}, tickfont: {color: theme.text, size: 11}, nticks: 5,
            ticks: "outside", ticklen: 3};
}

function area(x, y, more) {
    return {type: "scatter", mode: "lines", x, y, fill: "toself", line: {width: 0}, hoverinfo: "skip",
            showlegend: false, ...more};
}

// Between two lines over w, from one amplitude to another.
function band(from, to, lower, upper, more) {
    const w = ends(from, to, n_line);
    return area([...w, ...[...w].reverse()], [...w.map(lower), ...w.map(upper).reverse()], more);
}

// What lies outside a domain is covered: below, above, left and right of it, on its side of the limit.
function covers(domain, edges, limit_at, is_beyond, more) {
    if (!domain || domain.gap) return [];
    const bottom = w => is_beyond ? limit_at(w) : 0, top = w => is_beyond ? 1 : limit_at(w);
    const {from, to} = domain, parts = [];
    if (from > 0) parts.push(band(0, from, bottom, top, more));
    if (to < 1) parts.push(band(to, 1, bottom, top, more));
    // They overlap a little, lest a line of the ground shines through between them.
    const [first, last] = [Math.max(from - 0.005, 0), Math.min(to + 0.005, 1)];
    // Cells that the limit cuts are left out beyond it.
    const cut = is_beyond ? 2.5 / n_cells : 0;
    parts.push(band(first, last, bottom, w => Math.max(edges(domain, limit_at(w))[0], Math.min(bottom(w) + cut, 1)), more),
               band(first, last, w => edges(domain, limit_at(w))[1], top, more));
    return parts;
}

const known = limit_at => w => { const f = limit_at(w); return Number.isFinite(f) ? f : 0; };

function line_of(limit_at, more) {
    const w = ends(0, 1, n_line);
    return {type: "scatter", mode: "lines", x: w, y: w.map(limit_at), showlegend: false, hoverinfo: "skip", ...more};
}

function ground(z, cells, range, more) {
    const numbers = {zmin: range[0], zmax: range[1]};
    return [{type: "contour", x: cells, y: cells, z, ...numbers, autocontour: true, ncontours: 9, connectgaps: false,
             hoverinfo: "skip", showlegend: false, line: {width: 0.7, color: "rgba(0,0,0,0.5)"},
             contours: {coloring: "heatmap", showlabels: true, labelfont: {size: 10, color: "#000000"}}, ...more}];
}

// `shown`: of sample_map. `mark`: {w, f} of the case, or null.
function draw_map(shown, {quantity, is_layer, other_limit, mark}, theme) {
    const layout = {
        ...charts.layout(theme), margin: {...margin.map, autoexpand: false}, showlegend: false, annotations: [],
        xaxis: {...charts.axis({label: "amplitude <i>w</i> = <i>W</i>/<i>a</i>", low: 0, high: 1}, theme, false)},
        yaxis: {...charts.axis({label: "load <i>f</i><sub>T</sub> = <i>F</i><sub>T</sub>/(μ <i>F</i><sub>N</sub>)",
                                low: 0, high: 1}, theme, false)},
    };
    for (const axis of [layout.xaxis, layout.yaxis]) axis.showgrid = axis.zeroline = false;
    const note = (x, y, text, more) => layout.annotations.push(
        {x, y, text, showarrow: false, font: {size: 12, color: theme.soft}, bgcolor: theme.panel, borderpad: 3, ...more});
    if (!shown.limit_at) {
        note(0.5, 0.5, shown.gap);
        return [[], layout];
    }
    const traces = [], limit_at = known(shown.limit_at);
    const range = range_of(shown.rows), increments = range_of(shown.increments);
    if (range)
        traces.push(...ground(shown.rows, shown.cells, range, {
            colorscale: charts.ground, colorbar: colour_bar(quantities[quantity].title, theme, 0, increments ? 0.48 : 1)}));
    if (increments)
        traces.push(...ground(shown.increments, shown.cells, increments, {
            colorscale: warm, colorbar: colour_bar("Δ<i>u</i> per period", theme, 0.52, 0.48)}));
    const cover = {fillcolor: theme.panel};
    traces.push(...covers(shown.settled, shown.settled_edges, limit_at, false, cover),
                ...covers(shown.ratcheting, shown.ratcheting_edges, limit_at, true, cover));
    if (!shown.ratcheting || shown.ratcheting.gap)
        traces.push(band(0, 1, limit_at, () => 1, {
            fillcolor: theme.panel, fillpattern: {shape: "/", size: 9, solidity: 0.1, fgcolor: theme.line, bgcolor: theme.panel}}));
    if (!increments) note(0.985, 0.975, is_layer ? "above the limit" : "ratcheting", {xanchor: "right", yanchor: "top"});
    if (!range && shown.gap) note(0.02, 0.03, shown.gap, {xanchor: "left", yanchor: "bottom"});
    if (other_limit)
        traces.push(line_of(other_limit, {line: {color: colours(theme)[is_layer ? "bem" : "bem-layer"], width: 2, dash: "dash"}}));
    traces.push(line_of(shown.limit_at, {line: {color: theme.panel, width: 5}}),
                line_of(shown.limit_at, {line: {color: theme.text, width: 2.4}}));
    if (mark)
        traces.push({type: "scatter", mode: "markers", x: [mark.w], y: [mark.f], hoverinfo: "skip", cliponaxis: false,
                     marker: {symbol: "diamond", size: 13, color: "#ffffff", line: {color: "#000000", width: 2}}});
    return [traces, layout];
}

// ---- The shift over the load ----

function curve_of(from, to, value) {
    const points = {x: [], y: [], low: [], high: []};
    if (!(to > from)) return points;
    for (let i = 0; i < 61; ++i) {
        const s = i / 60, f = from + (to - from) * (1 - (1 - s) * (1 - s));  // closer at the limit, where it is steep
        const found = value(f);
        if (!found) continue;
        points.x.push(f);
        points.y.push(found.value);
        points.low.push(found.value - found.error);
        points.high.push(found.value + found.error);
    }
    return points;
}

// Settled shift over U_max of the half-space at this amplitude: {mdr, bem, "bem-layer"}, each
// {x, y, low, high, limit}; points are those of curve_of.
function sample_curves(maps, place) {
    const limit = atlas_maps.shakedown_limit(place.w), key = "settled_shift_ratio", curves = {};
    if (place.w === 0) return curves;
    const beside = maps.domain(place, false, "", null);
    curves.mdr = {...curve_of(0, limit, f => maps.springs({...place, f: Math.min(f, limit * (1 - 1e-12))})[key]), limit};
    if (beside && !beside.gap)
        curves.bem = {...curve_of(beside.low * limit, beside.high * limit,
                                  f => maps.half_space({...place, f}, [key])[key]), limit};
    if (!place.is_layer) return curves;
    const scale = maps.pressed_layer(place);
    if (scale.gap) return curves;
    const own_limit = maps.layer_limit_line(place, scale), domain = maps.domain(place, true, "", scale);
    curves["bem-layer"] = {x: [], y: [], low: [], high: [], limit: own_limit};
    if (domain && !domain.gap)
        Object.assign(curves["bem-layer"],
                      curve_of(domain.low * own_limit, domain.high * own_limit,
                               f => maps.common_shift(maps.layer({...place, f}, scale, [key]), key)));
    return curves;
}

const body_names = {mdr: "MDR", bem: "half-space", "bem-layer": "layer"};

// `here`: shifts at the marker by body.
function draw_curves(curves, place, here, theme) {
    const colour = colours(theme), traces = [];
    const limit_shown = curves["bem-layer"] ? ["bem", "bem-layer"] : ["bem"];
    const layout = {
        ...charts.layout(theme), margin: {...margin.curve, autoexpand: false},
        xaxis: charts.axis({label: "load <i>f</i><sub>T</sub>", low: 0, high: 1}, theme, false),
        yaxis: {...charts.axis({label: "<i>U</i><sub>sd</sub>/<i>U</i><sub>max</sub>"}, theme, false), rangemode: "tozero", nticks: 6},
        legend: {orientation: "h", x: 0, y: 1.02, yanchor: "bottom", font: {size: 12}}, shapes: [], annotations: [],
    };
    for (const [model, curve] of Object.entries(curves)) {
        if (curve.x.length) {
            if (model !== "mdr")
                traces.push(area([...curve.x, ...[...curve.x].reverse()], [...curve.low, ...[...curve.high].reverse()],
                                 {fillcolor: colour[model], opacity: 0.3}));
            traces.push({type: "scatter", mode: "lines", x: curve.x, y: curve.y, name: body_names[model], hoverinfo: "skip",
                         line: {color: colour[model], width: 2.4, dash: model === "mdr" ? "dash" : "solid"}});
        }
        if (limit_shown.includes(model) && Number.isFinite(curve.limit))
            layout.shapes.push({type: "line", x0: curve.limit, x1: curve.limit, y0: 0, y1: 1, yref: "paper",
                                line: {color: colour[model], width: 1.4, dash: "dot"}});
        if (here[model])
            traces.push({type: "scatter", mode: "markers", x: [place.f], y: [here[model].value], showlegend: false,
                         hoverinfo: "skip", cliponaxis: false,
                         marker: {size: 10, color: colour[model], line: {color: theme.panel, width: 2}}});
    }
    layout.shapes.push({type: "line", x0: place.f, x1: place.f, y0: 0, y1: 1, yref: "paper", layer: "below",
                        line: {color: theme.soft, width: 1}});
    if (!traces.length) layout.annotations = [charts.note("no rolling: the shift stays the static one")];
    return [traces, layout];
}

return {margin, height, quantities, body_names, sample_map, draw_map, sample_curves, draw_curves};
})();
