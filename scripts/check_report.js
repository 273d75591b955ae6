"use strict";
// Looks at a report from inside, as a reader would: sent to the page around it as a list of
// complaints, "[...]". See check_report.sh.

// A page on which a marker moves over a map: each way of moving it leads to another motion beside
// the map and to other readings, and back again.
async function check_marker(expect, settle) {
    const part = id => document.getElementById(id);
    const marker = part("map_marker");
    if (!part("slider_x")) return;
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
    const box = part("map_area").getBoundingClientRect();
    function point(type, across, up) {
        part("map_area").dispatchEvent(new PointerEvent(type, {
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

// Some real time: pages unpack beside their clock, which is a virtual one here.
const a_while = () => new Response(
    new Blob(["x".repeat(1e6)]).stream().pipeThrough(new CompressionStream("deflate"))).arrayBuffer();

// The view in three dimensions: another picture at another instant and from another side, or a sentence where there
// is no WebGL.
async function check_scene(expect, settle) {
    const part = id => document.getElementById("player_" + id);
    if (!part("open_scene")) return;
    expect(!window.contact_scene, "the library of three dimensions runs before it is asked for");
    part("open_scene").click();
    for (let i = 0; i < 1000 && !part("scene").textContent; ++i)
        await a_while();
    const canvas = part("scene").querySelector("canvas");
    if (canvas) {
        const first = canvas.toDataURL();
        canvas.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowLeft", bubbles: true}));
        const turned = canvas.toDataURL();
        expect(turned !== first, "the view does not turn by keys");
        part("scrub").value = 0;
        part("scrub").dispatchEvent(new Event("input"));
        expect(canvas.toDataURL() !== turned, "the view does not follow the slider");
        expect(canvas.ariaLabel, "the view has no text for readers who cannot see it");
    } else {
        expect(/WebGL/.test(part("scene").textContent), "no view, and no word why");
    }
    expect(document.documentElement.scrollWidth <= innerWidth, "the view is wider than the page");
    part("open_scene").click();
    expect(part("scene").hidden, "the view cannot be closed");
}

// When the first figure stands in the page.
const first_figure = new Promise(resolve => {
    new MutationObserver((_, observer) => {
        if (!document.querySelector("svg.main-svg")) return;
        observer.disconnect();
        resolve(performance.now());
    }).observe(document.documentElement, {childList: true, subtree: true});
});

// How soon the page is there and how long an instant takes, in real time: told on the console, for check_report.sh.
async function measure_player() {
    const part = id => document.getElementById("player_" + id);
    while (part("controls").hidden) await new Promise(resolve => setTimeout(resolve, 5));
    const ready = performance.now(), drawn = document.querySelector(".chart") ? await first_figure : Infinity;
    const painted = performance.getEntriesByName("first-contentful-paint")[0].startTime;
    const begin = performance.now(), n = Number(part("scrub").max) + 1, n_drawn = 3 * n;
    for (let k = 0; k < n_drawn; ++k) {
        part("scrub").value = k % n;
        part("scrub").dispatchEvent(new Event("input"));
        // What the canvas was told is done by the time that a pixel is asked for.
        document.querySelector("#player canvas").getContext("2d").getImageData(0, 0, 1, 1);
    }
    const each = (performance.now() - begin) / n_drawn;
    console.log(`player: ready after ${ready.toFixed(0)} ms, ${each.toFixed(2)} ms per instant of ` +
                `${document.querySelectorAll("#player canvas[data-film]").length} models; ` +
                `page: painted after ${painted.toFixed(0)} ms, first figure after ${drawn.toFixed(0)} ms` +
                (drawn < painted ? "; DRAWN BEFORE THE PAGE IS PAINTED" : "") + "; " + await recorded(n));
}

// The movie that the player's button saves: as long as its instants, and none of them empty.
async function recorded(n) {
    const part = id => document.getElementById("player_" + id), open = HTMLAnchorElement.prototype.click;
    part("speed").value = "30";
    const link = await new Promise(resolve => {
        HTMLAnchorElement.prototype.click = function () { resolve(this); };
        part("record").click();
    });
    HTMLAnchorElement.prototype.click = open;
    const movie = Object.assign(document.createElement("video"), {src: link.href, muted: true});
    await new Promise(resolve => { movie.onloadeddata = movie.onerror = resolve; });
    if (movie.error) return `NO MOVIE: ${movie.error.message}`;
    movie.currentTime = 1e9;  // to its end, which the browser's recorder does not write into the file
    await new Promise(resolve => { movie.onseeked = resolve; });
    const seconds = movie.currentTime, least = n / 30;
    return `${seconds < least || seconds > 5 * least + 1 || movie.videoWidth < 300 ? "NO MOVIE" : "movie"}: ` +
           `${link.download}, ${movie.videoWidth} x ${movie.videoHeight}, ${seconds.toFixed(1)} s of ${n} instants`;
}

// A page that plays a contact: each instant is painted, the slider, the space bar and the button move
// it, each field is another picture.
async function check_player(expect, settle) {
    const part = id => document.getElementById("player_" + id);
    if (!document.getElementById("player")) return;
    const canvases = [...document.querySelectorAll("#player canvas:not(.section)")].filter(canvas => !canvas.closest("[hidden]"));
    const seen = () => canvases.map(canvas => canvas.toDataURL());
    const copy = document.createElement("canvas");  // one that is made to be read
    const painted = canvas => {
        [copy.width, copy.height] = [canvas.width, canvas.height];
        const pen = copy.getContext("2d", {willReadFrequently: true});
        pen.drawImage(canvas, 0, 0);
        return pen.getImageData(0, 0, copy.width, copy.height).data.some(value => value > 0);
    };
    expect(!part("controls").hidden, "the player has no controls");
    for (const canvas of canvases) expect(painted(canvas), `the canvas ${canvas.ariaLabel} is empty`);
    const last = Number(part("scrub").max);
    expect(last >= 1, "the player has a single instant");
    function to(frame) {
        part("scrub").value = frame;
        part("scrub").dispatchEvent(new Event("input"));
    }
    to(0);
    const first = seen(), words = part("label").textContent;
    to(last);
    const end = seen();
    expect(words !== part("label").textContent, "the last instant is told as the first");
    canvases.forEach((canvas, i) => expect(first[i] !== end[i], `${canvas.ariaLabel}: the same at both ends`));
    // All models stand at one instant, each with its own n; one scale for all until somebody asks for their own.
    const captions = [...document.querySelectorAll("#player .films figcaption")].map(caption => caption.textContent);
    const n_films = document.querySelectorAll("#player canvas[data-film]").length;
    expect(captions.slice(0, n_films).every(text => /, (n = |row |pressed|loaded)/.test(text)),
           "a model does not say at which instant it is");
    expect(part("bar").querySelector(".ramp, .state"), "the player has no colour bar");
    part("own").click();
    expect(n_films < 2 || seen().some((picture, i) => picture !== end[i]), "own scales are the common one");
    part("own").click();
    expect(seen().every((picture, i) => picture === end[i]), "the common scale does not come back");
    const pictures = new Set();
    for (const option of part("field").options) {
        part("field").value = option.value;
        part("field").dispatchEvent(new Event("change"));
        pictures.add(canvases[0].toDataURL());
    }
    expect(pictures.size === part("field").options.length, "two fields are one picture");
    if (part("section")) {
        part("section").click();
        const sections = [...document.querySelectorAll("#player canvas.section")];
        // They are unpacked first.
        const is_painted = () => sections.some(canvas => !canvas.hidden && painted(canvas));
        for (let i = 0; i < 50 && !is_painted(); ++i) await settle();
        expect(is_painted(), "no section is painted");
        part("section").click();
        for (let i = 0; i < 50 && !sections.every(canvas => canvas.hidden); ++i) await settle();
        expect(sections.every(canvas => canvas.hidden), "sections cannot be closed");
    }
    await check_scene(expect, settle);
    to(0);
    part("play").click();
    for (let i = 0; i < 20 && part("scrub").value === "0"; ++i) await settle();
    expect(part("scrub").value !== "0", "play does not move it");
    part("play").click();
    document.getElementById("player").dispatchEvent(new KeyboardEvent("keydown", {key: " ", bubbles: true}));
    expect(part("play").getAttribute("aria-pressed") === "true", "the space bar does not play");
    part("play").click();
}

// A page of atlases: mouse, keys, sliders and fields move its marker, by which sentence, table and
// pictures change; each map is drawn; numbers beyond an atlas say so; and back to the case.
async function check_atlas(expect, settle) {
    const part = id => document.getElementById(id), marker = part("map_marker");
    if (!part("slider_w")) return;
    const seen = () => ({
        curves: [...part("chart_curve").querySelectorAll("path.point, path.js-line")]
            .map(path => path.getAttribute("d") + path.getAttribute("transform")).join(),
        words: marker.getAttribute("aria-valuetext"),
        numbers: part("numbers").textContent,
    });
    const place = () => [part("value_w").value, part("value_f").value].join();
    function set(id, value, event) {
        const element = part(id);
        if (element.type === "checkbox") element.checked = value;
        else element.value = value;
        element.dispatchEvent(new Event(event, {bubbles: true}));
    }
    async function to(w, f) {
        set("value_w", w, "change");
        set("value_f", f, "change");
        await settle();
    }
    const first = place();
    function point(type, w, f) {
        const box = part("map_area").getBoundingClientRect();
        part("map_area").dispatchEvent(new PointerEvent(type, {
            bubbles: true, cancelable: true, pointerId: 7, pointerType: "mouse",
            clientX: box.left + w * box.width, clientY: box.bottom - f * box.height}));
    }
    const key = name => marker.dispatchEvent(new KeyboardEvent("keydown", {key: name, bubbles: true}));
    const ways = {
        "dragging": ["0.4,0.1", () => {
            point("pointerdown", 0.3, 0.2);
            point("pointermove", 0.4, 0.1);
            point("pointerup", 0.4, 0.1);
        }],
        "the key →": ["0.205,0.2", () => key("ArrowRight")],
        "the key ←": ["0.195,0.2", () => key("ArrowLeft")],
        "the key ↑": ["0.2,0.205", () => key("ArrowUp")],
        "the key ↓": ["0.2,0.195", () => key("ArrowDown")],
        "the slider of w": ["0.5,0.2", () => set("slider_w", 0.5, "input")],
        "the slider of f_T": ["0.2,0.4", () => set("slider_f", 0.4, "input")],
    };
    for (const [way, [there, move]] of Object.entries(ways)) {
        await to(0.2, 0.2);
        const before = seen();
        move();
        await settle();
        expect(place() === there, `${way} leads to ${place()}, not ${there}`);
        const after = seen();
        for (const what in before) expect(after[what] !== before[what], `${way} leaves the ${what} as they were`);
        await to(0.2, 0.2);
        for (const what in before) expect(seen()[what] === before[what], `back before ${way}, other ${what}`);
    }
    point("pointermove", 0.9, 0.9);
    expect(place() === "0.2,0.2", "the marker follows a free pointer");

    for (const is_layer of [false, true]) {
        if (is_layer && part("is_layer").closest("[hidden]")) continue;
        set("is_layer", is_layer, "change");
        set("body", "bem", "change");
        for (const option of part("quantity").options) {
            set("quantity", option.value, "change");
            await settle();
            expect(part("chart_map").querySelector(".contourlayer .contour path, .heatmaplayer image"),
                   `no map of ${option.textContent}`);
        }
    }
    for (const [id, value] of [["slider_angle", 45], ["slider_poisson", 0.3], ["slider_thickness_ratio", 0]]) {
        const before = part("numbers").textContent;
        set(id, value, "input");
        await settle();
        expect(part("numbers").textContent !== before || part(id).hidden, `${id} changes no number`);
    }
    await to(0.95, 0.001);
    expect(part("gaps").textContent.includes("outside the atlas: w from"), "w = 0.95 is not said to be outside the atlas");
    expect(!/(over|under)states/.test(part("verdict").textContent), "the sentence compares outside the atlas");
    await to(0.6, 0.9);
    expect(part("verdict").textContent.includes("ratchets"), "f_T = 0.9 at w = 0.6 does not ratchet");
    set("value_w", 7, "change");
    expect(part("value_w").value === "0.6", "w = 7 is taken");
    part("to_case").click();
    await settle();
    expect(place() === first, `back to the case leads to ${place()}, not ${first}`);
}

addEventListener("load", async () => {
    if (location.hash === "#measure") return measure_player();
    const complaints = [];
    const expect = (right, complaint) => right || complaints.push(complaint);
    const all = (selector, root = document) => [...root.querySelectorAll(selector)];
    const settle = () => new Promise(resolve => setTimeout(resolve, 500));
    await settle();
    const controls = document.getElementById("player_controls");
    for (let i = 0; i < 1000 && controls?.hidden; ++i)
        await a_while();

    // What unfolds is drawn only then.
    for (const folded of all("details")) folded.open = true;
    for (let i = 0; i < 100 && all(".chart").some(chart => !chart.querySelector("svg.main-svg")); ++i)
        await new Promise(resolve => setTimeout(resolve, 50));
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
    for (const element of all("a[href], button, summary, input, select, [tabindex]")) {
        if (element.closest("[hidden]")) continue;
        // On a phone headings stand in each cell of a stacked table.
        if (element.closest(".stacks thead") && !element.getClientRects().length) continue;
        const name = element.getAttribute("aria-label") ?? (element.labels?.[0] ?? element).textContent.trim();
        expect(name, `${element.outerHTML.slice(0, 80)} has no name`);
        element.focus();
        expect(document.activeElement === element && element.tabIndex >= 0,
               `"${name}" cannot be reached by keyboard`);
        const {outlineStyle, outlineWidth} = getComputedStyle(element);
        expect(outlineStyle !== "none" && parseFloat(outlineWidth) >= 1, `nobody sees that "${name}" has the focus`);
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

    // Rules for readers who see, hear or move otherwise; the letters of drawings have those of the page.
    const {violations} = await axe.run({exclude: ["svg"]}, {resultTypes: ["violations"]});
    for (const {id, help, nodes} of violations) expect(false, `${id}: ${help}: ${nodes[0].html.slice(0, 120)}`);

    await check_marker(expect, settle);
    await check_atlas(expect, settle);
    await check_player(expect, settle);

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
