"use strict";
// Looks at a report from inside, as a reader would: sent to the page around it as a list of
// complaints, "[...]". See check_report.sh.

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
        expect(chart.getAttribute("aria-label"), `${chart.id} says nothing to who cannot see it`);
    }
    for (const {name} of performance.getEntriesByType("resource"))
        expect(/^(data|blob):/.test(name), `asks for ${name}`);
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
