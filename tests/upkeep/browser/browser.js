/*
 * What the pages of `make check REPORT=` and `make open` do in a browser: see reports.sh, which
 * makes them and names their directory in PAGES. Screenshots go there, too.
 */
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const {after, before, test} = require('node:test');
const axe = require('axe-core');
const {chromium} = require('playwright-core');

const pages = process.env.PAGES;
const report = JSON.parse(fs.readFileSync(pages + '/report.json', 'utf8'));
const items = report.steps.flatMap(step => step.items);
const desktop = {viewport: {width: 1280, height: 800}, colorScheme: 'light'};
const phone = {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, isMobile: true,
               hasTouch: true};
let browser, page;

/* The scene that is looked at closely: its size, and how many pixels are wrong in which way. */
const size = 800, item = items.find(item => item.scene == 'zbuffer');
const [, firstX, firstY, yours, right] =
    item.message.match(/first at \((\d+),(\d+)\): yours ([\d,]+), right ([\d,]+)/);
const [x, y] = [Number(firstX), Number(firstY)];
const pixels = percent => Math.round(percent * item.pixels_drawn / 100);
const scene = 'scenes.find(s => s.name == "zbuffer")';

before(async () => {
    browser = await chromium.launch({executablePath: process.env.BROWSER, args: [
        '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
        '--disable-background-networking', '--disable-component-update', '--disable-sync']});
});
after(() => browser.close());

/* A test in its own window, in which the page complains of nothing and loads nothing. */
function on(file, window, name, judge) {
    test(name, async () => {
        page = await browser.newPage(window);
        page.setDefaultTimeout(10000);
        const wrong = [];
        page.on('pageerror', error => wrong.push(error.stack));
        page.on('console', message => wrong.push(message.text()));
        page.on('dialog', dialog => wrong.push(dialog.message()));
        page.on('request', request => wrong.push('loads ' + request.url()));
        await page.goto(`file://${pages}/${file}`);
        try {
            await judge();
        } finally {
            await picture(name);
            await page.close();
        }
        const own = new RegExp(`^loads (data:|file:.*/${file}$)`);
        assert.deepEqual(wrong.filter(text => !own.test(text)), []);
    });
}

const ask = (what, given) => page.evaluate(what, given);
const picture = name => page.screenshot({path: `${pages}/${name.replace(/\W+/g, '_')}.png`});
const values = () => page.textContent('#pixel');
const zoom = () => page.textContent('#zoom');

/* When everything begun is drawn. */
const settle = () => ask(() => new Promise(done => setTimeout(
    () => requestAnimationFrame(() => requestAnimationFrame(done)), 60)));

async function press(...keys) {
    for (const key of keys) await page.keyboard.press(key);
    await settle();
}

async function click(...ids) {
    for (const id of ids) await page.click('#' + id);
    await settle();
}

/* A scene's picture is clicked: it opens, large. */
async function look(which, name = 'zbuffer') {
    await page.click(`section:has(:is(h2,h3):text-is("${name}")) [data-name=${which}] button`);
    await page.waitForFunction(which => shown && $('viewer').open && view === which &&
        (!sameSize() || made.view === which || which !== 'difference'), which);
    await settle();
}
const setCursor = (x, y) => ask(([x, y]) => {
    cursor = [x, shown.height - 1 - y];
    center = cursor.map(c => c + 0.5);
    paint();
}, [x, y]).then(settle);

/* Where on the screen the middle of a pixel is. */
const placeOf = (x, y) => ask(([x, y]) => {
    const {size, left, top} = place(visible()), box = canvas.getBoundingClientRect();
    return [box.x + (left + (x + 0.5) * size) / devicePixelRatio,
            box.y + (top + (shown.height - 0.5 - y) * size) / devicePixelRatio];
}, [x, y]);

/* Colours of the window at some points, as the eye sees them. */
async function seen(points) {
    const data = (await page.screenshot()).toString('base64');
    return ask(async ([data, points]) => {
        const picture = await readPicture('data:image/png;base64,' + data);
        return points.map(([x, y]) => colorAt(picture, Math.floor(x), Math.floor(y)).join());
    }, [data, points]);
}

/* Nothing is wider than the window, no control lies on another, and all can be read and reached. */
async function judgeLayout() {
    assert.ok(await ask('document.documentElement.scrollWidth <= document.documentElement.clientWidth'), 'too wide');
    const torn = await ask(() => {
        const boxes = [...document.querySelectorAll('dialog[open] form button')]
            .map(element => [element.textContent, element.getBoundingClientRect()]);
        return boxes.flatMap(([a, p]) => boxes.filter(([b, q]) => a != b && p.left < q.right &&
            q.left < p.right && p.top < q.bottom && q.top < p.bottom).map(([b]) => a + ' on ' + b));
    });
    assert.deepEqual(torn, []);
    await ask(axe.source + '; 0');
    const {violations} = await ask('axe.run({runOnly: ["wcag2a", "wcag2aa"]})');
    assert.deepEqual(violations.map(one => [one.help, one.nodes.map(node => node.html)]), []);
}

/* It says what the JSON of the same check says. */
async function judgeContents() {
    assert.equal(await page.textContent('.score'), `SCORE ${report.points}/${report.most}`);
    const rows = await page.locator('tr:has(td)').evaluateAll(rows => rows.map(
        row => [...row.cells].slice(0, 3).map(cell => cell.textContent.trim())));
    assert.deepEqual(rows, report.steps.map(
        step => [step.step, step.state, `${step.points}/${step.most}`]));
    assert.equal(rows.map(row => row[1]).join(), 'FAIL,BUILD,PASS,PASS,FAIL,TODO,CRASH');
    const sections = await page.locator('section').evaluateAll(all => all.map(section =>
        ['h3', 'p', '.looks'].map(name => section.querySelector(name)?.textContent || '')));
    assert.equal(sections.length, items.length);
    items.forEach((item, i) => {
        const [name, note, looks] = sections[i];
        assert.equal(name, item.scene + (item.counter ? ' ' + item.counter : ''));
        /* What waits for its picture has the picture's state in JSON, and says so on the page. */
        const waits = /^its picture must pass/.test(item.message) && item.state != 'TODO';
        const state = waits ? 'NOT JUDGED' : item.state;
        assert.ok(note.startsWith(`${state} ${item.points}/${item.most}`), name + ': ' + note);
        assert.ok(note.includes(item.message || ''), name + ': ' + note);
        assert.ok(looks.includes(item.looks_like || ''), name + ' looks like ' + looks);
    });
    assert.ok((await page.textContent('pre')).includes(
        '</pre><script>document.title=1</script><img src=x onerror=alert(1)>'));
    assert.equal(await page.title(), 'make check');
    assert.equal(await page.locator('script').count(), 1);
    assert.equal(await page.locator('img:not([src^=data])').count(), 0);
}

/* Where a scene's three pictures lie. */
const edges = side => page.locator('section:has(h3:text-is("zbuffer")) .pictures img').evaluateAll(
    (images, side) => images.map(image => Math.round(image.getBoundingClientRect()[side])), side);

for (const colorScheme of ['dark', 'light']) {
    on('report.html', {...desktop, colorScheme}, 'desktop, ' + colorScheme, async () => {
        await judgeLayout();
        await judgeContents();
        assert.equal(new Set(await edges('top')).size, 1, 'not side by side');
        await look('yours');
        await judgeLayout();
    });
    on('report.html', {...phone, viewport: {width: 400, height: 844}, colorScheme}, 'phone, ' + colorScheme, async () => {
        await judgeLayout();
        assert.equal(new Set(await edges('left')).size, 1, 'not below each other');
        await look('difference');
        await judgeLayout();
        for (const button of await page.locator('dialog button:visible').all()) {
            const {x, width} = await button.boundingBox();
            assert.ok(x >= 0 && x + width <= 400, 'cut off: ' + await button.textContent());
        }
        await page.tap('#close');
        await ask('document.querySelectorAll("details").forEach(d => { d.open = true; })');
        await settle();
        await judgeLayout();
    });
}

/* The same by buttons and by keys. */
const keyOf = {yours: 'y', reference: 'r', split: 's', difference: 'd', errors: 'e'};
for (const way of ['buttons', 'keys']) {
    on('report.html', desktop, way, async () => {
        await look('yours');
        for (const name of ['split', 'reference', 'difference', 'errors', 'yours']) {
            await (way == 'keys' ? press(keyOf[name]) : page.click(`#views button:text-is("${name}")`));
            assert.equal(await ask('view'), name);
            assert.equal(await page.textContent('#views [aria-pressed=true]'), name);
        }
        if (way == 'keys') {
            await press(' ');
            assert.equal(await ask('view'), 'reference');
            await press('Escape');
            assert.equal(await ask('$("viewer").open'), false);
        }
    });
}

on('report.html', desktop, 'errors', async () => {
    await look('yours');
    await press('e');
    const counts = (await page.locator('#counters dd').allTextContents()).map(text => Number(text.replaceAll(',', '')));
    const sum = counts => counts.reduce((a, b) => a + b, 0);
    assert.equal(sum(counts), size * size);
    assert.equal(sum(counts.slice(2)), pixels(item.apart_percent));
    const colors = await page.locator('#counters dt').evaluateAll(all => all.map(term => term.style.borderLeftColor));
    assert.equal(new Set(colors).size, 6);
});

/* Not smoothed: each pixel is one square of its own colour, and the values are those told. */
on('report.html', desktop, 'zoom', async () => {
    await look('yours');
    await press('w');
    assert.equal(await zoom(), '8x');
    assert.equal(await ask('view'), 'difference');
    assert.ok(['255,0,0', '0,0,255'].includes(await ask('colorAt(visible(), ...cursor).join()')), 'not wrong');
    const before = await ask('cursor.join()');
    await press('w');
    assert.notEqual(await ask('cursor.join()'), before);
    await setCursor(x, y);
    assert.ok((await values()).includes(`(${x},${y}) ${yours}, reference ${right}, error `), await values());
    await press('+', '+'); /* 32: numbers in the upper part of each pixel */
    await ask('cursor = null; paint()');
    const [left, top] = await placeOf(x, y);
    const corners = [[-14, -14], [14, -14], [-14, 14], [14, 14]].map(([i, j]) => [left + i, top + j]);
    for (const [key, color] of [['y', yours], ['r', right]]) {
        await press(key);
        assert.deepEqual(await seen(corners), Array(4).fill(color));
    }
    await press('d');
    assert.deepEqual(await seen([await placeOf(x, y - 1)]), ['0,0,0'], 'a wrong pixel below the first');
    await press(...Array(7).fill('-'));
    assert.equal(await zoom(), 'fit');
});

/* Yours is left of the cursor, the reference right of it; shrunk, wrong pixels are seen all the same. */
on('report.html', desktop, 'split', async () => {
    await look('yours');
    await setCursor(x, y);
    await press('s', '+', '+');
    for (const [beside, color] of [[40, yours], [-40, right]]) {
        await page.mouse.move(...await placeOf(x + beside, y));
        await settle();
        assert.deepEqual(await seen([await placeOf(x, y)]), [color]);
    }
    await press('d', '-', '-', '-', '-');
    assert.ok(await ask(() => {
        const {size, left, top} = place(shown), {data} = context.getImageData(0, 0, canvas.width, canvas.height);
        return size < 1 && made.wrong.length > 0 && made.wrong.every(at => {
            const [x, y] = [left + at % shown.width * size, top + Math.floor(at / shown.width) * size].map(Math.floor);
            const i = 4 * (y * canvas.width + x);
            return data[i + 1] == 0 && Math.max(data[i], data[i + 2]) == 255 && Math.min(data[i], data[i + 2]) == 0;
        });
    }), 'a wrong pixel is not seen');
});

/* Tab reaches everything, from the first to the last, and it is seen where one is. */
on('report.html', desktop, 'Tab', async () => {
    const reach = async () => {
        const reached = [];
        for (let at = ' '; at && reached.length < 300; reached.push(at)) {
            await page.keyboard.press('Tab');
            let outline;
            [at, outline] = await ask(`(e => [e == document.body ? '' : e.id || e.textContent.slice(0, 12) ||
                e.firstElementChild?.alt || e.type, getComputedStyle(e).outlineStyle])(document.activeElement)`);
            assert.ok(!at || outline != 'none', 'not seen: ' + at);
        }
        return reached;
    };
    const reached = await reach();
    for (const name of ['step01_line', 'Messages', 'zbuffer, yours', 'zbuffer, difference']) {
        assert.ok(reached.includes(name), name);
    }
    await page.focus('section [data-name=yours] button');
    await press('Enter');
    assert.equal(await ask('document.activeElement.id'), 'picture');
    await page.focus('#close');
    const inside = await reach();
    for (const name of ['picture', ...Object.keys(keyOf), 'wrong', 'smaller', 'larger', 'Keys']) {
        assert.ok(inside.includes(name), name);
    }
});

/* A small picture: one red pixel, which should be two lines. */
on('open.html', desktop, 'make open', async () => {
    const image = page.locator('section [data-name=yours] img').first();
    assert.equal(await image.evaluate(i => getComputedStyle(i).imageRendering), 'pixelated');
    await look('yours', 'pixel');
    await page.mouse.move(...await placeOf(52, 41));
    await settle();
    assert.ok((await values()).includes('(52,41) 255,0,0, reference 0,0,0, error 255'), await values());
    await press('d');
    assert.ok((await values()).includes('136 pixels differ'), await values());
});

/* Three groups, of names that are long, in the window of a desk and of a telephone. */
for (const [kind, window] of Object.entries({light: desktop, dark: {...desktop, colorScheme: 'dark'}, phone})) {
    on('class.html', window, `a class, ${kind}`, async () => {
        await judgeLayout();
        assert.equal(await page.locator('h2:text("alike") ~ div >> nth=0 >> tr').count(), 4);
        const first = await page.locator('a bdi').first().textContent();
        assert.ok(await page.getByText('Müller-Hohenwartenberger Jörg_7_assignsubmission_file').first().isVisible(), first);
        const narrow = await page.locator('td:has(bdi)').evaluateAll(all => all.map(cell => cell.offsetWidth).filter(width => width < 100));
        assert.deepEqual(narrow, []);
    });
}
