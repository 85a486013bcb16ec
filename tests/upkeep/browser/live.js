/*
 * `make live` in a browser, with a course that COURSE names: its programs draw what their references
 * show, the mouse and the keys move what they should, and what a student breaks is said.
 */
'use strict';
const assert = require('node:assert/strict');
const {spawn} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const {after, before, test} = require('node:test');
const axe = require('axe-core');
const {chromium} = require('playwright-core');

const course = process.env.COURSE, pages = process.env.PAGES;
let browser;

before(async () => {
    browser = await chromium.launch({executablePath: process.env.BROWSER,
                                     args: ['--no-sandbox', '--disable-gpu', '--no-first-run']});
});
after(() => browser.close());

/* Start the server for a lesson: its address, and how to end it. */
async function serve(step) {
    const server = spawn('build/live', ['build', 'make -s', step], {cwd: course});
    const address = await new Promise(done => server.stdout.once('data', text => done(`${text}`.trim())));
    const ended = new Promise(done => server.once('exit', done));
    return {address, ended, server};
}

/* A page on a lesson, which complains of nothing; the server ends with it. */
async function on(step, window, hash, judge) {
    const {address, ended, server} = await serve(step);
    const page = await browser.newPage(window);
    const wrong = [];
    page.on('pageerror', error => wrong.push(error.stack));
    page.on('console', message => wrong.push(message.text()));
    try {
        await page.goto(address + hash);
        await page.waitForFunction(() => document.querySelector('#pixel').textContent.includes('ms'),
                                   null, {timeout: 20000});
        await judge(page, address);
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
const has = (page, id, text, timeout = 20000) => page.waitForFunction(
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
                if (await page.isHidden('#values')) { // an animation's reference is a sheet of frames
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

test('corners of two neighbours move together, and no pixel is missing', () =>
    on('step03_triangle', desktop, '#scene=your+own', async page => {
        const before = await page.inputValue('#text');
        await page.focus('#picture');
        await page.keyboard.press('ArrowRight');
        assert.equal(await page.inputValue('#text'), before.replace('10 10', '11 10'));
        const box = await page.locator('#picture').boundingBox();
        const size = box.height / 100, left = box.x + (box.width - box.height) / 2;
        const place = (x, y) => [left + (x + .5) * size, box.y + (99.5 - y) * size];
        await page.mouse.move(...place(35, 85));
        await page.mouse.down();
        await page.mouse.move(...place(40, 60));
        await page.mouse.up();
        assert.equal((await page.inputValue('#text')).match(/ (39|40)[.\d]* (59|60)[.\d]*/g)?.length, 2);
        await has(page, 'counters', 'pixels written');
    }));

test('zoomed to single pixels their values are shown, and none is blurred', () =>
    on('step01_line', phone, '#scene=line', async page => {
        for (let i = 0; i < 6; i++) {
            await page.click('#larger');
        }
        await has(page, 'zoom', 'x');
        await picture(page, 'phone');
        await page.evaluate(axe.source);
        const found = await page.evaluate(() => axe.run());
        assert.deepEqual(found.violations.map(v => `${v.id}: ${v.nodes.map(n => n.html)}`), []);
    }));

test('a fault of the compiler, a crash and an endless loop are said, and mended at the next save', () =>
    on('step05_zbuffer', desktop, '#scene=depth', async page => {
        const begin = fs.readFileSync(main('step05_zbuffer'), 'utf8').match(/^static void show_depths.*{$/m)[0];
        await changed('step05_zbuffer', begin, `${begin} int x = ;`, async () => {
            await has(page, 'message', 'step05_zbuffer/main.c:', 60000);
            await picture(page, 'fault');
        });
        await page.waitForFunction(() => document.querySelector('#message').hidden, null, {timeout: 60000});
        await changed('step05_zbuffer', begin, `${begin} *(volatile int *)0 = 1;`,
                      () => has(page, 'message', 'store to null pointer', 60000));
        await page.waitForFunction(() => document.querySelector('#message').hidden, null, {timeout: 60000});
        await changed('step05_zbuffer', begin, `${begin} for (;;) {}`,
                      () => has(page, 'message', 'does every loop end?', 60000));
        await page.waitForFunction(() => document.querySelector('#message').hidden, null, {timeout: 60000});
        await page.click('button:text-is("difference")');
        await has(page, 'pixel', '\n0 pixels differ');
        await changed('step05_zbuffer', begin, `${begin} if (image != NULL) return;`, () =>
            page.waitForFunction(() => /\n[1-9]\d* pixels differ/.test(
                document.getElementById('pixel').textContent), null, {timeout: 60000}));
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
    assert.equal(await status(one.address, host, `${pathname}reference/../../../Makefile`), 404);
    assert.equal(await status(one.address, host, pathname.replace(/[0-9a-f]/, c => c === '0' ? '1' : '0')), 404);
    assert.equal(await status(two.address, new URL(two.address).host, new URL(two.address).pathname + 'state'), 200);
    for (const {server, ended} of [one, two]) {
        server.kill('SIGINT');
        assert.equal(await ended, 0);
    }
    assert.ok(!fs.readdirSync('/proc').some(id => {
        try {
            return fs.readFileSync(`/proc/${id}/cmdline`, 'utf8').includes('--live') &&
                   fs.realpathSync(`/proc/${id}/cwd`) === fs.realpathSync(course);
        } catch {
            return false;
        }
    }));
});
