// Where the live page's frames come from on a web page: the lesson's program in WebAssembly
// (answer.c), in a worker. From disk no page may fetch a file: a script brings the program.
"use strict";

// Runs in the worker, without the rest of this file.
function runInWorker() {
    const unsupported = 8; // what all else of WASI says: no such file
    let exports, input, output;
    const numbers = () => new DataView(exports.memory.buffer);
    const pieces = (vectors, count) => Array.from({length: count}, (_, i) =>
        new Uint8Array(exports.memory.buffer, numbers().getUint32(vectors + 8 * i, true),
                       numbers().getUint32(vectors + 8 * i + 4, true)));
    const wasi = {
        clock_time_get(clock, precision, time) {
            numbers().setBigUint64(time, BigInt(Math.round(1e6 * performance.now())), true);
            return 0;
        },
        fd_read(file, vectors, count, read) {
            let size = 0;
            for (const piece of pieces(vectors, count)) {
                const some = input.subarray(0, piece.length);
                piece.set(some);
                input = input.subarray(some.length);
                size += some.length;
            }
            numbers().setUint32(read, size, true);
            return 0;
        },
        fd_write(file, vectors, count, written) {
            const all = pieces(vectors, count);
            if (file === 1) {
                output.push(...all.map(piece => piece.slice()));
            }
            numbers().setUint32(written, all.reduce((sum, piece) => sum + piece.length, 0), true);
            return 0;
        },
    };
    const imports = {
        wasi_snapshot_preview1: new Proxy(wasi, {get: (all, name) => all[name] ?? (() => unsupported)}),
        env: {wait_for_calls() { throw "waiting"; }},
    };

    async function begin({program, lesson}) {
        const packed = Uint8Array.from(atob(program), letter => letter.charCodeAt(0));
        const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
        const bytes = await new Response(stream).arrayBuffer();
        exports = (await WebAssembly.instantiate(bytes, imports)).instance.exports;
        exports._initialize();
        try {
            exports.start(lesson);
        } catch (error) {
            if (error !== "waiting") {
                throw error;
            }
        }
    }

    // The bytes that answer a request. The description comes before each: it is left out of frames.
    function answer(request) {
        input = new TextEncoder().encode(request);
        output = [];
        exports.answer();
        const bytes = new Uint8Array(output.reduce((sum, piece) => sum + piece.length, 0));
        output.reduce((at, piece) => (bytes.set(piece, at), at + piece.length), 0);
        return request === "" ? bytes : bytes.slice(bytes.indexOf(10) + 1);
    }

    let begun;
    onmessage = async ({data}) => {
        begun ??= begin(data);
        await begun;
        const bytes = answer(data.request);
        postMessage(bytes, [bytes.buffer]);
    };
    onunhandledrejection = ({reason}) => setTimeout(() => { throw reason; });
}

const program = (() => {
    const waiting = []; // for the worker's answers
    let worker, started;

    function ask(message) {
        return new Promise((done, fail) => {
            waiting.push({done, fail});
            worker.postMessage(message);
        });
    }

    function load(source) {
        return new Promise((done, fail) => {
            const script = document.createElement("script");
            script.src = source;
            script.onload = done;
            script.onerror = () => fail(new Error(`${source} cannot be loaded.`));
            document.head.append(script);
        });
    }

    // Its description of its scenes.
    async function start(step) {
        await load("../live/program.js"); // which defines lessonPrograms
        worker = new Worker(URL.createObjectURL(new Blob([`(${runInWorker})()`], {type: "text/javascript"})));
        worker.onmessage = ({data}) => waiting.shift().done(data);
        worker.onerror = ({message}) => waiting.shift()?.fail(new Error(message));
        const lesson = lessonPrograms.lessons.indexOf(step);
        const bytes = await ask({program: lessonPrograms.program, lesson, request: ""});
        return JSON.parse(new TextDecoder().decode(bytes));
    }

    return {
        async state() {
            const step = location.pathname.split("/").at(-2);
            started ??= start(step);
            return {version: 1, step, message: "", program: await started};
        },
        frame: request => ask({request}),
        everything: "live.html", // the page with all that can be asked of it
    };
})();
