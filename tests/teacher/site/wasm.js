// Where the live page's frames come from on a web page: the lesson's program in WebAssembly
// (answer.c), in a worker. From disk no page may fetch a file: a script brings the program.
"use strict";

// Runs in the worker, without the rest of this file.
function runInWorker() {
    const unsupported = 8; // what all else of WASI says: no such file
    const files = [], missing = new Set(); // those that are here; those that the page should load
    let module, exports, input, output, arrived = () => {};
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
        env: {
            wait_for_calls() { throw "waiting"; },
            wait_for_textures() {
                if (missing.size > 0) {
                    throw "waiting";
                }
            },
            size_of_file(number) {
                if (files[number] === undefined) {
                    missing.add(number);
                    return 0;
                }
                return files[number].length;
            },
            copy_file(number, to) { new Uint8Array(exports.memory.buffer).set(files[number], to); },
        },
    };
    const unpacked = bytes => new Response(new Response(bytes).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

    async function here(textures) {
        while (textures.some(number => files[number] === undefined)) {
            await new Promise(done => { arrived = done; });
        }
    }

    // What it writes first: the description of its scenes.
    async function begin({program, models, lesson, textures}) {
        if (module === undefined) {
            (await Promise.all(models.map(unpacked))).forEach((model, i) => { files[i] = new Uint8Array(model); });
            module = await WebAssembly.compile(await unpacked(program));
            await here(textures);
        }
        exports = (await WebAssembly.instantiate(module, imports)).exports;
        exports._initialize();
        return outputOf(() => exports.start(lesson));
    }

    // What the program writes until it waits.
    function outputOf(call) {
        output = [];
        try {
            call();
        } catch (error) {
            if (error !== "waiting") {
                throw error;
            }
        }
        const bytes = new Uint8Array(output.reduce((sum, piece) => sum + piece.length, 0));
        output.reduce((at, piece) => (bytes.set(piece, at), at + piece.length), 0);
        return bytes;
    }

    function answer(request) {
        input = new TextEncoder().encode(request);
        return outputOf(() => exports.answer());
    }

    // A program that misses textures waits for them: another one begins, with them.
    let first;
    async function reply(request) {
        const bytes = answer(request);
        if (missing.size === 0) {
            return bytes;
        }
        postMessage({missing: [...missing]});
        await here([...missing]);
        missing.clear();
        await begin(first);
        return answer(request);
    }

    let last = Promise.resolve(); // one after another
    onmessage = ({data}) => {
        if (data.texture !== undefined) {
            files[data.number] = data.texture;
            arrived();
            return;
        }
        last = last.then(async () => {
            const bytes = await (first === undefined ? begin(first = data) : reply(data.request));
            postMessage(bytes, [bytes.buffer]);
        });
    };
    onunhandledrejection = ({reason}) => setTimeout(() => { throw reason; });
}

const program = (() => {
    const here = document.currentScript.src, {lesson, textures} = document.currentScript.dataset;
    const waiting = []; // for the worker's answers
    let worker, started;

    function ask(message) {
        return new Promise((done, fail) => {
            waiting.push({done, fail});
            worker.postMessage(message);
        });
    }

    function fromText(base64) {
        if (Uint8Array.fromBase64 !== undefined) { // not in every browser yet, and much quicker
            return Uint8Array.fromBase64(base64);
        }
        const letters = atob(base64), bytes = new Uint8Array(letters.length);
        for (let i = 0; i < letters.length; i++) {
            bytes[i] = letters.charCodeAt(i);
        }
        return bytes;
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

    // Let the worker have a texture, once: its script defines lessonPrograms[name].
    const sent = {};
    const send = number => sent[number] ??= (async () => {
        const name = lessonPrograms.files[number];
        await load(new URL(`${name}.js`, here));
        const texture = fromText(lessonPrograms[name]);
        worker.postMessage({number, texture}, [texture.buffer]);
    })();

    // Its description of its scenes.
    async function start(step) {
        await load(new URL("program.js", here)); // which defines lessonPrograms
        worker = new Worker(URL.createObjectURL(new Blob([`(${runInWorker})()`], {type: "text/javascript"})));
        worker.onmessage = async ({data}) => {
            if (data.missing === undefined) {
                waiting.shift().done(data);
                return;
            }
            try {
                await Promise.all(data.missing.map(send));
            } catch (error) {
                waiting.splice(0).forEach(({fail}) => fail(error));
            }
        };
        worker.onerror = ({message}) => waiting.shift()?.fail(new Error(message));
        const lesson = lessonPrograms.lessons.indexOf(step);
        const {program, models, files} = lessonPrograms;
        const read = (textures?.split(",") ?? []).map(name => files.indexOf(name)); // by the page's first picture
        const [bytes] = await Promise.all([ask({program: fromText(program), models: models.map(fromText), lesson, textures: read}), ...read.map(send)]);
        return JSON.parse(new TextDecoder().decode(bytes));
    }

    return {
        async state() {
            started ??= start(lesson);
            return {version: 1, step: lesson, message: "", program: await started};
        },
        frame: request => ask({request}),
        everything: new URL(`../${lesson}/live.html`, here).href, // the page with all that can be asked of it
    };
})();
