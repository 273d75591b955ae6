// Draws the figures of the page with plotly.js and makes its tables sortable. Without this script
// the page still has its texts, tables and data.

(() => {
const ids = [...document.querySelectorAll(".chart")].map(chart => chart.id.replace("chart_", ""));
const on_paper = {width: 640, height: 340};  // two to a page in portrait, with their captions
const on_screen = {width: undefined, height: 400};
const drawing = {width: 720, height: 450};

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
    Plotly.newPlot("chart_" + id, figures.traces_of(figure, theme, width), {...size, ...figures.layout_of(figure, theme, width)},
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
    const layout = {...figures.layout_of(figure, charts.paper, drawing.width), title: {text: figure.title},
                    margin: {l: 60, r: 16, t: 90, b: 48}};
    return charts.save(figures.traces_of(figure, charts.paper, drawing.width), layout, drawing, figure.id,
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
// The figures' data and the library stand behind this script; the page is painted before them. What is unfolded from the
// start says so while they are still being read, and is drawn afterwards with the rest.
addEventListener("DOMContentLoaded", () => requestAnimationFrame(() => draw_on_screen(ids)));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw_on_screen(ids));
for (const details of foldings)
    details.addEventListener("toggle", () => {
        if (details.open && document.readyState !== "loading") draw_on_screen(ids.filter(id => details.contains(chart_of(id))));
    });
for (const id of ids) {
    const button = document.querySelector(`#figure_${id} button`);
    if (!button) continue;  // its drawing is a file
    button.hidden = false;
    button.addEventListener("click", () => save_drawing(id));
}
})();
