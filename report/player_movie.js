"use strict";
// Records what the player shows as a movie: its pictures and captions on one canvas, an instant after the other, by the
// browser's own recorder. See player.js.

const player_movie = (() => {
const line_height = 18, margin = 16;  // CSS px
const formats = [["video/webm;codecs=vp9", "webm"], ["video/webm", "webm"], ["video/mp4", "mp4"]];
const later = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
const is_shown = part => part.getClientRects().length > 0;

// A text in lines of at most that width.
function write(pen, text, x, y, width) {
    let line = "";
    for (const word of text.split(" ")) {
        const longer = line ? `${line} ${word}` : word;
        if (line && pen.measureText(longer).width > width) {
            pen.fillText(line, x, y);
            [line, y] = [word, y + line_height];
        } else line = longer;
    }
    pen.fillText(line, x, y);
}

// The colour bar: words, states as squares, ramps as gradients.
function draw_bar(pen, bar, x, y, ink) {
    for (const node of bar.childNodes) {
        if (node.nodeType === Node.TEXT_NODE) {
            pen.fillStyle = ink;
            pen.fillText(node.textContent, x, y);
            x += pen.measureText(node.textContent).width + 8;
            continue;
        }
        const {backgroundImage, backgroundColor} = getComputedStyle(node), stops = backgroundImage.match(/rgb\([^)]*\)/g);
        const width = stops ? 160 : 12;
        pen.fillStyle = backgroundColor;
        if (stops) {
            pen.fillStyle = pen.createLinearGradient(x, 0, x + width, 0);
            stops.forEach((colour, i) => pen.fillStyle.addColorStop(i / (stops.length - 1), colour));
        }
        pen.fillRect(x, y - 11, width, 12);
        x += width + 8;
    }
}

// A canvas as large as the pictures that `root` shows, and what draws them on it.
function stage_of(root, label, bar) {
    const pictures = [...root.querySelectorAll("canvas")].filter(is_shown);
    const captions = [...root.querySelectorAll("figcaption")].filter(is_shown);
    const box_of = part => {  // from the corner of `root`, wherever the page is scrolled to
        const {left, top} = root.getBoundingClientRect(), box = part.getBoundingClientRect();
        return {x: box.left - left, y: box.top - top, width: box.width, height: box.height};
    };
    const boxes = [...pictures, ...captions].map(box_of), above = 2 * line_height + 2 * margin;
    const left = Math.min(...boxes.map(({x}) => x)) - margin, top = Math.min(...boxes.map(({y}) => y)) - above;
    const width = Math.max(...boxes.map(box => box.x + box.width)) + margin - left;
    const height = Math.max(...boxes.map(box => box.y + box.height)) + margin - top;
    const ratio = devicePixelRatio || 1, even = length => 2 * Math.ceil(length * ratio / 2);  // as encoders want them
    const stage = document.createElement("canvas");
    [stage.width, stage.height] = [even(width), even(height)];
    const pen = stage.getContext("2d");
    function draw() {
        const {color, fontFamily} = getComputedStyle(root);
        pen.setTransform(ratio, 0, 0, ratio, 0, 0);
        pen.fillStyle = getComputedStyle(document.body).backgroundColor;
        pen.fillRect(0, 0, stage.width, stage.height);
        pen.font = `14px ${fontFamily}`;
        pen.fillStyle = color;
        pen.fillText(label.textContent, margin, margin + line_height / 2);
        draw_bar(pen, bar, margin, margin + 1.8 * line_height, color);
        for (const picture of pictures) {
            const box = box_of(picture);
            pen.drawImage(picture, box.x - left, box.y - top, box.width, box.height);
        }
        pen.fillStyle = color;
        for (const caption of captions) {
            const box = box_of(caption);
            write(pen, caption.textContent, box.x - left, box.y - top + line_height, box.width);
        }
    }
    return {stage, draw};
}

// The movie of n instants that show(k) brings up one after another, as {blob, ending}. Throws where the browser records
// none.
async function record({root, label, bar, n, show, rate}) {
    const format = window.MediaRecorder && formats.find(([type]) => MediaRecorder.isTypeSupported(type));
    if (!format) throw new Error("it has no MediaRecorder");
    show(0);
    const {stage, draw} = stage_of(root, label, bar);
    const stream = stage.captureStream(0), [track] = stream.getVideoTracks(), parts = [];
    const recorder = new MediaRecorder(stream, {mimeType: format[0], videoBitsPerSecond: 8e6});
    recorder.addEventListener("dataavailable", event => parts.push(event.data));
    const stopped = new Promise(resolve => recorder.addEventListener("stop", resolve));
    recorder.start();
    for (let k = 0; k <= n; ++k) {  // the last one twice: a frame lasts until the next
        show(Math.min(k, n - 1));
        draw();
        track.requestFrame();
        await later(1000 / rate);
    }
    recorder.stop();
    await stopped;
    return {blob: new Blob(parts, {type: format[0]}), ending: format[1]};
}

return {record};
})();
