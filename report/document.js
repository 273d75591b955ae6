// Draws the figures of the page with plotly.js and makes its tables sortable. Without this script
// the page still has its texts, tables and data.

(() => {
const colours = document.getElementById("content").dataset.colours.split(" ");
const ids = [...document.querySelectorAll(".chart")].map(chart => chart.id.replace("chart_", ""));
// In the order of plot_style.h.
const markers = ["circle", "square", "triangle-up", "diamond", "triangle-down",
                 "circle-open", "square-open", "diamond-open"];
const dashes = ["solid", "dash", "dot", "dashdot", "longdash", "longdashdot"];
const most_grounds = 30;
const on_paper = {width: 640, height: 340};  // two to a page in portrait, with their captions
const on_screen = {width: undefined, height: 400};
const drawing = {width: 720, height: 450};

function colour_of(style, theme) {
    return style === null ? theme.soft : colours[style % colours.length];
}

function error_bars(errors) {
    return errors.length ? {type: "data", array: errors, thickness: 1.2, width: 3} : undefined;
}

function curve_trace(curve, theme, place = {}) {
    const style = curve.style ?? 0;
    const points = curve.kind !== "line", lines = curve.kind !== "points";
    return {
        ...place, type: "scatter", name: curve.name, x: curve.x, y: curve.y,
        mode: lines ? (points ? "lines+markers" : "lines") : "markers",
        legendgroup: "curve " + curve.name, showlegend: curve.named && !place.xaxis,
        error_x: error_bars(curve.x_error), error_y: error_bars(curve.y_error),
        line: {
            color: colour_of(curve.style, theme), width: 1.8,
            dash: dashes[curve.dash % dashes.length],
        },
        marker: {color: colour_of(curve.style, theme), size: 7, symbol: markers[style % markers.length]},
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
    const low = values.reduce((a, b) => Math.min(a, b));
    const high = values.reduce((a, b) => Math.max(a, b));
    const step = round_step((high - low) / most_grounds);
    const grid = {type: "contour", x: map.x, y: map.y, z: map.rows, connectgaps: false};
    const line = {color: "#1a1a1a", width: 1};
    const label = {size: 11, color: "#000000"};
    const traces = [{
        ...grid, colorscale: charts.ground, zmin: low, zmax: high, line: {width: 0},
        contours: {coloring: "fill", size: step, end: high,
                   start: Math.ceil(low / step) * step},
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
            hoverinfo: "skip", ncontours: 8,
            contours: {coloring: "lines", showlabels: true, labelfont: label},
        });
    return traces;
}

// A shade from that of the background, 0, to that of the letters, 1.
function shaded(shade, theme) {
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
            marker: {color: kinds.map(kind => shaded(kind.shade, theme)),
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
    const {n_columns} = rows_of_panels(figure, width), axis = k => k ? k + 1 : "";
    return figure.panels.flatMap((panel, i) => {
        const place = {xaxis: "x" + axis(i), yaxis: "y" + axis(Math.floor(i / n_columns))};
        const of_kinds = get => panel.rows.map(row => row.map(kind => kind < 0 ? null : get(figure.kinds[kind])));
        return [{
            ...place, type: "heatmap", x: panel.x, y: panel.y, zmin: 0, zmax: 1,
            colorscale: [[0, theme.panel], [1, theme.text]], z: of_kinds(kind => kind.shade), text: of_kinds(kind => kind.name), showscale: false,
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

// Read when it is drawn first.
const read = new Map();
function figure_of(id) {
    if (!read.has(id)) read.set(id, JSON.parse(document.getElementById("data_" + id).textContent));
    return read.get(id);
}

// The library runs when it is needed first: it takes longer than all the rest of the page.
function need_library() {
    if (window.Plotly) return;
    const library = document.createElement("script");
    library.textContent = document.getElementById("chart_library").textContent;
    document.head.append(library);
}

const chart_of = id => document.getElementById("chart_" + id);
function draw(id, theme, size) {
    need_library();
    const figure = figure_of(id);
    const width = size.width ?? chart_of(id).clientWidth;
    // Not react: after another size it leaves the legend where that had it.
    Plotly.newPlot("chart_" + id, traces_of(figure, theme, width), {...size, ...layout_of(figure, theme, width)},
                   {displayModeBar: false, responsive: true});
}

// What is folded has no width; it is drawn when it unfolds.
const is_shown = id => !chart_of(id).closest("details:not([open])");

// One after the other: between them the page answers its reader.
async function draw_on_screen(wanted) {
    for (const id of wanted) {
        await new Promise(resolve => setTimeout(resolve));
        if (is_shown(id) && !printing) draw(id, charts.screen(), on_screen);
    }
}

function save_drawing(id) {
    need_library();
    const figure = figure_of(id);
    const layout = {...layout_of(figure, charts.paper, drawing.width), title: {text: figure.title},
                    margin: {l: 60, r: 16, t: 90, b: 48}};
    return charts.save(traces_of(figure, charts.paper, drawing.width), layout, drawing, figure.id,
                       figure.description);
}

// Words come after numbers and undefined values last in either order.
function compare(a, b, direction) {
    if (a === undefined || b === undefined) return (a === undefined) - (b === undefined);
    if (typeof a !== typeof b) return (typeof a === "string") - (typeof b === "string");
    return direction * (typeof a === "number" ? a - b : a.localeCompare(b, "en", {numeric: true}));
}

function value_of(cell) {
    if (cell.dataset.value !== undefined) return Number(cell.dataset.value);
    return cell.dataset.words === undefined ? undefined : cell.textContent;
}

function sort_by(heading) {
    const ascending = heading.getAttribute("aria-sort") !== "ascending";
    for (const other of heading.parentElement.cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", ascending ? "ascending" : "descending");
    const body = heading.closest("table").tBodies[0];
    const keyed = [...body.rows].map(row => [value_of(row.cells[heading.cellIndex]), row]);
    keyed.sort((a, b) => compare(a[0], b[0], ascending ? 1 : -1));
    body.append(...keyed.map(pair => pair[1]));
}

function make_sortable(heading) {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...heading.childNodes);
    button.addEventListener("click", () => sort_by(heading));
    heading.append(button);
}

const foldings = [...document.querySelectorAll("section > details")];

// A link into what is folded unfolds it.
function unfold_target() {
    const details = document.getElementById(decodeURIComponent(location.hash.slice(1)))
        ?.querySelector(":scope > details");
    if (details) details.open = true;
}

function make_unfold_button() {
    const button = document.getElementById("unfold");
    if (!button) return;
    const all_open = () => foldings.every(details => details.open);
    const name = () => { button.textContent = all_open() ? "Fold all" : "Unfold all"; };
    button.hidden = false;
    button.addEventListener("click", () => {
        const open = !all_open();
        for (const details of foldings) details.open = open;
    });
    for (const details of foldings) details.addEventListener("toggle", name);
}

// On paper: what the reader has unfolded, and what a lab book needs.
let printing = false;
function print_folded() {
    let unfolded = [];
    addEventListener("beforeprint", () => {
        printing = true;
        unfolded = [...document.querySelectorAll("details[data-printed]:not([open])")];
        for (const details of unfolded) details.open = true;
        for (const id of ids.filter(is_shown)) draw(id, charts.paper, on_paper);
    });
    addEventListener("afterprint", () => {
        printing = false;
        for (const details of unfolded) details.open = false;
        draw_on_screen(ids);
    });
}

document.querySelectorAll(".data thead th").forEach(make_sortable);
addEventListener("hashchange", unfold_target);
unfold_target();
make_unfold_button();
print_folded();
// The figures' data stand behind this script; the page is painted before them.
addEventListener("DOMContentLoaded", () => requestAnimationFrame(() => draw_on_screen(ids)));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw_on_screen(ids));
for (const details of foldings)
    details.addEventListener("toggle", () => {
        if (details.open) draw_on_screen(ids.filter(id => details.contains(chart_of(id))));
    });
for (const id of ids) {
    const button = document.querySelector(`#figure_${id} button`);
    if (!button) continue;  // its drawing is a file
    button.hidden = false;
    button.addEventListener("click", () => save_drawing(id));
}
})();
