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

/* A test in a window of its own, in which the page complains of nothing and loads nothing. */
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
const values = () => page.textContent('#values');
const zoom = () => page.textContent('#zoom');

/* When all that was begun is drawn. */
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

/* The scene comes to the top; what is chosen in it; one of its pictures. */
const goToScene = () => ask(scene + '.section.scrollIntoView()').then(settle);
const setCursor = (x, y) => ask(`setCursor(${scene}, ${x}, ${y})`).then(settle);
const hideCursor = () => ask('document.querySelectorAll(".cursor").forEach(c => c.remove())');
const figure = name => page.locator(`section:has(h3:text-is("zbuffer")) [data-name=${name}]`);

/* Which pictures of it are seen, and how far from the window's edge. */
const shown = () => ask(`Object.keys(${scene}.figures)
    .filter(name => ${scene}.figures[name].clientWidth).join()`);
const edges = side => figure('yours').locator('..').locator('figure:visible .view').evaluateAll(
    (views, side) => views.map(view => Math.round(view.getBoundingClientRect()[side])), side);

/* Where on the screen the middle of a pixel is. */
async function placeOf(name, x, y) {
    const box = await figure(name).locator('.sheet').boundingBox();
    return [box.x + (x + 0.5) * box.width / size, box.y + (size - y - 0.5) * box.height / size];
}

/* Colours of the window at some points, as the eye sees them. */
async function seen(points) {
    const data = (await page.screenshot()).toString('base64');
    return ask(async ([data, points]) => {
        const image = make('img', {src: 'data:image/png;base64,' + data});
        await image.decode();
        return points.map(([x, y]) => colorAt(
            image, Math.floor(x), image.height - 1 - Math.floor(y)).join());
    }, [data, points]);
}

/* Nothing is wider than the window, no control lies on another, and all can be read and reached. */
async function judgeLayout() {
    assert.ok(await ask('document.documentElement.scrollWidth <= innerWidth'), 'too wide');
    const torn = await ask(() => {
        const boxes = [...document.querySelectorAll('.tools button, .tools output')]
            .map(element => [element.id, element.getBoundingClientRect()]);
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

/* Beside a diagnosis is the picture of that mistake, which is what was drawn. */
async function judgeLooks() {
    const found = await ask(() => [...document.querySelectorAll('.looks')].map(
        looks => [...looks.querySelectorAll('img')].map(image => [...allOf(image)])));
    assert.ok(found.length >= 2, 'no diagnosis');
    for (const [mistake, small, ...more] of found) {
        assert.equal(Math.max(...mistake), 255);
        assert.ok(mistake.join() == small.join() && more.length == 0, 'not what was drawn');
    }
}

for (const colorScheme of ['dark', 'light']) {
    on('report.html', {...desktop, colorScheme}, 'desktop, ' + colorScheme, async () => {
        await judgeLayout();
        await judgeContents();
        await judgeLooks();
        await goToScene();
        assert.equal(new Set(await edges('top')).size, 1, 'not side by side');
    });
    on('report.html', {...phone, colorScheme}, 'phone, ' + colorScheme, async () => {
        await judgeLayout();
        await goToScene();
        assert.equal(new Set(await edges('left')).size, 1, 'not below each other');
        await figure('yours').locator('.sheet').tap();
        assert.match(await values(), /^\(\d+,\d+\).*yours.*reference/);
        await page.tap('#slide');
        assert.equal(await shown(), 'slide');
        await page.tap('#side');
        await ask('document.querySelectorAll("details").forEach(d => { d.open = true; })');
        await settle();
        await judgeLayout();
    });
}

const keyOf = {side: 's', slide: 'l', yours: 'y', reference: 'r', difference: 'd', errors: 'e'};
for (const way of ['buttons', 'keys']) {
    on('report.html', desktop, way, async () => {
        for (const mode of ['slide', 'yours', 'reference', 'difference', 'errors', 'side']) {
            await (way == 'keys' ? press(keyOf[mode]) : click(mode));
            const all = 'yours,reference,difference,errors';
            assert.equal(await shown(), mode == 'side' ? all : mode);
            assert.equal(await page.locator('[aria-pressed=true]').getAttribute('id'), mode);
        }
    });
}

on('report.html', desktop, 'errors', async () => {
    await goToScene();
    const counts = (await figure('errors').locator('.scale li').allTextContents())
        .map(line => Number(line.replace(/.*: |,| pixels?/g, '')));
    const sum = counts => counts.reduce((a, b) => a + b, 0);
    assert.equal(sum(counts), size * size);
    assert.equal(sum(counts.slice(2)), pixels(item.apart_percent));
    const colors = await figure('errors').locator('.scale i').evaluateAll(
        all => all.map(square => square.style.background));
    assert.equal(new Set(colors).size, 6);
});

/* Not smoothed: each pixel is one square of its own colour, and the values are those told. */
on('report.html', desktop, 'zoom', async () => {
    await goToScene();
    await click('wrong');
    assert.equal(await zoom(), '8x');
    assert.match(await values(), /wrong: place 1 of /);
    await setCursor(x, y);
    const places = async name => {
        const [left, top] = await placeOf(name, x, y);
        return [[0, 0], [-3.5, -3.5], [3.5, -3.5], [-3.5, 3.5], [3.5, 3.5]]
            .map(([i, j]) => [left + i, top + j]);
    };
    await page.mouse.move(...(await places('yours'))[0]);
    assert.ok((await values()).replace(/ +/g, ' ').startsWith(
        `(${x},${y}) yours ${yours} reference ${right} `), await values());
    await hideCursor();
    assert.deepEqual(await seen(await places('yours')), Array(5).fill(yours));
    assert.deepEqual(await seen(await places('reference')), Array(5).fill(right));
    const below = await placeOf('difference', x, y - 1);
    assert.deepEqual(await seen([below]), ['0,0,0'], 'a wrong pixel below the first');
    const scrolled = await figure('yours').locator('..').locator('.view:visible').evaluateAll(
        views => views.map(view => view.scrollLeft));
    assert.equal(new Set(scrolled).size, 1, 'not scrolled together');
    await click('larger', 'larger');
    await setCursor(x, y);
    assert.equal(await figure('yours').locator('.values').count(), 1, 'no numbers at 32x');
    await click(...Array(6).fill('smaller'));
    assert.equal(await zoom(), 'fit');
});

on('report.html', desktop, 'marks', async () => {
    await goToScene();
    await click('larger', 'marks'); /* 1x: as many marks as wrong pixels */
    const marked = await ask(`allOf(${scene}.figures.yours.querySelector('.marks'))
        .filter((value, i) => i % 4 == 3 && value > 0).length`);
    assert.equal(marked, pixels(item.wrong_percent));
    await click('marks');
    assert.equal(await figure('yours').locator('.marks').isVisible(), false);
});

on('report.html', desktop, 'slider', async () => {
    await click('slide', 'larger');
    await setCursor(x, y);
    await hideCursor();
    const range = figure('slide').locator('input');
    const {width, height} = await range.boundingBox();
    for (const [beside, color] of [[40, yours], [-40, right]]) { /* yours is left of its handle */
        await range.click({position: {x: width * (x + beside) / size, y: height / 2}});
        assert.deepEqual(await seen([await placeOf('slide', x, y)]), [color]);
    }
    await range.focus();
    await press('Home', 'ArrowRight');
    assert.equal(await figure('slide').locator('.divider').evaluate(d => d.style.left), '0.5%');
});

/* Tab reaches everything, from the first to the last, and it is seen where one is. */
on('report.html', desktop, 'Tab', async () => {
    const reached = [];
    for (let at = ' '; at && reached.length < 200; reached.push(at)) {
        await page.keyboard.press('Tab');
        let outline;
        [at, outline] = await ask(`(e => [e == document.body ? '' : e.id || e.className ||
            e.textContent.slice(0, 12) || e.type, getComputedStyle(e).outlineStyle])(
            document.activeElement)`);
        assert.ok(!at || outline != 'none', 'not seen: ' + at);
    }
    for (const name of [...Object.keys(keyOf), 'smaller', 'larger', 'marks', 'wrong',
        'Keys and col', 'step01_line', 'Messages', 'view']) {
        assert.ok(reached.includes(name), name);
    }
    const after = async (selector, key, what) => {
        await page.focus(selector);
        await press(key);
        return ask(what);
    };
    assert.equal(await after('#difference', 'Enter', 'mode'), 'difference');
    assert.equal(await after('#errors', ' ', 'mode'), 'errors');
    assert.ok(await after('main summary', 'Enter', 'document.querySelector("details").open'));
});

on('report.html', desktop, 'other keys', async () => {
    const after = (...keys) => press(...keys).then(() => ask(
        '({mode, marked, zoom: byId("zoom").textContent, at: unfolded().indexOf(current())})'));
    assert.equal((await after(' ')).mode, 'yours');
    assert.equal((await after(' ')).mode, 'reference');
    const first = (await after('s', 'n')).at;
    assert.equal((await after('n', 'n')).at, first + 2);
    assert.equal((await after('p')).at, first + 1);
    await figure('yours').locator('.view').focus();
    await setCursor(x - 11, y - 1);
    await press('Shift+ArrowRight', 'ArrowRight', 'ArrowUp');
    assert.ok((await values()).startsWith(`(${x},${y})`), await values());
    assert.equal((await after('m')).marked, true);
    assert.equal((await after('m', 'w')).zoom, '8x');
    assert.equal((await after('-', '-', '-', '-')).zoom, 'fit');
    assert.equal((await after('+')).zoom, '1x');
});

/* A small picture: one red pixel, which should be two lines. */
on('open.html', desktop, 'make open', async () => {
    const image = page.locator('[data-name=yours] img').first();
    const width = () => image.evaluate(image => image.width);
    const left = name => page.$eval(`[data-name=${name}] .view`, view => view.scrollLeft);
    assert.equal(await page.locator('figure:visible').count(), 4);
    assert.ok(await width() > 100 && await width() % 100 == 0, 'not enlarged by a whole number');
    assert.equal(await image.evaluate(i => getComputedStyle(i).imageRendering), 'pixelated');
    await press('+', '+');
    assert.equal(await width(), 200);
    await press('-', '-', '-');
    assert.equal(await zoom(), 'fit');
    await press(...Array(9).fill('+'));
    assert.equal(await width(), 3200);
    await image.hover({position: {x: 52.5 * 32, y: (99 - 41 + 0.5) * 32}});
    assert.equal(await values(), '(52,41) yours 255,0,0 reference 0,0,0  error 255');
    assert.ok(await left('yours') > 0);
    assert.equal(await left('difference'), await left('yours'), 'not scrolled together');
});
