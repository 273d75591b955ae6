"use strict";
// Looks at a report from inside, as a reader would: sent to the page around it as a list of
// complaints, "[...]". See check_report.sh.

// A page on which a marker moves over a map: each way of moving it leads to another motion beside
// the map and to other readings, and back again.
async function check_marker(expect, settle) {
    const part = id => document.getElementById(id);
    const marker = part("marker");
    if (!marker) return;
    const seen = () => ({
        motion: [...part("chart_motion").querySelectorAll("path.js-line")]
            .map(path => path.getAttribute("d")).join(),
        words: marker.getAttribute("aria-valuetext"),
        readings: part("readings").textContent,
    });
    const [x, y] = [part("slider_x"), part("slider_y")];
    const machine = () => [x.value, y.value].join();
    async function to(column, row) {
        for (const [slider, value] of [[x, column], [y, row]]) {
            slider.value = value;
            slider.dispatchEvent(new Event("input"));
        }
        await settle();
    }
    const box = part("pointer").getBoundingClientRect();
    function point(type, across, up) {
        part("pointer").dispatchEvent(new PointerEvent(type, {
            bubbles: true, cancelable: true, pointerId: 7, pointerType: "mouse",
            clientX: box.left + across * box.width, clientY: box.bottom - up * box.height}));
    }
    const key = name => marker.dispatchEvent(new KeyboardEvent("keydown", {key: name, bubbles: true}));
    // At little friction no machine falls over: each has a motion.
    const ways = {
        "dragging from the lower left to the upper right": [0, 0, `${x.max},${y.max}`, () => {
            point("pointerdown", 0.001, 0.001);
            point("pointermove", 0.5, 0.5);
            point("pointermove", 1.2, 1.2);  // beyond the map
            point("pointerup", 1.2, 1.2);
        }],
        "the key →": [0, 0, "1,0", () => key("ArrowRight")],
        "the key ←": [1, 0, "0,0", () => key("ArrowLeft")],
        "the key ↑": [0, 0, "0,1", () => key("ArrowUp")],
        "the key ↓": [0, 1, "0,0", () => key("ArrowDown")],
    };
    for (const [way, [column, row, there, move]] of Object.entries(ways)) {
        await to(column, row);
        const before = seen();
        move();
        await settle();
        expect(machine() === there, `${way} leads to ${machine()}, not ${there}`);
        const after = seen();
        for (const what in before)
            expect(after[what] !== before[what], `${way} leaves the ${what} as they were`);
        await to(column, row);
        expect(seen().motion === before.motion, `back before ${way}, the motion is another`);
    }
    point("pointermove", 0.5, 0.5);
    expect(machine() === "0,1", "the marker follows a free pointer");
    for (const option of part("quantity").options) {
        part("quantity").value = option.value;
        part("quantity").dispatchEvent(new Event("change"));
        await settle();
        expect(part("chart_map").querySelector(".heatmaplayer image"), `no map of ${option.textContent}`);
    }
}

addEventListener("load", async () => {
    const complaints = [];
    const expect = (right, complaint) => right || complaints.push(complaint);
    const all = (selector, root = document) => [...root.querySelectorAll(selector)];
    const settle = () => new Promise(resolve => setTimeout(resolve, 500));
    await settle();

    const page = document.documentElement;
    expect(page.scrollWidth <= innerWidth, `page is ${page.scrollWidth} px wide`);
    for (const chart of all(".chart")) {
        const drawing = chart.querySelector("svg.main-svg");
        expect(drawing, `${chart.id} is not drawn`);
        if (!drawing) continue;
        const width = drawing.getBoundingClientRect().width;
        expect(width > 0 && width <= chart.clientWidth + 1, `${chart.id}: ${width} px wide`);
        const panel = getComputedStyle(page).getPropertyValue("--panel").trim();
        const background = document.createElement("i");
        background.style.color = panel;
        expect(drawing.style.background.replaceAll(" ", "") ===
               background.style.color.replaceAll(" ", ""), `${chart.id} is not in the page's colours`);
        expect(chart.getAttribute("aria-label"), `${chart.id} has no text for readers who cannot see it`);
    }
    for (const {name} of performance.getEntriesByType("resource"))
        expect(/^(data|blob):/.test(name), `asks for ${name}`);
    for (const folded of all("details")) folded.open = true;
    for (const image of all("img")) expect(image.naturalWidth > 0, `picture ${image.alt} is missing`);

    const names = new Set();
    for (const element of all("[id]")) {
        expect(!names.has(element.id), `two elements ${element.id}`);
        names.add(element.id);
    }
    let level = 0;
    for (const heading of all("h1, h2, h3, h4")) {
        const next = Number(heading.tagName[1]);
        expect(next <= level + 1, `heading "${heading.textContent}" skips a level`);
        level = next;
    }
    for (const element of all("a[href], button, summary")) {
        const name = element.getAttribute("aria-label") ?? element.textContent.trim();
        expect(name, `${element.outerHTML.slice(0, 80)} has no name`);
        element.focus();
        expect(document.activeElement === element && element.tabIndex >= 0,
               `"${name}" cannot be reached by keyboard`);
        const target = element.getAttribute("href") ?? "";
        if (target.startsWith("#")) expect(names.has(target.slice(1)), `no ${target} to go to`);
    }

    for (const table of all(".data table")) {
        const n_rows = table.tBodies[0].rows.length;
        for (const heading of all("thead th", table)) {
            for (const order of ["ascending", "descending"]) {
                heading.querySelector("button").click();
                expect(heading.getAttribute("aria-sort") === order, "a heading does not sort");
                const keys = [...table.tBodies[0].rows]
                    .map(row => row.cells[heading.cellIndex].dataset.value)
                    .filter(key => key !== undefined).map(Number);
                const sign = order === "ascending" ? 1 : -1;
                expect(keys.every((key, i) => i === 0 || sign * (key - keys[i - 1]) >= 0),
                       `${heading.textContent}: not ${order}`);
            }
        }
        expect(table.tBodies[0].rows.length === n_rows, "sorting loses rows");
    }

    await check_marker(expect, settle);

    const drawings = [];
    HTMLAnchorElement.prototype.click = function() { drawings.push(this); };
    const buttons = all("figure button");
    for (const button of buttons) button.click();
    await settle();
    expect(drawings.length === buttons.length, `${drawings.length} drawings from ${buttons.length} buttons`);
    for (const {href, download} of drawings) {
        const prefix = "data:image/svg+xml,";
        const svg = new DOMParser().parseFromString(
            decodeURIComponent(href.slice(prefix.length)), "image/svg+xml");
        expect(href.startsWith(prefix) && !svg.querySelector("parsererror") &&
               svg.querySelector("path"), `${download} is no drawing`);
    }
    parent.postMessage(JSON.stringify(complaints.map(text => text.replaceAll('"', "'"))), "*");
});
