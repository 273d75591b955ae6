// The contact in three dimensions, in the page of player.js: the surface of the substrate raised by
// its displacement, in the colours of the field that is chosen there, and the indenter over it.
// esbuild puts what it takes from three.js in front of it.

import {
    BufferAttribute, BufferGeometry, CanvasTexture, Color, DirectionalLight, DoubleSide, HemisphereLight, Mesh,
    MeshLambertMaterial, PerspectiveCamera, Scene, SRGBColorSpace, WebGLRenderer,
} from "three";

const texture_width = 1024;
const magnifications = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const first_view = {azimuth: -1.0, elevation: 0.55, distance: 1};

// Triangles between the points of a grid that are `known`.
function triangles(n_x, n_y, known = () => true) {
    const index = [];
    for (let j = 0; j + 1 < n_y; ++j)
        for (let i = 0; i + 1 < n_x; ++i) {
            const a = j * n_x + i, b = a + 1, c = a + n_x, d = c + 1;
            if ([a, b, c, d].every(known)) index.push(a, b, d, a, d, c);
        }
    return index;
}

// A grid of points [mm], all at height 0.
function grid_geometry({n: [n_x, n_y], first, spacing}, known) {
    const place = new Float32Array(3 * n_x * n_y), share = new Float32Array(2 * n_x * n_y);
    for (let k = 0; k < n_x * n_y; ++k) {
        const i = k % n_x, j = Math.floor(k / n_x);
        place[3 * k] = first[0] + i * spacing[0];
        place[3 * k + 1] = first[1] + j * spacing[1];
        share[2 * k] = i / (n_x - 1), share[2 * k + 1] = j / (n_y - 1);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(place, 3));
    geometry.setAttribute("uv", new BufferAttribute(share, 2));
    geometry.setIndex(triangles(n_x, n_y, known));
    return geometry;
}
function set_heights(geometry, height_of) {
    const {position} = geometry.attributes;
    for (let k = 0; k < position.count; ++k) position.setZ(k, height_of(k));
    position.needsUpdate = true;
    geometry.computeVertexNormals();
    geometry.computeBoundingSphere();
}

// The steps of a length scale: 1, 2 or 5 times a power of ten, some ten of them to a width.
function fitting_step(width) {
    const ten = 10 ** Math.floor(Math.log10(width / 10));
    return [1, 2, 5, 10].map(k => k * ten).find(step => width / step <= 12);
}

// Substrate and texture of a film.
class Substrate {
    constructor(film) {
        this.film = film;
        this.geometry = grid_geometry(film.relief);
        const {n: [n_x, n_y], spacing, first} = film.relief;
        this.width = (n_x - 1) * spacing[0], this.depth = (n_y - 1) * spacing[1];
        this.first = first;
        this.picture = document.createElement("canvas");
        this.picture.width = texture_width;
        this.picture.height = Math.max(1, Math.round(texture_width * this.depth / this.width));
        this.texture = new CanvasTexture(this.picture);
        this.texture.colorSpace = SRGBColorSpace;
        this.texture.anisotropy = 8;
        this.mesh = new Mesh(this.geometry, new MeshLambertMaterial({map: this.texture, side: DoubleSide}));
    }
    centre() {
        return [this.first[0] + this.width / 2, this.first[1] + this.depth / 2];
    }
    height(frame, k) {  // [mm]
        const {n: [n_x, n_y], heights, range: [low, high]} = this.film.relief;
        return (low + (high - low) * heights[frame * n_x * n_y + k] / 65535) / 1000;
    }
    show(frame, magnification, colours) {
        set_heights(this.geometry, k => magnification * this.height(frame, k));
        const pen = this.picture.getContext("2d"), {width, height} = this.picture;
        const scale = width / this.width;
        pen.fillStyle = colours.ground;
        pen.fillRect(0, 0, width, height);
        pen.strokeStyle = colours.lines;
        pen.lineWidth = 1.5;
        pen.beginPath();
        const step = fitting_step(this.width);
        for (let x = Math.ceil(this.first[0] / step) * step; x <= this.first[0] + this.width; x += step)
            pen.moveTo((x - this.first[0]) * scale, 0), pen.lineTo((x - this.first[0]) * scale, height);
        for (let y = Math.ceil(this.first[1] / step) * step; y <= this.first[1] + this.depth; y += step)
            pen.moveTo(0, height - (y - this.first[1]) * scale), pen.lineTo(width, height - (y - this.first[1]) * scale);
        pen.stroke();
        // The picture of the player, arrows included.
        const {canvas, first, spacing, n} = this.film;
        pen.drawImage(canvas, (first[0] - spacing[0] / 2 - this.first[0]) * scale,
                      height - (first[1] + (n[1] - 0.5) * spacing[1] - this.first[1]) * scale,
                      n[0] * spacing[0] * scale, n[1] * spacing[1] * scale);
        this.texture.needsUpdate = true;
    }
}

// The undeformed indenter; its lowest point is the mesh's origin.
class Body {
    constructor(body) {
        this.body = body;
        this.geometry = grid_geometry(body, k => body.heights[k] < 65535);
        // Behind the surface where both are at one place.
        this.mesh = new Mesh(this.geometry, new MeshLambertMaterial({
            color: 0x7a8a99, side: DoubleSide, transparent: true, opacity: 0.45, depthWrite: false,
            polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2}));
    }
    show({x, y, depth, rotation}, magnification) {
        const {heights, highest} = this.body;
        set_heights(this.geometry,
                    k => magnification * (highest * Math.min(heights[k], 65534) / 65534 - depth) / 1000);
        this.mesh.position.set(x, y, 0);
        this.mesh.rotation.z = rotation ?? 0;
    }
}

// What turns the view: mouse, fingers, keys, wheel.
function orbit(canvas, view, redraw) {
    const pointers = new Map();
    function turn(across, up) {
        view.azimuth += across;
        view.elevation = Math.min(1.55, Math.max(-0.3, view.elevation + up));
        redraw();
    }
    function zoom(factor) {
        view.distance = Math.min(4, Math.max(0.25, view.distance * factor));
        redraw();
    }
    const spread = () => {
        const [a, b] = [...pointers.values()];
        return Math.hypot(a.x - b.x, a.y - b.y);
    };
    canvas.addEventListener("pointerdown", event => {
        canvas.setPointerCapture?.(event.pointerId);
        pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    });
    canvas.addEventListener("pointermove", event => {
        const before = pointers.get(event.pointerId);
        if (!before) return;
        const wide = pointers.size === 2 ? spread() : 0;
        pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
        if (pointers.size === 1) turn((before.x - event.clientX) / 150, (event.clientY - before.y) / 150);
        else if (wide && spread()) zoom(wide / spread());
    });
    for (const end of ["pointerup", "pointercancel"])
        canvas.addEventListener(end, event => pointers.delete(event.pointerId));
    // A wheel that turns over a view that nobody has chosen moves the page.
    canvas.addEventListener("wheel", event => {
        if (document.activeElement !== canvas) return;
        event.preventDefault();
        zoom(Math.exp(event.deltaY / 500));
    }, {passive: false});
    const keys = {
        ArrowLeft: () => turn(0.1, 0), ArrowRight: () => turn(-0.1, 0), ArrowUp: () => turn(0, 0.1),
        ArrowDown: () => turn(0, -0.1), "+": () => zoom(0.9), "-": () => zoom(1 / 0.9),
        Home: () => { Object.assign(view, first_view); redraw(); },
    };
    canvas.addEventListener("keydown", event => {
        if (!keys[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        keys[event.key]();
    });
}

// Builds the view into `place`; show(instant) draws it. Throws where there is no WebGL.
globalThis.contact_scene = ({place, films, body, colour, element, redraw}) => {
    const canvas = element("canvas", {tabIndex: 0, className: "scene_view"});
    canvas.setAttribute("role", "img");
    // Three.js tells the console what it then throws.
    if (!element("canvas").getContext("webgl2")) throw new Error("it has no WebGL 2.");
    const renderer = new WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    const scene = new Scene(), camera = new PerspectiveCamera(35, 1.6, 0.01, 1000);
    camera.up.set(0, 0, 1);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(-1, -0.6, 2);
    scene.add(new HemisphereLight(0xffffff, 0x999999, 2), sun);
    const indenter = new Body(body), substrates = films.map(film => new Substrate(film));
    const view = {...first_view};
    scene.add(indenter.mesh);

    const chosen = element("select", {id: "player_scene_film"},
                           films.map((film, i) => element("option", {value: i, textContent: film.name})));
    // The most complete model is the last one.
    chosen.value = films.length - 1;
    const scale = element("select", {id: "player_scene_scale"},
                          magnifications.map(m => element("option", {value: m, textContent: `× ${m}`})));
    const substrate = () => substrates[chosen.value];
    function fit_scale() {
        const {film: {relief: {range: [low, high]}}, width} = substrate();
        const wanted = 0.16 * width / Math.max((high - low) / 1000, 1e-9);
        scale.value = magnifications.filter(m => m <= wanted).at(-1) ?? 1;
    }
    fit_scale();
    const with_body = element("input", {type: "checkbox", id: "player_scene_body", checked: true});
    const controls = element("div", {className: "controls"}, [
        element("label", {}, ["Model ", chosen]), element("label", {}, ["Heights ", scale]),
        element("label", {}, [with_body, " indenter"])]);
    const words = element("p", {className: "instant"});
    place.replaceChildren(controls, canvas, words, element("p", {className: "note", textContent:
        "Drag to turn the view, pinch to enlarge it; after a click the wheel does too. By keyboard: the arrow " +
        "keys turn it, + and − enlarge and reduce it, Home brings back the first one."}));

    let instant = 0;
    function draw() {
        const {width: long} = substrate(), [x, y] = substrate().centre();
        const width = canvas.clientWidth, height = Math.round(Math.min(0.62 * width, 560));
        if (!width) return;
        renderer.setPixelRatio(devicePixelRatio || 1);
        renderer.setSize(width, height, false);
        canvas.style.height = `${height}px`;
        camera.aspect = width / height;
        const far = view.distance * 2.1 * long;
        camera.position.set(x + far * Math.cos(view.elevation) * Math.cos(view.azimuth),
                            y + far * Math.cos(view.elevation) * Math.sin(view.azimuth),
                            far * Math.sin(view.elevation));
        camera.near = far / 100, camera.far = 10 * far;
        camera.lookAt(x, y, 0);
        camera.updateProjectionMatrix();
        renderer.render(scene, camera);
    }
    function show(now) {
        instant = now;
        const {film} = substrate(), place_of = film.follows[now], frame = film.frames[place_of];
        const magnification = Number(scale.value);
        for (const each of substrates) scene.remove(each.mesh);
        indenter.mesh.visible = with_body.checked && frame !== undefined;
        if (!frame) {
            words.textContent = `${film.name}: not part of this run`;
            return draw();
        }
        scene.add(substrate().mesh);
        const ground = new Color(colour("line"));
        substrate().show(place_of, magnification,
                         {ground: `#${ground.getHexString()}`, lines: colour("soft")});
        indenter.show(frame, magnification);
        words.textContent = `${film.name}, ${frame.label}: heights × ${magnification}, lines every ` +
            `${Number(fitting_step(substrate().width).toPrecision(1))} mm; the indenter’s lowest point is ` +
            `${frame.depth.toPrecision(3)} µm below the undeformed surface`;
        canvas.ariaLabel = `The contact in three dimensions. ${words.textContent}. Arrow keys turn the view.`;
        draw();
    }
    chosen.addEventListener("change", () => { fit_scale(); redraw(); });
    for (const input of [scale, with_body]) input.addEventListener("change", () => show(instant));
    orbit(canvas, view, draw);
    return {show};
};
