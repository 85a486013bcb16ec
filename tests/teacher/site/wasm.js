// Where the live page's frames come from on a web page: the lesson's program in WebAssembly
// (answer.c), in a worker. From disk no page may fetch a file: a script brings the program.
"use strict";

// Runs in the worker, without the rest of this file.
function runInWorker() {
    const unsupported = 8; // what all else of WASI says: no such file
    const files = [], missing = new Set(); // those that are here, as bytes or as what gives them; those that the page should load
    let module, exports, input, output;
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
                if (typeof files[number] === "string") {
                    files[number] = new TextEncoder().encode(modelOf(files[number]));
                }
                return files[number].length;
            },
            copy_file(number, to) { new Uint8Array(exports.memory.buffer).set(files[number], to); },
        },
    };
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

    const unpacked = text => new Response(new Blob([fromText(text)]).stream().pipeThrough(new DecompressionStream("gzip")));

    // A model's text, of its columns of differences (model.awk).
    function modelOf(columns) {
        const lines = columns.split("\n");
        let text = "";
        for (let at = 0; at < lines.length - 1;) {
            const look = lines[at++], rows = Number(lines[at++]), words = look.split(/[.0]/);
            const numbers = (look.match(/[.0]/g) ?? []).map(mark => {
                const end = mark === "." ? "e-6" : ""; // quicker to write than a fraction
                let sum = 0;
                return lines[at++].trim().split(" ").map(step => (sum += Number(step)) + end);
            });
            for (let row = 0; row < rows; row++) {
                text += words[0];
                numbers.forEach((column, i) => { text += column[row] + words[i + 1]; });
                text += "\n";
            }
        }
        return text;
    }

    async function begin({program, models, lesson}) {
        if (module === undefined) {
            (await Promise.all(models.map(model => unpacked(model).text()))).forEach((model, i) => { files[i] = model; });
            module = await WebAssembly.compile(await unpacked(program).arrayBuffer());
        }
        exports = (await WebAssembly.instantiate(module, imports)).exports;
        exports._initialize();
        untilItWaits(() => exports.start(lesson));
    }

    function untilItWaits(call) {
        try {
            return call();
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

    // A program that misses textures waits for them: another one begins, with them.
    let first, arrived = () => {};
    async function reply(request) {
        const bytes = untilItWaits(() => answer(request));
        if (missing.size === 0) {
            return bytes;
        }
        postMessage({missing: [...missing]});
        await new Promise(done => { arrived = done; });
        missing.clear();
        await begin(first);
        return answer(request);
    }

    let last = Promise.resolve(); // one after another
    onmessage = ({data}) => {
        if (data.textures !== undefined) {
            for (const [number, texture] of data.textures) {
                files[number] ??= fromText(texture);
            }
            arrived();
            return;
        }
        last = last.then(async () => {
            if (first === undefined) {
                await begin(first = data);
            }
            const bytes = await reply(data.request);
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

    function load(source) {
        return new Promise((done, fail) => {
            const script = document.createElement("script");
            script.src = source;
            script.onload = done;
            script.onerror = () => fail(new Error(`${source} cannot be loaded.`));
            document.head.append(script);
        });
    }

    // Let the worker have textures. Each is loaded once: its script defines lessonPrograms[name].
    const loads = {};
    async function send(names) {
        await Promise.all(names.map(name => loads[name] ??= load(new URL(`${name}.js`, here))));
        worker.postMessage({textures: names.map(name => [lessonPrograms.files.indexOf(name), lessonPrograms[name]])});
    }

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
                await send(data.missing.map(number => lessonPrograms.files[number]));
            } catch (error) {
                waiting.splice(0).forEach(({fail}) => fail(error));
            }
        };
        worker.onerror = ({message}) => waiting.shift()?.fail(new Error(message));
        const lesson = lessonPrograms.lessons.indexOf(step);
        const {program, models} = lessonPrograms, answer = ask({program, models, lesson, request: ""});
        await send(textures?.split(",") ?? []); // which the page's first picture reads
        const bytes = await answer;
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
