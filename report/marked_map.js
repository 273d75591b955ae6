"use strict";
// A map with a marker, and a chart of the place under it: what the pages with such a map share.

// A page of charts by their names: `charts_of[name](theme)` gives [traces, layout]; `height` in px on the page and
// `drawing` the {width, height} of a saved file, of each. They follow day, night and paper.
function chart_page(charts_of, height, drawing) {
    const quiet = {displayModeBar: false, responsive: true, staticPlot: true};
    function draw(name, theme = charts.screen()) {
        const [traces, layout] = charts_of[name](theme);
        return Plotly.react("chart_" + name, traces, {...layout, width: undefined, height: height[name]}, quiet);
    }
    const draw_all = theme => { for (const name in charts_of) draw(name, theme); };
    for (const name in charts_of)
        document.getElementById("save_" + name).addEventListener("click",
            () => charts.save(...charts_of[name](charts.paper), drawing[name], name, document.title));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw_all(charts.screen()));
    addEventListener("beforeprint", () => draw_all(charts.paper));
    addEventListener("afterprint", () => draw_all(charts.screen()));
    return {draw, draw_all};
}

// The marker #map_marker in #map_area, which lies inside the axes of #chart_map: mouse, finger and keyboard move it.
// `margin` and `height` of the chart in px. `where()`: the marker's place, shares of width and height from the lower left.
// `go_to([x, y])` and `step([right, up])` change it; `far`: steps of Page Up and of arrow keys with shift.
// Returned: what puts the marker at its place.
function map_marker({margin: {l, r, t, b}, height, where, go_to, step, far}) {
    const part = id => document.getElementById(id);
    const chart = part("chart_map"), area = part("map_area"), marker = part("map_marker");
    function place() {
        Object.assign(area.style, {
            left: chart.clientLeft + l + "px", top: chart.clientTop + t + "px",
            width: chart.clientWidth - l - r + "px", height: height - t - b + "px"});
        const [x, y] = where();
        Object.assign(marker.style, {left: 100 * x + "%", top: 100 * (1 - y) + "%"});
    }
    function follow(event) {
        const box = area.getBoundingClientRect();
        go_to([(event.clientX - box.left) / box.width, (box.bottom - event.clientY) / box.height]);
    }
    // A finger drags the marker itself; elsewhere on the map it scrolls the page, and a tap calls the
    // marker. A mouse drags from anywhere.
    let dragged_by = null;
    area.addEventListener("pointerdown", event => {
        if (event.pointerType === "touch" && event.target !== marker) return;
        event.preventDefault();
        dragged_by = event.pointerId;
        marker.focus({focusVisible: false, preventScroll: true});
        if (event.target !== marker) follow(event);
    });
    // Beyond the map too, where the marker stays at its edge.
    addEventListener("pointermove", event => {
        if (event.pointerId === dragged_by) follow(event);
    });
    for (const end of ["pointerup", "pointercancel"])
        addEventListener(end, event => { if (event.pointerId === dragged_by) dragged_by = null; });
    area.addEventListener("click", event => {
        if (event.target !== marker) follow(event);
    });
    marker.addEventListener("keydown", event => {
        const size = event.shiftKey ? far : 1;
        const [right, up] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
                             PageUp: [0, far], PageDown: [0, -far]}[event.key] ?? [0, 0];
        if (!right && !up) return;
        event.preventDefault();
        step([size * right, size * up]);
    });
    new ResizeObserver(place).observe(chart);
    return place;
}
