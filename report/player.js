"use strict";
// Plays the contact: fields of all models at one instant, and where that is in the shift's history.

(async () => {
const root = document.getElementById("player");
const part = id => document.getElementById("player_" + id);
const n_fields = 5;  // of film_json(): pressure, tau_x, tau_y, gap, state

// What packed() made, as a buffer of bytes.
async function unpacked(text) {
    const letters = atob(text), bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}
const bytes_of = async text => new Uint8Array(await unpacked(text));
const words_of = async text => new Uint16Array(await unpacked(text));

// Light to dark for magnitudes (viridis turned round), two hues about zero (plot_style.h), and the
// three states: safe for colour-blind readers, and told apart by their lightness too.
const components = colour => [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
const ramps = {
    magnitude: [[253, 231, 37], [94, 201, 98], [33, 145, 140], [59, 82, 139], [68, 1, 84]],
    sign: map_colours.about_zero.map(components),
};
function ramp(colours, share) {
    const place = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
    const k = Math.min(Math.floor(place), colours.length - 2), part_of = place - k;
    return colours[k].map((from, i) => from + part_of * (colours[k + 1][i] - from));
}
const table = (colours, n = 256) => Array.from({length: n}, (_, i) => ramp(colours, i / (n - 1)));
const magnitudes = table(ramps.magnitude), signs = table(ramps.sign);
const states = [null, ...document.getElementById("content").dataset.states.split(" ")  // open, stick, slip
    .map(components)];

function element(name, properties = {}, children = []) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
}
function picture(label) {
    const canvas = element("canvas", {width: 320, height: 200, ariaLabel: label});
    canvas.setAttribute("role", "img");
    return canvas;
}

// A film with its bytes, its canvases and the pictures of single pixels that these enlarge. Sections and reliefs are
// unpacked when they are asked for.
async function film_of(film) {
    const [mask, bytes] = await Promise.all([bytes_of(film.mask), bytes_of(film.bytes)]);
    const [n_x, n_y] = film.cells.n, cells = [];
    for (let k = 0; k < n_x * n_y; ++k) if (mask[k >> 3] >> (k & 7) & 1) cells.push(k);
    const made = {...film, ...film.cells, cells, bytes,
                  canvas: root.querySelector(`canvas[data-film="${film.name}"]`),
                  image: element("canvas", {width: n_x, height: n_y}), pixels: new ImageData(n_x, n_y)};
    if (film.line)
        made.canvas.ariaLabel = `Contact of ${film.name}, a line of ${film.line}, at the instant of the slider`;
    if (film.section) {
        const [n, m] = film.section.n;
        const canvas = picture(`Von Mises’ stress below the surface of ${film.name} at the instant of the slider`);
        canvas.hidden = true;
        canvas.className = "section";
        made.canvas.after(canvas);
        made.section = {...film.section, packed: film.section.bytes, bytes: null, canvas, image: element("canvas", {width: n, height: m}), pixels: new ImageData(n, m)};
    }
    return made;
}

const content = JSON.parse(document.getElementById("films").textContent);
if (!window.DecompressionStream) {
    part("label").textContent = "This browser cannot unpack what is played: it has no DecompressionStream.";
    return;
}
const films = await Promise.all(content.films.map(film_of));
const {instants} = content;
// Of each film its frame at every instant; -1: none. `shares`: its largest values over those of all.
films.forEach((film, i) => {
    film.follows = instants.map(instant => instant.frames[i]);
    film.shares = film.values.map((own, field) => {
        const all = Math.max(...films.map(each => each.values[field]));
        return all > 0 ? own / all : 1;
    });
});

let theme = charts.screen();
const colour = name => theme[name];
const minus = text => text.replace("-", "−");
const palette = document.getElementById("content").dataset.colours.split(" ");
let now = 0, timer = 0, scene = null, opening = null, difference = null;

// The five fields of a frame, on the film's cells.
function fields_of(film, frame) {
    return Array.from({length: n_fields}, (_, field) => {
        const start = (frame * n_fields + field) * film.cells.length;
        return film.bytes.subarray(start, start + film.cells.length);
    });
}

// What a film's own largest value of a field is on the scale that is drawn.
const place_of = {pressure: 0, traction: 1, traction_x: 1, gap: 2, von_mises: 3};
const share_of = (film, field) => (part("own").checked ? 1 : film.shares[place_of[field]] ?? 1);

// The colour of the k-th cell in the field that is chosen; null: none.
function colour_of(shown, [pressure, tau_x, tau_y, gap, state], k, share) {
    if (shown === "state") return states[state[k]];
    if (shown === "gap") return gap[k] ? magnitudes[Math.round(share * gap[k])] : null;
    if (!state[k]) return null;
    if (shown === "pressure") return magnitudes[Math.round(share * pressure[k])];
    if (shown === "traction_x") return signs[128 + Math.round(share * (tau_x[k] - 128))];
    return magnitudes[Math.round(share * traction(tau_x[k], tau_y[k]))];
}
const traction = (tau_x, tau_y) => Math.min(255, Math.round(Math.hypot(tau_x - 128, tau_y - 128) * 2));

function set_pixel(pixels, at, rgb) {
    pixels[at] = rgb[0], pixels[at + 1] = rgb[1], pixels[at + 2] = rgb[2], pixels[at + 3] = 255;
}

// A pen on the canvas, emptied, as wide as it is shown and of that height over its width.
function pen_on(canvas, height_ratio) {
    const ratio = devicePixelRatio || 1, width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(width * height_ratio);
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const pen = canvas.getContext("2d");
    pen.clearRect(0, 0, width, height);
    pen.imageSmoothingEnabled = false;
    return pen;
}

function paint(film, frame) {
    if (frame < 0) {
        say(film.canvas, "not part of this run");
        if (film.section) film.section.canvas.hidden = true;
    } else if (film.line) paint_line(film, frame);
    else paint_surface(film, frame);
    if (film.section && frame >= 0) paint_section(film, frame);
}

// Words instead of a picture.
function say(canvas, words, height_ratio = 0.62) {
    const pen = pen_on(canvas, height_ratio);
    pen.fillStyle = colour("soft");
    pen.font = `${12 * (devicePixelRatio || 1)}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.fillText(words, canvas.width / 2, canvas.height / 2);
}

function paint_surface(film, frame) {
    const shown = part("field").value, [n_x, n_y] = film.n, pixels = film.pixels.data;
    const fields = fields_of(film, frame), share = share_of(film, shown);
    pixels.fill(0);
    for (let k = 0; k < film.cells.length; ++k) {
        const rgb = colour_of(shown, fields, k, share);
        if (!rgb) continue;
        const column = film.cells[k] % n_x, row = n_y - 1 - Math.floor(film.cells[k] / n_x);  // y upwards
        set_pixel(pixels, 4 * (row * n_x + column), rgb);
    }
    film.image.getContext("2d").putImageData(film.pixels, 0, 0);
    const pen = pen_on(film.canvas, n_y * film.spacing[1] / (n_x * film.spacing[0]));
    const {width, height} = film.canvas;
    pen.drawImage(film.image, 0, 0, width, height);
    const x_of = x => (x - film.first[0] + film.spacing[0] / 2) / (n_x * film.spacing[0]) * width;
    const y_of = y => height - (y - film.first[1] + film.spacing[1] / 2) / (n_y * film.spacing[1]) * height;
    if (part("arrows").checked) arrows(pen, film, fields, x_of, y_of);
    pen.strokeStyle = colour("text");
    pen.lineWidth = 1.5 * (devicePixelRatio || 1);
    pen.beginPath();
    pen.arc(x_of(film.frames[frame].x), y_of(film.frames[frame].y), 4 * (devicePixelRatio || 1), 0, 2 * Math.PI);
    pen.stroke();
}

// A line of springs or cells: the field as its curve, filled with its colours, over a band of stick
// and slip.
function paint_line(film, frame) {
    const shown = part("field").value, [n_x] = film.n, fields = fields_of(film, frame);
    const [pressure, tau_x, tau_y, gap, state] = fields;
    const pen = pen_on(film.canvas, 0.62), {width, height} = film.canvas, ratio = devicePixelRatio || 1;
    const band = 12 * ratio, bottom = height - 2 * band, top = 8 * ratio;
    const zero = shown === "traction_x" ? (top + bottom) / 2 : bottom;
    const own = share_of(film, shown === "state" ? "pressure" : shown);
    const height_of = {gap: k => gap[k] / 255, traction_x: k => (tau_x[k] - 128) / 127,
                       traction: k => traction(tau_x[k], tau_y[k]) / 255}[shown] ?? (k => pressure[k] / 255);
    const share = k => own * height_of(k);
    const cell = width / n_x;
    for (let k = 0; k < film.cells.length; ++k) {
        const x = film.cells[k] * cell, rgb = colour_of(shown, fields, k, own);
        if (state[k]) {
            pen.fillStyle = `rgb(${states[state[k]]})`;
            pen.fillRect(x, height - 1.5 * band, cell + 1, band);
        }
        if (!rgb) continue;
        pen.fillStyle = `rgb(${rgb})`;
        pen.fillRect(x, zero, cell + 1, -share(k) * (zero - top));
    }
    pen.strokeStyle = colour("text");
    pen.lineWidth = 1.5 * ratio;
    pen.beginPath();
    for (let k = 0; k < film.cells.length; ++k)
        pen[k ? "lineTo" : "moveTo"]((film.cells[k] + 0.5) * cell, zero - share(k) * (zero - top));
    pen.stroke();
    pen.lineWidth = ratio;
    pen.beginPath();
    pen.moveTo(0, zero), pen.lineTo(width, zero);
    const x = (film.frames[frame].x - film.first[0] + film.spacing[0] / 2) / (n_x * film.spacing[0]) * width;
    pen.moveTo(x, zero), pen.lineTo(x, height);
    pen.stroke();
}

// Von Mises' stress below the surface, to the scale and under the cells of the surface above it.
function paint_section(film, frame) {
    const {section} = film, [n_x, n_y] = section.n, place = film.frames[frame].section;
    section.canvas.hidden = !section.bytes || !part("section").checked;
    if (section.canvas.hidden) return;
    const height_ratio = n_y * section.spacing[1] / (n_x * section.spacing[0]);
    if (place === undefined) return say(section.canvas, "not computed at this instant", height_ratio);
    const pen = pen_on(section.canvas, height_ratio), {width, height} = section.canvas;
    const share = share_of(film, "von_mises");
    const pixels = section.pixels.data, values = section.bytes.subarray(place * n_x * n_y, (place + 1) * n_x * n_y);
    pixels.fill(0);
    for (let k = 0; k < values.length; ++k) if (values[k]) set_pixel(pixels, 4 * k, magnitudes[Math.round(share * values[k])]);
    section.image.getContext("2d").putImageData(section.pixels, 0, 0);
    pen.imageSmoothingEnabled = true;
    pen.drawImage(section.image, 0, 0, width, height);
    const x = (film.frames[frame].x - section.first[0] + section.spacing[0] / 2) / (n_x * section.spacing[0]) * width;
    pen.strokeStyle = colour("text");
    pen.lineWidth = 1.5 * (devicePixelRatio || 1);
    pen.beginPath();
    pen.arc(x, 0, 4 * (devicePixelRatio || 1), 0, Math.PI);
    pen.stroke();
}

// Tangential traction on the substrate, on every few cells.
function arrows(pen, film, [, tau_x, tau_y, , state], x_of, y_of) {
    const [n_x] = film.n, step = Math.max(1, Math.round(Math.max(...film.n) / 14));
    const length = 0.9 * step * pen.canvas.width / n_x / 127;
    pen.strokeStyle = colour("text");
    pen.lineWidth = Math.max(1, pen.canvas.width / 400);
    pen.beginPath();
    film.cells.forEach((cell, k) => {
        const column = cell % n_x, row = Math.floor(cell / n_x);
        if (column % step || row % step || !state[k]) return;
        const x = x_of(film.first[0] + column * film.spacing[0]),
              y = y_of(film.first[1] + row * film.spacing[1]);
        const dx = length * (tau_x[k] - 128), dy = -length * (tau_y[k] - 128);
        if (Math.hypot(dx, dy) < 1) return;
        pen.moveTo(x - dx / 2, y - dy / 2);
        pen.lineTo(x + dx / 2, y + dy / 2);
        const angle = Math.atan2(dy, dx), head = 0.3 * Math.hypot(dx, dy);
        for (const turn of [2.6, -2.6]) {
            pen.moveTo(x + dx / 2, y + dy / 2);
            pen.lineTo(x + dx / 2 + head * Math.cos(angle + turn), y + dy / 2 + head * Math.sin(angle + turn));
        }
    });
    pen.stroke();
}

// The least and the largest of a column of all films.
const spans = {};
function span_of(key) {
    if (spans[key]) return spans[key];
    let low = Infinity, high = -Infinity;
    for (const film of films)
        for (const value of film[key]) low = Math.min(low, value), high = Math.max(high, value);
    return spans[key] = high > low ? [low, high] : [low - 1, high + 1];
}

// A column over another, of the steps of all films, and where the instant is.
function chart(canvas) {
    const {across, up} = canvas.dataset, pen = pen_on(canvas, 0.62);
    const [first] = films[0][across];  // of a body that does not move there is no loop
    canvas.closest("figure").hidden = films.every(film => film[across].every(value => value === first));
    const ratio = devicePixelRatio || 1, inset = 40 * ratio;
    const [left, right] = span_of(across), [low, high] = span_of(up);
    const x_of = x => inset + (x - left) / (right - left) * (canvas.width - 1.3 * inset);
    const y_of = y => canvas.height - inset - (y - low) / (high - low) * (canvas.height - 1.5 * inset);
    pen.font = `${12 * ratio}px system-ui, sans-serif`;
    pen.fillStyle = pen.strokeStyle = colour("soft");
    pen.lineWidth = ratio;
    pen.strokeRect(inset, 0.5 * inset, canvas.width - 1.3 * inset, canvas.height - 1.5 * inset);
    // Rounding beside a range is zero.
    const number = (value, range) => (Math.abs(value) < 1e-6 * range ? "0" : minus(Number(value.toPrecision(3)).toString()));
    for (const [x, side] of [[left, "left"], [right, "right"]]) {
        pen.textAlign = side;
        pen.fillText(number(x, right - left), x_of(x), canvas.height - 0.6 * inset);
    }
    pen.textAlign = "center";
    pen.fillText(canvas.dataset.label, canvas.width / 2, canvas.height - 0.2 * inset);
    pen.textAlign = "right";
    for (const y of [low, high]) pen.fillText(number(y, high - low), 0.95 * inset, y_of(y) + 4 * ratio);
    films.forEach(film => {
        pen.strokeStyle = pen.fillStyle = palette[film.style % palette.length];
        pen.lineWidth = 1.5 * ratio;
        pen.beginPath();
        film[up].forEach((value, k) => pen[k ? "lineTo" : "moveTo"](x_of(film[across][k]), y_of(value)));
        pen.stroke();
        const frame = film.frames[film.follows[now]];
        if (!frame) return;
        pen.beginPath();
        pen.arc(x_of(frame[across]), y_of(frame[up]), 4.5 * ratio, 0, 2 * Math.PI);
        pen.fill();
    });
}

// Where the film is, and its largest values.
function words_of_film(film) {
    const field = part("field").value, frame = film.frames[film.follows[now]];
    const largest = {pressure: film.largest[0], traction: film.largest[1], traction_x: film.largest[1],
                     gap: film.largest[2]}[field];
    let words = frame ? `, ${frame.label}, indenter at ${minus(frame.x.toFixed(2))}, ${minus(frame.y.toFixed(2))} mm` : "";
    if (film.line) words += `; along its ${film.line}`;
    if (largest) words += `; up to ${field === "traction_x" ? "± " : ""}${largest}`;
    if (film.section && part("section")?.checked) words += `; below: von Mises’ stress up to ${film.largest[3]}`;
    return words;
}

// The colours and what their ends stand for.
const gradient = colours => `linear-gradient(to right, ${colours.map(rgb => `rgb(${rgb})`).join(", ")})`;
function ramp_of(colours) {
    const made = element("span", {className: "ramp"});
    made.style.background = gradient(colours);
    return made;
}
function draw_bar() {
    const field = part("field").value, bar = part("bar");
    if (field === "state") {
        bar.replaceChildren(...["stick", "slip"].flatMap((name, i) => {
            const made = element("span", {className: "state"});
            made.style.background = `rgb(${states[i + 1]})`;
            return [made, name];
        }));
        return;
    }
    const end = part("own").checked ? "each model’s largest" : content.largest[place_of[field]];
    const sign = field === "traction_x";
    bar.replaceChildren(sign ? `−${end}` : "0", ramp_of(sign ? ramps.sign : ramps.magnitude), end);
    if (!part("section")?.checked) return;
    const below = part("own").checked ? "each model’s largest" : content.largest[place_of.von_mises];
    bar.append("· below the surface: von Mises’ stress, 0", ramp_of(ramps.magnitude), below);
}

function show(frame) {
    now = frame;
    part("scrub").value = frame;
    part("label").textContent = instants[frame].label;
    part("scrub").setAttribute("aria-valuetext", instants[frame].label);
    for (const film of films) paint(film, film.follows[frame]);
    for (const id of ["history", "loop", "force"]) chart(part(id));
    films.forEach((film, i) => { part("of_" + i).textContent = words_of_film(film); });
    draw_bar();
    difference?.show(now);
    scene?.show(now);
}

function pause() {
    clearInterval(timer);
    timer = 0;
    part("play").textContent = "Play";
    part("play").setAttribute("aria-pressed", "false");
}
function play() {
    if (timer) return pause();
    part("play").textContent = "Pause";
    part("play").setAttribute("aria-pressed", "true");
    timer = setInterval(() => show((now + 1) % instants.length), 1000 / Number(part("speed").value));
}

if (films.length > 1) {
    difference = player_difference({films, part, element, fields_of, signs, gradient, pen_on, set_pixel, colour});
    difference.chosen.addEventListener("change", () => show(now));
}

// Instants at which some film has a section.
const with_section = instants.map((_, k) => k)
    .filter(k => films.some(film => film.section && film.frames[film.follows[k]]?.section !== undefined));
if (with_section.length) {
    const box = element("input", {type: "checkbox", id: "player_section"});
    box.addEventListener("change", async () => {
        pause();
        for (const {section} of films) if (section) section.bytes ??= await bytes_of(section.packed);
        // The nearest instant that has one.
        const nearest = with_section.reduce((a, b) => (Math.abs(b - now) < Math.abs(a - now) ? b : a));
        show(box.checked ? nearest : now);
    });
    part("arrows").closest("label").after(element("label", {}, [box, " section"]));
}

// The view in three dimensions: its library is unpacked and run when it is opened first.
async function open_scene() {
    pause();
    const script = element("script", {textContent: new TextDecoder().decode(
        await unpacked(document.getElementById("scene_library").textContent))});
    document.head.append(script);
    const with_relief = films.filter(film => film.relief);
    for (const {relief} of with_relief) relief.heights = await words_of(relief.heights);
    return contact_scene({place: part("scene"), films: with_relief,
                          body: {...content.body, heights: await words_of(content.body.heights)},
                          colour, element, redraw: () => show(now)});
}
part("open_scene")?.addEventListener("click", async () => {
    if (!part("scene").hidden) {
        part("scene").hidden = true;
    } else {
        part("scene").hidden = false;
        try {
            scene = await (opening ??= open_scene());
        } catch (error) {
            part("scene").textContent = `This browser draws nothing in three dimensions: ${error.message}`;
        }
        show(now);
    }
    part("open_scene").setAttribute("aria-expanded", !part("scene").hidden);
});

// All instants once, as a file.
async function record() {
    pause();
    part("record").disabled = true;
    try {
        const {blob, ending} = await player_movie.record({root, label: part("label"), bar: part("bar"),
                                                          n: instants.length, show, rate: Number(part("speed").value)});
        const link = element("a", {href: URL.createObjectURL(blob), download: `contact.${ending}`});
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    } catch (error) {
        part("label").textContent = `This browser records no movie: ${error.message}`;
    }
    part("record").disabled = false;
}

if (matchMedia("(prefers-reduced-motion: reduce)").matches) part("speed").value = part("speed").options[0].value;
part("scrub").max = instants.length - 1;
part("scrub").addEventListener("input", event => { pause(); show(Number(event.target.value)); });
part("play").addEventListener("click", play);
part("record").addEventListener("click", record);
part("speed").addEventListener("change", () => { if (timer) { pause(); play(); } });
for (const id of ["field", "arrows", "own"]) part(id).addEventListener("change", () => show(now));
root.addEventListener("keydown", event => {
    const tag = event.target.tagName;
    if (event.key === " " && tag !== "BUTTON" && tag !== "SELECT" && tag !== "INPUT") {
        event.preventDefault();
        play();
    }
});
addEventListener("resize", () => show(now));
function show_in(colours) {
    theme = colours;
    show(now);
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => show_in(charts.screen()));
addEventListener("beforeprint", () => { pause(); show_in(charts.paper); });
addEventListener("afterprint", () => show_in(charts.screen()));
// Contacts that nothing pulls along have no tangential traction to show.
if (films.every(film => !film.values[place_of.traction])) part("field").value = "pressure";
part("controls").hidden = false;
show(instants.length - 1);
})();
