// The difference of two models of player.js at the instant of its slider: on the finer of the two grids, a minus b, in
// two hues about zero. Both are kept in some 250 steps of their largest value; the sum of half a step of either is
// what a difference may be off by.
globalThis.player_difference = ({films, part, element, fields_of, signs, gradient, pen_on, set_pixel, colour}) => {
const pairs = films.flatMap((a, i) => films.slice(0, i).map(b => ({a, b, name: `${a.name} minus ${b.name}`}))).reverse();
const names = {pressure: "pressure", traction: "tangential traction", traction_x: "traction along x", gap: "gap"};
const place_of = {pressure: 0, traction: 1, traction_x: 1, gap: 2};
const units = ["Pa", "Pa", "m"], prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];

function words(value, unit) {
    const [factor, prefix] = prefixes.find(([factor]) => value >= factor) ?? prefixes.at(-1);
    return `${Number((value / factor).toPrecision(3))} ${prefix}${unit}`;
}

// A film's field in a frame on all cells of its grid, in Pa or m; NaN: not kept.
function values_of(film, frame, field) {
    const [pressure, tau_x, tau_y, gap] = fields_of(film, frame), largest = film.values[place_of[field]];
    const value = {pressure: k => pressure[k] / 255, gap: k => gap[k] / 255, traction_x: k => (tau_x[k] - 128) / 127,
                   traction: k => Math.hypot(tau_x[k] - 128, tau_y[k] - 128) / 127}[field];
    const values = new Float32Array(film.n[0] * film.n[1]).fill(field === "gap" ? NaN : 0);
    film.cells.forEach((cell, k) => { values[cell] = largest * value(k); });
    return values;
}

// Of a grid, or of a line of springs by the distance from the indenter, at a point; beyond the contact nothing acts.
function sampler(film, frame, field) {
    const values = values_of(film, frame, field), [n_x, n_y] = film.n, beyond = field === "gap" ? NaN : 0;
    const at = (i, j) => (i < 0 || j < 0 || i >= n_x || j >= n_y ? beyond : values[j * n_x + i]);
    const {x: x_0, y: y_0} = film.frames[frame];
    return (x, y) => {
        if (film.line === "springs") x = x_0 + Math.hypot(x - x_0, y - y_0);
        const u = (x - film.first[0]) / film.spacing[0], i = Math.floor(u + 1e-6), right = Math.max(0, u - i);
        const v = n_y > 1 ? (y - film.first[1]) / film.spacing[1] : 0, j = Math.floor(v + 1e-6), up = Math.max(0, v - j);
        const mix = (a, b, share) => (share < 1e-6 ? a : (1 - share) * a + share * b);
        const row = k => mix(at(i, k), right < 1e-6 ? 0 : at(i + 1, k), right);
        return mix(row(j), up < 1e-6 ? 0 : row(j + 1), up);
    };
}

// The film whose cells are drawn.
function frame_of({a, b}) {
    if ((a.n[1] > 1) !== (b.n[1] > 1)) return a.n[1] > 1 ? a : b;
    return a.spacing[0] < b.spacing[0] ? a : b;
}
// a minus b at an instant on those cells; null where one of them has none.
function difference_at(pair, instant, field) {
    const i = pair.a.follows[instant], k = pair.b.follows[instant];
    if (i < 0 || k < 0) return null;
    const grid = frame_of(pair), of_a = sampler(pair.a, i, field), of_b = sampler(pair.b, k, field);
    const values = new Float32Array(grid.n[0] * grid.n[1]);
    for (let c = 0; c < values.length; ++c) {
        const x = grid.first[0] + (c % grid.n[0]) * grid.spacing[0];
        const y = grid.n[1] > 1 ? grid.first[1] + Math.floor(c / grid.n[0]) * grid.spacing[1] : grid.frames[grid.follows[instant]].y;
        values[c] = of_a(x, y) - of_b(x, y);
    }
    return values;
}
const largest_in = values => values.reduce((most, value) => Math.max(most, Math.abs(value) || 0), 0);

const chosen = element("select", {id: "player_difference"}, [
    element("option", {value: "", textContent: "none"}),
    ...pairs.map((pair, i) => element("option", {value: i, textContent: pair.name}))]);
part("field").closest("label").after(element("label", {}, ["Difference ", chosen]));
const canvas = element("canvas", {width: 320, height: 200, className: "difference"}), bar = element("p", {className: "bar"});
canvas.setAttribute("role", "img");
const title = element("b"), where = element("span");
const figure = element("figure", {hidden: true, className: "difference"}, [canvas, element("figcaption", {}, [title, where, bar])]);
films[0].canvas.closest(".films").append(figure);

// The largest difference of all instants, by pair and field: one scale for the whole film.
const scales = {};
function scale_of(pair, field) {
    return scales[pair.name + field] ??= Math.max(...films[0].follows.map((_, instant) => largest_in(difference_at(pair, instant, field) ?? [])));
}
function say(text) {
    const pen = pen_on(canvas, 0.62);
    pen.fillStyle = colour("soft");
    pen.font = `${12 * (devicePixelRatio || 1)}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.fillText(text, canvas.width / 2, canvas.height / 2);
    where.textContent = "";
    bar.replaceChildren();
}

function paint(grid, values, scale) {
    const [n_x, n_y] = grid.n, share = value => (scale > 0 ? value / scale : 0);
    const rgb_of = value => signs[Math.round(127.5 * (1 + share(value)))];
    if (n_y === 1) {
        const pen = pen_on(canvas, 0.62), {width, height} = canvas, cell = width / n_x;
        values.forEach((value, i) => {
            if (Number.isNaN(value)) return;
            pen.fillStyle = `rgb(${rgb_of(value)})`;
            pen.fillRect(i * cell, height / 2, cell + 1, -0.45 * height * share(value));
        });
        pen.fillStyle = colour("text");
        pen.fillRect(0, height / 2, width, 1);
        return;
    }
    const image = element("canvas", {width: n_x, height: n_y}), pixels = new ImageData(n_x, n_y);
    const touched = new Set(grid.cells);
    values.forEach((value, c) => {
        if (Number.isNaN(value) || (value === 0 && !touched.has(c))) return;
        set_pixel(pixels.data, 4 * ((n_y - 1 - Math.floor(c / n_x)) * n_x + c % n_x), rgb_of(value));
    });
    image.getContext("2d").putImageData(pixels, 0, 0);
    const pen = pen_on(canvas, n_y * grid.spacing[1] / (n_x * grid.spacing[0]));
    pen.drawImage(image, 0, 0, canvas.width, canvas.height);
}

function show(instant) {
    figure.hidden = chosen.value === "";
    if (figure.hidden) return;
    const pair = pairs[chosen.value], field = part("field").value;
    title.textContent = pair.name;
    canvas.ariaLabel = `${pair.name}: ${names[field] ?? "no difference"} at the instant of the slider`;
    if (!names[field]) return say("stick and slip have no difference; choose another field");
    const values = difference_at(pair, instant, field);
    if (!values) return say("one of the two is not part of this run");
    const scale = scale_of(pair, field), place = place_of[field], unit = units[place];
    const steps = (pair.a.values[place] + pair.b.values[place]) * {pressure: 1 / 510, gap: 1 / 510, traction_x: 1 / 254, traction: Math.SQRT2 / 254}[field];
    paint(frame_of(pair), values, scale);
    where.textContent = `, ${names[field]}: up to ± ${words(largest_in(values), unit)} now, ± ${words(steps, unit)} being the rounding of what is played`;
    const ramp = element("span", {className: "ramp"});
    ramp.style.background = gradient(signs.filter((_, i) => i % 51 === 0));
    bar.replaceChildren(`−${words(scale, unit)}`, ramp, words(scale, unit));
}
return {show, chosen, pairs, difference_at};
};
