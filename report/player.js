"use strict";
// Plays the contact: fields of all models at one instant, and where that is in the shift's history.

(() => {
const root = document.getElementById("player");
const content = JSON.parse(document.getElementById("films").textContent);
const part = id => document.getElementById("player_" + id);
const n_fields = 5;  // of film_json(): pressure, tau_x, tau_y, gap, state

function bytes_of(text) {
    return Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
}

// Light to dark for magnitudes (viridis turned round), two hues about zero (Okabe and Ito), and the
// three states: safe for colour-blind readers, and told apart by their lightness too.
const ramps = {
    magnitude: [[253, 231, 37], [94, 201, 98], [33, 145, 140], [59, 82, 139], [68, 1, 84]],
    sign: [[0, 114, 178], [160, 200, 225], [247, 247, 247], [240, 180, 130], [213, 94, 0]],
};
function ramp(colours, share) {
    const place = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
    const k = Math.min(Math.floor(place), colours.length - 2), part_of = place - k;
    return colours[k].map((from, i) => from + part_of * (colours[k + 1][i] - from));
}
const table = (colours, n = 256) => Array.from({length: n}, (_, i) => ramp(colours, i / (n - 1)));
const magnitudes = table(ramps.magnitude), signs = table(ramps.sign);
const states = [null, [60, 66, 72], [213, 150, 60]];  // open, stick, slip

const films = content.films.map(film => {
    const mask = bytes_of(film.mask), cells = [];
    for (let k = 0; k < film.n[0] * film.n[1]; ++k) if (mask[k >> 3] >> (k & 7) & 1) cells.push(k);
    const canvas = root.querySelector(`canvas[data-film="${film.name}"]`);
    const image = document.createElement("canvas");
    [image.width, image.height] = film.n;
    return {...film, cells, bytes: bytes_of(film.bytes), canvas, image,
            pixels: new ImageData(film.n[0], film.n[1])};
});
// The film with most instants leads; others show the same instant, or what they have before it.
const leader = films.reduce((a, b) => (b.frames.length > a.frames.length ? b : a));
for (const film of films) {
    let last = 0;
    film.follows = leader.frames.map(frame => {
        const same = film.frames.findIndex(own => own.label === frame.label);
        if (same >= 0) last = same;
        return last;
    });
}

const colour = name => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
const palette = root.dataset.colours.split(" ");
let now = 0, timer = 0;

function field_of(film, frame, field) {
    const start = (frame * n_fields + field) * film.cells.length;
    return film.bytes.subarray(start, start + film.cells.length);
}

function paint(film, frame) {
    const shown = part("field").value, [n_x, n_y] = film.n, pixels = film.pixels.data;
    pixels.fill(0);
    const [pressure, tau_x, tau_y, gap, state] =
        [0, 1, 2, 3, 4].map(field => field_of(film, frame, field));
    film.cells.forEach((cell, k) => {
        let rgb = states[0];
        if (shown === "state") rgb = states[state[k]];
        else if (shown === "gap") rgb = gap[k] ? magnitudes[gap[k]] : null;
        else if (!state[k]) rgb = null;
        else if (shown === "pressure") rgb = magnitudes[pressure[k]];
        else if (shown === "traction_x") rgb = signs[tau_x[k]];
        else rgb = magnitudes[Math.min(255, Math.round(Math.hypot(tau_x[k] - 128, tau_y[k] - 128) * 2))];
        if (!rgb) return;
        const column = cell % n_x, row = n_y - 1 - Math.floor(cell / n_x);  // y upwards
        const at = 4 * (row * n_x + column);
        pixels[at] = rgb[0], pixels[at + 1] = rgb[1], pixels[at + 2] = rgb[2], pixels[at + 3] = 255;
    });
    film.image.getContext("2d").putImageData(film.pixels, 0, 0);
    const {canvas} = film, ratio = devicePixelRatio || 1;
    const width = canvas.clientWidth * ratio;
    const height = width * n_y * film.spacing[1] / (n_x * film.spacing[0]);
    if (canvas.width !== Math.round(width) || canvas.height !== Math.round(height))
        [canvas.width, canvas.height] = [Math.round(width), Math.round(height)];
    const pen = canvas.getContext("2d");
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.imageSmoothingEnabled = false;
    pen.drawImage(film.image, 0, 0, canvas.width, canvas.height);
    const x_of = x => (x - film.first[0] + film.spacing[0] / 2) / (n_x * film.spacing[0]) * canvas.width;
    const y_of = y => canvas.height - (y - film.first[1] + film.spacing[1] / 2) /
                                          (n_y * film.spacing[1]) * canvas.height;
    if (part("arrows").checked) arrows(pen, film, tau_x, tau_y, state, x_of, y_of);
    pen.strokeStyle = colour("text");
    pen.lineWidth = 1.5 * ratio;
    pen.beginPath();
    pen.arc(x_of(film.frames[frame].x), y_of(film.frames[frame].y), 4 * ratio, 0, 2 * Math.PI);
    pen.stroke();
}

// Tangential traction on the substrate, on every few cells.
function arrows(pen, film, tau_x, tau_y, state, x_of, y_of) {
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

// The shift of all films over `across` ("position" or "way"), and where the instant is.
function chart(canvas, across) {
    const ratio = devicePixelRatio || 1, width = canvas.clientWidth * ratio, height = 0.62 * width;
    if (canvas.width !== Math.round(width)) [canvas.width, canvas.height] = [Math.round(width), Math.round(height)];
    const pen = canvas.getContext("2d"), inset = 40 * ratio;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    const all = key => films.flatMap(film => film[key]);
    const ends = values => {
        let low = Infinity, high = -Infinity;
        for (const value of values) low = Math.min(low, value), high = Math.max(high, value);
        return high > low ? [low, high] : [low - 1, high + 1];
    };
    const [left, right] = ends(all(across)), [low, high] = ends(all("shift"));
    const x_of = x => inset + (x - left) / (right - left) * (canvas.width - 1.3 * inset);
    const y_of = y => canvas.height - inset - (y - low) / (high - low) * (canvas.height - 1.5 * inset);
    pen.font = `${12 * ratio}px system-ui, sans-serif`;
    pen.fillStyle = pen.strokeStyle = colour("soft");
    pen.lineWidth = ratio;
    pen.strokeRect(inset, 0.5 * inset, canvas.width - 1.3 * inset, canvas.height - 1.5 * inset);
    // Rounding beside a range is zero.
    const number = (value, range) => (Math.abs(value) < 1e-6 * range ? "0" : Number(value.toPrecision(3)).toString().replace("-", "−"));
    pen.textAlign = "center";
    for (const x of [left, right]) pen.fillText(number(x, right - left), x_of(x), canvas.height - 0.6 * inset);
    pen.fillText(canvas.dataset.label, canvas.width / 2, canvas.height - 0.2 * inset);
    pen.textAlign = "right";
    for (const y of [low, high]) pen.fillText(number(y, high - low), 0.95 * inset, y_of(y) + 4 * ratio);
    films.forEach(film => {
        pen.strokeStyle = pen.fillStyle = palette[film.style % palette.length];
        pen.lineWidth = 1.5 * ratio;
        pen.beginPath();
        film.shift.forEach((shift, k) => pen[k ? "lineTo" : "moveTo"](x_of(film[across][k]), y_of(shift)));
        pen.stroke();
        const frame = film.frames[film.follows[now]];
        pen.beginPath();
        pen.arc(x_of(frame[across]), y_of(frame.shift), 4.5 * ratio, 0, 2 * Math.PI);
        pen.fill();
    });
}
function show(frame) {
    now = frame;
    const {label, x, y} = leader.frames[frame];
    part("scrub").value = frame;
    const words = `${label}, indenter at ${x.toFixed(2).replace("-", "−")}, ${y.toFixed(2).replace("-", "−")} mm`;
    part("label").textContent = words;
    part("scrub").setAttribute("aria-valuetext", words);
    for (const film of films) paint(film, film.follows[frame]);
    chart(part("history"), "position");
    chart(part("loop"), "way");
    const field = part("field").value;
    films.forEach((film, i) => {
        const largest = {pressure: film.largest[0], traction: film.largest[1], traction_x: film.largest[1],
                         gap: film.largest[2]}[field];
        document.getElementById("player_of_" + i).textContent =
            field === "state" ? "" : ` up to ${field === "traction_x" ? "± " : ""}${largest}`;
    });
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
    timer = setInterval(() => show((now + 1) % leader.frames.length), 1000 / Number(part("speed").value));
}

part("scrub").max = leader.frames.length - 1;
part("scrub").addEventListener("input", event => { pause(); show(Number(event.target.value)); });
part("play").addEventListener("click", play);
part("speed").addEventListener("change", () => { if (timer) { pause(); play(); } });
for (const id of ["field", "arrows"]) part(id).addEventListener("change", () => show(now));
root.addEventListener("keydown", event => {
    const tag = event.target.tagName;
    if (event.key === " " && tag !== "BUTTON" && tag !== "SELECT" && tag !== "INPUT") {
        event.preventDefault();
        play();
    }
});
addEventListener("resize", () => show(now));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => show(now));
addEventListener("beforeprint", pause);
part("controls").hidden = false;
// The last instant of the first period says more than an unloaded contact.
show(Math.min(leader.frames.length - 1, 2 + Math.floor((leader.frames.length - 2) / 2)));
})();
