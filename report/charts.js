"use strict";
// What the scripts of pages share: colours by day, by night and on paper, axes, saved drawings.

const charts = (() => {
const even = colours => colours.map((colour, i) => [i / (colours.length - 1), colour]);
// Of plot_style.h; see charts_script().
const ground = even(map_colours.ground), ground_about_zero = even(map_colours.about_zero);

const paper = {text: "#000000", soft: "#333333", line: "#d0d0d0", panel: "#ffffff"};
function screen() {
    const style = getComputedStyle(document.documentElement);
    const colour = name => style.getPropertyValue("--" + name).trim();
    return {text: colour("text"), soft: colour("soft"), line: colour("line"),
            panel: colour("panel")};
}

// `automargin`: an axis makes room across itself only. Along it the last number and the legend would
// ask for room in turns.
function axis(content, theme, automargin) {
    const end = value => value === null || value === undefined || !content.logarithmic ? value
                                                                                       : Math.log10(value);
    const ends = [end(content.low), end(content.high)];
    const chosen = ends.every(value => value === null || value === undefined);
    return {
        ...(chosen ? {} : {range: ends}),
        ...(content.names?.length ? {tickmode: "array", tickvals: content.names.map((_, i) => i), ticktext: content.names} : {}),
        title: {text: content.label, standoff: 8}, type: content.logarithmic ? "log" : "linear",
        automargin, exponentformat: "power", gridcolor: theme.line, zerolinecolor: theme.line,
        linecolor: theme.soft, showline: true, ticks: "outside", tickcolor: theme.soft, ticklen: 4,
    };
}

function layout(theme) {
    return {
        autosize: true, paper_bgcolor: theme.panel, plot_bgcolor: theme.panel,
        font: {family: "system-ui, 'Liberation Sans', Arial, sans-serif", size: 13, color: theme.text},
    };
}

// Words instead of a drawing.
function note(text) {
    return {text, showarrow: false, xref: "paper", yref: "paper", x: 0.5, y: 0.5};
}

// `size`: {width, height} in px. `description`: its words in the file.
async function save(traces, layout_there, size, name, description) {
    const uri = await Plotly.toImage({data: traces, layout: {...layout_there, ...size}},
                                     {format: "svg", ...size});
    const drawing = new DOMParser().parseFromString(
        decodeURIComponent(uri.slice(uri.indexOf(",") + 1)), "image/svg+xml");
    const words = drawing.createElementNS(drawing.documentElement.namespaceURI, "desc");
    words.textContent = description;
    drawing.documentElement.prepend(words);
    const link = document.createElement("a");
    link.href = "data:image/svg+xml," +
        encodeURIComponent(new XMLSerializer().serializeToString(drawing));
    link.download = name + ".svg";
    link.click();
}

return {ground, ground_about_zero, paper, screen, axis, layout, note, save};
})();
