'use strict';
/*
 * The page holds, for each scene, yours, the reference and their difference. Made of them here: a
 * slider between the first two, a map of the errors, marks, and the values of single pixels.
 *
 * Rows of pixels count from the bottom, as in the course.
 */
const modes = ['side', 'slide', 'yours', 'reference', 'difference', 'errors'];
const zooms = [0, 1, 2, 4, 8, 16, 32]; /* 0 fits the picture into its column */
const cell = 16;                       /* wrong pixels so near to each other are one place */

/* From which error on a colour stands, and the colour (magma, of matplotlib). */
const scale = [[0, '#000004'], [1, '#3b0f70'], [5, '#8c2981'], [16, '#de4968'], [64, '#fe9f6d'],
               [128, '#fcfdbf']];

let mode = 'side', zoom = 0, marked = false;
const byId = id => document.getElementById(id);

/* An element with properties and children. */
function make(tag, properties, ...children) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
}

/* A square of that colour. */
function swatch(color) {
    const square = make('i', {});
    square.style.background = color;
    return square;
}

/* ---- Pixels ---- */

const contexts = new Map();
function contextOf(picture) {
    if (!contexts.has(picture)) {
        const canvas = picture.getContext ? picture : make(
            'canvas', {width: picture.naturalWidth, height: picture.naturalHeight});
        const context = canvas.getContext('2d', {willReadFrequently: true});
        if (canvas != picture) context.drawImage(picture, 0, 0);
        contexts.set(picture, context);
    }
    return contexts.get(picture);
}

const widthOf = picture => picture.naturalWidth || picture.width;
const heightOf = picture => picture.naturalHeight || picture.height;

/* Red, green and blue, or nothing outside of the picture. */
function colorAt(picture, x, y) {
    const top = heightOf(picture) - 1 - y;
    if (x >= widthOf(picture) || top < 0) return null;
    return [...contextOf(picture).getImageData(x, top, 1, 1).data.slice(0, 3)];
}

const allOf = picture =>
    contextOf(picture).getImageData(0, 0, widthOf(picture), heightOf(picture)).data;

/* The largest difference of a channel; what is not there counts as black. */
const errorOf = (a, b) =>
    Math.max(...[0, 1, 2].map(i => Math.abs((a ? a[i] : 0) - (b ? b[i] : 0))));

/* ---- What is made for a scene ---- */

const addSheet = figure => {
    const view = figure.querySelector('.view'), frame = make('div', {className: 'frame'});
    const sheet = make('div', {className: 'sheet'}, ...view.childNodes);
    view.replaceWith(frame);
    frame.append(view);
    view.append(sheet);
    view.tabIndex = 0;
    return sheet;
};

function makeFigure(scene, name, caption, ...children) {
    const view = make('div', {className: 'view'}, ...children);
    const figure = make('figure', {className: name}, make('figcaption', {}, caption), view);
    view.setAttribute('role', 'group');
    view.setAttribute('aria-label', scene.name + ', ' + caption);
    figure.dataset.name = name;
    scene.section.querySelector('.pictures').append(figure);
    scene.figures[name] = figure;
    return figure;
}

function addSlider(scene) {
    const {yours, reference} = scene.pictures;
    const top = make('img', {className: 'top', src: yours.src, alt: yours.alt});
    const below = make('img', {src: reference.src, alt: reference.alt});
    const divider = make('div', {className: 'divider'});
    const range = make('input', {type: 'range', min: 0, max: 100, step: 0.5, value: 50});
    const figure = makeFigure(scene, 'slide', 'yours | reference', below, top, divider);
    top.style.width = 100 * widthOf(yours) / widthOf(reference) + '%';
    range.setAttribute('aria-label', scene.name + ': how much of yours covers the reference');
    range.oninput = () => {
        const shown = range.value * widthOf(reference) / widthOf(yours);
        top.style.clipPath = `inset(0 ${Math.max(0, 100 - shown)}% 0 0)`;
        divider.style.left = range.value + '%';
    };
    range.oninput();
    figure.append(range);
    /* The picture itself can be dragged, too. */
    figure.onpointermove = figure.onpointerdown = e => {
        const sheet = e.target.closest('.sheet'), box = sheet && sheet.getBoundingClientRect();
        if (!sheet || (e.pointerType == 'mouse' && e.type == 'pointermove' && !e.buttons)) return;
        range.value = 100 * (e.clientX - box.left) / box.width;
        range.oninput();
    };
}

/* The errors in the colours of the scale, and how many pixels have each. */
function drawErrors(scene) {
    const {yours, reference} = scene.pictures, canvas = scene.pictures.errors;
    const width = canvas.width, height = canvas.height, context = contextOf(canvas);
    const map = context.createImageData(width, height), counts = scale.map(() => 0);
    const mine = allOf(yours), right = allOf(reference);
    const colors = scale.map(([, color]) => parseInt(color.slice(1), 16));
    const lower = heightOf(yours) - height, mineWidth = widthOf(yours);
    for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
            const at = 4 * (y * width + x), own = 4 * ((y + lower) * mineWidth + x);
            const there = x < mineWidth && y + lower >= 0;
            let error = 0, step = 0;
            for (let i = 0; i < 3; i++) {
                error = Math.max(error, Math.abs((there ? mine[own + i] : 0) - right[at + i]));
            }
            while (step + 1 < scale.length && error >= scale[step + 1][0]) step++;
            counts[step]++;
            const color = colors[step];
            map.data.set([color >> 16, color >> 8 & 255, color & 255, 255], at);
        }
    }
    context.putImageData(map, 0, 0);
    const lines = scale.map(([from, color], i) => {
        const to = i + 1 < scale.length ? scale[i + 1][0] - 1 : 255;
        const range = from == to ? from : from + ' to ' + to;
        const pixels = counts[i].toLocaleString('en') + (counts[i] == 1 ? ' pixel' : ' pixels');
        return make('li', {}, swatch(color), range + ': ' + pixels);
    });
    scene.figures.errors.querySelector('.scale').replaceChildren(...lines);
}

function addErrors(scene) {
    const {reference} = scene.pictures;
    const canvas = make('canvas', {width: widthOf(reference), height: heightOf(reference)});
    scene.pictures.errors = canvas;
    makeFigure(scene, 'errors', 'error: largest difference of a channel', canvas)
        .append(make('ol', {className: 'scale'}));
}

/* Which pixels has the difference in red or blue? Positions in the order of its bytes. */
function findWrong(scene) {
    if (!scene.wrong) {
        const data = scene.pictures.difference ? allOf(scene.pictures.difference) : [];
        const width = scene.pictures.difference ? widthOf(scene.pictures.difference) : 1;
        const height = data.length / 4 / width, places = new Map();
        scene.wrong = [];
        for (let at = 0; at < data.length; at += 4) {
            const [r, g, b] = [data[at], data[at + 1], data[at + 2]];
            if (g == 0 && (r == 255 && b == 0 || r == 0 && b == 255)) {
                const x = at / 4 % width, y = height - 1 - Math.floor(at / 4 / width);
                const place = Math.floor(y / cell) * 100000 + Math.floor(x / cell);
                scene.wrong.push(at / 4);
                places.set(place, [x, y]);
            }
        }
        scene.places = [...places].sort((a, b) => a[0] - b[0]).map(([, pixel]) => pixel);
    }
    return scene.wrong;
}

/* Wrong pixels as they are in the difference; where that is shrunk, so large that they are seen. */
function drawMarks(scene, figure, factor) {
    const {difference} = scene.pictures, name = figure.dataset.name;
    let canvas = figure.querySelector('.marks');
    const wanted = difference && (marked && name != 'errors' || name == 'difference' && factor < 1);
    if (canvas) canvas.hidden = !wanted;
    if (!wanted) return;
    const around = factor < 1 ? Math.ceil(0.75 / factor) : 0;
    if (canvas && canvas.dataset.around == around) return;
    const width = widthOf(difference), height = heightOf(difference), from = allOf(difference);
    const map = new ImageData(width, height), to = new Uint32Array(map.data.buffer);
    const source = new Uint32Array(from.buffer);
    for (const at of findWrong(scene)) {
        const x = at % width, y = Math.floor(at / width);
        for (let j = Math.max(0, y - around); j <= Math.min(height - 1, y + around); j++) {
            to.fill(source[at], j * width + Math.max(0, x - around),
                    j * width + Math.min(width - 1, x + around) + 1);
        }
    }
    if (!canvas) {
        canvas = make('canvas', {className: 'marks', width, height});
        figure.querySelector('.sheet').append(canvas);
    }
    canvas.dataset.around = around;
    canvas.getContext('2d').putImageData(map, 0, 0);
}

/* At 32 times each pixel has room for its numbers. */
function drawValues(scene, figure) {
    const name = figure.dataset.name, picture = scene.pictures[name];
    const frame = figure.querySelector('.frame');
    const old = frame.querySelector('.values');
    if (zooms[zoom] < 32 || !picture || name == 'difference') {
        if (old) old.remove();
        return;
    }
    const view = figure.querySelector('.view'), dots = window.devicePixelRatio, size = zooms[zoom];
    const width = view.clientWidth, height = view.clientHeight;
    const canvas = old || make('canvas', {className: 'values'});
    if (!old) frame.append(canvas);
    Object.assign(canvas, {width: width * dots, height: height * dots});
    Object.assign(canvas.style, {width: width + 'px', height: height + 'px'});
    const context = canvas.getContext('2d');
    context.scale(dots, dots);
    context.font = '10px sans-serif';
    context.textAlign = 'center';
    const left = Math.floor(view.scrollLeft / size), first = Math.floor(view.scrollTop / size);
    for (let row = first; row * size < view.scrollTop + height; row++) {
        for (let x = left; x * size < view.scrollLeft + width; x++) {
            const y = heightOf(picture) - 1 - row, color = y < 0 ? null : colorAt(picture, x, y);
            if (!color) continue;
            const lines = name == 'errors' ? [errorAt(scene, x, y)]
                : color[0] == color[1] && color[1] == color[2] ? [color[0]] : color;
            const bright = 0.3 * color[0] + 0.6 * color[1] + 0.1 * color[2] > 110;
            context.fillStyle = bright ? '#000' : '#fff';
            lines.forEach((line, i) => context.fillText(
                line, (x + 0.5) * size - view.scrollLeft,
                (row + 0.5) * size - view.scrollTop + 3.5 + 10 * (i - (lines.length - 1) / 2)));
        }
    }
}

/* ---- Sizes ---- */

/* Fitted, a small picture becomes a whole number of times as large. */
function fit(figure, width, height) {
    const room = figure.clientWidth - 2, high = Math.max(200, window.innerHeight - 190);
    let shown = width * zooms[zoom];
    if (!shown) {
        const most = Math.min(room, high * width / height);
        shown = width > most ? most : width * Math.max(1, Math.floor(most / width));
    }
    const sheet = figure.querySelector('.sheet');
    sheet.style.width = shown + 'px';
    sheet.classList.toggle('smooth', shown < width);
    const range = figure.querySelector('input');
    if (range) range.style.width = figure.querySelector('.view').offsetWidth + 'px';
    return shown / width;
}

function updateScene(scene) {
    for (const [name, figure] of Object.entries(scene.figures)) {
        if (!figure.clientWidth) continue;
        const picture = scene.pictures[name] || scene.pictures.reference;
        const factor = fit(figure, widthOf(picture), heightOf(picture));
        if (!scene.near) continue;
        if (name == 'errors' && !figure.drawn) {
            figure.drawn = true;
            drawErrors(scene);
        }
        drawMarks(scene, figure, factor);
        drawValues(scene, figure);
    }
}

/* What was in the window stays there, though pictures above it change their size. */
function update() {
    const kept = current(), top = kept && kept.section.getBoundingClientRect().top;
    document.body.classList.toggle('side', mode == 'side');
    for (const id of modes) byId(id).setAttribute('aria-pressed', mode == id);
    byId('marks').setAttribute('aria-pressed', marked);
    byId('zoom').textContent = zoom ? zooms[zoom] + 'x' : 'fit';
    for (const scene of scenes) {
        const shown = scene.figures[mode] ? mode : 'reference'; /* what is exact has only that */
        for (const [name, figure] of Object.entries(scene.figures)) {
            figure.classList.toggle('shown', name == shown);
        }
        updateScene(scene);
    }
    if (kept) window.scrollBy(0, kept.section.getBoundingClientRect().top - top);
}

function choose(name) {
    mode = name;
    update();
}

function resize(by) {
    zoom = Math.min(zooms.length - 1, Math.max(0, zoom + by));
    update();
    for (const scene of scenes) if (scene.near && scene.cursor) showCursor(scene);
}

function mark() {
    marked = !marked;
    update();
}

/* ---- One pixel ---- */

const errorAt = (scene, x, y) => errorOf(colorAt(scene.pictures.yours, x, y),
                                         colorAt(scene.pictures.reference, x, y));

function showValues(scene, x, y, more) {
    const parts = ['(' + x + ',' + y + ')'], {yours, reference} = scene.pictures;
    for (const [name, picture] of [['yours', yours], ['reference', reference]]) {
        const color = picture && colorAt(picture, x, y);
        if (color) parts.push(swatch('rgb(' + color + ')'), ' ' + name + ' ' + color);
    }
    if (yours && reference) parts.push('  error ' + errorAt(scene, x, y));
    byId('values').replaceChildren(...parts, more || '');
}

/* Is what is there, `size` wide, near the view's edge or outside? Then it comes to the middle. */
function bringNear(view, side, length, middle, size) {
    const shown = view['client' + length], edge = Math.min(2.5 * size + 8, shown / 3);
    const place = middle - view['scroll' + side];
    if (place < edge || place > shown - edge) view['scroll' + side] = middle - shown / 2;
}

/* Mark the scene's chosen pixel in all its pictures, and scroll them there. */
function showCursor(scene) {
    const [x, y] = scene.cursor;
    for (const [name, figure] of Object.entries(scene.figures)) {
        const picture = scene.pictures[name] || scene.pictures.reference;
        const view = figure.querySelector('.view'), sheet = figure.querySelector('.sheet');
        const width = widthOf(picture), height = heightOf(picture);
        let box = figure.querySelector('.cursor');
        if (!box) sheet.append(box = make('div', {className: 'cursor'}));
        box.hidden = x >= width || y >= height;
        Object.assign(box.style, {left: 100 * x / width + '%', bottom: 100 * y / height + '%',
                                  width: 100 / width + '%', height: 100 / height + '%'});
        if (!figure.clientWidth) continue;
        const factor = sheet.clientWidth / width;
        bringNear(view, 'Left', 'Width', (x + 0.5) * factor, factor);
        bringNear(view, 'Top', 'Height', (height - y - 0.5) * factor, factor);
    }
}

function setCursor(scene, x, y, more) {
    const {reference, yours} = scene.pictures, picture = reference || yours;
    scene.cursor = [Math.min(widthOf(picture) - 1, Math.max(0, x)),
                    Math.min(heightOf(picture) - 1, Math.max(0, y))];
    showCursor(scene);
    showValues(scene, ...scene.cursor, more);
    /* The bars at the window's top and bottom may cover it. */
    const box = [...scene.section.querySelectorAll('.cursor')].find(c => c.clientWidth);
    const place = box && box.getBoundingClientRect(), top = byId('top').offsetHeight + 20;
    const bottom = window.innerHeight - byId('values').offsetHeight - 20;
    if (box && (place.top < top || place.bottom > bottom)) {
        window.scrollBy(0, place.top - (top + bottom) / 2);
    }
}

/* Which pixel of a scene is there on the screen? */
function pixelAt(e) {
    const sheet = e.target.closest && e.target.closest('.sheet');
    if (!sheet) return null;
    const scene = scenes.find(s => s.section.contains(sheet));
    const name = sheet.closest('figure').dataset.name, box = sheet.getBoundingClientRect();
    const picture = scene.pictures[name] || scene.pictures.reference;
    const across = (e.clientX - box.left) / box.width, down = (e.clientY - box.top) / box.height;
    if (across < 0 || across >= 1 || down < 0 || down >= 1) return null;
    return [scene, Math.floor(across * widthOf(picture)),
            heightOf(picture) - 1 - Math.floor(down * heightOf(picture))];
}

/* Those that are not folded away. */
const unfolded = () => scenes.filter(s => !s.section.closest('details:not([open])'));

/* The scene that the keyboard is in, else the first that is seen. */
function current() {
    const shown = unfolded();
    const top = byId('top').offsetHeight + 20;
    return shown.find(s => s.section.contains(document.activeElement)) ||
        shown.find(s => s.section.getBoundingClientRect().bottom > top) || shown[shown.length - 1];
}

/* Go to the next place with wrong pixels, and make them large. */
function nextWrong() {
    const scene = current();
    if (!scene || !findWrong(scene).length) {
        byId('values').textContent = scene ? scene.name + ': no wrong pixel' : '';
        return;
    }
    scene.place = ((scene.place ?? -1) + 1) % scene.places.length;
    zoom = Math.max(zoom, zooms.indexOf(8));
    if (scene.section.getBoundingClientRect().bottom < byId('top').offsetHeight + 100 ||
        scene.section.getBoundingClientRect().top > window.innerHeight - 100) {
        scene.section.scrollIntoView();
    }
    scene.near = true;
    update();
    setCursor(scene, ...scene.places[scene.place],
              `  wrong: place ${scene.place + 1} of ${scene.places.length}`);
}

function jump(by) {
    const shown = unfolded();
    const at = Math.min(shown.length - 1, Math.max(0, shown.indexOf(current()) + by));
    if (at < 0) return;
    const view = [...shown[at].section.querySelectorAll('.view')].find(v => v.clientWidth);
    window.scrollTo(0, shown[at].section.getBoundingClientRect().top + window.scrollY -
                       byId('top').offsetHeight);
    if (view) view.focus({preventScroll: true});
}

/* ---- The page ---- */

function makeScene(section) {
    const heading = section.querySelector('h2,h3');
    const scene = {section, figures: {}, pictures: {}, name: heading ? heading.textContent : ''};
    for (const figure of section.querySelectorAll('.pictures figure')) {
        scene.figures[figure.dataset.name] = figure;
        scene.pictures[figure.dataset.name] = figure.querySelector('img');
    }
    if (scene.pictures.yours && scene.pictures.reference) {
        addErrors(scene);
        addSlider(scene);
    }
    Object.values(scene.figures).forEach(addSheet);
    return scene;
}

let scenes = [];
const keys = {
    s: () => choose('side'), l: () => choose('slide'), y: () => choose('yours'),
    r: () => choose('reference'), d: () => choose('difference'), e: () => choose('errors'),
    ' ': () => choose(mode == 'yours' ? 'reference' : 'yours'), m: mark, w: nextWrong,
    '+': () => resize(1), '=': () => resize(1), '-': () => resize(-1), n: () => jump(1),
    p: () => jump(-1)
};
const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

function pressed(e) {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const arrow = arrows[e.key], on = e.target;
    if (arrow && on.classList && on.classList.contains('view')) {
        const scene = scenes.find(s => s.section.contains(on)), by = e.shiftKey ? 10 : 1;
        const picture = scene.pictures.reference || scene.pictures.yours;
        const [x, y] = scene.cursor || [widthOf(picture) >> 1, heightOf(picture) >> 1];
        setCursor(scene, x + by * arrow[0], y + by * arrow[1]);
    } else if (keys[e.key] && !(e.key == ' ' && /^(BUTTON|SUMMARY|A)$/.test(on.tagName))) {
        keys[e.key]();
    } else {
        return;
    }
    e.preventDefault();
}

/* The pictures of a scene are scrolled together. */
function scrolled(e) {
    const view = e.target;
    if (!view.classList || !view.classList.contains('view')) return;
    const scene = scenes.find(s => s.section.contains(view));
    for (const figure of Object.values(scene.figures)) {
        const other = figure.querySelector('.view');
        if (other.scrollLeft != view.scrollLeft) other.scrollLeft = view.scrollLeft;
        if (other.scrollTop != view.scrollTop) other.scrollTop = view.scrollTop;
        if (figure.clientWidth) drawValues(scene, figure);
    }
}

function begin() {
    scenes = [...document.querySelectorAll('section')].map(makeScene);
    document.body.classList.add('js');
    for (const id of modes) byId(id).onclick = () => choose(id);
    byId('marks').onclick = mark;
    byId('wrong').onclick = nextWrong;
    byId('smaller').onclick = () => resize(-1);
    byId('larger').onclick = () => resize(1);
    document.addEventListener('keydown', pressed);
    document.addEventListener('scroll', scrolled, true);
    document.addEventListener('mousemove', e => {
        const pixel = pixelAt(e);
        if (pixel) showValues(...pixel);
    });
    document.addEventListener('click', e => {
        const pixel = pixelAt(e);
        if (pixel) setCursor(...pixel);
    });
    document.addEventListener('toggle', update, true);
    window.addEventListener('resize', update);
    /* What takes time is drawn when it is nearly seen. */
    const watcher = new IntersectionObserver(entries => {
        for (const entry of entries) {
            const scene = scenes.find(s => s.section == entry.target);
            scene.near = entry.isIntersecting;
            if (scene.near) updateScene(scene);
        }
    }, {rootMargin: '300px'});
    for (const scene of scenes) watcher.observe(scene.section);
    update();
}
window.addEventListener('load', begin);
