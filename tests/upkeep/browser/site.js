/*
 * The web pages of `make site`, which SITE names, in a browser: as they open from disk and from a
 * server, for the eye, the keys and without scripts; and the pictures that their programs draw.
 */
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const path = require('node:path');
const {after, before, test} = require('node:test');
const {pathToFileURL} = require('node:url');
const zlib = require('node:zlib');
const axe = require('axe-core');
const {chromium} = require('playwright-core');

const site = fs.realpathSync(process.env.SITE), pictures = process.env.PAGES;
const files = fs.readdirSync(site, {recursive: true}).filter(file => fs.statSync(`${site}/${file}`).isFile());
const pages = files.filter(file => file.endsWith('.html'));
const lessons = fs.readdirSync(site).filter(name => /^step/.test(name)).sort();
const onDisk = file => pathToFileURL(`${site}/${file}`).href;
const size = file => fs.statSync(`${site}/${file}`).size;
const text = file => fs.readFileSync(`${site}/${file}`, 'utf8');
const patience = 200000; /* milliseconds: other stages of .ci/run take the processors */
let browser, server;

before(async () => {
    browser = await chromium.launch({executablePath: process.env.BROWSER,
                                     args: ['--no-sandbox', '--disable-gpu', '--no-first-run']});
    const types = {html: 'text/html', css: 'text/css', js: 'text/javascript', webp: 'image/webp', svg: 'image/svg+xml'};
    server = http.createServer(({url}, answer) => {
        const file = site + new URL(url, 'http://x').pathname;
        answer.writeHead(200, {'Content-Type': types[path.extname(file).slice(1)]});
        fs.createReadStream(file).pipe(answer);
    });
    await new Promise(done => server.listen(0, '127.0.0.1', done));
});
after(() => {
    server.close();
    return browser.close();
});
const served = file => `http://127.0.0.1:${server.address().port}/${file}`;

const desktop = {viewport: {width: 1280, height: 800}, colorScheme: 'light', reducedMotion: 'reduce'};
const phone = {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, isMobile: true, hasTouch: true,
               colorScheme: 'dark'};

/* A page that complains of nothing, and asks nobody else. */
async function on(address, window, judge) {
    const page = await browser.newPage(window), wrong = [];
    page.setDefaultTimeout(patience);
    page.on('pageerror', error => wrong.push(error.stack));
    page.on('console', message => wrong.push(message.text()));
    page.on('request', request => /^(blob|data):/.test(request.url()) ||
        new URL(request.url()).host === new URL(address).host || wrong.push(request.url()));
    await page.goto(address);
    await judge(page);
    await page.close();
    assert.deepEqual(wrong, [], address);
}

const drawn = page => page.waitForFunction(() => document.querySelector('#pixel').textContent.includes('ms'),
                                           null, {timeout: patience});

/* In a live page: how many pixels of a scene are not its reference's. Frames lie on a sheet. */
async function countWrong([scene, png]) {
    const image = new Image();
    image.src = png;
    await image.decode();
    const sheet = new OffscreenCanvas(image.width, image.height).getContext('2d', {willReadFrequently: true});
    sheet.drawImage(image, 0, 0);
    const {frames} = about.scenes.find(({name}) => name === scene);
    const columns = Math.ceil(Math.sqrt(frames)), rows = Math.ceil(frames / columns);
    const width = Math.floor(image.width / columns), height = Math.floor(image.height / rows);
    let wrong = 0;
    for (let i = 0; i < frames; i++) {
        const frame = parseFrame(await program.frame(`--only ${scene} --frame ${i + 1} -s ${width}x${height}\n`));
        const right = sheet.getImageData(i % columns * width, Math.floor(i / columns) * height, width, height).data;
        wrong += frame.pixels?.length !== right.length ? Infinity : frame.pixels.filter((v, at) => v !== right[at]).length;
    }
    return wrong;
}

for (const lesson of lessons) {
    test(`from disk, every scene of ${lesson} is its reference`, () =>
        on(onDisk(`${lesson}/live.html`), desktop, async page => {
            await drawn(page);
            const scenes = await page.evaluate(() => about.scenes.map(({name}) => name));
            const references = fs.readdirSync(`tests/reference/${lesson}`).map(file => file.replace('.png', ''));
            for (const scene of references.filter(name => scenes.includes(name))) {
                const png = fs.readFileSync(`tests/reference/${lesson}/${scene}.png`).toString('base64');
                assert.equal(await page.evaluate(countWrong, [scene, `data:image/png;base64,${png}`]), 0, scene);
            }
            assert.ok(await page.isVisible('a[href="index.html"]'));
        }));
}

test('all links lead somewhere, and none to a source', () => {
    const wrong = [];
    for (const page of pages) {
        for (const [, link] of text(page).matchAll(/(?:href|src)="?([^" >]+)/g)) {
            const [file, id] = link.split('#');
            const target = path.join(path.dirname(page), file || path.basename(page));
            const there = /^(https?|data):/.test(link) || files.includes(target) &&
                (!id || text(target).includes(`id="${id}"`));
            there || wrong.push(`${page}: ${link}`);
        }
    }
    assert.deepEqual(wrong, []);
    assert.deepEqual(files.filter(file => !/\.(html|css|js|webp|svg)$/.test(file)), []);
    assert.ok(!files.some(file => /BEGIN SOLUTION|#include "scenes.h"/.test(text(file))));
});

test('the whole is below 4.8 MB without textures, and a page with its program below 700 kB', t => {
    const textures = files.filter(file => /live\/bust_/.test(file)), sum = files => files.reduce((sum, file) => sum + size(file), 0);
    const whole = sum(files) - sum(textures);
    t.diagnostic(`${whole} bytes, and ${sum(textures)} of textures, which a scene loads that reads them`);
    assert.ok(whole < 4.8e6 && sum(textures) < 3.7e6, `${whole}, ${sum(textures)}`);
    for (const page of pages.filter(file => !file.endsWith('live.html'))) {
        const needed = new Set([page]);
        for (const [, source] of text(page).matchAll(/<(?:img|script|link rel=stylesheet) [^>]*(?:src|href)="([^":]+)"/g)) {
            needed.add(path.join(path.dirname(page), source));
        }
        if (needed.has('live/wasm.js')) needed.add('live/program.js');
        const sent = file => file.endsWith('.webp') ? size(file) : zlib.gzipSync(text(file)).length; /* as hosts of pages do */
        const weight = sum([...needed]), packed = [...needed].reduce((sum, file) => sum + sent(file), 0);
        t.diagnostic(`${page}: ${weight} bytes, ${packed} as it is sent`);
        assert.ok(packed < 700e3 && weight < (page === 'step06_texture/index.html' ? 800e3 : 700e3), `${page}: ${weight}, ${packed}`); /* of lesson 6 pictures are the subject */
    }
});

/* Nothing is wider than the window. (On a telephone innerWidth is as wide as what is in it.) */
async function judgeWidth(page, file) {
    const [width, limit] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
    assert.ok(width <= limit, `${file}: ${width} in ${limit}`);
}

/* In one window: words that can be read, and nothing that is wider, torn or too small. */
async function judgeWindow(page, file, kind) {
    const found = await page.evaluate(() => axe.run());
    assert.deepEqual(found.violations.map(v => `${v.id}: ${v.nodes.map(n => n.html + n.failureSummary)}`), [], file);
    await judgeWidth(page, file);
    const rows = await page.evaluate(() => [...document.querySelectorAll('p:has([width="49%"])')].map(
        p => new Set([...p.querySelectorAll('img')].map(image => image.getBoundingClientRect().bottom)).size));
    assert.ok(rows.every(count => count === 1), `${file}: pictures of one row in ${rows}`);
    const [torn, small] = await page.evaluate(() => [ /* options of code, and words of drawings */
        [...document.querySelectorAll('main :not(pre) > code')].flatMap(({firstChild}) => {
            const range = document.createRange(), texts = document.createTreeWalker(firstChild.parentNode, NodeFilter.SHOW_TEXT), torn = [];
            while (texts.nextNode()) {
                for (const {index, 0: word} of texts.currentNode.data.matchAll(/\S*-\S*/g)) {
                    range.setStart(texts.currentNode, index);
                    range.setEnd(texts.currentNode, index + word.length);
                    if (range.getClientRects().length > 1) torn.push(word);
                }
            }
            return torn;
        }),
        [...document.querySelectorAll('main p > img[src$=".svg"]')].map(image => image.clientWidth / image.getAttribute('width')).filter(scale => scale < .65)]);
    assert.deepEqual([torn, small], [[], []], file);
    await page.screenshot({path: `${pictures}/site_${kind}_${file.replaceAll('/', '_')}.png`});
}

/* axe reads the page as a telephone shows it, and then, which takes a fifth as long, on a desk. */
test('axe finds nothing, and nothing is wider than the window, on a telephone and on a desk', async () => {
    for (const file of pages.filter(name => !/live/.test(name) || /step05/.test(name))) {
        await on(served(file), phone, async page => {
            await page.evaluate(axe.source);
            await judgeWindow(page, file, 'phone');
            await page.setViewportSize(desktop.viewport);
            await page.emulateMedia(desktop);
            await judgeWindow(page, file, 'desktop');
        });
    }
});

test('the keys find a word, and open everything about a figure over the page', () =>
    on(served('step10_phong/index.html'), desktop, async page => {
        await page.focus('#search');
        await page.keyboard.type('fill rule');
        await page.waitForSelector('#found a:text("triangle")');
        await page.screenshot({path: `${pictures}/site_search.png`});
        await page.fill('#search', '');
        const figure = page.locator('figure[data-live^="live: shine"]'), more = figure.locator('.more');
        await figure.scrollIntoViewIfNeeded();
        await more.waitFor();
        await figure.locator('.lamp').press('ArrowLeft');
        await more.press('Enter');
        const live = await (await page.waitForSelector('dialog iframe')).contentFrame();
        await drawn(live);
        const shown = new URLSearchParams(new URL(live.url()).hash.slice(1));
        assert.equal(shown.get('scene'), 'shine');
        assert.equal(shown.get('light').split(',').length, 3);
        const before = await live.evaluate(() => String(shown.pixels));
        await live.focus('#picture');
        await page.keyboard.press('ArrowLeft');
        await live.waitForFunction(before => String(shown.pixels) !== before, before);
        await page.screenshot({path: `${pictures}/site_live.png`});
        await page.keyboard.press('Escape');
        await page.waitForSelector('dialog', {state: 'detached'});
        assert.ok(await more.evaluate(button => button === document.activeElement));
    }));

// ---- Living figures ----

/* What the lesson's program says, built for this machine: its scenes, or the answer to a request. */
function printed(lesson, request = '') {
    const {stdout} = spawnSync(`build/moving/${lesson}`, ['--live'], {input: request, maxBuffer: 1e8});
    const rest = stdout.subarray(stdout.indexOf(10) + 1);
    if (request === '') return JSON.parse(stdout);
    const lines = rest.toString('latin1').split('\n', 100), [, width, height, , count] = lines[0].split(' ').map(Number);
    const counters = Object.fromEntries(lines.slice(1, 1 + count).filter(line => line[0] !== ' ').map(line => line.split(' ')));
    const notes = lines.slice(1, 1 + count).filter(line => line[0] === ' ');
    return {width, height, counters, notes, pixels: rest.subarray(rest.length - 4 * width * height)};
}

/* A figure's picture, as large as one is; and in how many bytes it is another one than that. */
const differs = (figure, [width, height, bytes]) => figure.evaluate(async (figure, [width, height, base64]) => {
    const canvas = figure.querySelector('canvas'), large = new OffscreenCanvas(width, height);
    const context = large.getContext('2d', {willReadFrequently: true});
    context.imageSmoothingEnabled = false;
    context.drawImage(canvas, 0, 0, width, height);
    const {data} = context.getImageData(0, 0, width, height), wanted = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
    return width % canvas.width + data.filter((v, i) => v !== wanted[i]).length;
}, [width, height, bytes]);

/* A PNG's pixels as four bytes each, by the browser. */
const decoded = (page, file) => page.evaluate(async png => {
    const image = new Image();
    image.src = png;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d', {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    const {data} = context.getImageData(0, 0, image.width, image.height);
    let text = '';
    for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
    return [image.width, image.height, btoa(text)];
}, `data:image/png;base64,${fs.readFileSync(file).toString('base64')}`);

/* What a figure's title asks the program for, with these numbers, text, light or camera; said here once more. */
function requestOf(lesson, title, changes) {
    const [scene, ...options] = title.replace('live: ', '').split(', ');
    const given = Object.fromEntries(options.map(option => [option.slice(0, option.indexOf('=')), option.slice(option.indexOf('=') + 1)]));
    const {show, tell = '', at, text, ...numbers} = {...given, ...changes};
    const about = printed(lesson).scenes.find(({name}) => name === scene);
    const words = ['--stats', ...about.text === undefined ? ['--only', scene] : []];
    for (const [name, value] of Object.entries(numbers)) {
        words.push(...['light', 'eye', 'center', 'frame'].includes(name) ? [`--${name}`, value] : ['--set', `${name}=${value}`]);
    }
    if (at) words.push('--probe', at);
    const lines = about.text === undefined ? '' : ` text\n${(text ?? about.text).replaceAll('; ', '\n').trim()}\nend`;
    return {scene: about, given, tells: tell.split(',').filter(Boolean), request: `${words.join(' ')}${lines}\n`};
}

/* It shows that picture, and those numbers. */
async function judge(figure, lesson, changes, what) {
    const title = await figure.getAttribute('data-live'), {tells, request} = requestOf(lesson, title, changes);
    const {width, height, counters, notes, pixels} = printed(lesson, request);
    let count = -1; /* it comes to rest: what is dear is drawn small until then */
    for (let i = 0; count !== 0 && i < 100; i++) {
        await figure.page().waitForTimeout(i > 0 ? 100 : 0);
        count = await figure.locator('canvas').evaluate((c, width) => c.width - width, width) === 0
            ? await differs(figure, [width, height, pixels.toString('base64')]) : -1;
    }
    assert.equal(count, 0, `${what}: ${request}`);
    const numbers = await figure.locator('.numbers').textContent();
    for (const word of tells) {
        const said = word in counters ? [`${word.replaceAll('_', ' ')}: ${Number(counters[word]).toLocaleString('en')}`]
            : notes.map(note => note.slice(1).replace(/^triangle 1: /, '')).filter(note => ` ${note}`.includes(` ${word}`));
        assert.ok(said.every(text => numbers.includes(text)), `${what}: ${numbers} is not ${said}`);
    }
    return request;
}

/* Every figure of a lesson: asleep until it comes into view, then the still picture's pixels; and whatever is
   touched, what the program prints for the same options. */
for (const file of pages.filter(file => /^step/.test(file) && (file.endsWith('index.html') || text(file).includes('data-live')))) {
    test(`the living figures of ${file}`, () => on(served(file), desktop, async page => {
        const lesson = path.dirname(file), figures = await page.locator('figure[data-live]').all();
        assert.ok(figures.length >= (file.endsWith('index.html') ? 3 : 1), 'too few');
        assert.equal(await figures.at(-1).locator('canvas').count(), 0, 'it is awake too early');
        for (const [number, figure] of figures.entries()) {
            const title = await figure.getAttribute('data-live'), what = `${number + 1} ${title}`;
            const {scene, given} = requestOf(lesson, title), shows = given.show.split(',');
            await figure.scrollIntoViewIfNeeded();
            await figure.locator('.more').waitFor({timeout: patience});
            const still = path.join(lesson, (await figure.locator('img').getAttribute('src')).replace('.webp', '.png'));
            assert.equal(await differs(figure, await decoded(page, still)), 0, `${what}: ${still} is another picture`);
            let changes = {}, asked = await judge(figure, lesson, changes, what), told = '';
            for (const name of shows) {
                const value = scene.values?.find(value => value.name === name);
                if (value) {
                    const control = figure.locator('.panel').locator('label, .choice, .toggle').nth(
                        shows.filter(name => scene.values.some(value => value.name === name)).indexOf(name));
                    const kind = await control.evaluate(one => one.matches('label') ? 'LABEL' : one.classList[0]);
                    const now = Number(given[name] ?? value.value), next = now < value.most ? value.most : value.least;
                    if (kind === 'LABEL') await control.locator('input').press(now < value.most ? 'End' : 'Home');
                    else if (kind === 'toggle') await control.press('Space');
                    else await control.locator('button').nth(next - value.least).click();
                    changes = {...changes, [name]: next};
                } else if (name === 'points') {
                    const handle = figure.locator('.point').last(), before = await handle.getAttribute('aria-valuetext');
                    await handle.press('Shift+ArrowLeft');
                    const after = await handle.getAttribute('aria-valuetext');
                    assert.notEqual(before, after, what);
                    if (scene.text === undefined) {
                        const last = scene.values.filter(({name}) => /_[xy]$/.test(name)).slice(-2), now = after.split(', ');
                        changes = {...changes, [last[0].name]: now[0], [last[1].name]: now[1]};
                    } else {
                        const at = text => ` ${text.replace(',', ' ')} `;
                        changes = {...changes, text: (given.text ?? scene.text).replaceAll('; ', '\n').replaceAll(at(before), at(after))};
                    }
                } else if (name === 'pixel') {
                    const handle = figure.locator('.probe');
                    await handle.press('ArrowRight');
                    changes = {...changes, at: await handle.getAttribute('aria-valuetext')};
                    assert.equal(changes.at, given.at.replace(/^\d+/, x => Number(x) + 1), what);
                    await handle.hover();
                    assert.equal(await handle.evaluate(one => getComputedStyle(one).backgroundColor), 'rgba(0, 0, 0, 0)', `${what}: the pixel is hidden`);
                } else if (name === 'wrong') {
                    await figure.locator('.toggle').last().press('Space');
                    const right = printed(lesson, requestOf(lesson, title, {...changes, attempt: 0}).request);
                    const {width, pixels} = printed(lesson, requestOf(lesson, title, changes).request);
                    const wrong = right.pixels.reduce((sum, _, i) => sum + (i % 4 === 0 &&
                        pixels.compare(right.pixels, i, i + 4, i, i + 4) !== 0), 0);
                    await page.waitForFunction(([figure, text]) => figure.textContent.includes(text),
                                               [await figure.elementHandle(), `${wrong.toLocaleString('en')} pixels differ`]);
                    await page.waitForFunction(([figure, width, wrong]) => {
                        const canvas = figure.querySelector('canvas');
                        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
                        copy.drawImage(canvas, 0, 0);
                        const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
                        const marked = data.filter((v, i) => i % 4 === 0 && ['235,60,50', '70,110,255'].includes(data.slice(i, i + 3).join()));
                        return canvas.width === width && marked.length === wrong;
                    }, [await figure.elementHandle(), width, wrong]);
                    await figure.locator('.toggle').last().press('Space');
                } else { /* by a hand: at the program it is the direction that the page says */
                    const handle = figure.locator(name === 'light' ? '.lamp' : '.whole');
                    await handle.press('ArrowRight');
                    const said = await handle.getAttribute('aria-valuetext');
                    const sent = await figure.locator('.more').evaluate(button => (button.click(), document.querySelector('dialog iframe').src));
                    await page.click('dialog > button');
                    const hash = new URLSearchParams(new URL(sent).hash.slice(1)), names = name === 'light' ? ['light'] : ['center', 'eye'];
                    for (const name of names) {
                        changes = {...changes, [name]: hash.get(name).split(',').map(x => Number(Number(x).toFixed(4))).join()};
                    }
                    const length = name === 'light' ? Math.hypot(...hash.get('light').split(',')) : 1;
                    assert.ok(said.endsWith(hash.get(names.at(-1)).split(',').map(x => (x / length).toFixed(2)).join()), `${what}: ${said}`);
                    assert.notEqual(hash.get(names.at(-1)), String(scene[names.at(-1)]), what);
                }
                if (name !== 'wrong' || value) {
                    const again = await judge(figure, lesson, changes, what);
                    assert.notEqual(again, asked, `${what}: ${name} changes nothing`);
                    asked = again;
                }
                told += await figure.locator('.numbers').textContent();
            }
            assert.ok(!given.tell || told !== '', `${what}: it never tells a number`);
        }
        await page.evaluate(axe.source);
        await page.setViewportSize(phone.viewport); /* as wide as a screen below, with the words */
        const {violations} = await page.evaluate(() => axe.run());
        assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.map(n => n.html + n.failureSummary)}`), []);
        await judgeWidth(page, file);
    }));
}

/* The figure of each word that belongs to one, by their order in the text. */
const ownersOf = page => page.evaluate(() => {
    const owners = [], waiting = [];
    let figures = 0, words = 0;
    for (const part of document.querySelectorAll('main :is(figure[data-live], [data-touch])')) {
        if (part.tagName === 'FIGURE') {
            waiting.splice(0).forEach(word => { owners[word] = figures; });
            figures++;
        } else if (part.dataset.of === 'below') waiting.push(words++);
        else owners[words++] = figures - 1;
    }
    return owners;
});

/* Numbers by their names as what requestOf() takes: #5 is the fifth one of a scene's text. */
function changesOf(title, numbers) {
    let text = /, text=(.*?)(, [a-z]+=|$)/.exec(title)?.[1], changes = {};
    for (const [name, value] of numbers) {
        let i = 0;
        if (name[0] === '#') text = text.replace(/-?\d+(\.\d+)?/g, old => ++i === Number(name.slice(1)) ? value : old);
        else changes = {...changes, [name]: value};
    }
    return text === undefined ? changes : {...changes, text};
}

/* Numbers in sentences are dragged, claims come true and go, and words and what they make light each other. */
for (const file of pages.filter(file => text(file).includes('data-touch'))) {
    test(`the words of ${file} that belong to figures`, () => on(served(file), desktop, async page => {
        const lesson = path.dirname(file), owners = await ownersOf(page);
        assert.equal(await page.locator('[data-touch][tabindex]').count(), 0, 'before the figure lives, words are words');
        for (const [i, owner] of owners.entries()) {
            const word = page.locator('[data-touch]').nth(i), figure = page.locator('figure[data-live]').nth(owner);
            const [touch, title] = [await word.getAttribute('data-touch'), await figure.getAttribute('data-live')];
            const all = touch.split(' '), what = `${i} ${touch}`;
            await figure.scrollIntoViewIfNeeded();
            await figure.locator('.more').waitFor({timeout: 60000});
            const lit = () => figure.locator('.lit').evaluateAll(parts => parts.map(part => part.dataset.part).sort());
            if (touch[0] === '@') {
                await word.focus();
                assert.deepEqual(await lit(), all.map(name => name.slice(1)).sort(), what);
                await word.blur();
                assert.deepEqual(await lit(), [], what);
                await figure.locator(`[data-part="${all[0].slice(1)}"]`).dispatchEvent('pointerover');
                assert.match(await word.getAttribute('class'), /\blit\b/, what);
                await figure.dispatchEvent('pointerleave');
                assert.doesNotMatch(await word.getAttribute('class'), /\blit\b/, what);
            } else if (touch.includes('=')) {
                const numbers = changesOf(title, all.map(one => one.split('=')));
                await word.press('Enter');
                await judge(figure, lesson, numbers, what);
                assert.equal(await word.getAttribute('aria-pressed'), 'true', what);
                if (await judge(figure, lesson, numbers, what) !== requestOf(lesson, title).request) await word.press('Enter');
                await judge(figure, lesson, {}, what);
            } else {
                const before = await word.textContent();
                const highest = Number(await word.getAttribute('aria-valuemax')) === Number(before);
                await word.press(highest ? 'ArrowLeft' : 'ArrowRight');
                const after = await word.textContent();
                assert.notEqual(after, before, what);
                await judge(figure, lesson, changesOf(title, [[touch, after]]), what);
                await word.scrollIntoViewIfNeeded();
                const {x, y, width, height} = await word.boundingBox(); /* and back, by the mouse: 14 px a step */
                await page.mouse.move(x + width / 2, y + height / 2);
                await page.mouse.down();
                await page.mouse.move(x + width / 2 + (highest ? 16 : -16), y + height / 2);
                await page.mouse.up();
                await page.mouse.move(0, 0); /* on no other figure, wherever the page scrolls next */
                assert.equal(await word.textContent(), before, what);
            }
        }
        await page.evaluate(axe.source);
        const {violations} = await page.evaluate(() => axe.run());
        assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.map(n => n.html + n.failureSummary)}`), []);
    }));
}

/* Its first link begins lesson 1; the head is the program's, turns under a hand, and moves until it is stopped. */
test('the first screen', async () => {
    const canvasOf = figure => figure.locator('canvas').evaluate(canvas => canvas.toDataURL());
    await on(served('index.html'), desktop, async page => {
        assert.equal(await page.locator('main a').first().getAttribute('href'), 'step01_line/index.html');
        assert.ok((await page.locator('table:has-text("Debian")').boundingBox()).y > 800);
        const figure = page.locator('figure');
        await figure.locator('button:text-is("move")').waitFor({timeout: 60000});
        await judge(figure, 'step10_phong', {}, 'at rest');
        const before = await canvasOf(figure);
        await figure.locator('.whole').press('ArrowRight');
        await page.waitForFunction(before => document.querySelector('canvas').toDataURL() !== before, before);
    });
    await on(served('index.html'), {...desktop, reducedMotion: 'no-preference'}, async page => {
        const figure = page.locator('figure'), stop = figure.locator('button:text-is("stop")');
        await stop.waitFor({timeout: 60000});
        const before = await canvasOf(figure);
        await page.waitForFunction(before => document.querySelector('canvas').toDataURL() !== before, before);
        await stop.click();
        await page.waitForFunction(() => document.querySelector('canvas').width === 800); /* it rests */
        const after = await canvasOf(figure);
        await page.waitForTimeout(500);
        assert.equal(await canvasOf(figure), after);
    });
});

test('where the still picture comes late, its place is kept, and enlarged pixels have edges', async () => {
    const page = await browser.newPage(desktop);
    let arrive;
    const late = new Promise(done => { arrive = done; });
    await page.route('**/walk.webp', route => late.then(() => route.continue()));
    await page.goto(served('step01_line/index.html'));
    const figure = page.locator('figure[data-live*="at=2,1"]'), height = async () => (await figure.boundingBox()).height;
    await figure.scrollIntoViewIfNeeded();
    await figure.locator('.more').waitFor({timeout: patience});
    const before = await height();
    arrive();
    await figure.locator('img').evaluate(image => image.decode());
    assert.equal(await height(), before);
    assert.equal(await figure.locator('canvas').evaluate(canvas => getComputedStyle(canvas).imageRendering), 'pixelated');
    await page.close();
});

/* Without scripts, since that shows as much and is quick. */
test('a wide screen cuts no program of 100 columns, and figures are as wide as the text; the map is a list', async () => {
    const context = await browser.newContext({javaScriptEnabled: false, viewport: {width: 1440, height: 900}});
    const page = await context.newPage();
    for (const file of pages.filter(file => !file.endsWith('live.html'))) {
        await page.goto(served(file));
        const wrong = await page.evaluate(() => [
            ...[...document.querySelectorAll('main pre')].filter(one => one.scrollWidth > one.clientWidth &&
                one.textContent.split('\n').every(line => line.length <= (one.closest('li') ? 88 : 100))).map(one => one.textContent),
            ...[...document.querySelectorAll('main .pane')].filter(one => one.clientWidth !== one.querySelector('img').clientWidth ||
                one.clientWidth > 612).map(one => `${one.innerHTML} is ${one.clientWidth} wide`),
            ...[...document.querySelectorAll('tr:has(img[alt=""])')].filter(one => one.clientHeight > 120).map(one => one.textContent),
            ...[...document.querySelectorAll('pre')].filter(one => one.querySelectorAll('i.l').length !== one.querySelectorAll('i.r').length ||
                one.querySelectorAll('i.t').length !== one.querySelectorAll('i.b').length || /^\| /m.test(one.textContent) &&
                one.querySelector('i') === null).map(one => one.innerHTML)]);
        assert.deepEqual(wrong, [], file);
    }
    await page.goto(served('index.html'));
    assert.equal(await page.getAttribute('[rel=next]', 'href'), 'step01_line/index.html');
    await page.goto(served('step05_zbuffer/index.html'));
    assert.equal(await page.getAttribute('a:has-text("make live STEP=05")', 'href'), 'live.html');
    await context.close();
});

/* make live has a Markdown of its own, for machines without cmark-gfm: it makes the same of every text. */
test('the lessons of make live are the same pages', () => on(served('index.html'), desktop, async page => {
    await page.evaluate(`${fs.readFileSync('tests/student/live/text.js')}; window.render = htmlOfMarkdown`);
    const first = await page.evaluate(text => render(text, link => link), fs.readFileSync('README.md', 'utf8'));
    assert.ok(first.includes('turn.png') && !first.includes('live: turn')); /* no pointer shows a figure's title */
    for (const file of pages.filter(file => /^step/.test(file) && !file.endsWith('live.html'))) {
        const source = file.replace('index.html', 'README.md').replace('.html', '.md');
        const [site, live] = await page.evaluate(([html, text]) => {
            const parse = html => new DOMParser().parseFromString(html, 'text/html');
            const [site, live] = [parse(html).querySelector('main'), parse(`<main>${render(text, link => link)}</main>`).querySelector('main')];
            site.querySelector('.neighbours').remove();
            const told = 'pre, code, :not(li) > p, li, td, th, strong, em, img, figure, details, blockquote, [data-touch]';
            return [site, live].map(main => [main.textContent.replace(/\s/g, ''),
                ...[...main.querySelectorAll(told)].map(e => `${e.tagName}: ${e.dataset.touch ?? e.dataset.live ??
                    (e.tagName === 'PRE' ? e.textContent : e.textContent.replace(/\s/g, ''))}`).filter(one => one !== 'P: ')]);
        }, [text(file), fs.readFileSync(source, 'utf8')]);
        assert.deepEqual(live, site, file);
    }
}));

test('affine and correct stand side by side, which needs no reference', () =>
    on(onDisk('step08_projection/live.html') + '#scene=wall&affine=1&far=5&view=difference', desktop, async page => {
        await page.waitForFunction(() => document.querySelector('#pixel').textContent.includes('the same with affine as in the lesson'));
        assert.ok(await page.evaluate('compared("difference").count') > 1000);
        assert.ok(await page.isVisible('#views'));
        await page.click('#scenes button:text-is("lookat")');
        assert.ok(await page.isVisible('#views'));
        await page.click('#scenes button:text-is("narrow")'); /* nothing to compare with */
        assert.ok(await page.isHidden('#views'));
    }));

test('without scripts the text is there', async () => {
    const context = await browser.newContext({javaScriptEnabled: false});
    const page = await context.newPage();
    await page.goto(onDisk('step03_triangle/index.html'));
    assert.ok(await page.isVisible('main pre'));
    assert.ok(await page.isHidden('#search'));
    assert.ok(await page.isVisible('figure img')); /* a picture, and nothing that looks like a button */
    assert.equal(await page.locator('main :is(button, input, .handle)').count(), 0);
    const next = await page.textContent('[rel=next]');
    await page.click('[rel=next]');
    assert.equal(await page.textContent('h1'), next);
    await context.close();
});

test('a lesson as slides: by keys, questions with their answers, living pictures, and as a PDF', () =>
    on(served('step03_triangle/index.html'), desktop, async page => {
        const headings = await page.locator('main :is(h1, h2, h3, h4)').count();
        await page.keyboard.press('s');
        const count = await page.locator('#slides section').count();
        assert.ok(count >= headings, `${count} slides of ${headings} sections`);
        const shown = page.locator('#slides section.shown');
        for (let i = 1; i <= count; i++) { /* nothing is cut, at the size of a projector */
            assert.equal(await shown.count(), 1);
            assert.ok(await shown.evaluate(slide => slide.scrollHeight <= slide.clientHeight + 1 &&
                [...slide.querySelectorAll('img')].every(image => image.getBoundingClientRect().height > 200)), `slide ${i}`);
            const slide = new URL(page.url()).hash;
            await page.keyboard.press('ArrowRight');
            while (slide === new URL(page.url()).hash && i < count) {
                await page.keyboard.press('ArrowRight'); /* an answer came first */
            }
        }
        assert.equal(new URL(page.url()).hash, `#slide=${count}`);
        assert.ok(await shown.locator('details[open]').count() > 0);
        await page.keyboard.press('Home');
        while (await shown.locator('figure').count() === 0) await page.keyboard.press('ArrowRight');
        await shown.locator('.more').waitFor({timeout: patience}); /* it wakes */
        await shown.locator('h1').click();
        await page.keyboard.press('Escape');
        assert.equal(await page.locator('main:not(#slides)').isVisible(), true);
        await page.goto(served('step08_projection/index.html#slide=3'));
        assert.equal(await shown.count(), 1);
        const pdf = await page.pdf({preferCSSPageSize: true});
        assert.equal((pdf.toString('latin1').match(/\/Type\s*\/Page\b/g) ?? []).length, await page.locator('#slides section').count());
    }));

/* With every answer open. Where a slide is higher than the window, it begins at its top. */
for (const [kind, file, window] of [['dark', 'step08_projection', {...desktop, colorScheme: 'dark'}],
                                    ['phone', 'step03_triangle', phone]]) {
    test(`slides can be read and turned without keys: ${kind}`, () =>
        on(served(`${file}/index.html`), window, async page => {
            await page.locator('header a:text-is("Slides")').click();
            await page.evaluate(axe.source);
            const count = await page.locator('#slides section').count();
            assert.equal(await page.locator('#slides pre').count(), await page.locator('main:not(#slides) pre').count()); /* none twice */
            for (let i = 1; i <= count; i++) {
                const found = await page.evaluate(async () => {
                    const slide = document.querySelector('.shown'), wrong = [];
                    slide.querySelectorAll('details').forEach(answer => answer.open = true);
                    for (const {id, nodes} of (await axe.run()).violations) wrong.push(id, ...nodes.map(node => node.html));
                    if (slide.scrollWidth > slide.clientWidth) wrong.push('wider than the window');
                    if (slide.firstElementChild.getBoundingClientRect().top < 0) wrong.push('its heading is cut');
                    if (document.activeElement !== slide) wrong.push('the focus is elsewhere');
                    for (const program of slide.querySelectorAll('pre')) {
                        const size = parseFloat(getComputedStyle(program).fontSize);
                        if (size < 14 || size < 24 && innerWidth > 1000 && program.style.getPropertyValue('--columns') < 60) wrong.push(`${size}px`);
                    }
                    for (const button of document.querySelectorAll('#slides nav button')) {
                        const {width, height, bottom} = button.getBoundingClientRect();
                        if (Math.min(width, height) < 44 || bottom > innerHeight) wrong.push(button.ariaLabel);
                    }
                    return wrong;
                });
                assert.deepEqual(found, [], `slide ${i}`);
                if (i % 12 === 3) await page.screenshot({path: `${pictures}/slides_${kind}_${i}.png`});
                await page.getByRole('button', {name: 'Next slide'}).click();
            }
            assert.equal(new URL(page.url()).hash, `#slide=${count}`);
            await page.getByRole('button', {name: 'Previous slide'}).click();
            assert.equal(await page.locator('#slides nav span').textContent(), `${count - 1} / ${count}`);
            await page.getByRole('button', {name: 'Back to the text'}).click();
            assert.equal(await page.isVisible('main:not(#slides)'), true);
            await page.locator('header a:text-is("Slides")').click();
            await page.goBack();
            assert.equal(await page.isVisible('main:not(#slides)'), true);
        }));
}
