/*
 * The server of `make live`, asked without a browser, with a course that COURSE names: whom it
 * answers and how soon, how it ends, and what it says of programs that go wrong. RANDOM=600: so many
 * seconds of random input.
 */
'use strict';
const assert = require('node:assert/strict');
const {spawn} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const net = require('node:net');
const {test} = require('node:test');

const course = process.env.COURSE, step = 'step05_zbuffer', main = `${course}/${step}/main.c`;
const patience = 200000; /* milliseconds: other stages of .ci/run take the processors */
const pause = ms => new Promise(done => setTimeout(done, ms));

const ask = (address, method, body) => new Promise((done, failed) => {
    const request = http.request(address, {method}, answer => {
        const parts = [];
        answer.on('data', part => parts.push(part));
        answer.on('end', () => done(Buffer.concat(parts)));
    });
    request.on('error', failed);
    request.end(body);
});
const text = async (address, body) => `${(await ask(address + 'frame', 'POST', body)).subarray(0, 300)}`;
const state = async address => JSON.parse(await ask(address + 'state', 'GET'));

/* Until what the page is told has it. */
async function told(address, judge) {
    for (const begun = Date.now(); Date.now() - begun < patience;) {
        const now = await state(address);
        if (judge(now)) {
            return now;
        }
        await pause(100);
    }
    assert.fail(`${judge}: ${JSON.stringify(await state(address)).slice(0, 600)}`);
}

async function served(judge, ...open) {
    const server = spawn('build/live', ['build', 'make -s', step, ...open],
                         {cwd: course, stdio: ['ignore', 'pipe', 'ignore']});
    const ended = new Promise(done => server.once('exit', (status, signal) => done([status, signal])));
    const address = `${await new Promise(done => server.stdout.once('data', done))}`.trim();
    try {
        await judge(address, server, ended);
    } finally {
        server.kill('SIGTERM');
        await ended;
    }
}

/* Its main.c otherwise, for as long as it takes; the last change is built. */
async function changed(address, from, to, judge) {
    const source = fs.readFileSync(main, 'utf8'), {version} = await state(address);
    assert.ok(source.includes(from));
    fs.writeFileSync(main, source.replace(from, to));
    try {
        await told(address, now => now.building);
        await told(address, now => !now.building && now.version > version);
        await judge();
    } finally {
        fs.writeFileSync(main, source);
    }
}

for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
    test(`${signal} ends it and its program`, () => served(async (address, server, ended) => {
        assert.match(await text(address, '--only rows -s 9x9\n'), /^frame 9 9/);
        server.kill(signal);
        assert.deepEqual(await Promise.race([ended, pause(9000)]), [0, null]);
    }));
}

test('Ctrl-C at a terminal ends make live', async () => {
    const live = spawn('script', ['-qec', `make -s live STEP=${step}`, '/dev/null'], {cwd: course});
    let said = '';
    const ended = new Promise(done => live.once('exit', done));
    await new Promise(done => live.stdout.on('data', more => {
        said += more;
        if (/http:\S+\/\r?\n/.test(said)) {
            done();
        }
    }));
    const address = said.match(/http:\S+/)[0];
    await state(address);
    live.stdin.write('\x03');
    assert.notEqual(await Promise.race([ended, pause(9000)]), undefined);
    await assert.rejects(state(address));
});

test('who says nothing, or says it slowly, keeps nobody waiting', () => served(async address => {
    const {port} = new URL(address);
    const callers = [...Array(40)].map(() => net.connect(port, '127.0.0.1').on('error', () => {}));
    const slow = setInterval(() => callers[39].write('G'), 50);
    await pause(300);
    const times = [];
    for (let i = 0; i < 5; i++) {
        const begun = Date.now();
        await state(address);
        times.push(Date.now() - begun);
    }
    clearInterval(slow);
    assert.ok(times.sort((a, b) => a - b)[2] < 1500, `${times} ms`);
    await pause(2500);
    callers.forEach(caller => caller.destroy());
    assert.match(await text(address, '--only rows -s 9x9\n'), /^frame 9 9/);
}));

test('no process has the address among its arguments, and the page that has it is the user\'s', async () => {
    const seen = `${course}/build/served/seen`;
    await served(async address => {
        await pause(500);
        const [, place, all] = fs.readFileSync(seen, 'utf8').split('\0'), page = `${course}/${place}`;
        const token = new URL(address).pathname.split('/')[1];
        assert.ok(!all.includes(token));
        assert.ok(fs.readFileSync(page, 'utf8').includes(address));
        assert.equal(fs.statSync(page).mode & 0o077, 0);
    }, '', `sh ${__dirname}/opened.sh ${seen}`);
});

test('one question, one answer', () => served(async address => {
    for (const wrong of ['--only rows\n--only rows\n', '--only rows', '\n\n', 'text\nsize 2 2\n']) {
        assert.match(await text(address, wrong), /^error a question is one line/);
    }
    assert.match(await text(address, '--only rows -s 9x9\n'), /^frame 9 9/);
    assert.match(await text(address, '--only knot -s 8x8\n'), /^frame 8 8/);
}));

test('what a program prints, how it ends, what it takes, what it writes where it must not', () => served(async address => {
    const begin = 'static void draw_segment(const struct segment *s, struct image *image, int row, double *depths) {';
    const now = (code, judge) => changed(address, begin, `${begin}\n${code}`, judge);
    const rows = '--only rows -s 99x99\n';
    await now('printf("a = %g\\n", s->a.x); fputs("and <this>\\n", stderr);', async () => {
        assert.match(await text(address, rows), /^frame 99 99/);
        const {printed} = await told(address, now => now.printed.includes('and <this>'));
        assert.ok(printed.includes('a = 20.5'));
    });
    await now('int x = y;', async () => {
        const {message} = await state(address);
        assert.match(message, /^step05_zbuffer\/main.c: In function|^step05_zbuffer\/main.c:\d+/);
        assert.match(message, /error: /);
        assert.doesNotMatch(message, /make|Error 1/);
        assert.match(await text(address, '--only rows -s 9x9\n'), /^frame 9 9/); /* the one before */
    });
    await now('printf("last words"); exit(3);', async () => {
        assert.match(await text(address, rows), /^error step05_zbuffer ended with exit status 3/);
        await told(address, now => now.printed.includes('last words'));
    });
    await now('for (int i = 0; i < 5000000; i++) { puts("flood"); }', async () => {
        await text(address, rows);
        assert.ok((await state(address)).printed.length <= 16384);
    });
    await now('char *all = malloc(3u << 30); for (long i = 0; i < 3l << 30; i += 4096) { all[i] = 1; } for (;;) { }', async () => {
        assert.match(await text(address, rows), /^error step05_zbuffer is stopped: it (uses more than 2000 MB|draws for too long)/);
    });
    /* A program that waits, as on a busy machine, has longer than one that computes. */
    await now('extern unsigned sleep(unsigned); static int calls; if (calls++ == 0) { sleep(3); }', async () => {
        assert.match(await text(address, rows), /^frame 99 99/);
    });
    await now('for (;;) { }', async () => {
        assert.match(await text(address, rows), /is stopped: it draws for too long/);
    });
    await now('depths[image->width] = 1;', async () => {
        assert.match(await text(address, '--only rows -s 99x1\n'), /^frame 99 1/);
        await told(address, now => /main.c:\d+: draw_segment\(\) writes outside of the memory/.test(now.message));
    });
    await now('// to do 5.1: find the depth', async () => assert.equal((await state(address)).todo, '5.1'));
    await told(address, now => !now.building && now.message === '' && now.todo === '');
}));

test('random input', {skip: !process.env.RANDOM}, () => served(async address => {
    const {port, pathname} = new URL(address);
    let seed = 1;
    const random = n => (seed = (seed * 1103515245 + 12345) % 2147483648, Math.floor(seed / 65536) % n);
    const words = ['GET ', 'POST ', pathname, 'frame', 'state', '..', '/', ' HTTP/1.1\r\n', '\r\n', '\r\n\r\n',
                   'Host: 127.0.0.1', `:${port}`, 'Content-Length: ', '9', '99999999999', '-1', '\0', '--only rows',
                   ' -s 9x9', ' text', '\n', 'end\n', 'size 2 2\n', '\xff', 'a'.repeat(20000)];
    const until = Date.now() + 1000 * Number(process.env.RANDOM);
    for (let i = 0; Date.now() < until; i++) {
        const caller = net.connect(port, '127.0.0.1').on('error', () => {});
        const good = `POST ${pathname}frame HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nContent-Length: `;
        const body = [...Array(random(6))].map(() => words[13 + random(words.length - 13)]).join('');
        caller.write(random(2) ? `${good}${body.length}\r\n\r\n${body}`
                               : [...Array(1 + random(12))].map(() => words[random(words.length)]).join(''));
        await new Promise(done => { caller.once('close', done); setTimeout(() => { caller.destroy(); done(); }, 200); caller.resume(); });
        if (i % 100 === 0) {
            assert.match(await text(address, '--only rows -s 9x9\n'), /^frame 9 9/);
        }
    }
}));
