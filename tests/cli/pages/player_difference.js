// The differences of the player of reports, on films of Hertz' pressure whose difference is known.
// usage: player_difference.js SOURCE_DIR
const fs = require("fs"), assert = require("assert");
const made = () => ({append() {}, after() {}, replaceChildren() {}, setAttribute() {}, closest: made, style: {}});
(0, eval)(fs.readFileSync(process.argv[2] + "/report/player_difference.js", "utf8"));

const hertz = (r, a) => Math.sqrt(Math.max(0, 1 - (r / a) ** 2));  // Johnson (1985), 3.39, over p_0
// A film of one frame with Hertz' pressure p_0, half of it as traction along -x, and no gap; contact radius a [mm].
function film({name, line = "", n, first, spacing, p_0, a}) {
    const cells = [], fields = [[], [], [], [], []];
    for (let c = 0; c < n[0] * n[1]; ++c) {
        const x = first[0] + (c % n[0]) * spacing[0], y = n[1] > 1 ? first[1] + Math.floor(c / n[0]) * spacing[1] : 0;
        const p = hertz(Math.hypot(x - 1, y), a);
        if (p === 0) continue;
        cells.push(c);
        fields[0].push(Math.round(255 * p));
        fields[1].push(128 - Math.round(127 * p));
        fields[2].push(128), fields[3].push(0), fields[4].push(1);
    }
    return {name, line, n, first, spacing, cells, fields, follows: [0, -1], frames: [{x: 1, y: 0}],
            values: [p_0, p_0 / 2, 0, 0], canvas: made()};
}
const grid = (n, rest) => ({n: [n, n], spacing: [6 / (n - 1), 6 / (n - 1)], first: [-2, -3], ...rest});
const springs = film({name: "springs", line: "springs", n: [3001, 1], spacing: [0.002, 0.002], first: [-2, 0], p_0: 3e5, a: 2});
const coarse = film(grid(61, {name: "coarse", p_0: 2e5, a: 2})), fine = film(grid(121, {name: "fine", p_0: 3e5, a: 1.5}));
const films = [springs, coarse, fine];
const {pairs, difference_at} = globalThis.player_difference({
    films, part: made, element: (_, properties) => Object.assign(made(), properties), fields_of: one => one.fields,
    signs: [], gradient: String, pen_on: made, set_pixel() {}, colour: String});
assert.deepStrictEqual(pairs.map(({name}) => name).sort(), ["coarse minus springs", "fine minus coarse", "fine minus springs"]);

let n_checked = 0;
for (const {a, b, name} of pairs) {
    const on = [a, b].filter(({n}) => n[1] > 1).reduce((one, other) => (other.spacing[0] < one.spacing[0] ? other : one));
    for (const [field, sign, steps] of [["pressure", 1, 255], ["traction_x", -0.5, 127], ["traction", 0.5, 127]]) {
        const values = difference_at({a, b}, 0, field);
        assert.strictEqual(values.length, on.n[0] * on.n[1], name);
        values.forEach((value, c) => {
            const x = on.first[0] + (c % on.n[0]) * on.spacing[0], y = on.first[1] + Math.floor(c / on.n[0]) * on.spacing[1];
            const r = Math.hypot(x - 1, y);
            // Near an edge the root of the pressure is no straight line between the points of the coarser grid.
            if (r > 1.2 && r < 2.2) return;
            const [of_a, of_b] = [[a, 1], [b, 1]].map(([one]) => sign * one.values[0] * hertz(r, one === fine ? 1.5 : 2));
            // Half a step of either, and what a chord of the coarser grid misses: h^2/8 p'' < 0.1^2/8 1/(a^2 0.6^3) p_0.
            const allowed = (Math.abs(sign) * (a.values[0] + b.values[0])) * (0.5 / steps + 0.0026);
            assert(Math.abs(value - (of_a - of_b)) <= allowed, `${name}, ${field} at r = ${r}: ${value}, ${of_a - of_b}`);
            ++n_checked;
        });
    }
    assert(Number.isNaN(difference_at({a, b}, 0, "gap")[0]), "a gap where none is kept");
    assert.strictEqual(difference_at({a, b}, 1, "pressure"), null);
}
assert(n_checked > 20000);
