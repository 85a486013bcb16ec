/*
 * `make live` in a browser, with a course that COURSE names: its programs draw what their references
 * show, the mouse and the keys move what they should, and what a student breaks is said.
 */
'use strict';
const assert = require('node:assert/strict');
const {execFileSync, spawn} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const {after, before, test} = require('node:test');
const axe = require('axe-core');
const {chromium} = require('playwright-core');

const course = process.env.COURSE, pages = process.env.PAGES;
const patience = 200000; /* milliseconds: other stages of .ci/run take the processors */
let browser;

before(async () => {
    browser = await chromium.launch({executablePath: process.env.BROWSER,
                                     args: ['--no-sandbox', '--disable-gpu', '--no-first-run']});
});
after(() => browser.close());

/* Start the server for a lesson, whose program is built as `make live` does it before: its address, and
 * how to end it. */
async function serve(step) {
    execFileSync('make', ['-s', `build/moving/${step}`], {cwd: course});
    const server = spawn('build/live', ['build', 'make -s', step], {cwd: course});
    const address = await new Promise(done => server.stdout.once('data', text => done(`${text}`.trim())));
    const ended = new Promise(done => server.once('exit', done));
    return {address, ended, server};
}

/* A page on a lesson, which complains of nothing; the server ends with it. */
async function on(step, window, hash, judge) {
    const {address, ended, server} = await serve(step);
    const page = await browser.newPage(window);
    page.setDefaultTimeout(patience);
    const wrong = [];
    page.on('pageerror', error => wrong.push(error.stack));
    page.on('console', message => { // a browser asks for an icon of a source that it shows
        if (!message.location().url.endsWith('/favicon.ico')) wrong.push(message.text());
    });
    try {
        await page.goto(address + hash);
        await page.waitForFunction(() => document.querySelector('#pixel').textContent.includes('ms'),
                                   null, {timeout: patience});
        await judge(page, address);
        await page.evaluate(axe.source);
        const found = await page.evaluate(() => axe.run());
        wrong.push(...found.violations.map(v => `${v.id}: ${v.nodes.map(n => n.html)}`));
    } finally {
        await page.close();
        server.kill('SIGINT');
        await ended;
    }
    assert.deepEqual(wrong, []);
}

const desktop = {viewport: {width: 1280, height: 800}, colorScheme: 'light'};
const phone = {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, isMobile: true,
               hasTouch: true, colorScheme: 'dark'};
const has = (page, id, text, timeout = patience) => page.waitForFunction(
    ([id, text]) => document.getElementById(id).textContent.includes(text), [id, text], {timeout});
const picture = (page, name) => page.screenshot({path: `${pages}/live_${name}.png`});
const main = step => `${course}/${step}/main.c`;

/* Change main.c for as long as it takes. */
async function changed(step, from, to, judge) {
    const source = fs.readFileSync(main(step), 'utf8');
    assert.ok(source.includes(from));
    fs.writeFileSync(main(step), source.replace(from, to));
    try {
        await judge();
    } finally {
        fs.writeFileSync(main(step), source);
    }
}

for (const step of ['step01_line', 'step05_zbuffer', 'step08_projection', 'step10_phong']) {
    test(`every scene of ${step} is its reference`, () => on(step, desktop, '', async page => {
        await page.click('button:text-is("difference")');
        for (const button of await page.locator('#scenes button').all()) {
            const scene = await button.textContent();
            if (fs.existsSync(`${course}/tests/reference/${step}/${scene}.png`)) {
                await button.click();
                if (await page.evaluate('scene().frames') === 1) { // an animation's reference is a sheet of frames
                    await has(page, 'pixel', '\n0 pixels differ');
                }
            }
        }
        await picture(page, step);
    }));
}

test('the mouse turns the light, the keys too, and the address keeps it', () =>
    on('step05_zbuffer', desktop, '#scene=zbuffer', async page => {
        const box = await page.locator('#picture').boundingBox();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        await page.mouse.move(x, y);
        await has(page, 'pixel', 'reference');
        await page.mouse.down();
        await page.mouse.move(x + 150, y);
        await page.mouse.up();
        const light = new URLSearchParams(new URL(page.url()).hash.slice(1)).get('light').split(',').map(Number);
        assert.ok(Math.abs(light[0] + Math.sin(1)) < 1e-6 && Math.abs(light[2] + Math.cos(1)) < 1e-6, `${light}`);
        const before = page.url();
        await page.focus('#picture');
        await page.keyboard.press('ArrowLeft');
        assert.notEqual(page.url(), before);
        await page.reload();
        await has(page, 'pixel', 'ms');
        assert.ok(page.url().includes('light'));
        await page.click('#reset');
        await page.click('button:text-is("difference")');
        await has(page, 'pixel', '\n0 pixels differ');
    }));

/* Where on the screen the middle of a pixel is, counted from below. */
const placeOf = (page, x, y) => page.evaluate(([x, y]) => {
    const {size, left, top} = place(visible()), box = canvas.getBoundingClientRect();
    return [box.x + (left + (x + .5) * size) / devicePixelRatio,
            box.y + (top + (shown.height - .5 - y) * size) / devicePixelRatio];
}, [x, y]);

async function dragTo(page, from, to) {
    await settled(page);
    await page.mouse.move(...await placeOf(page, ...from));
    await page.mouse.down();
    await page.mouse.move(...await placeOf(page, ...to));
    await page.mouse.up();
    await settled(page);
}

/* When everything asked is answered. */
const settled = page => page.waitForFunction(() => !asking && !again);

/* A slider becomes that number, by keys alone. */
async function set(page, name, value) {
    const slider = page.locator(`label:has-text("${name}") input`);
    if (await slider.getAttribute('type') === 'checkbox') {
        for (let i = 0; i < 3 && await slider.isChecked() !== Boolean(value); i++) {
            await slider.focus(); /* which it loses where a build has just ended: all are made anew */
            await page.keyboard.press('Space');
        }
        assert.equal(await slider.isChecked(), Boolean(value), name);
        return settled(page);
    }
    await slider.focus();
    const [step, most] = [Number(await slider.getAttribute('step')), Number(await slider.getAttribute('max'))];
    if (step < most / 300) {
        await slider.fill(`${value}`);
    } else {
        await page.keyboard.press(value === most ? 'End' : 'Home');
        for (let now = Number(await slider.inputValue()); now < value - step / 2; now += step) {
            await page.keyboard.press('ArrowRight');
        }
    }
    assert.ok(Math.abs(Number(await slider.inputValue()) - value) < step / 2, name);
    await settled(page);
}

/* A number becomes the one that has this name. */
async function tab(page, name, text) {
    await page.click(`[role=group][aria-label="${name}"] button:text-is("${text}")`);
    await settled(page);
}

const show = async (page, view) => {
    await page.click(`#views button:text-is("${view}")`);
    await settled(page);
};
const wrongPixels = page => page.evaluate('compared("difference").count');
const counted = (page, name) => page.evaluate(name => Number(shown.counters.find(c => c[0] === name)[1]), name);
const level = (page, x, y) => page.evaluate(([x, y]) => colorAt(shown, x, shown.height - 1 - y)[0], [x, y]);
const colorOf = (page, x, y) => page.evaluate(([x, y]) => colorAt(shown, x, shown.height - 1 - y).join(), [x, y]);

/* What the program says of a pixel. */
async function notes(page, x, y) {
    await settled(page);
    await page.evaluate(() => { shown.notes = []; }); /* those of another pixel */
    await page.mouse.move(...await placeOf(page, x + 1, y));
    await page.mouse.move(...await placeOf(page, x, y));
    await page.waitForTimeout(100); /* until it rests there */
    await page.waitForFunction(() => shown.notes.length > 0 && !asking && !again);
    await settled(page);
    return page.evaluate('shown.notes.join("\\n")');
}
const near = (a, b, most = 2e-3) => assert.ok(Math.abs(a - b) <= most, `${a} is not ${b}`);

test('corners of two neighbours move together, by mouse and keys, and no pixel is missing', () =>
    on('step03_triangle', desktop, '#scene=your+own', async page => {
        const before = await page.inputValue('#text');
        await page.focus('#picture');
        await page.keyboard.press('ArrowRight');
        assert.equal(await page.inputValue('#text'), before.replace('4 4', '4.125 4'));
        await page.keyboard.press('n');
        await page.keyboard.press('Shift+ArrowUp'); /* both at (30,10) */
        assert.equal((await page.inputValue('#text')).match(/ 30 11\.25 /g)?.length, 2);
        await dragTo(page, [14, 34], [11, 31]);
        assert.equal((await page.inputValue('#text')).match(/ 11 31 /g)?.length, 2);
        await set(page, 'orange', 1);
        assert.deepEqual([await counted(page, 'pixels_too_often'), await counted(page, 'pixels_missing')], [0, 0]);
        await page.click('#reset');
        await set(page, 'orange', 1);
        await tab(page, 'attempt', 'box in double'); /* what lies on the common side, twice */
        assert.equal(await counted(page, 'pixels_too_often'), 13);
        assert.equal(await colorOf(page, 22, 22), '255,150,0');
        await picture(page, 'counted');
        await tab(page, 'attempt', 'open sides'); /* and never, with one on an outer side */
        assert.equal(await counted(page, 'pixels_missing'), 18);
        await set(page, 'fraction', 0); /* from a pixel's middle to its upper right corner */
        assert.match(await notes(page, 22, 22), /1: E0 = \+20\.0000, inside/);
        await page.click('#reset');
        await settled(page);
        const said = await notes(page, 22, 22);
        assert.match(said, /1: weights 0\.0000, 0\.\d+, 0\.\d+\n/);
        assert.match(said, /1: E0 = \+0\.0000, on it\n.*\n.*\n.*\n.*\n.*2: E1 = \+0\.0000, on it, a top or left edge/);
        await changed('step03_triangle', 'if (columns.begin >= columns.end', 'if (columns.begin < columns.end', async () => {
            await page.waitForFunction(() => shown.pixels.every((v, i) => i % 4 === 3 || v === 0), null, {timeout: patience});
            assert.match(await notes(page, 20, 20), /1: E0 = \+80\.0000\n.*\n.*\n.*2: E0 = .*\n.*2: E1 = -80\.0000/); /* of part a */
        });
    }));

test('the ends of a line are dragged; an attempt, its wrong pixels, and half of its steps', () =>
    on('step01_line', desktop, '#scene=your+own', async page => {
        await dragTo(page, [80, 40], [83, 90]);
        await set(page, 'red is wrong', 1);
        assert.equal(await counted(page, 'pixels_wrong') + await counted(page, 'pixels_missing'), 0);
        await tab(page, 'attempt', 'a step for each column'); /* a step for every column: a steep line has holes */
        assert.equal(await counted(page, 'pixels_missing'), 47);
        assert.equal(await colorOf(page, 20, 14), '0,90,255');
        await picture(page, 'attempt');
        await set(page, 'share', 0.5);
        const drawn = await page.evaluate(() => shown.pixels.filter((v, i) => i % 4 === 2 && v > 0).length);
        assert.equal(drawn, 36 + 34 - 1); /* columns 13 to 48, rows 13 to 46; one is on both */
        assert.match(await notes(page, 48, 60), /at x = 48 the line is at y = 20 \+ 35 \* 70\/70 = 55\.000, error \+5\.000/);
        await page.click('#reset');
        await dragTo(page, [80, 40], [83, 41]); /* with ties: 21 rows in 70 columns */
        await tab(page, 'attempt', 'by cases');
        await set(page, 'second end', 1);
        await show(page, 'difference'); /* from what the lesson's line() draws, from either end */
        assert.ok(await wrongPixels(page) > 0);
        await tab(page, 'attempt', 'line()');
        assert.equal(await wrongPixels(page), 0);
        await show(page, 'yours');
        await page.focus('#picture');
        await page.keyboard.press('w'); /* there is no reference in which a pixel could be wrong */
        await page.click('#reset');
        await page.fill('#text', 'size 3 3\nend\nline 0 0 2 0 9 9 9\n'); /* `end` is the mark behind a text */
        await settled(page);
        assert.equal(await page.evaluate(() => `${shown.width} ${shown.pixels.filter(v => v === 9).length}`), '3 9');
    }));

test('perspective and its mistake: u, v and w at the cursor, and levels as colours', () =>
    on('step06_texture', desktop, '#scene=room', async page => {
        const numbers = async () => [...(await notes(page, 300, 200)).matchAll(/-?\d+\.\d+/g)].map(Number);
        const [u, v, w, uByW, , byW] = await numbers();
        near(uByW * w, u);
        near(byW * w, 1);
        const right = await colorOf(page, 300, 200);
        await set(page, 'mixed without', 1);
        const wrong = await numbers();
        assert.ok(wrong[2] === 1 && Math.abs(wrong[0] - u) > 0.1 && v !== wrong[1], `${wrong}`);
        assert.notEqual(await page.evaluate('isAsInLesson()'), true);
        await show(page, 'split'); /* affine and correct, beside each other */
        assert.ok((await page.textContent('#pixel')).includes('on the right: the same with affine as in the lesson'));
        const halves = () => page.evaluate(() => {
            const {size, left, top} = place(visible());
            const {data} = context.getImageData(left + 299.5 * size, top + (shown.height - 200.5) * size, 2 * size + 1, 1);
            return [data.slice(0, 3).join(), data.slice(-4, -1).join(), colorAt(shown, 299, 399).join(), colorAt(plain, 301, 399).join()];
        });
        await page.evaluate(() => { zoom = 8; center = [300.5, 399.5]; paint(); }); /* not blurred */
        await page.mouse.move(...await placeOf(page, 300, 200));
        await settled(page);
        const [leftHalf, rightHalf, affine, correct] = await halves();
        assert.deepEqual([leftHalf, rightHalf], [affine, correct]);
        assert.ok(await page.evaluate('plain.pixels.every((v, i) => v === reference.pixels[i])'));
        await page.evaluate(() => { zoom = 0; });
        await show(page, 'yours');
        await page.click('#reset');
        await settled(page);
        assert.equal(await colorOf(page, 300, 200), right);
        await page.click('button:text-is("checker")');
        await settled(page);
        await set(page, 'its own colour', 1);
        assert.match(await notes(page, 500, 20), /mip level 0\.00/);
        const lightTile = '250,245,235', darkTile = '202,150,142', blueTiles = ['68,105,129', '84,172,214'];
        assert.equal(await colorOf(page, 500, 20), lightTile);
        const coarse = await colorOf(page, 10, 420);
        await tab(page, 'sampler', 'nearest');
        assert.equal(await colorOf(page, 10, 420), darkTile); /* level 0 to the horizon */
        await set(page, 'finest', 2); /* or level 2, to our feet */
        assert.deepEqual([await colorOf(page, 10, 420), await colorOf(page, 500, 20)], blueTiles);
        await tab(page, 'sampler', 'with mip levels');
        assert.deepEqual([await colorOf(page, 10, 420), await colorOf(page, 500, 20)], [coarse, blueTiles[1]]);
        await picture(page, 'levels');
        await page.click('#reset');
        const far = () => page.evaluate(() => [...Array(2000).keys()].flatMap( /* x 300 to 399, y 540 to 559 */
            i => colorAt(shown, 300 + i % 100, 240 + Math.floor(i / 100))));
        const shimmers = [];
        for (const sampler of ['nearest', 'bilinear', 'with mip levels']) { /* between two neighbouring frames */
            await tab(page, 'sampler', sampler);
            await set(page, 'how far the camera walks', 0);
            const before = await far();
            await page.keyboard.press('ArrowRight');
            await settled(page);
            shimmers.push((await far()).reduce((sum, value, i) => sum + Math.abs(value - before[i]), 0));
        }
        assert.ok(Math.min(...shimmers.slice(0, 2)) > 3 * shimmers[2] && shimmers[2] > 0, `${shimmers}`);
        await page.click('button:text-is("close")');
        await settled(page);
        await show(page, 'difference');
        const wrongOnes = [];
        for (const attempt of ['nearest by rounding', 'bilinear from corners', 'the sampler']) {
            await tab(page, 'attempt', attempt);
            wrongOnes.push(await wrongPixels(page));
        }
        assert.deepEqual(wrongOnes, [34216, 50876, 0]);
    }));

test('the columns of a matrix are dragged; near plane; a corner through the spaces', () =>
    on('step08_projection', desktop, '#scene=house', async page => {
        const pixel = (x, y) => [Math.floor((x + 2) / 4 * 405), Math.floor((y + 2) / 4 * 363)];
        assert.equal(await colorOf(page, ...pixel(0.28, 0.3)), '96,62,40'); /* the door */
        await dragTo(page, [(1 + 2) / 4 * 405 - .5, 363 / 2 - .5], pixel(1, 1));
        near(await page.evaluate('chosen.right_y'), 1, 0.051);
        await set(page, 'times y', 0.2);
        const [[x, y], [, , mappedW], [, onX, onY], ...matrix] = (await notes(page, ...pixel(1 / 1.16, 1.8 / 1.16))).split('\n').map(
            line => [...line.matchAll(/-?\d+\.?\d*/g)].map(Number));
        assert.deepEqual([x, y], [1, 0.8]);
        near(mappedW, 1.16);
        near(onX, 1 / 1.16);
        near(onY, 1.8 / 1.16, 0.051);
        assert.deepEqual(matrix, [[1, 0, 0], [1, 1, 0], [0, 0.2, 1]]);
        await set(page, 'times y', 0);
        await dragTo(page, pixel(0, 1), pixel(1, 1)); /* both columns at one place */
        await dragTo(page, pixel(1, 1), pixel(1, 0)); /* and the first one away */
        assert.deepEqual(await page.evaluate('[chosen.right_x, chosen.right_y, chosen.up_x, chosen.up_y]'), [1, 0, 1, 1]);
        await dragTo(page, pixel(1, 1), pixel(0, 1));
        await dragTo(page, pixel(1, 0), pixel(1, 1));
        assert.equal(await colorOf(page, ...pixel(0.28, 0.3 + 0.28)), '96,62,40');
        await picture(page, 'columns');
        await page.click('button:text-is("closeup")');
        await settled(page);
        const before = await counted(page, 'faces_clipped');
        await set(page, 'of the near plane', 0.125);
        assert.ok(before > 0 && await counted(page, 'faces_clipped') > before);
        await show(page, 'difference');
        await tab(page, 'attempt', 'divided by any w');
        assert.equal(await counted(page, 'faces_clipped'), 0);
        assert.ok(await wrongPixels(page) > 1000);
        await picture(page, 'uncut');
        const [outside, all] = [await counted(page, 'faces_outside'), await counted(page, 'faces')];
        await tab(page, 'attempt', 'left out');
        assert.ok(await counted(page, 'faces_outside') > outside && await counted(page, 'faces_outside') < all);
        await show(page, 'yours');
        await page.click('button:text-is("wall")');
        await settled(page);
        const row = async () => (await notes(page, 400, 390)).split('\n').slice(-3).map(
            line => [...line.matchAll(/-?\d+\.\d+/g)].map(Number));
        const [[uByW, , byW], [u, , w], [affine]] = await row();
        near(uByW / byW, u);
        near(byW * w, 1);
        assert.ok(affine > u + 0.1);
        const beside = () => colorOf(page, 500, 390), right = await beside();
        await set(page, 'mixed without', 1);
        assert.notEqual(await beside(), right);
        await set(page, 'far end', 4);
        const [, , affineThere] = await row();
        await show(page, 'split');
        assert.ok(await page.evaluate('plain !== null'), 'correct, with the same far end, beside it');
        assert.ok(await page.evaluate('plain.pixels.some((v, i) => v !== reference.pixels[i])'));
        assert.ok(affineThere[0] !== affine);
        await picture(page, 'split');
        await page.reload(); /* the address keeps what is shown */
        await page.waitForFunction(() => shown && view === 'split' && chosen.affine === 1);
        await page.click('button:text-is("yours")');
        await page.click('#reset');
        await settled(page);
        await set(page, 'far end', 8);
        assert.ok((await row())[1][2] > w);
        await page.click('button:text-is("lookat")');
        await settled(page);
        const [, seen, clip, ndc, screen] = (await notes(page, 400, 400)).split('\n').map(
            line => [...line.matchAll(/-?\d+\.\d+/g)].map(Number));
        assert.deepEqual(seen, clip.slice(0, 3)); /* projection adds w alone */
        near(1 - seen[2] / Math.sqrt(6), clip[3]);
        near(clip[0] / clip[3], ndc[0]);
        near((ndc[0] + 1) * 400, screen[0], 0.5);
        near(screen[1], 400, 20);
        await page.click('button:text-is("projection")'); /* no corner of the small head in the corner */
        await settled(page);
        assert.equal((await notes(page, 400, 400)).match(/corner/g).length, 1);
    }));

test('ends of segments are dragged before a row of depths; painter, bits', () =>
    on('step05_zbuffer', desktop, '#scene=rows', async page => {
        assert.equal(await colorOf(page, 60, 100), '255,0,0');
        await dragTo(page, [120.7 - .5, 434 + 140 - .5], [40, 600]); /* green, now also at x = 60 */
        assert.equal(await colorOf(page, 60, 100), '0,255,0');
        await show(page, 'split');
        await tab(page, 'attempt', "the painter's order"); /* red and blue cross at 511, and blue is in front everywhere */
        const colors = await page.evaluate(() => [shown, plain].map(frame =>
            [400, 500, 580].map(x => colorAt(frame, x, frame.height - 1 - 100).join())));
        assert.deepEqual(colors, [['0,255,0', '0,0,255', '0,0,255'], ['0,255,0', '0,0,255', '255,0,0']]);
        await picture(page, 'painter');
        await show(page, 'yours');
        await page.click('button:text-is("zbuffer")');
        await settled(page);
        await page.click('button:text-is("difference")');
        await has(page, 'pixel', '\n0 pixels differ');
        assert.ok(await counted(page, 'pixels_hidden') > 0);
        const all = await counted(page, 'pixels_tested');
        await show(page, 'yours');
        await tab(page, 'attempt', "the painter's");
        assert.equal(await counted(page, 'pixels_hidden'), 0);
        const apart = await page.evaluate(async () => {
            const {pixels} = await readPicture('reference/zbuffer.png');
            return shown.pixels.filter((v, i) => v !== pixels[i]).length;
        });
        assert.equal(apart, 0); /* seen from the front, no order of these faces is wrong */
        await page.click('button:text-is("side")');
        await show(page, 'difference');
        const wrong = [];
        for (const attempt of ["the file's order", "the painter's", 'a depth for each face', 'depth buffer']) {
            await tab(page, 'attempt', attempt);
            wrong.push(await wrongPixels(page));
        }
        assert.deepEqual(wrong, [10808, 12, 12, 0]);
        await show(page, 'yours');
        await set(page, 'share', 0.5);
        assert.ok(await counted(page, 'pixels_tested') < all);
        await set(page, 'share', 0.7);
        const drawn = new Set();
        for (let i = 0; i < 20; i++) { /* one by one: a step more is at most one face more */
            await page.keyboard.press('ArrowRight');
            await settled(page);
            drawn.add(await counted(page, 'pixels_tested'));
        }
        assert.ok(drawn.size > 5);
        await page.click('[aria-label^="play share"]');
        await page.waitForFunction(() => chosen.faces === 1 && playing === null, null, {timeout: patience});
        await settled(page);
        assert.ok(await page.evaluate(() => shown.pixels.some(v => v > 100)));
        await page.click('button:text-is("cards")');
        await settled(page);
        assert.equal(await colorOf(page, 230, 160), '230,190,40');
        await set(page, 'bits', 4); /* as near as red, which came first */
        assert.equal(await colorOf(page, 230, 160), '220,60,50');
    }));

test('cuts of a sphere against the error; steps of toon; a window over the lines; work', async () => {
    await on('step07_gouraud', desktop, '#scene=sphere', async page => {
        const error = () => counted(page, 'error_in_thousandths');
        const few = await error();
        await set(page, 'cut into four', 4);
        near(few / await error(), 9, 1); /* a third for four times the triangles, as README says */
        await tab(page, 'look', 'flat');
        near(await error(), 4840, 100);
        await tab(page, 'look', 'a normal at each pixel');
        near(await error(), 612, 20);
    });
    await on('step09_shaders', desktop, '#scene=toon', async page => {
        const shades = () => page.evaluate(() => new Set(shown.pixels.filter((v, i) => i % 4 === 0)).size);
        const full = () => page.evaluate(() => shown.pixels.filter((v, i) => i % 4 === 0 && v === 255).length);
        assert.equal(await shades(), 5);
        const fifth = await full();
        await set(page, 'steps', 3); /* a third of the light is in the last step, not a fifth */
        assert.equal(await shades(), 3);
        assert.ok(await full() > 1.2 * fifth);
    });
    await on('step09_shaders', desktop, '#scene=skipped', async page => {
        const blue = () => page.evaluate(() => shown.pixels.filter((v, i) => i % 4 === 2 && v > 2 * shown.pixels[i - 2]).length);
        const yellow = () => page.evaluate(() => shown.pixels.filter((v, i) => i % 4 === 1 && v > 40 + shown.pixels[i + 1]).length);
        assert.ok(await blue() > 20000 && await yellow() > 20000);
        assert.ok(await counted(page, 'seen_white') > 5000 && await counted(page, 'outside_red') > 100);
        await picture(page, 'skipped');
        await set(page, 'degrees', 0); /* from the camera itself: what is skipped is not seen */
        assert.ok(await blue() === 0 && await yellow() < 100, `${await yellow()}`);
    });
    await on('step02_wireframe', desktop, '#scene=enlarged', async page => {
        const drawn = await counted(page, 'lines_drawn');
        await dragTo(page, [1.08 / 2 * 480 - .5, 1.42 / 2 * 360 - .5], [470, 180]);
        assert.ok(drawn > 0);
        assert.equal(await counted(page, 'lines_drawn'), 0);
        await page.click('button:text-is("border")');
        await show(page, 'difference');
        const wrong = [];
        for (const attempt of ['sides in one direction', 'each side once']) {
            await tab(page, 'attempt', attempt);
            wrong.push(await wrongPixels(page));
        }
        await page.click('button:text-is("cut")');
        for (const attempt of ['every pixel tested', 'ends rounded', 'line_inside()']) {
            await tab(page, 'attempt', attempt);
            wrong.push(await wrongPixels(page));
        }
        assert.deepEqual(wrong, [525, 0, 0, 301, 0]);
    });
    await on('step04_flat', desktop, '#scene=flat&view=difference', async page => {
        const wrong = [];
        for (const attempt of ['not normalized', 'inward', 'absolute', 'a guessed root', 'two', 'face_intensity()']) {
            await tab(page, 'attempt', attempt);
            wrong.push(await wrongPixels(page));
        }
        assert.ok(wrong.every((count, i) => i === 5 ? count === 0 : i === 4 ? count < 2000 : count > 20000), `${wrong}`);
        await show(page, 'yours');
        await page.click('#reset');
        await settled(page);
        const levels = [await level(page, 400, 520)];
        for (const x of [430, 370]) { /* by the same angle to either side: n . l is linear in l */
            await dragTo(page, [400, 520], [x, 520]);
            levels.push(await level(page, 400, 520));
            levels.push(await page.evaluate('chosen.light'));
            await page.click('#reset');
            await settled(page);
        }
        const [ahead, left, [x, , z], right, [otherX]] = levels;
        near(x, -otherX);
        assert.ok(Math.abs(x) > 0.1 && left !== right, `${levels}`);
        near(left + right, -2 * z * ahead, 2);
    });
    for (const step of ['step09_shaders', 'step10_phong']) {
        await on(step, desktop, '#scene=four&view=difference', async page => {
            const name = step === 'step10_phong' ? 'both' : 'Gouraud textured';
            const quarter = await page.evaluate(() => colorAt(shown, 600, 600));
            const shaded = await counted(page, 'pixels_shaded');
            await page.check('#all'); /* --no-skip */
            await settled(page);
            assert.ok(await counted(page, 'pixels_shaded') > shaded);
            assert.equal(await wrongPixels(page), 0);
            await page.uncheck('#all');
            await tab(page, 'shader', name); /* the one at the lower right, twice as large */
            const whole = await page.evaluate(() => colorAt(shown, 400, 400));
            whole.forEach((v, i) => near(v, quarter[i], 40));
            assert.ok(await wrongPixels(page) > 100000);
        });
    }
    await on('step07_gouraud', desktop, '#scene=gouraud', async page => {
        const dark = () => page.evaluate(() => colorAt(shown, 330, 400)[0]);
        const before = await dark();
        await tab(page, 'attempt', 'not clamped');
        await show(page, 'difference');
        assert.ok(await wrongPixels(page) > 1000, `${before}`);
        await tab(page, 'attempt', 'flat');
        assert.ok(await wrongPixels(page) > 10000);
        await page.click('#reset');
        await settled(page);
        await has(page, 'pixel', '\n0 pixels differ');
    });
});

test('the camera comes nearer until it is in the wall; the view and its zoom are in the address', () =>
    on('step08_projection', desktop, '#scene=projection', async page => {
        const width = () => page.evaluate(() => {
            const at = [...Array(800).keys()].filter(x => colorAt(shown, x, 350).join() !== '0,0,0');
            return at.at(-1) - at[0];
        });
        const near = await width();
        await set(page, 'distance of the camera', 20); /* flatter, and what is before z = 0 is smaller */
        assert.deepEqual(await page.evaluate('chosen.eye'), [0, 0, 20]);
        assert.ok(await width() !== near);
        await page.click('button:text-is("wall")');
        await settled(page);
        assert.equal(await counted(page, 'faces_clipped'), 0);
        await set(page, 'distance of the camera', 1);
        assert.equal(await counted(page, 'faces_clipped'), 2);
        await tab(page, 'attempt', 'left out');
        assert.equal(await counted(page, 'faces_outside'), 2);
        await page.focus('#picture');
        for (const key of ['+', '+', '+']) {
            await page.keyboard.press(key);
        }
        const zoomed = await page.evaluate('[zoom, view, chosen.attempt].join()');
        await page.keyboard.press('d');
        await settled(page);
        assert.ok(await wrongPixels(page) > 10000);
        await page.reload();
        await page.waitForFunction(() => shown && plain);
        assert.equal(await page.evaluate('[zoom, view, chosen.attempt].join()'), zoomed.replace('yours', 'difference'));
        const drags = () => page.locator('#drags button').allTextContents();
        assert.deepEqual(await drags(), ['picture', 'light', 'camera']);
        await page.click('button:text-is("house")');
        assert.deepEqual(await drags(), ['picture', 'points']); /* no light falls on it */
        await settled(page);
        await set(page, 'in space', 1);
        await set(page, 'times y', 0.2);
        const sketch = (x, y, w) => [(.36 * x + .16 * y + 1) / 4 * 405, (.26 * y + .9 * w + .2) / 4 * 363].map(Math.floor);
        assert.equal(await colorOf(page, ...sketch(-1.5, 1.8, 1)), '60,60,60'); /* the plane */
        assert.equal(await colorOf(page, ...sketch(.28, .3 / 1.06, 1)), '96,62,40'); /* the door on it */
        const roof = await page.evaluate(([x, y]) => [-1, 0, 1].flatMap(i => [-1, 0, 1].map(k => colorAt(shown, x + i, shown.height - 1 - y + k)[0])),
                                         sketch(.5, 1.35, 1.27)); /* outlined where its w is */
        assert.ok(roof.includes(255), `${roof}`);
        await picture(page, 'space');
    }));

test('the pixel under the cursor is a parallelogram on the texture', () =>
    on('step06_texture', desktop, '#scene=checker', async page => {
        const outline = () => page.evaluate(() => {
            const at = [];
            for (let i = 0; i < shown.pixels.length; i += 4) {
                if (shown.pixels[i] === 255 && shown.pixels[i + 1] === 0 && shown.pixels[i + 2] === 255) {
                    at.push([i / 4 % shown.width, Math.floor(i / 4 / shown.width)]);
                }
            }
            const ends = i => [Math.min(...at.map(p => p[i])), Math.max(...at.map(p => p[i]))];
            const [[left, right], [top, bottom]] = [ends(0), ends(1)];
            const corner = at.find(([x]) => x === right); /* the rightmost one, from the middle */
            return [(right - left) / (bottom - top), ((top + bottom) / 2 - corner[1]) / ((right - left) / 2)];
        });
        await set(page, 'on the texture', 1);
        for (const [x, y] of [[500, 500], [500, 200]]) {
            const said = await notes(page, x, y);
            const [ru, rv, uu, uv] = said.match(/right \((.*), (.*)\), up \((.*), (.*)\)/).slice(1).map(Number);
            const [u, v] = Math.abs(ru + uu) > Math.abs(ru - uu) ? [ru + uu, rv + uv] : [ru - uu, rv - uv];
            const [wide, corner] = await outline();
            near(wide, (Math.abs(ru) + Math.abs(uu)) / (Math.abs(rv) + Math.abs(uv)), 0.05);
            near(corner, v / u, 0.15);
            const place = text => text.match(/u (\S+) +v (\S+)/).slice(1).map(Number);
            const [here, above] = [place(said), place(await notes(page, x, y + 8))];
            assert.equal(Math.sign(uv), Math.sign(above[1] - here[1]));
            assert.equal(Math.sign(uu), Math.sign(above[0] - here[0]));
        }
        await picture(page, 'footprint');
    }));

test('n, l and r at the cursor are those of the formula', () =>
    on('step10_phong', desktop, '#scene=four', async page => {
        const lines = (await notes(page, 200, 600)).split('\n').map(
            line => [...line.matchAll(/[-+]\d+\.\d+/g)].map(Number));
        const [n, l, r, v] = lines, dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        near(dot(n, l), l[3]);
        [0, 1, 2].forEach(i => near(r[i], 2 * l[3] * n[i] - l[i], 4e-3));
        near(dot(r, v), v[3], 4e-3);
        near(dot(n, n), 1, 4e-3);
        await set(page, 'of the ambient', 0);
        await set(page, 'of the diffuse', 0);
        await set(page, 'power of', 3); /* only the highlight, half as bright as white */
        near(await level(page, 200, 600), 127.5 * v[3] ** 3, 1);
        await set(page, 'as much specular', 0);
        await set(page, 'of the ambient', 1);
        assert.equal(await colorOf(page, 200, 600), '255,128,255');
        await page.click('#drags button:text-is("light")');
        await dragTo(page, [200, 600], [350, 600]);
        const turned = (await notes(page, 200, 600)).split('\n').map(
            line => [...line.matchAll(/[-+]\d+\.\d+/g)].map(Number));
        near(dot(turned[0], turned[1]), turned[1][3]);
        near(turned[1][1], l[1]); /* about the vertical */
        assert.ok(Math.abs(turned[1][0] - l[0]) > 0.1);
    }));

test('by keys alone: a scene, a view, what is dragged, a number, back to the lesson', () =>
    on('step05_zbuffer', desktop, '', async page => {
        const reach = async text => {
            for (let i = 0; i < 60; i++) {
                await page.keyboard.press('Tab');
                if (await page.evaluate(text => document.activeElement.textContent === text ||
                        document.activeElement.closest('label')?.textContent.startsWith(text) ||
                        `#${document.activeElement.id}` === text, text)) {
                    return page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
                }
            }
            assert.fail(`${text} is not reached`);
        };
        const press = async (...keys) => {
            for (const key of keys) {
                await page.keyboard.press(key);
            }
            await settled(page);
        };
        assert.notEqual(await reach('zbuffer'), 'none');
        await press('Enter');
        assert.equal(await page.evaluate(() => chosen.scene), 'zbuffer');
        assert.notEqual(await reach('#picture'), 'none');
        await press('d');
        await has(page, 'pixel', '\n0 pixels differ');
        await press('ArrowRight'); /* the light */
        near((await page.evaluate(() => chosen.light))[0], -Math.sin(0.1));
        await reach('#picture'); /* Tab goes around */
        await press(' ');
        assert.equal(await page.evaluate(() => view), 'yours');
        await reach('bits');
        await press('Home');
        assert.equal(await page.evaluate(() => chosen.bits), 1);
        await reach('as in the lesson');
        await press('Enter');
        assert.ok(await page.evaluate(() => isAsInLesson()));
    }));

test('zoomed to single pixels their values are shown, and none is blurred', () =>
    on('step01_line', phone, '#scene=line', async page => {
        for (let i = 0; i < 6; i++) {
            await page.click('#larger');
        }
        await has(page, 'zoom', 'x');
        await picture(page, 'phone');
    }));

/* The programs that run behind pages. */
const programs = () => fs.readdirSync('/proc').filter(id => {
    try {
        return fs.readFileSync(`/proc/${id}/cmdline`, 'utf8').includes('--live') &&
               fs.realpathSync(`/proc/${id}/cwd`) === fs.realpathSync(course);
    } catch {
        return false;
    }
});

test("the lesson's figures, by one's own program, now and after the next save", () =>
    on('step03_triangle', desktop, '', async (page, address) => {
        await page.click('header a');
        const figure = page.locator('figure').first(), canvas = figure.locator('canvas');
        await figure.scrollIntoViewIfNeeded();
        await figure.locator('.more').waitFor({timeout: patience});
        const white = () => canvas.evaluate(canvas => {
            const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
            copy.drawImage(canvas, 0, 0);
            return copy.getImageData(0, 0, canvas.width, canvas.height).data.filter((v, i) => i % 4 === 0 && v === 255).length;
        });
        for (let i = 0; i < 600 && await white() === 0; i++) {
            await figure.scrollIntoViewIfNeeded(); /* pictures above it may still arrive */
            await page.waitForTimeout(100);
        }
        assert.equal(await white(), 5, await figure.innerText());
        assert.match(await figure.locator('.numbers').textContent(), /E0 = \+5\.0000, inside/);
        await page.getByRole('button', {name: '(3,3)'}).click(); /* in the table above it */
        await figure.locator('.numbers:has-text("E0 = -2.0000, outside")').waitFor();
        const headings = text => text.match(/^#+ /gm).length;
        assert.equal(await page.locator('main :is(h1, h2, h3, h4)').count(), headings(fs.readFileSync(`${course}/step03_triangle/README.md`, 'utf8')));
        assert.equal(await page.locator('main img').evaluateAll(all => all.filter(i => i.complete && i.naturalWidth === 0).length), 0);
        await changed('step03_triangle', 'if (columns.begin >= columns.end', 'if (columns.begin < columns.end', async () => {
            for (let i = 0; i < 600 && await white() > 0; i++) await page.waitForTimeout(100);
            assert.equal(await white(), 0);
            await page.click('button:text-is("the lesson\'s")');
            assert.ok(await canvas.isHidden() && await figure.locator('img').isVisible());
            await page.click('button:text-is("yours")');
            assert.ok(await canvas.isVisible());
        });
        await figure.locator('.more').click(); /* all scenes, over the page */
        await page.frameLocator('dialog iframe').locator('#pixel:has-text("ms")').waitFor();
        await page.click('dialog > button');
        await picture(page, 'figures');
        assert.equal(new URL(page.url()).pathname, new URL(`${address}figures.html`).pathname);
    }));

test('links lead to other lessons, whose figures are still and say so, and to sources', () =>
    on('step03_triangle', desktop, '', async page => {
        await page.click('header a');
        for (const [link, title, still] of [['4 flat >', 'Lesson 4: flat shading', '04'], ['map of the course', 'A software renderer in ten lessons', null],
                                            ['3 triangle', 'Lesson 3: a filled triangle', null], ['more', 'Lesson 3: more for the curious', null]]) {
            await page.locator('main').getByRole('link', {name: link, exact: true}).first().click();
            await page.locator(`h1:text-is("${title}")`).waitFor();
            assert.equal(await page.locator(`p:has-text("still here. make live STEP=${still}")`).count(), still === null ? 0 : 1, title);
            assert.equal(await page.locator('header .choice').isVisible(), title.startsWith('Lesson 3'), title);
            await page.waitForFunction(() => [...document.images].every(image => image.complete));
            assert.deepEqual(await page.locator('main img').evaluateAll(all => all.filter(i => i.naturalWidth === 0).map(i => i.src)), [], title);
            if (still !== null) assert.equal(await page.locator('[data-live], .panel:not(header)').count(), 0, title);
        }
        const opened = page.context().waitForEvent('response', answer => answer.url().endsWith('/step03_triangle/attempts.h'));
        await page.getByRole('link', {name: 'attempts.h'}).first().click();
        assert.equal(await (await opened).text(), fs.readFileSync(`${course}/step03_triangle/attempts.h`, 'utf8'));
        await page.goBack();
    }));

test('a fault of the compiler, a crash and an endless loop are said, and mended at the next save', () =>
    on('step05_zbuffer', desktop, '#scene=depth', async page => {
        await page.focus('#picture');
        for (const [signal, said] of [['SIGSTOP', 'does every loop end?'], ['SIGKILL', 'step05_zbuffer ended']]) {
            await settled(page);
            programs().forEach(id => process.kill(id, signal));
            await page.keyboard.press('ArrowRight');
            await has(page, 'message', said);
            await page.keyboard.press('ArrowRight');
            await page.waitForFunction(() => document.querySelector('#message').hidden);
        }
        await page.click('#reset');
        const begin = fs.readFileSync(main('step05_zbuffer'), 'utf8').match(/^static void show_depths.*{$/m)[0];
        await changed('step05_zbuffer', begin, `${begin} int x = ;`, async () => {
            await has(page, 'message', 'step05_zbuffer/main.c:');
            await picture(page, 'fault');
        });
        await page.waitForFunction(() => document.querySelector('#message').hidden, null, {timeout: patience});
        await changed('step05_zbuffer', begin, `${begin} *(volatile int *)0 = 1;`,
                      () => has(page, 'message', 'store to null pointer'));
        await page.waitForFunction(() => document.querySelector('#message').hidden, null, {timeout: patience});
        await changed('step05_zbuffer', begin, `${begin} for (;;) {}`,
                      () => has(page, 'message', 'does every loop end?'));
        await page.waitForFunction(() => document.querySelector('#message').hidden, null, {timeout: patience});
        await page.click('button:text-is("difference")');
        await has(page, 'pixel', '\n0 pixels differ');
        await changed('step05_zbuffer', begin, `${begin} if (image != NULL) return;`, () =>
            page.waitForFunction(() => /\n[1-9]\d* pixels differ/.test(
                document.getElementById('pixel').textContent), null, {timeout: patience}));
    }));

/* The status of an answer, 0 for none. */
const status = (address, host, path) => new Promise(done => {
    const {hostname, port} = new URL(address);
    const asked = http.get({hostname, port, path, headers: {host}}, answer => {
        answer.resume();
        answer.on('end', () => done(answer.statusCode));
    });
    asked.on('error', () => done(0));
});

test('nobody else is answered, two lessons go side by side, and nothing is left', async () => {
    const one = await serve('step01_line'), two = await serve('step05_zbuffer');
    const {host, pathname} = new URL(one.address);
    assert.equal(await status(one.address, host, pathname), 200);
    assert.equal(await status(one.address, 'evil.example', pathname), 404);
    assert.equal(await status(one.address, host, '/'), 404);
    for (const file of ['reference/../../../Makefile', 'Makefile', '/etc/alternatives/README.md', `${fs.realpathSync(course)}/README.md`]) {
        assert.equal(await status(one.address, host, pathname + file), 404, file);
    }
    assert.equal(await status(one.address, host, pathname.replace(/[0-9a-f]/, c => c === '0' ? '1' : '0')), 404);
    assert.equal(await status(two.address, new URL(two.address).host, new URL(two.address).pathname + 'state'), 200);
    for (const {server, ended} of [one, two]) {
        server.kill('SIGINT');
        assert.equal(await ended, 0);
    }
    assert.deepEqual(programs(), []);
});
