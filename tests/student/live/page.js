// The page under the mouse: asks a lesson's program for frames, and shows them pixel by pixel. What
// can be changed stands in what the program says of its scenes (common/run/live.h). Frames come from
// the `program` that another file defines: server.js has the one of `make live`.
"use strict";

const $ = id => document.getElementById(id);
const canvas = $("picture");
const context = canvas.getContext("2d");

// ---- What is shown ----

const ownTexts = {
    line: "size 100 100\nline 13 20 80 40 255 255 255\nline 20 13 40 80 255 0 0\n",
    triangle: "size 100 100\ntriangle 10 10 80 25 35 85 255 140 0\ntriangle 80 25 90 90 35 85 80 80 255\n",
};
let about = null;      // what the program says of itself
let version = -1;      // of the program, as built
let shown = null;      // the last frame: width, height, pixels, milliseconds, counters
let reference = null;  // the same of the reference, for the scene as in the lesson
let chosen = {};       // scene, values that differ from the scene's own, text
let view = "yours";
let drag = null;
let zoom = 0;          // screen pixels of a pixel; 0: fit
let center = null;     // the pixel in the middle of the canvas; null: that of the picture
let cursor = null;     // the pixel under the mouse

const OWN = "your own";
const sceneOf = name => about.scenes.find(scene => scene.name === name);
const isOwn = () => chosen.scene === OWN;
const valueOf = name => chosen[name] ?? sceneOf(chosen.scene)?.[name];
const isAsInLesson = () => !isOwn() && Object.keys(chosen).every(name => name === "scene");

// ---- The address keeps what is shown ----

function readAddress() {
    const given = new URLSearchParams(location.hash.slice(1));
    chosen = {scene: given.get("scene")};
    for (const name of ["light", "eye", "center", "up"]) {
        const numbers = (given.get(name) ?? "").split(",").map(Number);
        if (numbers.length === 3 && numbers.every(Number.isFinite)) {
            chosen[name] = numbers;
        }
    }
    for (const [name, text] of given) {
        if (!(name in chosen) && name !== "text" && Number.isFinite(Number(text))) {
            chosen[name] = Number(text);
        }
    }
    if (given.get("text")) {
        chosen.text = given.get("text");
    }
}

function writeAddress() {
    const kept = Object.entries(chosen).filter(([, value]) => value !== undefined);
    history.replaceState(null, "", "#" + new URLSearchParams(kept.map(([name, value]) => [name, `${value}`])));
}

// ---- Asking ----

const three = v => v.map(x => Number(x.toFixed(4))).join(",");

function request() {
    if (isOwn()) {
        return `--stats text\n${chosen.text.trimEnd()}\nend\n`;
    }
    const scene = sceneOf(chosen.scene);
    let words = `--stats --only ${scene.name}`;
    if (chosen.size) {
        const height = Math.max(1, Math.round(chosen.size * scene.height / scene.width));
        words += ` -s ${chosen.size}x${height}`;
    }
    for (const name of ["light", "eye", "center", "up"]) {
        words += chosen[name] ? ` --${name} ${three(chosen[name])}` : "";
    }
    for (const value of scene.values ?? []) {
        const set = chosen[value.name];
        words += set === undefined ? "" : ` --set ${value.name}=${set}`;
    }
    return words + (chosen.frame ? ` --frame ${chosen.frame}` : "") + "\n";
}

// "frame W H MS COUNT", COUNT lines, pixels; or "error MESSAGE".
function parseFrame(bytes) {
    let at = 0;
    const line = () => {
        const end = bytes.indexOf(10, at);
        const text = new TextDecoder().decode(bytes.subarray(at, end < 0 ? bytes.length : end));
        at = end < 0 ? bytes.length : end + 1;
        return text;
    };
    const head = line();
    if (!head.startsWith("frame ")) {
        return {error: head.replace(/^error /, "")};
    }
    const [width, height, milliseconds, count] = head.split(" ").slice(1).map(Number);
    const counters = Array.from({length: count}, () => line().split(" "));
    const pixels = new Uint8ClampedArray(bytes.subarray(at, at + 4 * width * height));
    return {width, height, milliseconds, counters, pixels};
}

let asking = false, again = false;

// One question at a time; what changes meanwhile is asked once, after it.
async function ask() {
    if (asking) {
        again = true;
        return;
    }
    asking = true;
    do {
        again = false;
        try {
            const frame = parseFrame(await program.frame(request()));
            if (frame.error) {
                say(frame.error);
            } else {
                shown = frame;
                say(buildMessage);
            }
        } catch (error) {
            say(error.message);
        }
        paint();
    } while (again);
    asking = false;
}

let buildMessage = "";

function say(text) {
    $("message").hidden = text === "";
    if ($("message").textContent !== text) {
        $("message").textContent = text;
    }
}

async function lookForChanges() {
    try {
        const state = await program.state();
        buildMessage = state.message;
        if (state.version !== version || !about) {
            version = state.version;
            if (state.program) {
                about = state.program;
                document.title = $("title").textContent = state.step;
                build();
            }
            say(buildMessage);
            if (about) {
                ask();
            }
        }
    } catch (error) {
        say(error.message);
    }
    setTimeout(lookForChanges, 500);
}

// ---- The reference ----

async function readReference() {
    reference = null;
    if (!isAsInLesson() || !program.reference) {
        return;
    }
    const scene = chosen.scene;
    const image = new Image();
    image.src = program.reference(scene);
    try {
        await image.decode();
    } catch {
        return;
    }
    const copy = new OffscreenCanvas(image.width, image.height).getContext("2d");
    copy.drawImage(image, 0, 0);
    if (chosen.scene === scene && isAsInLesson()) {
        reference = {width: image.width, height: image.height,
                     pixels: copy.getImageData(0, 0, image.width, image.height).data};
        paint();
    }
}

const colorAt = (frame, x, y) => frame && x >= 0 && y >= 0 && x < frame.width && y < frame.height
    ? [...frame.pixels.subarray(4 * (y * frame.width + x), 4 * (y * frame.width + x) + 3)] : null;

// As make check draws it: the reference, dark, and what differs in red.
function difference() {
    const pixels = new Uint8ClampedArray(shown.pixels.length);
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
        const differs = [0, 1, 2].some(k => shown.pixels[i + k] !== reference.pixels[i + k]);
        count += differs;
        pixels.set(differs ? [255, 0, 0, 255]
                           : [...reference.pixels.subarray(i, i + 3)].map(c => c / 4).concat(255), i);
    }
    return {width: shown.width, height: shown.height, pixels, count};
}

// ---- Painting ----

const sameSize = () => reference && shown && reference.width === shown.width && reference.height === shown.height;

function visible() {
    if (view === "reference" && reference) {
        return reference;
    }
    return view === "difference" && sameSize() ? difference() : shown;
}

// Where pixel (x,y), counted from the top left, is on the canvas.
function place(frame) {
    const size = zoom || Math.min(canvas.width / frame.width, canvas.height / frame.height);
    const middle = (zoom && center) || [frame.width / 2, frame.height / 2];
    return {size, left: canvas.width / 2 - middle[0] * size, top: canvas.height / 2 - middle[1] * size};
}

function paint() {
    const frame = shown && visible();
    if (!frame) {
        return;
    }
    canvas.width = canvas.clientWidth * devicePixelRatio;
    canvas.height = canvas.clientHeight * devicePixelRatio;
    const {size, left, top} = place(frame);
    const copy = new OffscreenCanvas(frame.width, frame.height);
    copy.getContext("2d").putImageData(new ImageData(frame.pixels, frame.width, frame.height), 0, 0);
    context.imageSmoothingEnabled = size < 1;
    context.drawImage(copy, left, top, frame.width * size, frame.height * size);
    if (size >= 8 * devicePixelRatio) {
        paintGrid(frame, size, left, top);
    }
    if (isOwn()) {
        paintHandles(size, left, top);
    }
    describe(frame);
}

function paintGrid(frame, size, left, top) {
    const from = [Math.max(0, Math.floor(-left / size)), Math.max(0, Math.floor(-top / size))];
    const to = [Math.min(frame.width, Math.ceil((canvas.width - left) / size)),
                Math.min(frame.height, Math.ceil((canvas.height - top) / size))];
    context.strokeStyle = "#8888";
    context.font = `${Math.floor(size / 4)}px monospace`;
    context.textAlign = "center";
    for (let y = from[1]; y < to[1]; y++) {
        for (let x = from[0]; x < to[0]; x++) {
            context.strokeRect(left + x * size, top + y * size, size, size);
            if (size >= 32 * devicePixelRatio) {
                const color = colorAt(frame, x, y);
                context.fillStyle = color[0] + color[1] + color[2] > 380 ? "#000" : "#fff";
                color.forEach((value, i) =>
                    context.fillText(value, left + (x + .5) * size, top + (y + .3 + .27 * i) * size));
            }
        }
    }
}

// The numbers below the picture, and those that were counted.
function describe(frame) {
    const lines = [`${shown.width}x${shown.height} pixels, ${shown.milliseconds.toFixed(1)} ms`];
    if (view === "difference" && frame.count !== undefined) {
        lines.push(`${frame.count} pixels differ from the reference`);
    } else if (!reference && view !== "yours") {
        lines.push("no reference: not as in the lesson");
    }
    if (cursor) {
        const [x, y] = cursor, mine = colorAt(shown, x, y), right = sameSize() && colorAt(reference, x, y);
        lines.push(`(${x},${shown.height - 1 - y}) ${mine}` + (right ? `, reference ${right}` : ""));
    }
    $("pixel").textContent = lines.join("\n");
    $("zoom").textContent = zoom ? `${zoom}x` : "fit";
    const counters = $("counters");
    counters.replaceChildren(...shown.counters.flatMap(([name, value]) => {
        const term = document.createElement("dt"), number = document.createElement("dd");
        term.textContent = name.replaceAll("_", " ");
        number.textContent = Number(value).toLocaleString("en");
        return [term, number];
    }));
}

// ---- Corners of a scene of one's own ----

// Of each line `line` or `triangle`: which words are x and y of its corners.
function corners() {
    return chosen.text.split("\n").flatMap((line, row) => {
        const words = line.trim().split(/\s+/), count = {line: 2, triangle: 3}[words[0]] ?? 0;
        return Array.from({length: count}, (_, i) => ({row, word: 1 + 2 * i, x: Number(words[1 + 2 * i]),
                                                       y: Number(words[2 + 2 * i])}));
    });
}

const cornerPlace = (corner, size, left, top) =>
    [left + (corner.x + .5) * size, top + (shown.height - .5 - corner.y) * size];

function paintHandles(size, left, top) {
    for (const corner of corners()) {
        const [x, y] = cornerPlace(corner, size, left, top);
        context.beginPath();
        context.arc(x, y, 7 * devicePixelRatio, 0, 2 * Math.PI);
        context.lineWidth = 2 * devicePixelRatio;
        context.strokeStyle = "#fff";
        context.stroke();
        context.strokeStyle = "#2a6fdb";
        context.setLineDash([4, 4]);
        context.stroke();
        context.setLineDash([]);
    }
}

function moveCorners(held, x, y) {
    const lines = chosen.text.split("\n"), whole = about.text === "line";
    const round = value => whole ? Math.round(value) : Math.round(8 * value) / 8;
    for (const {row, word} of held) {
        const words = lines[row].trim().split(/\s+/);
        words[word] = round(x);
        words[word + 1] = round(y);
        lines[row] = words.join(" ");
    }
    chosen.text = $("text").value = lines.join("\n");
}

// ---- Turning ----

const minus = (a, b) => a.map((x, i) => x - b[i]);
const length = v => Math.hypot(...v);

// The vector turned by so much about the vertical, and up or down, but not beyond.
function turned(v, right, up) {
    const size = length(v), latitude = Math.asin(v[1] / size), longitude = Math.atan2(v[0], v[2]);
    const limit = 89 * Math.PI / 180, most = Math.max(-limit, Math.min(limit, latitude + up));
    return [size * Math.cos(most) * Math.sin(longitude + right), size * Math.sin(most),
            size * Math.cos(most) * Math.cos(longitude + right)];
}

function turn(right, up) {
    if (drag === "light") {
        chosen.light = turned(valueOf("light"), right, up);
    } else if (drag === "camera") {
        const middle = valueOf("center");
        chosen.eye = turned(minus(valueOf("eye"), middle), -right, -up).map((x, i) => x + middle[i]);
        chosen.center = middle;
    } else {
        return false;
    }
    changed();
    return true;
}

function changed() {
    writeAddress();
    reference = isAsInLesson() ? reference : null;
    $("own").hidden = !isOwn();
    ask();
}

// ---- Mouse and touch ----

const pixelAt = event => {
    const {size, left, top} = place(visible());
    const box = canvas.getBoundingClientRect();
    return [((event.clientX - box.left) * devicePixelRatio - left) / size,
            ((event.clientY - box.top) * devicePixelRatio - top) / size];
};

let held = null;

canvas.addEventListener("pointerdown", event => {
    if (!shown) {
        return;
    }
    const at = pixelAt(event), {size, left, top} = place(visible());
    held = {x: event.clientX, y: event.clientY, corners: []};
    if (isOwn()) {
        const near = corner => {
            const [x, y] = cornerPlace(corner, size, left, top);
            return Math.hypot(x - (left + at[0] * size), y - (top + at[1] * size)) < 16 * devicePixelRatio;
        };
        const first = corners().find(near);
        held.corners = first ? corners().filter(corner => corner.x === first.x && corner.y === first.y) : [];
    }
    canvas.setPointerCapture(event.pointerId);
});

canvas.addEventListener("pointermove", event => {
    if (!shown) {
        return;
    }
    const at = pixelAt(event);
    cursor = at.map(Math.floor);
    if (held?.corners.length > 0) {
        moveCorners(held.corners, at[0] - .5, shown.height - .5 - at[1]);
        changed();
    } else if (held) {
        const dx = event.clientX - held.x, dy = event.clientY - held.y;
        held.x = event.clientX;
        held.y = event.clientY;
        if (!turn(dx / 150, -dy / 150) && zoom) {
            const {size} = place(visible());
            const middle = center ?? [shown.width / 2, shown.height / 2];
            center = [middle[0] - dx * devicePixelRatio / size, middle[1] - dy * devicePixelRatio / size];
        }
    }
    paint();
});

for (const name of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(name, () => { held = null; });
}
canvas.addEventListener("pointerleave", () => { cursor = null; paint(); });

function enlarge(by, at) {
    const fit = place(visible()).size;
    const next = zoom ? zoom * by : Math.max(1, 2 ** Math.floor(Math.log2(fit)) * (by > 1 ? 2 : 1));
    if (!zoom && by < 1) {
        return;
    }
    center = at ?? center ?? [shown.width / 2, shown.height / 2];
    zoom = next < 1 || next < fit / 4 ? 0 : Math.min(64, next);
    paint();
}

canvas.addEventListener("wheel", event => {
    event.preventDefault();
    if (shown) {
        enlarge(event.deltaY < 0 ? 2 : .5, pixelAt(event));
    }
}, {passive: false});

// ---- Keys ----

const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

canvas.addEventListener("keydown", event => {
    const arrow = arrows[event.key];
    if (arrow && shown) {
        event.preventDefault();
        if (isOwn()) {
            const all = corners(), first = all[0];
            moveCorners(all.filter(c => c.x === first.x && c.y === first.y), first.x + arrow[0], first.y + arrow[1]);
            changed();
        } else if (!turn(arrow[0] / 10, arrow[1] / 10)) {
            const middle = center ?? [shown.width / 2, shown.height / 2];
            center = [middle[0] + arrow[0], middle[1] - arrow[1]];
            paint();
        }
    } else if (event.key === "+" || event.key === "-") {
        enlarge(event.key === "+" ? 2 : .5);
    }
});

// ---- Controls ----

function buttons(parent, names, current, choose) {
    parent.replaceChildren(...names.map(name => {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = name;
        button.setAttribute("aria-pressed", name === current);
        button.addEventListener("click", () => {
            choose(name);
            [...parent.children].forEach(other =>
                other.setAttribute("aria-pressed", other === button));
        });
        return button;
    }));
}

function slider(name, value, least, most, step, change) {
    const label = document.createElement("label"), input = document.createElement("input");
    const output = document.createElement("output");
    Object.assign(input, {type: "range", min: least, max: most, step, value});
    output.textContent = value;
    input.addEventListener("input", () => {
        output.textContent = input.value;
        change(Number(input.value));
    });
    label.append(`${name} `, output, input);
    return label;
}

// What this scene lets one change.
function buildControls() {
    const scene = sceneOf(chosen.scene);
    const drags = isOwn() ? ["corners"] : ["picture", scene.light && "light", scene.eye && "camera"].filter(Boolean);
    drag = drags.includes(drag) ? drag : drags[drags.length - 1];
    buttons($("drags"), drags, drag, name => { drag = name; });
    $("values").replaceChildren($("values").firstElementChild);
    $("values").hidden = true;
    if (!isOwn() && scene.frames > 1) {
        $("values").append(slider("frame", chosen.frame ?? 1, 1, scene.frames, 1, value => {
            chosen.frame = value;
            changed();
        }));
        $("values").hidden = false;
    }
    for (const value of (!isOwn() && scene.values) || []) {
        $("values").append(slider(value.help, chosen[value.name] ?? value.value, value.least, value.most,
                                  value.step, number => {
            chosen[value.name] = number;
            changed();
        }));
        $("values").hidden = false;
    }
    const sizes = isOwn() ? [] : [...new Set([scene.width, 100, 200, 400, 800])].sort((a, b) => a - b);
    $("size").replaceChildren(...sizes.map(size => new Option(size, size, false, size === (chosen.size ?? scene.width))));
    $("own").hidden = !isOwn();
    $("text").value = chosen.text ?? "";
}

function chooseScene(name) {
    chosen = {scene: name, ...(name === OWN && {text: ownTexts[about.text]})};
    center = null;
    buildControls();
    writeAddress();
    readReference();
    ask();
}

function build() {
    const names = about.scenes.map(scene => scene.name).concat(about.text ? [OWN] : []);
    if (!names.includes(chosen.scene)) {
        chosen = {scene: names[0]};
    }
    if (isOwn() && !chosen.text) {
        chosen.text = ownTexts[about.text];
    }
    buttons($("scenes"), names, chosen.scene, chooseScene);
    $("views").parentElement.hidden = !program.reference;
    buttons($("views"), ["yours", "reference", "difference"], view, name => { view = name; paint(); });
    buildControls();
    readReference();
}

$("text").addEventListener("input", () => { chosen.text = $("text").value; changed(); });
$("size").addEventListener("change", () => { chosen.size = Number($("size").value); changed(); });
$("reset").addEventListener("click", () => chooseScene(chosen.scene));
$("larger").addEventListener("click", () => shown && enlarge(2));
$("smaller").addEventListener("click", () => shown && enlarge(.5));
$("controls").addEventListener("submit", event => event.preventDefault());
new ResizeObserver(paint).observe(canvas);
readAddress();
lookForChanges();
