// What plotly.js is told of a page's figures: traces and layout, in the colours of a theme, for a width in px.

const figures = (() => {
const {colours: of_models, states: of_states} = document.getElementById("content").dataset;
const colours = of_models.split(" "), states = of_states.split(" ");  // stick, slip
const measured = -3;  // figure.h
// In the order of plot_style.h.
const markers = ["circle", "square", "triangle-up", "diamond", "triangle-down",
                 "circle-open", "square-open", "triangle-up-open", "diamond-open", "triangle-down-open"];
const dashes = ["solid", "dash", "dot", "dashdot", "longdash", "longdashdot"];
const most_grounds = 30;

function colour_of(style, theme) {
    if (style === null) return theme.soft;
    return style === measured ? theme.text : style < 0 ? states[-style - 1] : colours[style % colours.length];
}

function error_bars(errors) {
    return errors.length ? {type: "data", array: errors, thickness: 1.2, width: 3} : undefined;
}

function curve_trace(curve, theme, place = {}) {
    const style = curve.style ?? 0, marker = style < 0 ? -style - 1 : style;
    const points = curve.kind !== "line", lines = curve.kind !== "points";
    return {
        ...place, type: "scatter", name: curve.name, x: curve.x, y: curve.y,
        mode: lines ? (points ? "lines+markers" : "lines") : "markers",
        ...(curve.detail ? {hovertemplate: `%{x:.4g}, %{y:.4g}<br>${curve.detail}`} : {}),
        legendgroup: "curve " + curve.name, showlegend: curve.named && !place.xaxis,
        error_x: error_bars(curve.x_error), error_y: error_bars(curve.y_error),
        line: {
            color: colour_of(curve.style, theme), width: 1.8,
            dash: dashes[curve.dash % dashes.length],
        },
        marker: {color: colour_of(curve.style, theme), size: 7, symbol: markers[marker % markers.length]},
        connectgaps: false,
    };
}

// One closed outline per stretch without gaps. A curve of the same name speaks for it in the legend.
function band_traces(band, theme, curves) {
    const stretches = [[]];
    band.x.forEach((x, i) => {
        if (x === null || band.low[i] === null || band.high[i] === null) stretches.push([]);
        else stretches.at(-1).push([x, band.low[i], band.high[i]]);
    });
    const alone = band.name !== "" && curves.every(curve => curve.name !== band.name);
    return stretches.filter(stretch => stretch.length > 1).map((stretch, i) => {
        const back = [...stretch].reverse();
        return {
            type: "scatter", mode: "lines", name: band.name, fill: "toself", hoverinfo: "skip",
            x: stretch.map(p => p[0]).concat(back.map(p => p[0])),
            y: stretch.map(p => p[1]).concat(back.map(p => p[2])),
            line: {width: 0}, opacity: 0.25, fillcolor: colour_of(band.style, theme),
            legendgroup: (alone ? "band " : "curve ") + band.name, showlegend: alone && i === 0,
        };
    });
}

// 1, 2 or 5 times a power of ten, not below the given one: so are the tics beside the map.
function round_step(least) {
    if (!(least > 0)) return 1;
    const power = 10 ** Math.floor(Math.log10(least));
    return power * [1, 2, 5, 10].find(factor => factor * power >= least);
}

// A ground of many even steps; the lines at any levels lie over it.
function map_traces(map, theme) {
    const values = map.rows.flat().filter(value => value !== null);
    if (!values.length) return [];
    let low = values.reduce((a, b) => Math.min(a, b));
    let high = values.reduce((a, b) => Math.max(a, b));
    if (map.about_zero) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
    const step = round_step((high - low) / most_grounds);
    const grid = {type: "contour", x: map.x, y: map.y, z: map.rows, connectgaps: false};
    const line = {color: "#1a1a1a", width: 1};
    const label = {size: 11, color: "#000000"};
    const traces = [{
        ...grid, colorscale: map.about_zero ? charts.ground_about_zero : charts.ground, zmin: low, zmax: high, line: {width: 0},
        contours: map.about_zero ? {coloring: "heatmap"}
            : {coloring: "fill", size: step, end: high, start: Math.ceil(low / step) * step},
        colorbar: {title: {text: map.label, side: "right"}, thickness: 14, outlinewidth: 0,
                   tickfont: {color: theme.text}},
        hovertemplate: "%{x:.4g}, %{y:.4g}: %{z:.4g}<extra></extra>",
    }];
    const levels = map.levels.filter(level => level > low && level < high);
    for (const value of levels)
        traces.push({
            ...grid, line, showlegend: false, hoverinfo: "skip",
            contours: {type: "constraint", operation: "=", value, showlabels: true, labelfont: label},
        });
    if (!map.levels.length)
        traces.push({
            ...grid, line, colorscale: [[0, line.color], [1, line.color]], showscale: false,
            hoverinfo: "skip", ncontours: 8, autocontour: !map.about_zero,
            contours: {coloring: "lines", showlabels: true, labelfont: label,
                       // Not at 0, where rounding draws lines.
                       ...map.about_zero && {start: .75 * low, end: .75 * high, size: .5 * high}},
        });
    return traces;
}

// A kind's colour, or its shade from that of the background, 0, to that of the letters, 1.
function shaded({colour, shade}, theme) {
    if (colour) return colour;
    const parts = colour => [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
    const [from, to] = [parts(theme.panel), parts(theme.text)];
    return `rgb(${from.map((part, i) => Math.round(part + shade * (to[i] - part)))})`;
}

// A row of boxes per strip, with the kind's name where it fits.
function strip_traces(figure, theme) {
    return figure.strips.map(strip => {
        const kinds = strip.stretches.map(([kind]) => figure.kinds[kind]);
        return {
            type: "bar", orientation: "h", yaxis: "y2", showlegend: false, hoverinfo: "text",
            y: strip.stretches.map(() => strip.name), base: strip.stretches.map(([, begin]) => begin),
            x: strip.stretches.map(([, begin, end]) => end - begin), text: kinds.map(kind => kind.name),
            textposition: "inside", insidetextanchor: "middle", textangle: 0, constraintext: "inside",
            marker: {color: kinds.map(kind => shaded(kind, theme)),
                     line: {color: theme.panel, width: 1}},
        };
    });
}

// Panels of a figure of that width [px]: in as few rows as leave each of them wide enough.
const least_panel = 150, between_rows = 60;
function rows_of_panels(figure, width) {
    const n = figure.panels.length, n_rows = Math.ceil(n * least_panel / width);
    const n_columns = Math.ceil(n / n_rows), span = values => values.at(-1) - values[0];
    const ratio = Math.max(...figure.panels.map(({x, y}) => span(y) / span(x)));
    const height = figure.equal_scales ? ratio * (width - 76) / n_columns : 220;
    return {n_rows, n_columns, height: n_rows * (height + between_rows) + 36,
            gap: between_rows / (n_rows * (height + between_rows) - between_rows)};
}

function panel_traces(figure, theme, width) {
    const n = figure.kinds.length;
    // A stretch of one colour for each kind.
    const colours_of_kinds = figure.kinds.flatMap((kind, i) =>
        [[i / n, shaded(kind, theme)], [(i + 1) / n, shaded(kind, theme)]]);
    const {n_columns} = rows_of_panels(figure, width), axis = k => k ? k + 1 : "";
    return figure.panels.flatMap((panel, i) => {
        const place = {xaxis: "x" + axis(i), yaxis: "y" + axis(Math.floor(i / n_columns))};
        const of_kinds = get => panel.rows.map(row => row.map(kind => kind < 0 ? null : get(kind)));
        return [{
            ...place, type: "heatmap", x: panel.x, y: panel.y, zmin: -0.5, zmax: n - 0.5,
            colorscale: colours_of_kinds, z: of_kinds(kind => kind), text: of_kinds(kind => figure.kinds[kind].name), showscale: false,
            hovertemplate: "%{x:.3g}, %{y:.3g}: %{text}<extra></extra>",
        }, ...panel.curves.map(curve => curve_trace(curve, theme, place))];
    });
}

function traces_of(figure, theme, width) {
    return [...(figure.map ? map_traces(figure.map, theme) : []), ...strip_traces(figure, theme),
            ...figure.bands.flatMap(band => band_traces(band, theme, figure.curves)),
            ...figure.curves.map(curve => curve_trace(curve, theme)), ...panel_traces(figure, theme, width)];
}

// The axes of panels side by side and of strips beneath the curves.
function further_axes(figure, theme, width) {
    const n_strips = figure.strips.length, axes = {};
    const {n_rows, n_columns, gap} = rows_of_panels(figure, width);
    const name = k => k ? k + 1 : "", height = (1 - (n_rows - 1) * gap) / n_rows;
    figure.panels.forEach((panel, i) => {
        const column = i % n_columns, row = Math.floor(i / n_columns), top = 1 - row * (height + gap);
        axes["xaxis" + name(i)] = {
            ...charts.axis(figure.x, theme, "height"), ...(i ? {matches: "x"} : {}), constrain: "domain",
            anchor: "y" + name(row),
            domain: [column / n_columns, (column + 1) / n_columns - (column + 1 < n_columns ? 0.02 : 0)],
        };
        axes["yaxis" + name(row)] = {
            ...charts.axis(figure.y, theme, "width"), ...(row ? {matches: "y"} : {}), constrain: "domain",
            domain: [top - height, top],
        };
    });
    if (n_strips) {
        const height = 0.075 * n_strips;
        axes.yaxis2 = {domain: [0, height], autorange: "reversed", type: "category", fixedrange: true,
                       dtick: 1, tickfont: {size: 11}, showgrid: false, ticks: ""};
        axes.yaxis = {...charts.axis(figure.y, theme, "width"), domain: [height + 0.03, 1]};
        axes.xaxis = {...charts.axis(figure.x, theme, "height"), anchor: "y2"};
        axes.barmode = "overlay";
        axes.bargap = 0.15;
    }
    return axes;
}

function layout_of(figure, theme, width) {
    const empty = !figure.map && !figure.panels.length && !figure.bands.length &&
                  figure.curves.every(curve => !curve.x.length);
    const panels = rows_of_panels(figure, width);
    const layout = {
        ...charts.layout(theme),
        xaxis: charts.axis(figure.x, theme, "height"), yaxis: charts.axis(figure.y, theme, "width"),
        ...further_axes(figure, theme, width),
        margin: {l: 60, r: 16, t: 16, b: 48},
        showlegend: !figure.panels.length, legend: {orientation: "h", y: 1.02, yanchor: "bottom", x: 0},
        hovermode: "closest",
        // A finger scrolls the page, a mouse zooms.
        dragmode: matchMedia("(pointer: coarse)").matches ? false : "zoom",
        annotations: empty ? [charts.note("no data")] : figure.panels.map((panel, i) => ({
            text: panel.title, showarrow: false, x: (i % panels.n_columns + 0.49) / panels.n_columns, xref: "paper",
            y: 1 - Math.floor(i / panels.n_columns) * (1 + panels.gap) / panels.n_rows, yref: "paper", yanchor: "bottom",
        })),
        uniformtext: {mode: "hide", minsize: 9},  // what does not fit into a strip
    };
    // Equal scales move the axis, which would ask for another margin, which moves the axis.
    if (figure.equal_scales)
        Object.assign(layout.yaxis, {scaleanchor: "x", constrain: "domain", automargin: false});
    if (figure.panels.length) [layout.margin.t, layout.height] = [32, panels.height];
    // Room for the names of strips, some 8 px a letter.
    for (const {name} of figure.strips)
        layout.margin.l = Math.max(layout.margin.l, 16 + 8 * name.length);
    return layout;
}

return {traces_of, layout_of};
})();
