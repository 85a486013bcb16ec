/*
 * How long a frame takes, in lessons 5, 8 and 10: in the program that `make live` runs, in its page,
 * and in the page of `make site`, which SITE names. A page's time is that from a movement of the
 * mouse to the picture. Printed are the least and the median of many, in milliseconds, and how many
 * frames a second the least allows.
 */
'use strict';
const {spawn} = require('node:child_process');
const fs = require('node:fs');
const {pathToFileURL} = require('node:url');
const {chromium} = require('playwright-core');

const scenes = [['step05_zbuffer', 'zbuffer'], ['step08_projection', 'lookat'], ['step10_phong', 'four']];
const sizes = [400, 800], count = 60;

function row(what, times) {
    const sorted = times.toSorted((a, b) => a - b), [least, median] = [sorted[0], sorted[times.length >> 1]];
    console.log(`${what.padEnd(44)} ${least.toFixed(1).padStart(7)} ${median.toFixed(1).padStart(7)} ms  ` +
                `${(1000 / least).toFixed(0).padStart(5)} a second`);
}

/* What the program itself says, for a light that turns. */
async function program(step, scene, size) {
    const child = spawn(`build/${step}`, ['--live'], {stdio: ['pipe', 'pipe', 'inherit']});
    const times = [];
    for (let i = 0; i < count; i++) {
        child.stdin.write(`--only ${scene} -s ${size}x${size} --light ${Math.sin(i / 9)},0.5,${Math.cos(i / 9)}\n`);
    }
    child.stdin.end();
    let bytes = Buffer.concat(await child.stdout.toArray());
    bytes = bytes.subarray(bytes.indexOf(10) + 1);
    while (bytes.length > 0) {
        const [, width, height, time, lines] = `${bytes.subarray(0, bytes.indexOf(10))}`.split(' ').map(Number);
        for (let i = 0; i <= lines; i++) {
            bytes = bytes.subarray(bytes.indexOf(10) + 1);
        }
        bytes = bytes.subarray(4 * width * height);
        times.push(time);
    }
    return times;
}

/* In the page: a drag of the light, and how long each movement takes until its picture is there. */
async function drag(count) {
    const times = [], box = canvas.getBoundingClientRect(), shownNow = () => new Promise(requestAnimationFrame);
    const send = (type, x) => canvas.dispatchEvent(new PointerEvent(type, {clientX: box.x + 50 + x, clientY: box.y + 50, pointerId: 1}));
    canvas.setPointerCapture = () => {};
    drag = "light";
    send("pointerdown", 0);
    for (let i = 1; i <= count; i++) {
        await shownNow();
        const start = performance.now();
        send("pointermove", 3 * i);
        while (asking) {
            await scheduler.postTask(() => {});
        }
        times.push(performance.now() - start);
    }
    send("pointerup", 0);
    return times;
}

async function page(browser, address, scene, size) {
    const page = await browser.newPage({viewport: {width: 1280, height: 800}});
    await page.goto(`${address}#scene=${scene}&size=${size}`);
    await page.waitForFunction(() => shown !== null, null, {timeout: 60000});
    const times = await page.evaluate(`(${drag.toString().replace('drag(count)', 'measure(count)')})(${count})`);
    await page.close();
    return times;
}

(async () => {
    const browser = await chromium.launch({executablePath: process.env.BROWSER,
                                           args: ['--no-sandbox', '--disable-gpu', '--no-first-run']});
    console.log(`${'least and median of ' + count}`.padEnd(44));
    for (const [step, scene] of scenes) {
        const server = spawn('build/live', ['build', 'make -s', step]);
        const address = await new Promise(done => server.stdout.once('data', text => done(`${text}`.trim())));
        const site = pathToFileURL(`${fs.realpathSync(process.env.SITE)}/${step}/live.html`).href;
        for (const size of sizes) {
            const name = `${step} ${scene} ${size}x${size}`;
            row(`${name}: program`, await program(step, scene, size));
            row(`${name}: make live`, await page(browser, address, scene, size));
            row(`${name}: WebAssembly`, await page(browser, site, scene, size));
        }
        server.kill('SIGINT');
    }
    await browser.close();
})();
