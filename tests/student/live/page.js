// The page under the mouse: asks a lesson's program for frames, and shows them pixel by pixel. What
// can be changed is in what the program says of its scenes (common/run/live.h). Frames come from
// the `program` that another file defines: server.js has the one of `make live`.
"use strict";

const $ = id => document.getElementById(id);
const canvas = $("picture");
const context = canvas.getContext("2d");

// ---- What is shown ----

let about = null;      // what the program says of itself
let version = -1;      // of the program, as built
let shown = null;      // the last frame: width, height, pixels, milliseconds, counters
let reference = null;  // the same of the reference: the scene as in the lesson
let told = null;       // and of their difference, where the program has a picture of it
let plain = null;      // the same scene without its modes, in their place
let chosen = {};       // scene, values that differ from the scene's own, text
let view = "yours";
let drag = null;
let zoom = 0;          // screen pixels of a pixel; 0: fit
let center = null;     // the pixel in the middle of the canvas; null: that of the picture
let cursor = null;     // the pixel under the mouse
let point = 0;         // which of the points the arrows move

const scene = () => about.scenes.find(scene => scene.name === chosen.scene);
const isOwn = () => scene().text !== undefined;
const textOf = () => chosen.text ?? scene().text;
const valueOf = name => chosen[name] ?? scene()[name] ??
    scene().values?.find(value => value.name === name)?.value;

// Where the help of a value names each of its numbers ("0 flat, 1 smooth"), these names. Such a value,
// and one of two, is a mode: what it changes is compared with the same scene without it.
function namesOf({help, least, most}) {
    const names = help.split(", ").map((part, i) => part.startsWith(`${least + i} `) && part.slice(`${least + i} `.length));
    return names.length === most - least + 1 && names.every(Boolean) ? names : null;
}
const isMode = value => namesOf(value) !== null || value.most - value.least === value.step;
const modes = () => (scene().values ?? []).filter(isMode);
const chosenModes = () => modes().filter(({name, value}) => valueOf(name) !== value).map(({name}) => name);
const isAsInLesson = () => !isOwn() && !scene().extra && Object.keys(chosen).every(name => name === "scene" || name === "all");

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
        if (name === "view") {
            view = Object.values(views).includes(text) ? text : view;
        } else if (name === "zoom") {
            const [size, ...middle] = text.split(",").map(Number);
            zoom = size >= 1 && size <= 64 ? size : 0;
            center = middle.length === 2 && middle.every(Number.isFinite) ? middle : null;
        } else if (!(name in chosen) && name !== "text" && Number.isFinite(Number(text))) {
            chosen[name] = Number(text);
        }
    }
    if (given.get("text")) {
        chosen.text = given.get("text");
    }
}

function writeAddress() {
    const looked = {view: view === "yours" ? undefined : view,
                    zoom: zoom ? [zoom, ...(center ?? []).map(x => Number(x.toFixed(1)))] : undefined};
    const kept = Object.entries({...chosen, ...looked}).filter(([, value]) => value !== undefined);
    history.replaceState(null, "", "#" + new URLSearchParams(kept.map(([name, value]) => [name, `${value}`])));
}

// ---- Asking ----

const three = v => v.map(x => Number(x.toFixed(4))).join(",");

// The same without some of its numbers, which are as in the lesson then.
function request(without = []) {
    const {name, width, height, values = []} = scene();
    let words = "--stats" + (chosen.all ? " --no-skip" : "") + (isOwn() ? "" : ` --only ${name}`);
    if (chosen.size) {
        words += ` -s ${chosen.size}x${Math.max(1, Math.round(chosen.size * height / width))}`;
    }
    for (const name of ["light", "eye", "center", "up"]) {
        words += chosen[name] ? ` --${name} ${three(chosen[name])}` : "";
    }
    for (const {name} of values) {
        words += chosen[name] === undefined || without.includes(name) ? "" : ` --set ${name}=${chosen[name]}`;
    }
    words += chosen.frame ? ` --frame ${chosen.frame}` : "";
    if (cursor && colorAt(shown, ...cursor)) {
        words += ` --probe ${cursor[0]},${shown.height - 1 - cursor[1]}`;
    }
    const text = textOf()?.split("\n").filter(line => line !== "end").join("\n").trimEnd();
    return words + (isOwn() ? ` text\n${text}\nend\n` : "\n");
}

// "frame W H MS COUNT", COUNT lines (a note begins with a blank), pixels; or "error MESSAGE".
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
    const lines = Array.from({length: count}, line);
    const counters = lines.filter(text => text[0] !== " ").map(text => text.split(" "));
    const notes = lines.filter(text => text[0] === " ").map(text => text.slice(1));
    const pixels = new Uint8ClampedArray(bytes.subarray(at, at + 4 * width * height));
    return {width, height, milliseconds, counters, notes, pixels};
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
        const slow = setTimeout(() => { $("pixel").textContent = "One moment"; }, 400);
        try {
            const frame = parseFrame(await program.frame(request()));
            const without = view === "yours" ? [] : chosenModes();
            const other = without.length > 0 ? parseFrame(await program.frame(request(without))) : null;
            plain = other?.pixels ? {...other, without} : null;
            frameMessage = frame.error ?? "";
            if (!frame.error) {
                shown = frame;
            }
        } catch (error) {
            frameMessage = error.message;
        }
        say();
        clearTimeout(slow);
        paint();
    } while (again);
    asking = false;
}

let frameMessage = "", buildMessage = "";

function say() {
    const text = [...new Set([frameMessage, buildMessage])].filter(Boolean).join("\n");
    $("message").hidden = text === "";
    if ($("message").textContent !== text) {
        $("message").textContent = text;
    }
}

// What there is to say of a program while it is written, first what matters most.
const messageOf = ({building, message, todo, printed}) =>
    [building && "Building ...", message, todo && `Task ${todo} in main.c is to do.`,
     printed && `Your program prints:\n${printed}`].filter(Boolean).join("\n");

async function lookForChanges() {
    try {
        const state = await program.state();
        buildMessage = messageOf(state);
        if (state.version !== version || !about) {
            version = state.version;
            frameMessage = "";
            if (state.program) {
                about = state.program;
                document.title = $("title").textContent = state.step;
                build();
            }
            if (about) {
                ask();
            }
        }
    } catch (error) {
        frameMessage = error.message;
    }
    say();
    if (!program.still) {
        setTimeout(lookForChanges, 500);
    }
}

// ---- The reference, and how far yours is from it ----

async function readPicture(address) {
    const image = new Image();
    image.src = address;
    try {
        await image.decode();
    } catch {
        return null;
    }
    const {width, height} = image, copy = new OffscreenCanvas(width, height).getContext("2d");
    copy.drawImage(image, 0, 0);
    return {width, height, pixels: copy.getImageData(0, 0, width, height).data};
}

async function readReference() {
    reference = told = null;
    const {scene: name} = chosen, address = !isOwn() && !scene().extra && program.reference?.(name);
    const read = address ? await readPicture(address) : null;
    const difference = program.difference?.(name);
    const readToo = difference ? await readPicture(difference) : null;
    if (chosen.scene === name) {
        [reference, told] = [read, readToo];
        paint();
    }
}

const colorAt = (frame, x, y) => frame && x >= 0 && y >= 0 && x < frame.width && y < frame.height
    ? [...frame.pixels.subarray(4 * (y * frame.width + x), 4 * (y * frame.width + x) + 3)] : null;

// The largest difference of a channel.
const errorAt = (a, b, i) => Math.max(Math.abs(a[i] - b[i]), Math.abs(a[i + 1] - b[i + 1]), Math.abs(a[i + 2] - b[i + 2]));

// From which error on a colour is used, and the colour (magma, of matplotlib).
const scale = [[0, 0x00, 0x00, 0x04], [1, 0x3b, 0x0f, 0x70], [5, 0x8c, 0x29, 0x81], [16, 0xde, 0x49, 0x68],
               [64, 0xfe, 0x9f, 0x6d], [128, 0xfc, 0xfd, 0xbf]];

// The difference as make check draws it: the reference, dark, and what differs in red; or the errors
// in the colours of the scale.
function compare(errors) {
    const {width, height, pixels: mine} = shown, wanted = right().pixels;
    const pixels = new Uint8ClampedArray(mine.length), counts = scale.map(() => 0);
    for (let i = 0; i < pixels.length; i += 4) {
        const error = errorAt(mine, wanted, i), step = scale.findLastIndex(([from]) => error >= from);
        counts[step]++;
        pixels.set(errors ? scale[step].slice(1)
                   : error > 0 ? [255, 0, 0]
                   : [wanted[i] / 4, wanted[i + 1] / 4, wanted[i + 2] / 4], i);
        pixels[i + 3] = 255;
    }
    return {width, height, pixels, counts, count: width * height - counts[0]};
}

// Which pixels of a difference are red, or blue: missing.
function wrongOf({pixels}) {
    const wrong = [];
    for (let i = 0; i < pixels.length; i += 4) {
        if (pixels[i + 1] === 0 && Math.max(pixels[i], pixels[i + 2]) === 255 && Math.min(pixels[i], pixels[i + 2]) === 0) {
            wrong.push(i / 4);
        }
    }
    return wrong;
}

// ---- Painting ----

// With what the picture is compared.
const right = () => plain ?? reference;
const sameSize = () => right() && shown && right().width === shown.width && right().height === shown.height;
const isComparable = () => sameSize() && (plain !== null || isAsInLesson());

let made = {};         // what was last compared, and of what

function compared(view) {
    if (made.view !== view || made.shown !== shown || made.right !== right() || made.told !== told) {
        const frame = view === "difference" && told && !plain ? {...told, count: compare(false).count} : compare(view === "errors");
        made = {view, shown, right: right(), told, frame, wrong: view === "difference" ? wrongOf(frame) : []};
    }
    return made.frame;
}

function visible() {
    if (view === "reference" && right()) {
        return right();
    }
    return (view === "difference" || view === "errors") && isComparable() ? compared(view) : shown;
}

// Where pixel (x,y), counted from the top left, is on the canvas.
function place(frame) {
    const size = zoom || Math.min(canvas.width / frame.width, canvas.height / frame.height);
    const middle = (zoom && center) || [frame.width / 2, frame.height / 2];
    return {size, left: canvas.width / 2 - middle[0] * size, top: canvas.height / 2 - middle[1] * size};
}

// The frame as what can be drawn at any size.
function drawable(frame) {
    if (!frame.picture) {
        frame.picture = new OffscreenCanvas(frame.width, frame.height);
        frame.picture.getContext("2d").putImageData(new ImageData(frame.pixels, frame.width, frame.height), 0, 0);
    }
    return frame.picture;
}

function paint() {
    const frame = shown && visible();
    if (!frame) {
        return;
    }
    canvas.width = canvas.clientWidth * devicePixelRatio;
    canvas.height = canvas.clientHeight * devicePixelRatio;
    const {size, left, top} = place(frame);
    context.imageSmoothingEnabled = size < 1;
    context.drawImage(drawable(frame), left, top, frame.width * size, frame.height * size);
    if (view === "split" && sameSize()) {
        paintSplit(size, left, top);
    }
    if (frame === made.frame && size < 3) {
        paintWrong(frame, size, left, top);
    }
    if (size >= 8 * devicePixelRatio) {
        paintGrid(frame, size, left, top);
    }
    paintPoints(size, left, top);
    paintCursor(size, left, top);
    describe(frame);
}

// With what it is compared, to the right of the cursor.
function paintSplit(size, left, top) {
    const {width, height} = right(), from = cursor ? Math.max(0, Math.min(width, cursor[0])) : width >> 1;
    context.drawImage(drawable(right()), from, 0, width - from, height, left + from * size, top, (width - from) * size, height * size);
    context.fillStyle = "#fff";
    context.fillRect(left + from * size, top, devicePixelRatio, height * size);
}

// Wrong pixels so large that they are seen.
function paintWrong({width, pixels}, size, left, top) {
    for (const at of made.wrong) {
        context.fillStyle = pixels[4 * at] > 0 ? "#f00" : "#00f";
        context.fillRect(left + at % width * size - 1, top + Math.floor(at / width) * size - 1, 3, 3);
    }
}

function paintCursor(size, left, top) {
    if (cursor && size >= 4) {
        context.lineWidth = devicePixelRatio;
        for (const [color, by] of [["#000", 1], ["#fff", 0]]) {
            context.strokeStyle = color;
            context.strokeRect(left + cursor[0] * size - by, top + cursor[1] * size - by, size + 2 * by, size + 2 * by);
        }
    }
}

function paintGrid(frame, size, left, top) {
    const from = [Math.max(0, Math.floor(-left / size)), Math.max(0, Math.floor(-top / size))];
    const to = [Math.min(frame.width, Math.ceil((canvas.width - left) / size)),
                Math.min(frame.height, Math.ceil((canvas.height - top) / size))];
    context.strokeStyle = "#8888";
    context.lineWidth = 1;
    context.font = `${Math.floor(size * .3)}px monospace`;
    context.textAlign = "center";
    for (let y = from[1]; y < to[1]; y++) {
        for (let x = from[0]; x < to[0]; x++) {
            context.strokeRect(left + x * size, top + y * size, size, size);
            if (size >= 32 * devicePixelRatio && view !== "difference") {
                const color = colorAt(frame, x, y), i = 4 * (y * frame.width + x);
                const numbers = view === "errors" && isComparable() ? [errorAt(shown.pixels, right().pixels, i)] : color;
                context.fillStyle = color[0] + color[1] + color[2] > 380 ? "#000" : "#fff";
                numbers.forEach((value, i) =>
                    context.fillText(value, left + (x + .5) * size, top + (y + .32 + .29 * i) * size));
            }
        }
    }
}

const otherName = () => plain ? `the same with ${plain.without.join(", ")} as in the lesson` : "the reference";

// The numbers below the picture, and those that were counted.
function describe(frame) {
    const lines = [`${shown.width}x${shown.height} pixels` +
                   (program.still ? "" : `, ${shown.milliseconds.toFixed(1)} ms`)];
    if (frame.count !== undefined) {
        lines.push(`${frame.count} pixels differ from ${otherName()}`);
    } else if (right() && !sameSize() && view !== "yours") {
        lines.push(`the reference has ${reference.width}x${reference.height}`);
    } else if (plain && view !== "yours") {
        lines.push(`${view === "split" ? "on the right: " : ""}${otherName()}`);
    } else if (!isAsInLesson() && view !== "yours") {
        lines.push("not as in the lesson, which is the reference");
    }
    if (cursor) {
        const [x, y] = cursor, mine = colorAt(shown, x, y), wanted = isComparable() && colorAt(right(), x, y);
        lines.push(`(${x},${shown.height - 1 - y}) ${mine}` + (wanted && mine ? `, ${plain ? "as in the lesson" : "reference"} ${wanted}, error ${errorAt(mine, wanted, 0)}` : ""));
        lines.push(...shown.notes);
    }
    $("pixel").textContent = lines.join("\n");
    $("zoom").textContent = zoom ? `${zoom}x` : "fit";
    const ranges = (frame.counts ?? []).map((count, i) => [
        `error ${scale[i][0]}` + (i > 0 ? ` to ${(scale[i + 1] ?? [256])[0] - 1}` : ""), count, `rgb(${scale[i].slice(1)})`]);
    $("counters").replaceChildren(...(view === "errors" ? ranges : shown.counters).flatMap(([name, value, color]) => {
        const term = document.createElement("dt"), number = document.createElement("dd");
        term.textContent = name.replaceAll("_", " ");
        term.style.borderLeft = color ? `1.2em solid ${color}` : "";
        number.textContent = Number(value).toLocaleString("en");
        return [term, number];
    }));
}

// ---- Points to drag ----

const pairs = () => (scene().values ?? []).filter(value => value.name.endsWith("_x"))
    .map(x => [x, scene().values.find(y => y.name === x.name.replace(/x$/, "y"))]);
const steps = (v, step) => Number((Math.round(v / step) * step).toFixed(6));

// Of each line `line` or `triangle` the corners, and of numbers NAME_x and NAME_y the point: where
// it is in pixels, counted from below, and how to move it.
function points() {
    const lines = isOwn() ? textOf().split("\n") : [], whole = lines.some(line => /^\s*line/.test(line));
    const corners = lines.flatMap((line, row) => {
        const words = line.trim().split(/\s+/), count = {line: 2, triangle: 3}[words[0]] ?? 0;
        return Array.from({length: count}, (_, i) => ({
            x: Number(words[1 + 2 * i]), y: Number(words[2 + 2 * i]), step: whole ? 1 : 1 / 8,
            move(x, y) {
                const all = textOf().split("\n"), moved = all[row].trim().split(/\s+/);
                moved.splice(1 + 2 * i, 2, steps(x, this.step), steps(y, this.step));
                all[row] = moved.join(" ");
                chosen.text = $("text").value = all.join("\n");
            },
        }));
    });
    const place = ({name, least, most}, size) => (valueOf(name) - least) / (most - least) * size - .5;
    const set = ({name, least, most, step}, part) => {
        chosen[name] = steps(Math.max(least, Math.min(most, least + part * (most - least))), step);
    };
    return corners.concat(pairs().map(([x, y]) => ({
        x: place(x, shown.width), y: place(y, shown.height), name: x.name.slice(0, -2),
        step: Math.max(1, x.step / (x.most - x.least) * shown.width),
        move(left, up) {
            set(x, (left + .5) / shown.width);
            set(y, (up + .5) / shown.height);
        },
    })));
}

// All corners at the place of this one: those of neighbours stay together. A point with a name is alone.
const together = one => points().filter(p => p.x === one.x && p.y === one.y && p.name === one.name);

const pointPlace = (p, size, left, top) => [left + (p.x + .5) * size, top + (shown.height - .5 - p.y) * size];

function paintPoints(size, left, top) {
    points().forEach((p, i) => {
        const [x, y] = pointPlace(p, size, left, top);
        context.beginPath();
        context.arc(x, y, 7 * devicePixelRatio, 0, 2 * Math.PI);
        context.lineWidth = (i === point ? 4 : 2) * devicePixelRatio;
        for (const [color, dash] of [["#fff", []], ["#2a6fdb", [4, 4]]]) {
            context.setLineDash(dash);
            context.strokeStyle = color;
            context.stroke();
        }
        context.setLineDash([]);
        if (p.name) {
            context.font = `${12 * devicePixelRatio}px sans-serif`;
            context.textAlign = "center";
            context.lineWidth = 3 * devicePixelRatio;
            context.strokeStyle = "#000";
            context.fillStyle = "#fff";
            context.strokeText(p.name, x, y - 11 * devicePixelRatio);
            context.fillText(p.name, x, y - 11 * devicePixelRatio);
        }
    });
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

function moveCamera(away) {
    const middle = valueOf("center"), sight = minus(valueOf("eye"), middle), size = length(sight);
    chosen.eye = sight.map((x, i) => x / size * away + middle[i]);
    chosen.center = middle;
    changed();
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
    const at = pixelAt(event), {size} = place(visible());
    const far = p => Math.hypot(p.x + .5 - at[0], shown.height - .5 - p.y - at[1]) * size / devicePixelRatio;
    const nearest = points().map(far).reduce((best, d, i, all) => d < (all[best] ?? 16) ? i : best, -1);
    held = {x: event.clientX, y: event.clientY, points: nearest < 0 ? [] : together(points()[nearest])};
    point = nearest < 0 ? point : nearest;
    canvas.setPointerCapture(event.pointerId);
});

canvas.addEventListener("pointermove", event => {
    if (!shown) {
        return;
    }
    const at = pixelAt(event);
    cursor = at.map(Math.floor);
    if (held?.points.length > 0) {
        held.points.forEach(p => p.move(at[0] - .5, shown.height - .5 - at[1]));
        changed();
        return;
    }
    if (held) {
        const dx = event.clientX - held.x, dy = event.clientY - held.y;
        held.x = event.clientX;
        held.y = event.clientY;
        if (turn(dx / 150, -dy / 150)) {
            return;
        }
        if (zoom) {
            const {size} = place(visible());
            const middle = center ?? [shown.width / 2, shown.height / 2];
            center = [middle[0] - dx * devicePixelRatio / size, middle[1] - dy * devicePixelRatio / size];
        }
    } else {
        probeSoon();
    }
    paint();
});

// When the mouse rests, the program says what there is to say about the pixel.
let rest = 0;

function probeSoon() {
    clearTimeout(rest);
    rest = setTimeout(ask, 60);
}

for (const name of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(name, () => {
        held = null;
        writeAddress();
    });
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
    writeAddress();
    paint();
}

canvas.addEventListener("wheel", event => {
    event.preventDefault();
    if (shown) {
        enlarge(event.deltaY < 0 ? 2 : .5, pixelAt(event));
    }
}, {passive: false});

// The next place with wrong pixels, large: one at least 16 pixels from the last.
function nextWrong() {
    chooseView("difference");
    const {width} = shown, last = cursor ?? [-99, -99];
    const all = (isComparable() ? made.wrong : []).map(at => [at % width, Math.floor(at / width)]);
    const after = all.filter(([x, y]) => y * width + x > last[1] * width + last[0]);
    const found = after.find(([x, y]) => Math.hypot(x - last[0], y - last[1]) >= 16) ?? all[0];
    if (found) {
        cursor = found;
        center = [found[0] + .5, found[1] + .5];
        zoom = Math.max(zoom, 8);
        writeAddress();
        paint();
    }
}

// ---- Keys ----

const views = {y: "yours", r: "reference", s: "split", d: "difference", e: "errors"};

function chooseView(name) {
    view = name;
    [...$("views").children].forEach(button => button.setAttribute("aria-pressed", button.textContent === name));
    if (shown) {
        writeAddress();
        paint();
        if (chosenModes().length > 0) {
            ask();
        }
    }
}

// Over a lesson's page, Escape leads back to it.
document.addEventListener("keydown", ({key}) => key === "Escape" && parent !== window && parent.postMessage("close", "*"));

const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

canvas.addEventListener("keydown", event => {
    const arrow = arrows[event.key];
    if (arrow && shown) {
        event.preventDefault();
        const now = drag === "points" && points()[point];
        if (now) {
            const by = now.step * (event.shiftKey ? 10 : 1);
            together(now).forEach(p => p.move(now.x + by * arrow[0], now.y + by * arrow[1]));
            changed();
        } else if (!turn(arrow[0] / 10, arrow[1] / 10)) {
            const by = event.shiftKey ? 10 : 1, from = cursor ?? [shown.width >> 1, shown.height >> 1];
            cursor = [Math.max(0, Math.min(shown.width - 1, from[0] + by * arrow[0])),
                      Math.max(0, Math.min(shown.height - 1, from[1] - by * arrow[1]))];
            center = cursor.map(x => x + .5);
            writeAddress();
            probeSoon();
            paint();
        }
    } else if (event.key === "+" || event.key === "-") {
        enlarge(event.key === "+" ? 2 : .5);
    } else if (event.key === "n" && shown) {
        point = (point + 1) % Math.max(1, points().length);
        paint();
    } else if (event.key === "w" && shown) {
        nextWrong();
    } else if (event.key === " ") {
        event.preventDefault();
        chooseView(view === "yours" ? "reference" : "yours");
    } else if (views[event.key] && !event.ctrlKey && !event.metaKey) {
        chooseView(views[event.key]);
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

// The slider that moves by itself, to its end.
let playing = null;

function play() {
    if (playing?.isConnected && !asking) {
        playing.stepUp(Math.ceil((playing.max - playing.min) / playing.step / 100));
        playing.dispatchEvent(new Event("input"));
    }
    if (!playing?.isConnected || Number(playing.value) === Number(playing.max)) {
        playing = null;
    } else {
        setTimeout(play, 40);
    }
}

function playButton(input, name) {
    const button = document.createElement("button");
    Object.assign(button, {type: "button", textContent: "play", ariaLabel: `play ${name}`});
    button.addEventListener("click", () => {
        const now = playing;
        playing = now === input ? null : input;
        input.value = Number(input.value) === Number(input.max) ? input.min : input.value;
        if (!now) {
            play();
        }
    });
    return button;
}

// Of two values a box to check, of more a slider, of named ones a button each.
function tabs(name, names, value, least, change) {
    const group = document.createElement("div"), label = document.createElement("span"), list = document.createElement("span");
    label.textContent = `${name} `;
    group.setAttribute("role", "group");
    group.ariaLabel = name;
    buttons(list, names, names[value - least], chosen => change(least + names.indexOf(chosen)));
    group.append(label, list);
    return group;
}

function slider(name, value, least, most, step, change) {
    const row = document.createElement("div"), label = document.createElement("label"), input = document.createElement("input");
    const output = document.createElement("output");
    if (most - least === step) {
        Object.assign(input, {type: "checkbox", checked: value === most});
        input.addEventListener("change", () => change(input.checked ? most : least));
        label.append(input, ` ${name}`);
        return label;
    }
    Object.assign(input, {type: "range", min: least, max: most, step, value});
    output.textContent = value;
    input.addEventListener("input", () => {
        output.textContent = input.value;
        change(Number(input.value));
    });
    label.append(`${name} `, output, input);
    row.className = "slider";
    row.append(label, playButton(input, name));
    return row;
}

// What this scene lets one change.
function buildControls() {
    const {light, eye, width, frames, values = []} = scene();
    const drags = ["picture", light && "light", eye && "camera", (isOwn() || pairs().length > 0) && "points"].filter(Boolean);
    drag = drags.includes(drag) ? drag : drags[drags.length - 1];
    buttons($("drags"), drags, drag, name => { drag = name; });
    $("views").parentElement.hidden = (!program.reference || isOwn() || Boolean(scene().extra)) && modes().length === 0;
    $("values").replaceChildren($("values").firstElementChild);
    const set = name => value => {
        chosen[name] = value;
        changed();
    };
    const add = (name, help, ...range) => $("values").append(slider(help, ...range, set(name)));
    if (frames > 1) {
        add("frame", "frame", chosen.frame ?? 1, 1, frames, 1);
    }
    if (eye) {
        const away = length(minus(eye, scene().center)), step = away / 20;
        const now = length(minus(valueOf("eye"), valueOf("center")));
        $("values").append(slider("distance of the camera", steps(now, step), step, 10 * away, step, moveCamera));
    }
    const dragged = pairs().flat();
    for (const value of values.filter(value => !dragged.includes(value))) {
        const {name, help, least, most, step} = value, names = namesOf(value);
        if (names) {
            $("values").append(tabs(name, names, valueOf(name), least, set(name)));
        } else {
            add(name, help, valueOf(name), least, most, step);
        }
    }
    $("values").hidden = $("values").children.length === 1;
    $("size").closest("fieldset").hidden = isOwn();
    const sizes = isOwn() ? [] : [...new Set([width, 100, 200, 400, 800])].sort((a, b) => a - b);
    $("size").replaceChildren(...sizes.map(size => new Option(size, size, false, size === (chosen.size ?? width))));
    $("all").parentElement.hidden = !about.skips;
    $("all").checked = Boolean(chosen.all);
    $("own").hidden = !isOwn();
    $("text").value = textOf() ?? "";
}

function chooseScene(name) {
    chosen = {scene: name};
    center = plain = null;
    point = 0;
    drag = drag === "picture" ? null : drag; // what is there to drag instead?
    buildControls();
    writeAddress();
    readReference();
    ask();
}

function build() {
    const names = about.scenes.map(scene => scene.name);
    if (!names.includes(chosen.scene)) {
        chosen = {scene: names[0]};
    }
    buttons($("scenes"), names, chosen.scene, chooseScene);
    buttons($("views"), Object.values(views), view, chooseView);
    buildControls();
    readReference();
}

$("text").addEventListener("input", () => { chosen.text = $("text").value; changed(); });
$("size").addEventListener("change", () => { chosen.size = Number($("size").value); changed(); });
$("all").addEventListener("change", () => { chosen.all = $("all").checked ? 1 : undefined; changed(); });
$("reset").addEventListener("click", () => chooseScene(chosen.scene));
$("wrong").addEventListener("click", () => shown && nextWrong());
$("larger").addEventListener("click", () => shown && enlarge(2));
$("smaller").addEventListener("click", () => shown && enlarge(.5));
$("controls").addEventListener("submit", event => event.preventDefault());
new ResizeObserver(paint).observe(canvas);
readAddress();
lookForChanges();
