// Draws the map and the motion of the machine under its marker, which moves from machine to machine
// (marked_map.js). Nothing is computed here but pictures.

(() => {
const map = JSON.parse(document.getElementById("map").textContent);
const part = id => document.getElementById(id);
const n_x = map.x.values.length, n_y = map.y.values.length;
// Okabe and Ito; the last, of machines that fell over, also where there is no value.
const motion_colours = ["#f0e442", "#009e73", "#56b4e9", "#e69f00", "#8a8a8a"];
const map_margin = {l: 54, r: 16, t: 66, b: 48};
const motion_margin = {l: 66, r: 16, t: 10, b: 48};
const heights = {map: 430, motion: 560};
const drawing = {map: {width: 720, height: 560}, motion: {width: 720, height: 620}};
let here = map.start, quantity = 0;

// Cells reach half way to their neighbours.
function reach(values) {
    const first = (values[1] - values[0]) / 2, last = (values.at(-1) - values.at(-2)) / 2;
    return [values[0] - first, values.at(-1) + last];
}
const x_range = reach(map.x.values), y_range = reach(map.y.values);

function rows(values) {
    return map.y.values.map((_, row) => values.slice(row * n_x, (row + 1) * n_x));
}

function motion_scale(n) {
    return [...Array(n).keys()].flatMap(i => [[i / n, motion_colours[i]], [(i + 1) / n, motion_colours[i]]]);
}

// Numbers have a colour bar; words squares of their colours, which wrap on a narrow screen.
function ground_of(shown, theme) {
    const cells = {type: "heatmap", x: map.x.values, y: map.y.values, z: rows(shown.values), showlegend: false};
    if (!shown.words)
        return [{...cells, colorscale: charts.ground, zmin: shown.low, zmax: shown.high, colorbar: {
            orientation: "h", x: 0.5, y: 1.01, yanchor: "bottom", len: 1, thickness: 12, outlinewidth: 0,
            tickfont: {color: theme.text}, ticks: "outside", ticklen: 3}}];
    const n = shown.words.length;
    const names = shown.words.map((name, i) => ({
        type: "scatter", mode: "markers", name, x: [null], y: [null], showlegend: true,
        marker: {symbol: "square", size: 11, color: motion_colours[i]}}));
    return [{...cells, colorscale: motion_scale(n), zmin: -0.5, zmax: n - 0.5, showscale: false}, ...names];
}

function draw_map(theme) {
    const shown = map.quantities[quantity];
    // Not line colours of the page: it lies on colours that are the same day and night.
    const limit = {type: "scatter", mode: "lines", x: map.limit.x, y: map.limit.y,
                   line: {color: "#000000", width: 2, dash: "dash"}, showlegend: false};
    const layout = {
        ...charts.layout(theme), margin: {...map_margin, autoexpand: false},
        xaxis: {...charts.axis({label: map.x.name}, theme, false), range: x_range},
        yaxis: {...charts.axis({label: map.y.name}, theme, false), range: y_range},
        plot_bgcolor: motion_colours.at(-1),
        legend: {orientation: "h", x: -0.1, y: 1.01, yanchor: "bottom", font: {size: 11}, itemwidth: 30,
                 entrywidth: 0.5, entrywidthmode: "fraction"},
    };
    for (const axis of [layout.xaxis, layout.yaxis]) axis.showgrid = axis.zeroline = false;
    return [[...ground_of(shown, theme), limit], layout];
}

function unpacked([offset, scale, text]) {
    const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    return Float64Array.from({length: bytes.length / 2},
                             (_, i) => offset + scale * view.getInt16(2 * i, true));
}

function draw_motion(theme) {
    const cell = map.cells[here], n = map.curves.length;
    const layout = {...charts.layout(theme), margin: {...motion_margin, autoexpand: false},
                    showlegend: false, annotations: []};
    layout.xaxis = charts.axis({label: "time <i>t</i>*"}, theme, false);
    layout.xaxis.anchor = "y" + n;
    const traces = cell.samples.map((list, i) => {
        const y = [...unpacked(list)];
        return {type: "scatter", mode: "lines", x: y.map((_, k) => k * cell.interval), y,
                yaxis: "y" + (i + 1), line: {color: theme.text, width: 1.5}};
    });
    map.curves.forEach((label, i) => {
        const room = 0.05, high = 1 - i / n;
        layout["yaxis" + (i + 1)] = {...charts.axis({label}, theme, false), nticks: 4,
                                     domain: [high - 1 / n + room / 2, high - room / 2]};
    });
    if (!traces.length) layout.annotations = [charts.note("no motion kept")];
    else if (cell.mean !== null)
        traces.push({type: "scatter", mode: "lines", y: [cell.mean, cell.mean], yaxis: "y" + n,
                     x: [0, traces[0].x.at(-1)], line: {color: theme.soft, width: 1.2, dash: "dash"}});
    return [traces, layout];
}

function csv_of(cell) {
    const columns = cell.samples.map(unpacked);
    const plain = text => text.replace(/<[^>]*>/g, "");
    const lines = [["t", ...map.curves.map(plain)].join(",")];
    for (let i = 0; i < (columns[0]?.length ?? 0); ++i)
        lines.push([i * cell.interval, ...columns.map(column => column[i])]
            .map(value => Number(value.toPrecision(6))).join(","));
    return lines.join("\n") + "\n";
}

const {draw, draw_all} = chart_page({map: draw_map, motion: draw_motion}, heights, drawing);

const short = value => String(Number(value.toPrecision(4))).replace("-", "−");

function tell() {
    const column = here % n_x, row = Math.floor(here / n_x);
    const {readings} = map.cells[here];
    const x = short(map.x.values[column]), y = short(map.y.values[row]);
    part("value_x").textContent = x;
    part("value_y").textContent = y;
    part("slider_x").value = column;
    part("slider_y").value = row;
    [...part("readings").querySelectorAll("dd")].forEach((dd, i) => { dd.textContent = readings[i]; });
    const words = `κ₈ = ${x}, μ = ${y}: ${readings[0]}`;
    part("verdict").textContent = words;
    part("map_marker").setAttribute("aria-valuenow", row);
    part("map_marker").setAttribute("aria-valuetext", words);
    part("slider_x").setAttribute("aria-valuetext", "κ₈ = " + x);
    part("slider_y").setAttribute("aria-valuetext", "μ = " + y);
    part("data_motion").download = `motion_${column}_${row}.csv`;
    part("data_motion").href = "data:text/csv;charset=utf-8," + encodeURIComponent(csv_of(map.cells[here]));
}

function go_to(column, row) {
    const inside = (i, n) => Math.min(Math.max(i, 0), n - 1);
    const there = inside(row, n_y) * n_x + inside(column, n_x);
    if (there === here) return;
    here = there;
    place_marker();
    tell();
    draw("motion");
}

function nearest(values, wanted) {
    return values.reduce((best, value, i) =>
        Math.abs(value - wanted) < Math.abs(values[best] - wanted) ? i : best, 0);
}

const along = ([low, high], share) => low + share * (high - low);
const place_marker = map_marker({
    margin: map_margin, height: heights.map, far: 5,
    where: () => [[map.x.values[here % n_x], x_range], [map.y.values[Math.floor(here / n_x)], y_range]]
        .map(([value, [low, high]]) => (value - low) / (high - low)),
    go_to: ([x, y]) => go_to(nearest(map.x.values, along(x_range, x)), nearest(map.y.values, along(y_range, y))),
    step: ([right, up]) => go_to(here % n_x + right, Math.floor(here / n_x) + up),
});

function listen() {
    part("slider_x").addEventListener("input",
        event => go_to(Number(event.target.value), Math.floor(here / n_x)));
    part("slider_y").addEventListener("input",
        event => go_to(here % n_x, Number(event.target.value)));
    part("quantity").addEventListener("change", event => {
        quantity = Number(event.target.value);
        draw("map");
    });
}

map.quantities.forEach(({name}, i) => {
    const option = document.createElement("option");
    option.value = i;
    option.textContent = name;
    part("quantity").append(option);
});
draw_all(charts.screen());
place_marker();
tell();
listen();
})();
