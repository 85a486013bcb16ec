/*
 * Tries an HTML report of the check in Chromium: see report_in_browser.sh.
 *
 *     node report_in_browser.js BROWSER REPORT.html DIRECTORY
 *
 * What the report must tell is read from REPORT.json beside it. Screenshots go to DIRECTORY. Speaks
 * the DevTools protocol through a pipe, so that nothing else is needed.
 */
'use strict';
const {spawn} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

const [browser, page, out] = process.argv.slice(2);
const report = JSON.parse(fs.readFileSync(page.replace(/html$/, 'json'), 'utf8'));
const failed = [];
let where = '';

function expect(what, holds) {
    if (!holds) failed.push(where + ': ' + what);
}

function same(what, found, wanted) {
    expect(`${what}: ${JSON.stringify(found)}, not ${JSON.stringify(wanted)}`,
           JSON.stringify(found) == JSON.stringify(wanted));
}

/* ---- The browser ---- */

const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'report.'));
const child = spawn(browser, ['--headless', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
                              '--no-first-run', '--hide-scrollbars', '--remote-debugging-pipe',
                              '--user-data-dir=' + profile],
                    {stdio: ['ignore', 'ignore', 'pipe', 'pipe', 'pipe'], detached: true});
const waiting = new Map(), heard = [];
let number = 0, session, rest = '', said = '';

child.stderr.on('data', data => { said += data; });
child.stdio[4].on('data', data => {
    const messages = (rest + data).split('\0');
    rest = messages.pop();
    for (const message of messages.map(text => JSON.parse(text))) {
        const call = waiting.get(message.id);
        if (!call) {
            heard.push(message);
        } else if (message.error) {
            call.reject(new Error(call.method + ': ' + message.error.message));
        } else {
            call.resolve(message.result);
        }
    }
});

function send(method, params = {}) {
    return new Promise((resolve, reject) => {
        waiting.set(++number, {resolve, reject, method});
        child.stdio[3].write(JSON.stringify({id: number, method, params, sessionId: session}) + '\0');
    });
}

/* The value of an expression in the page; a function is called with the arguments. */
async function ask(what, ...given) {
    const expression = typeof what == 'function'
        ? `(${what})(...${JSON.stringify(given)})` : what;
    const answer = await send('Runtime.evaluate', {expression, awaitPromise: true,
                                                   returnByValue: true});
    if (answer.exceptionDetails) {
        throw new Error(answer.exceptionDetails.exception.description + '\n' + expression);
    }
    return answer.result.value;
}

/* When all that was begun is drawn. */
const settle = () => ask(() => new Promise(done => setTimeout(
    () => requestAnimationFrame(() => requestAnimationFrame(() => done(true))), 60)));

async function press(key, code, shift) {
    const codes = {Tab: 9, Enter: 13, ' ': 32, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39,
                   ArrowDown: 40, End: 35, Home: 36};
    const text = key == 'Enter' ? '\r' : key.length == 1 ? key : undefined;
    const event = {key, code: code || key, text, modifiers: shift ? 8 : 0,
                   windowsVirtualKeyCode: codes[key] || key.toUpperCase().charCodeAt(0)};
    await send('Input.dispatchKeyEvent', {...event, type: text ? 'keyDown' : 'rawKeyDown'});
    await send('Input.dispatchKeyEvent', {...event, type: 'keyUp', text: undefined});
    await settle();
}

async function mouse(type, x, y) {
    await send('Input.dispatchMouseEvent', {type, x, y, button: type == 'mouseMoved' ? 'none' : 'left',
                                            clickCount: 1});
}

async function click(x, y) {
    await mouse('mouseMoved', x, y);
    await mouse('mousePressed', x, y);
    await mouse('mouseReleased', x, y);
    await settle();
}

async function tap(x, y) {
    await send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: [{x, y}]});
    await send('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
    await settle();
}

/* The middle of what a selector finds, brought into the window. */
const middle = (selector, press) => ask((selector, press) => {
    const element = document.querySelector(selector);
    if (element.closest('.tools')) {
        element.scrollIntoView({block: 'nearest', inline: 'nearest'});
    } else {
        element.scrollIntoView({block: 'center'});
    }
    const box = element.getBoundingClientRect();
    return [box.left + box.width / 2, box.top + box.height / 2];
}, selector, press);

const clickOn = async selector => click(...await middle(selector));

async function picture(name) {
    const {data} = await send('Page.captureScreenshot', {format: 'png'});
    fs.writeFileSync(path.join(out, name + '.png'), Buffer.from(data, 'base64'));
    return data;
}

/* Colours of the window at some points, as the eye sees them. */
async function seen(points, scale) {
    const {data} = await send('Page.captureScreenshot', {format: 'png'});
    return ask(async (data, points, scale) => {
        const image = new Image();
        image.src = 'data:image/png;base64,' + data;
        await image.decode();
        const canvas = document.createElement('canvas');
        canvas.width = image.width;
        canvas.height = image.height;
        const context = canvas.getContext('2d', {willReadFrequently: true});
        context.drawImage(image, 0, 0);
        return points.map(([x, y]) => [...context.getImageData(
            Math.floor(x * scale), Math.floor(y * scale), 1, 1).data.slice(0, 3)].join());
    }, data, points, scale);
}

/* ---- What a page must be, whatever its size ---- */

async function open(name, width, height, scale, mobile, scheme) {
    where = name;
    await send('Emulation.setDeviceMetricsOverride',
               {width, height, deviceScaleFactor: scale, mobile});
    await send('Emulation.setTouchEmulationEnabled', {enabled: mobile});
    await send('Emulation.setEmulatedMedia',
               {features: [{name: 'prefers-color-scheme', value: scheme}]});
    await send('Page.navigate', {url: 'file://' + path.resolve(page)});
    for (let i = 0; i < 300 && !heard.some(m => m.method == 'Page.loadEventFired'); i++) {
        await new Promise(done => setTimeout(done, 50));
    }
    await settle();
}

/* What the browser complained of, and what it loaded, since it was asked last. */
function judgeLog() {
    for (const {method, params} of heard.splice(0)) {
        const text = JSON.stringify(params).slice(0, 300);
        expect('exception ' + text, method != 'Runtime.exceptionThrown');
        expect('on the console: ' + text, method != 'Runtime.consoleAPICalled');
        expect('in the log: ' + text, method != 'Log.entryAdded');
        expect('a dialog: ' + text, method != 'Page.javascriptDialogOpening');
        if (method == 'Network.requestWillBeSent') {
            expect('loads ' + text, /^(data:|file:.*\/report\.html$)/.test(params.request.url));
        }
    }
}

/* Nothing is wider than the window, no control lies on another, all text can be read. */
async function judgeLayout() {
    const [width, window_] = await ask('[document.documentElement.scrollWidth, innerWidth]');
    expect(`${width} pixels wide, the window ${window_}`, width <= window_);
    const torn = await ask(() => {
        const found = [], boxes = [...document.querySelectorAll('.tools button, .tools output')]
            .map(element => [element.textContent, element.getBoundingClientRect()]);
        for (const [a, p] of boxes) {
            for (const [b, q] of boxes) {
                if (p != q && p.left < q.right && q.left < p.right && p.top < q.bottom &&
                    q.top < p.bottom) found.push(a + ' on ' + b);
            }
        }
        return found;
    });
    same('controls on each other', torn, []);
    const pale = await ask(() => {
        const light = color => {
            const [r, g, b] = color.match(/[\d.]+/g).map(value => value / 255)
                .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const found = [];
        for (const element of document.querySelectorAll('h1,h2,h3,p,td,b,a,summary,button,pre,li')) {
            let paper = element;
            const background = () => getComputedStyle(paper).backgroundColor;
            while (paper != document.body && background() == 'rgba(0, 0, 0, 0)') {
                paper = paper.parentElement;
            }
            const [a, b] = [light(getComputedStyle(element).color), light(background())];
            const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
            if (contrast < 4.5) found.push(element.textContent.slice(0, 20) + ' ' + contrast);
        }
        return found;
    });
    same('contrast below 4.5', pale, []);
}

/* It tells what the JSON of the same check tells. */
async function judgeContents() {
    same('score', await ask('document.querySelector(".score").textContent'),
         `SCORE ${report.points}/${report.most}`);
    const rows = await ask(() => [...document.querySelectorAll('tr')].slice(1).map(
        row => [...row.cells].slice(0, 3).map(cell => cell.textContent.trim())));
    same('steps', rows, report.steps.map(
        step => [step.step, step.state, `${step.points}/${step.most}`]));
    same('states', rows.map(row => row[1]), ['FAIL', 'BUILD', 'PASS', 'PASS', 'FAIL', 'TODO',
                                               'CRASH']);
    const items = report.steps.flatMap(step => step.items);
    const sections = await ask(() => [...document.querySelectorAll('section')].map(section => [
        section.querySelector('h3').textContent, section.querySelector('p').textContent,
        section.querySelector('.looks')?.textContent || '']));
    same('items', sections.length, items.length);
    items.forEach((item, i) => {
        const [name, note, looks] = sections[i];
        same('name', name, item.scene + (item.counter ? ' ' + item.counter : ''));
        /* What waits for its picture has the picture's state in JSON, and says so on the page. */
        const waits = /^its picture must pass/.test(item.message) && item.state != 'TODO';
        const state = waits ? 'NOT JUDGED' : item.state;
        expect(name + ': ' + note, note.startsWith(`${state} ${item.points}/${item.most}`) &&
            note.includes(item.message || ''));
        expect(name + ' looks like ' + looks, looks.includes(item.looks_like || ''));
    });
    const hostile = '</pre><script>document.title=1</script><img src=x onerror=alert(1)>';
    expect('the message is not shown as it is',
           (await ask('document.querySelector("pre").textContent')).includes(hostile));
    same('title', await ask('document.title'), 'make check');
    same('scripts', await ask('document.scripts.length'), 1);
    same('foreign pictures', await ask('document.querySelectorAll("img:not([src^=data])").length'), 0);
}

/* Beside a diagnosis is the picture of that mistake, which is what was drawn. */
async function judgeLooks() {
    const found = await ask(() => [...document.querySelectorAll('.looks')].map(looks => {
        const bytes = [...looks.querySelectorAll('img')].map(image => {
            const canvas = document.createElement('canvas');
            canvas.width = image.naturalWidth;
            canvas.height = image.naturalHeight;
            const context = canvas.getContext('2d', {willReadFrequently: true});
            context.drawImage(image, 0, 0);
            return [...context.getImageData(0, 0, canvas.width, canvas.height).data];
        });
        return [bytes.length, Math.max(...bytes[0]), bytes[0].join() == bytes[1].join()];
    }));
    expect('no diagnosis', found.length >= 2);
    for (const looks of found) same('pictures of a mistake, brightest, same', looks, [2, 255, true]);
}

/* ---- One scene ---- */

const wrongItem = report.steps.flatMap(step => step.items).find(item => item.scene == 'zbuffer');
const [, firstX, firstY, got, wanted] =
    wrongItem.message.match(/first at \((\d+),(\d+)\): yours ([\d,]+), right ([\d,]+)/);
const count = percent => Math.round(percent * wrongItem.pixels_drawn / 100);
const scene = 'scenes.find(s => s.name == "zbuffer")';

/* The scene comes to the top. */
const goToScene = () => ask(scene + '.section.scrollIntoView()').then(settle);

const shownFigures = () => ask(`Object.entries(${scene}.figures).filter(([, f]) => f.clientWidth)
    .map(([name, f]) => { const box = f.querySelector('.view').getBoundingClientRect();
                          return [name, Math.round(box.left), Math.round(box.top)]; })`);

/* Where on the screen a pixel of a figure is: the middle of it. */
const placeOf = (name, x, y) => ask((name, x, y) => {
    const it = scenes.find(s => s.name == 'zbuffer');
    const box = it.figures[name].querySelector('.sheet').getBoundingClientRect();
    const {naturalWidth: width, naturalHeight: height} = it.pictures.reference;
    return [box.left + (x + 0.5) * box.width / width,
            box.top + (height - y - 0.5) * box.height / height];
}, name, Number(x), Number(y));

async function judgeModes(press_) {
    for (const [key, id, figure] of [['l', 'slide', 'slide'], ['y', 'yours', 'yours'],
        ['r', 'reference', 'reference'], ['d', 'difference', 'difference'],
        ['e', 'errors', 'errors']]) {
        await (press_ ? press(key) : clickOn('#' + id));
        same(id, (await shownFigures()).map(([name]) => name), [figure]);
        same(id + ' pressed', await ask(`document.querySelectorAll('[aria-pressed=true]').length`), 1);
    }
    await (press_ ? press('s') : clickOn('#side'));
    same('side', (await shownFigures()).map(([name]) => name),
         ['yours', 'reference', 'difference', 'errors']);
}

async function judgeErrors() {
    await goToScene();
    const counts = await ask(`[...${scene}.figures.errors.querySelectorAll('.scale li')]
        .map(line => Number(line.textContent.replace(/.*: |,| pixels?/g, '')))`);
    same('pixels of the error map', counts.reduce((a, b) => a + b, 0), 800 * 800);
    same('pixels apart', counts.slice(2).reduce((a, b) => a + b, 0), count(wrongItem.apart_percent));
    const swatches = await ask(`[...${scene}.figures.errors.querySelectorAll('.scale i')]
        .map(i => i.style.background)`);
    same('colours of the scale', new Set(swatches).size, 6);
}

/* Not smoothed: each pixel is one square of its own colour, and the values are those told. */
async function judgeZoom() {
    await goToScene();
    await clickOn('#wrong');
    same('zoom', await ask('byId("zoom").textContent'), '8x');
    expect('not at the first wrong place: ' + await ask('byId("values").textContent'),
           (await ask('byId("values").textContent')).includes('wrong: place 1 of '));
    await ask(`setCursor(${scene}, ${firstX}, ${firstY})`);
    await settle();
    const [x, y] = await placeOf('yours', firstX, firstY);
    await mouse('mouseMoved', x, y);
    await settle();
    same('values', (await ask('byId("values").textContent')).trim().split(/ +/).slice(0, 5),
         [`(${firstX},${firstY})`, 'yours', got, 'reference', wanted]);
    await ask(`document.querySelectorAll('.cursor').forEach(c => c.remove())`);
    const corners = [[-3.5, -3.5], [3.5, -3.5], [-3.5, 3.5], [3.5, 3.5], [0, 0]];
    same('yours at 8x', await seen(corners.map(([i, j]) => [x + i, y + j]), 1), Array(5).fill(got));
    const [u, v] = await placeOf('reference', firstX, firstY);
    same('the reference at 8x', await seen(corners.map(([i, j]) => [u + i, v + j]), 1),
         Array(5).fill(wanted));
    /* Below the first wrong pixel is none. */
    const below = await placeOf('difference', firstX, firstY - 1);
    same('difference below', await seen([below], 1), ['0,0,0']);
    expect('not scrolled together', await ask(`new Set(Object.values(${scene}.figures)
        .filter(f => f.clientWidth).map(f => f.querySelector('.view').scrollLeft)).size == 1`));
    await picture('desktop_8x');
    await clickOn('#larger');
    await clickOn('#larger');
    await ask(`setCursor(${scene}, ${firstX}, ${firstY})`);
    await settle();
    expect('no numbers at 32x', await ask(`${scene}.figures.yours.querySelector('.values') != null`));
    await picture('desktop_32x');
    for (let i = 0; i < 6; i++) await clickOn('#smaller');
    same('smaller', await ask('byId("zoom").textContent'), 'fit');
}

async function judgeMarks() {
    await goToScene();
    await clickOn('#larger'); /* 1x: as many marks as wrong pixels */
    await clickOn('#marks');
    const marks = await ask(`(() => {
        const canvas = new OffscreenCanvas(800, 800);
        const context = canvas.getContext('2d', {willReadFrequently: true});
        context.drawImage(${scene}.figures.yours.querySelector('.marks'), 0, 0);
        const data = context.getImageData(0, 0, 800, 800).data;
        let count = 0;
        for (let i = 3; i < data.length; i += 4) count += data[i] > 0;
        return count; })()`);
    same('marked pixels', marks, count(wrongItem.wrong_percent));
    await picture('desktop_marks');
    await clickOn('#marks');
    same('marks that stay', await ask(
        `${scene}.figures.yours.querySelector('.marks').clientWidth`), 0);
    await clickOn('#smaller');
}

/* At its left the slider shows yours, at its right the reference. */
async function judgeSlider() {
    await clickOn('#slide');
    await clickOn('#larger');
    await ask(`setCursor(${scene}, ${firstX}, ${firstY})`);
    await ask(`document.querySelectorAll('.cursor').forEach(c => c.remove())`);
    const range = await middle('.slide.shown input', true);
    const ends = await ask(`(() => {
        const box = ${scene}.figures.slide.querySelector('input').getBoundingClientRect();
        ${scene}.figures.slide.querySelector('input').scrollIntoView({block: 'end'});
        return 0; })()`);
    expect('no slider', range && ends == 0);
    for (const [part, color] of [[0.99, got], [0.01, wanted], [0.5, null]]) {
        const [x, y] = await ask(part => {
            const it = scenes.find(s => s.name == 'zbuffer').figures.slide.querySelector('input');
            it.scrollIntoView({block: 'center'});
            const box = it.getBoundingClientRect();
            return [box.left + box.width * part, box.top + box.height / 2];
        }, part);
        await click(x, y);
        if (color) same('slider at ' + part,
                        await seen([await placeOf('slide', firstX, firstY)], 1), [color]);
    }
    await clickOn('#smaller');
    await goToScene();
    await picture('desktop_slider');
    await clickOn('#side');
}

/* From the first Tab to the last, and every key. */
async function judgeKeyboard() {
    const reached = [];
    for (let i = 0; i < 200; i++) {
        await press('Tab');
        const at = await ask(`(e => e == document.body ? '' : e.id || e.className ||
            e.textContent.slice(0, 12) || e.type)(document.activeElement)`);
        if (!at) break;
        reached.push(at);
        expect('focus is not seen on ' + at, await ask(
            `getComputedStyle(document.activeElement).outlineStyle != 'none'`));
    }
    for (const id of ['side', 'slide', 'yours', 'reference', 'difference', 'errors', 'smaller',
        'larger', 'marks', 'wrong', 'Keys and col', 'step01_line', 'Messages', 'view']) {
        expect('Tab does not reach ' + id, reached.includes(id));
    }
    await ask('byId("difference").focus()');
    await press('Enter');
    same('Enter on a button', await ask('mode'), 'difference');
    await ask('byId("errors").focus()');
    await press(' ');
    same('space on a button', await ask('mode'), 'errors');
    await ask('document.activeElement.blur()');
    await goToScene();
    await judgeModes(true);
    await press(' ');
    same('space', await ask('mode'), 'yours');
    await press(' ');
    same('space again', await ask('mode'), 'reference');
    await press('s');
    await ask('document.activeElement.blur(), scrollTo(0, 0)');
    await press('n');
    const first = await ask('unfolded().indexOf(current())');
    await press('n');
    await press('n');
    same('n twice', await ask('unfolded().indexOf(current())'), first + 2);
    await press('p');
    same('p', await ask('unfolded().indexOf(current())'), first + 1);
    /* One pixel, by arrows. */
    await ask(`${scene}.figures.yours.querySelector('.view').focus()`);
    await ask(`setCursor(${scene}, ${firstX} - 11, ${firstY} - 1)`);
    await press('ArrowRight', 'ArrowRight', true);
    await press('ArrowRight');
    await press('ArrowUp');
    expect('arrows: ' + await ask('byId("values").textContent'),
           (await ask('byId("values").textContent')).startsWith(`(${firstX},${firstY})`));
    await press('m');
    same('m', await ask('marked'), true);
    await press('m');
    await press('w');
    same('w', await ask('byId("zoom").textContent'), '8x');
    for (let i = 0; i < 4; i++) await press('-');
    same('-', await ask('byId("zoom").textContent'), 'fit');
    await press('+');
    same('+', await ask('byId("zoom").textContent'), '1x');
    await press('-');
    await press('l');
    await ask(`${scene}.figures.slide.querySelector('input').focus()`);
    await press('Home');
    await press('ArrowRight');
    same('arrow on the slider',
         await ask(`${scene}.figures.slide.querySelector('.divider').style.left`), '0.5%');
    await press('s');
    await ask(`document.querySelector('section').closest('main').querySelector('summary').focus()`);
    await press('Enter');
    expect('Enter on a summary', await ask(`document.querySelector('details').open`));
    await press('Enter');
}

/* ---- The run ---- */

async function desktop(scheme) {
    await open('desktop_' + scheme, 1280, 800, 1, false, scheme);
    await judgeLayout();
    await judgeContents();
    await judgeLooks();
    await picture(where);
    await goToScene();
    const tops = (await shownFigures()).map(([, , top]) => top);
    same('side by side', new Set(tops).size, 1);
    await picture(where + '_scene');
    judgeLog();
}

async function phone(scheme) {
    await open('phone_' + scheme, 390, 844, 2, true, scheme);
    await judgeLayout();
    await picture(where);
    await goToScene();
    const lefts = (await shownFigures()).map(([, left]) => left);
    same('below each other', new Set(lefts).size, 1);
    await picture(where + '_scene');
    await ask(`${scene}.figures.yours.scrollIntoView({block: 'center'})`);
    await tap(...await placeOf('yours', firstX, firstY));
    expect('a tap shows no values', /^\(\d+,\d+\).*yours.*reference/.test(
        await ask('byId("values").textContent')));
    await tap(...await middle('#slide'));
    same('slider', (await shownFigures()).map(([name]) => name), ['slide']);
    await goToScene();
    await picture(where + '_slider');
    await tap(...await middle('#side'));
    await ask('document.querySelectorAll("details").forEach(d => { d.open = true; })');
    await settle();
    await judgeLayout();
    await ask('document.querySelector("pre").scrollIntoView({block: "center"})');
    await picture(where + '_messages');
    await ask(`${scene}.figures.errors.scrollIntoView({block: 'center'})`);
    await settle();
    await picture(where + '_errors');
    judgeLog();
}

async function run() {
    const {targetId} = await send('Target.createTarget', {url: 'about:blank'});
    session = (await send('Target.attachToTarget', {targetId, flatten: true})).sessionId;
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await send(domain + '.enable');
    await desktop('dark');
    await desktop('light');
    await judgeModes(false);
    await judgeErrors();
    await judgeZoom();
    await judgeMarks();
    await judgeSlider();
    judgeLog();
    await open('keyboard', 1280, 800, 1, false, 'light');
    await judgeKeyboard();
    judgeLog();
    await phone('light');
    await phone('dark');
}

/*
 * Whatever happens, the browser ends, with its other processes, which are of its group. For a moment
 * one of them may still write into the profile: while there is something left, again.
 */
const end = async status => {
    if (child.exitCode === null && child.signalCode === null) {
        const gone = new Promise(resolve => child.once('exit', resolve));
        process.kill(-child.pid, 'SIGKILL');
        await gone;
    }
    for (let tries = 0; fs.existsSync(profile) && tries < 50; tries++) {
        try {
            fs.rmSync(profile, {recursive: true, force: true});
        } catch {
            await new Promise(resolve => setTimeout(resolve, 100));
        }
    }
    if (fs.existsSync(profile)) console.error('report_in_browser: left behind: ' + profile);
    process.exit(status);
};
const tooLong = setTimeout(() => {
    console.error('report_in_browser: the browser does not answer in ' + where + '\n' +
                  said.slice(-500));
    end(1);
}, 120000);
child.on('error', error => {
    console.error('report_in_browser: ' + error.message);
    process.exit(1);
});
run().catch(error => failed.push(where + ': ' + error.stack)).then(() => {
    clearTimeout(tooLong);
    for (const what of failed) console.error('report_in_browser: ' + what);
    console.log('report_in_browser: ' + (failed.length ? failed.length + ' wrong' : 'all as it should be'));
    end(failed.length ? 1 : 0);
});
