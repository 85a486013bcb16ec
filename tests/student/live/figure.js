// Living figures: where a lesson's text shows a picture with a title "live: ...", the lesson's program draws
// it as soon as it comes into view, and again whenever one of its controls moves. What a title may say is
// in figures.awk, which checks it. `program` is the one of server.js or, in the course's web pages, wasm.js.
"use strict";

const figures = (() => {
    const make = (tag, options = {}, ...content) => {
        const made = Object.assign(document.createElement(tag), options);
        made.append(...content);
        return made;
    };
    const limited = (x, least, most) => Math.min(most, Math.max(least, x));
    const stepped = (x, step) => Number((Math.round(x / step) * step).toFixed(6));
    const length = v => Math.hypot(...v);

    // "live: rows, attempt=1, show=points,attempt" as {scene, attempt, show}; lists stay text.
    function parse(title) {
        const [scene, ...options] = title.replace(/^live: /, "").split(", ");
        return {scene, ...Object.fromEntries(options.map(option => option.split(/=(.*)/s, 2)))};
    }

    // The answer to a request (common/run/live.h).
    function parseFrame(bytes) {
        let at = 0;
        const line = () => {
            const end = bytes.indexOf(10, at), text = new TextDecoder().decode(bytes.subarray(at, end));
            at = end + 1;
            return text;
        };
        const [kind, ...rest] = line().split(" "), [width, height, milliseconds, count] = rest.map(Number);
        if (kind !== "frame") {
            throw new Error(rest.join(" "));
        }
        const lines = Array.from({length: count}, line);
        return {width, height, milliseconds, notes: lines.filter(text => text[0] === " ").map(text => text.slice(1)),
                counters: Object.fromEntries(lines.filter(text => text[0] !== " ").map(text => text.split(" "))),
                image: new ImageData(new Uint8ClampedArray(bytes.subarray(at, at + 4 * width * height)), width, height)};
    }

    // A row of a matrix, with brackets instead of its bars.
    function bracketed(row, y, rows) {
        const side = k => `${k % 2 ? "l" : "r"}${y === 0 ? " t" : ""}${y === rows.length - 1 ? " b" : ""}`;
        return [y > 0 ? "\n" : "", ...row.split("|").flatMap((part, k) =>
            k === 0 ? [part] : [make("i", {className: side(k), textContent: "|"}), part])];
    }

    // The names of its numbers, where a value's help gives each of them one: "0 flat, 1 smooth".
    function namesOf({help, least, most}) {
        const names = help.split(", ").map((part, i) => part.startsWith(`${least + i} `) && part.slice(`${least + i} `.length));
        return names.length === most - least + 1 && names.every(Boolean) ? names : null;
    }

    // ---- Handles: what is dragged on a picture ----

    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

    // read() gives its place, from 0 to 1 from the lower left, and that in words; move() gets another place,
    // or with an arrow, how many steps to go.
    function addHandle(pane, kind, name, read, move, walk, part) {
        const handle = make("button", {type: "button", className: `handle ${kind}`, ariaLabel: name});
        handle.dataset.part = part;
        handle.setAttribute("role", "slider");
        const place = event => {
            const box = pane.getBoundingClientRect();
            return [(event.clientX - box.left) / box.width, (box.bottom - event.clientY) / box.height];
        };
        let held = null;
        handle.addEventListener("pointerdown", event => {
            handle.setPointerCapture(event.pointerId);
            held = place(event);
        });
        handle.addEventListener("pointermove", event => {
            if (held !== null) {
                const now = place(event);
                move(limited(now[0], 0, 1), limited(now[1], 0, 1), now[0] - held[0], now[1] - held[1]);
                held = now;
            }
        });
        for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
            handle.addEventListener(end, () => { held = null; });
        }
        handle.addEventListener("keydown", event => {
            if (arrows[event.key]) {
                event.preventDefault();
                event.stopPropagation();
                walk(...arrows[event.key].map(by => by * (event.shiftKey ? 10 : 1)));
            }
        });
        pane.append(handle);
        return () => {
            const [x, y, text] = read();
            handle.style.left = `${100 * x}%`;
            handle.style.top = `${100 - 100 * y}%`;
            handle.setAttribute("aria-valuenow", Math.round(100 * x));
            handle.setAttribute("aria-valuetext", text);
        };
    }

    // The vector turned by so much about the vertical, and up or down, but not beyond.
    function turned(v, right, up) {
        const size = length(v), limit = 89 * Math.PI / 180, longitude = Math.atan2(v[0], v[2]) + right;
        const latitude = limited(Math.asin(v[1] / size) + up, -limit, limit);
        return [size * Math.cos(latitude) * Math.sin(longitude), size * Math.sin(latitude),
                size * Math.cos(latitude) * Math.cos(longitude)];
    }

    // ---- Words that belong to a figure: figures.awk says how a text writes them ----

    // Those whose figure it is: of "above", the last one before them, of "below", the first one after them.
    function wordsOf(figure) {
        const found = [], waiting = [];
        let above = null;
        for (const part of (figure.closest("main") ?? document).querySelectorAll("figure[data-live], [data-touch]")) {
            if (part.matches("figure")) {
                found.push(...part === figure ? waiting : []);
                waiting.length = 0;
                above = part;
            } else if (part.dataset.of === "below") {
                waiting.push(part);
            } else if (above === figure) {
                found.push(part);
            }
        }
        return found;
    }

    // A number in a sentence: dragged to the side or moved by the arrows, a step each.
    function makeScrub(word, {name, least, most, step}, read, write) {
        Object.assign(word, {className: "scrub", tabIndex: 0, role: "slider", ariaLabel: name, ariaValueMin: least, ariaValueMax: most});
        const by = steps => write(limited(stepped(read() + steps * step, step), least, most));
        let held = null;
        word.addEventListener("pointerdown", event => {
            word.setPointerCapture(event.pointerId);
            held = event.clientX;
        });
        word.addEventListener("pointermove", ({clientX}) => {
            const steps = held === null ? 0 : Math.trunc((clientX - held) / 14);
            if (steps !== 0) {
                held += 14 * steps;
                by(steps);
            }
        });
        for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
            word.addEventListener(end, () => { held = null; });
        }
        word.addEventListener("keydown", event => {
            if (arrows[event.key]) {
                event.preventDefault();
                event.stopPropagation();
                const [right, up] = arrows[event.key];
                by((right + up) * (event.shiftKey ? 10 : 1));
            }
        });
        return () => { word.textContent = word.ariaValueNow = read(); };
    }

    // What a click does, and Enter and the space key.
    function makePress(word, press) {
        Object.assign(word, {className: "claim", tabIndex: 0, role: "button"});
        word.addEventListener("click", press);
        word.addEventListener("keydown", event => {
            if (event.key === "Enter" || event.key === " ") {
                event.preventDefault();
                event.stopPropagation();
                press();
            }
        });
    }

    // ---- A figure ----

    async function wake(figure) {
        const {scene: name, show = "", tell = "", at, text, ...given} = parse(figure.dataset.live);
        const shows = show.split(","), tells = tell.split(",").filter(Boolean);
        figure.dataset.state = "waking";
        const {program: about} = await program.state();
        const scene = about.scenes.find(scene => scene.name === name), values = scene.values ?? [];
        const asInText = Object.fromEntries(Object.entries(given).map(([name, value]) => [name, Number(value)]));
        const chosen = {...asInText};
        if (scene.text !== undefined) {
            chosen.text = text === undefined ? scene.text : text.replaceAll("; ", "\n");
        }
        const valueOf = name => chosen[name] ?? scene[name] ?? values.find(value => value.name === name)?.value ?? 0;
        const pane = figure.querySelector(".pane"), still = pane.querySelector("img");
        const canvas = make("canvas", {ariaLabel: still.alt}), numbers = make("output", {className: "numbers"});
        const parts = []; // what shows the chosen numbers: each is called when they change
        let frame = null, slow = false, small = false, pixel = at?.split(",").map(Number);
        canvas.setAttribute("role", "img");
        const marks = shows.includes("wrong") && !values.some(({name}) => name === "wrong"); // of the page, not of the program

        function request(half, without) {
            let words = `--stats${scene.text === undefined ? ` --only ${name}` : ""}`;
            words += half ? ` -s ${Math.ceil(scene.width / 2)}x${Math.ceil(scene.height / 2)}` : "";
            for (const name of ["light", "eye", "center", "up"]) {
                words += chosen[name] ? ` --${name} ${chosen[name].map(x => Number(x.toFixed(4)))}` : "";
            }
            for (const {name} of values) {
                words += chosen[name] === undefined || name === without ? "" : ` --set ${name}=${chosen[name]}`;
            }
            words += chosen.frame ? ` --frame ${chosen.frame}` : "";
            words += pixel ? ` --probe ${pixel.map(x => half ? x >> 1 : x)}` : "";
            return `${words}${scene.text === undefined ? "" : ` text\n${chosen.text.trimEnd()}\nend`}\n`;
        }

        // Pixels that are others without the attempt: red where another colour is, blue where none is.
        function compare({image: {data}}, {image: {data: right}}) {
            let wrong = 0, drawn = 0;
            for (let i = 0; i < data.length; i += 4) {
                const differs = [0, 1, 2].some(k => data[i + k] !== right[i + k]);
                drawn += right[i] + right[i + 1] + right[i + 2] > 0;
                wrong += differs;
                if (differs && chosen.wrong) {
                    data.set(data[i] + data[i + 1] + data[i + 2] > 0 ? [235, 60, 50] : [70, 110, 255], i);
                }
            }
            return `${wrong.toLocaleString("en")} pixels differ: ${(100 * wrong / Math.max(drawn, 1)).toFixed(1)} %`;
        }

        // Enlarged pixels have edges, whenever the pane gets its size.
        const sharpen = () => canvas.classList.toggle("enlarged", !small && canvas.width < pane.clientWidth);
        new ResizeObserver(sharpen).observe(pane);

        async function draw(half) {
            const next = parseFrame(await program.frame(request(half))), told = [];
            if (marks) {
                told.push(compare(next, parseFrame(await program.frame(request(half, "attempt")))));
            }
            frame = next;
            slow = half ? slow : frame.width > 400 && frame.milliseconds > 25;
            [canvas.width, canvas.height] = [frame.width, frame.height];
            small = half;
            sharpen();
            canvas.getContext("2d").putImageData(frame.image, 0, 0);
            const common = /^[^:]*: /.exec(frame.notes[0])?.[0] ?? ""; // "triangle 1: "
            const cut = frame.notes.every(note => note.startsWith(common)) ? common.length : 0;
            for (const word of tells) {
                const notes = frame.notes.map(note => note.slice(cut)).filter(note => ` ${note}`.includes(` ${word}`));
                const said = word in frame.counters
                    ? [[`${word.replaceAll("_", " ")}: ${Number(frame.counters[word]).toLocaleString("en")}`]]
                    : word === "|" ? [notes.flatMap(bracketed)] : notes.map(note => [note]);
                told.push(...said.map((content, i) => {
                    const number = make("span", {className: word === "|" ? "matrix" : ""}, ...content);
                    number.dataset.part = said.length > 1 ? word + i : word;
                    return number;
                }));
            }
            numbers.replaceChildren(...told);
            figure.dataset.state = "live";
            parts.forEach(show => show());
            showLit();
        }

        // One question at a time; what changes meanwhile is asked once, after it. What takes long is drawn small
        // until it rests.
        let asking = false, again = false, rest = 0;
        async function refresh(half = slow) {
            clearTimeout(rest);
            again = asking;
            if (asking) {
                return;
            }
            asking = true;
            do {
                again = false;
                try {
                    await draw(half);
                } catch (error) {
                    fail(figure, numbers, error);
                }
            } while (again);
            asking = false;
            if (half) {
                rest = setTimeout(() => refresh(false), 200);
            }
        }
        function choose(changes) {
            Object.assign(chosen, changes);
            parts.forEach(show => show());
            refresh();
        }

        // ---- Words of the text that belong to it ----

        const lit = new Set(), lights = []; // parts that are pointed at; words that light some, and which
        function showLit() {
            figure.querySelectorAll("[data-part]").forEach(part => part.classList.toggle("lit", lit.has(part.dataset.part)));
            lights.forEach(([word, names]) => word.classList.toggle("lit", names.some(name => lit.has(name))));
        }
        function light(names) {
            lit.clear();
            names.forEach(name => lit.add(name));
            showLit();
        }

        // A number by its name in the text: #5 is the fifth one of the scene's own text.
        const anyNumber = /-?\d+(\.\d+)?/g;
        function read(name) {
            return name === "at" ? `${pixel}` : name[0] === "#" ? Number(chosen.text.match(anyNumber)[name.slice(1) - 1]) : valueOf(name);
        }
        function write(numbers) {
            for (const [name, value] of numbers) {
                if (name === "at") {
                    pixel = value.split(",").map(Number);
                } else if (name[0] === "#") {
                    let i = 0;
                    chosen.text = chosen.text.replace(anyNumber, old => ++i === Number(name.slice(1)) ? value : old);
                } else {
                    chosen[name] = Number(value);
                }
            }
            choose({});
        }

        // What is lit besides handles and numbers: a pixel of the figure as in the text, and a line between handles.
        function addMark(name) {
            const [from, to] = name.split("-").map(part => pane.querySelector(`.handle[data-part="${part}"]`));
            if (to !== undefined) {
                const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
                svg.append(...["hit", "line"].map(className => {
                    const line = document.createElementNS(svg.namespaceURI, "line");
                    line.setAttribute("class", className);
                    return line;
                }));
                svg.dataset.part = name;
                canvas.after(svg);
                parts.push(() => svg.childNodes.forEach(line => [from, to].forEach((handle, i) => {
                    line.setAttribute(`x${i + 1}`, handle.style.left);
                    line.setAttribute(`y${i + 1}`, handle.style.top);
                })));
            } else if (/^\d/.test(name)) {
                const [x, y] = name.split(",").map(Number), mark = make("span", {className: "mark"}), given = chosen.text;
                mark.dataset.part = name;
                canvas.after(mark);
                parts.push(() => {
                    Object.assign(mark.style, {left: `${100 * x / frame.width}%`, bottom: `${100 * y / frame.height}%`,
                                               width: `${100 / frame.width}%`, height: `${100 / frame.height}%`});
                    mark.hidden = chosen.text !== given;
                });
            }
        }

        function addWords(word) {
            const all = word.dataset.touch.split(" "), numbers = all.map(one => one.split("="));
            if (all[0][0] === "@") {
                const names = all.map(one => one.slice(1));
                names.filter(name => figure.querySelector(`[data-part="${name}"]`) === null).forEach(addMark);
                Object.assign(word, {className: "lights", tabIndex: 0});
                for (const begin of ["pointerenter", "focus"]) {
                    word.addEventListener(begin, () => light(names));
                }
                for (const end of ["pointerleave", "blur"]) {
                    word.addEventListener(end, () => light([]));
                }
                lights.push([word, names]);
            } else if (numbers[0].length > 1) {
                const before = numbers.map(([name]) => [name, `${read(name)}`]);
                const is = () => numbers.every(([name, value]) => `${read(name)}` === value || Number(value) === read(name));
                makePress(word, () => write(is() ? before : numbers));
                parts.push(() => { word.ariaPressed = is(); });
            } else {
                const value = values.find(({name}) => name === all[0]) ?? {name: "coordinate", least: 0, most: Math.max(frame.width, frame.height) - 1, step: 1};
                const step = Math.max(value.step, (value.most - value.least) / 100);
                parts.push(makeScrub(word, {...value, step}, () => read(all[0]), to => write([[all[0], to]])));
            }
        }
        figure.addEventListener("pointerover", ({target}) => light([target.closest("[data-part]")?.dataset.part ?? ""]));
        figure.addEventListener("pointerleave", () => light([]));

        // ---- What is dragged on the picture ----

        const add = (part, ...handle) => parts.push(addHandle(pane, ...handle, part));
        const spot = (v, size) => (v + .5) / size; // the middle of a pixel
        const ratio = () => scene.text === undefined ? scene : frame; // its width and height

        const handles = {
            // On the half of a sphere that we see: the light goes from there to its middle.
            light() {
                const angle = () => chosen.light ?? scene.light;
                add("light", "lamp", "the lamp", () => {
                    const [x, y, z] = angle().map(v => v / length(angle()));
                    const far = z > 0 ? Math.max(Math.hypot(x, y), 1e-9) : 1; // behind: at the rim
                    return [.5 - .46 * x / far, .5 - .46 * y / far, `light ${[x, y, z].map(v => v.toFixed(2))}`];
                }, (left, up) => {
                    let [x, y] = [(.5 - left) / .46, (.5 - up) / .46];
                    const far = Math.max(1, Math.hypot(x, y));
                    [x, y] = [x / far, y / far];
                    choose({light: [x, y, -Math.sqrt(Math.max(0, 1 - x * x - y * y))]});
                }, (right, up) => choose({light: turned(angle(), right / 30, -up / 30)}));
            },
            // The picture itself turns.
            camera() {
                const turn = (right, up) => {
                    const middle = valueOf("center"), sight = valueOf("eye").map((x, i) => x - middle[i]);
                    choose({center: middle, eye: turned(sight, -right, -up).map((x, i) => x + middle[i])});
                };
                add("camera", "whole", "the camera", () => [.5, .5, `at ${valueOf("eye").map(v => v.toFixed(2))}`],
                    (x, y, right, up) => turn(3 * right, 3 * up), (right, up) => turn(right / 30, up / 30));
            },
            // The pixel of which the program says something.
            pixel() {
                const put = (x, y) => {
                    pixel = [limited(x, 0, ratio().width - 1), limited(y, 0, ratio().height - 1)];
                    choose({});
                };
                const point = (x, y) => put(Math.floor(x * ratio().width), Math.floor(y * ratio().height));
                pane.style.setProperty("--pixel", `${100 / ratio().width}%`);
                add("pixel", "probe", "the pixel", () => [spot(pixel[0], ratio().width), spot(pixel[1], ratio().height), `${pixel}`],
                    point, (right, up) => put(pixel[0] + right, pixel[1] + up));
                pane.addEventListener("pointermove", ({clientX, clientY, buttons, pointerType}) => {
                    if (buttons === 0 && pointerType === "mouse") {
                        const box = pane.getBoundingClientRect();
                        point((clientX - box.left) / box.width, (box.bottom - clientY) / box.height);
                    }
                });
            },
            // Corners and ends in the scene's text, those at one place together; and pairs of values NAME_x, NAME_y.
            points() {
                const read = () => scene.text === undefined ? [] : chosen.text.split("\n").map(line => line.trim().split(/\s+/));
                const lines = read();
                const step = lines.some(([word]) => word === "line") ? 1 : 1 / 8, shared = new Map();
                lines.forEach((words, row) => {
                    for (let i = 1; i < 1 + 2 * ({line: 2, triangle: 3}[words[0]] ?? 0); i += 2) {
                        const place = `${words[i]},${words[i + 1]}`;
                        shared.set(place, [...shared.get(place) ?? [], [row, i]]);
                    }
                });
                for (const [number, all] of [...shared.values()].entries()) {
                    const [row, i] = all[0], now = () => read()[row].slice(i, i + 2).map(Number);
                    const put = (x, y) => {
                        const lines = read();
                        all.forEach(([row, i]) => lines[row].splice(i, 2, stepped(x, step), stepped(y, step)));
                        choose({text: lines.map(words => words.join(" ")).join("\n")});
                    };
                    add(`point${number + 1}`, "point", lines[row][0] === "line" ? "an end" : "a corner",
                        () => [spot(now()[0], frame.width), spot(now()[1], frame.height), `${now()}`],
                        (x, y) => put(x * frame.width - .5, y * frame.height - .5),
                        (right, up) => put(now()[0] + right * step, now()[1] + up * step));
                }
                for (const x of values.filter(({name}) => name.endsWith("_x"))) {
                    const point = x.name.slice(0, -2), y = values.find(({name}) => name === `${point}_y`);
                    const part = ({name, least, most}) => (valueOf(name) - least) / (most - least);
                    const put = (right, up) => choose(Object.fromEntries([[x, right], [y, up]].map(([v, to]) =>
                        [v.name, stepped(limited(to, v.least, v.most), v.step)])));
                    const key = Math.max(x.step, (x.most - x.least) / 100);
                    add(point, "point", point.replaceAll("_", " "), () => [part(x), part(y), `${valueOf(x.name)}, ${valueOf(y.name)}`],
                        (left, up) => put(x.least + left * (x.most - x.least), y.least + up * (y.most - y.least)),
                        (right, up) => put(valueOf(x.name) + right * key, valueOf(y.name) + up * key));
                }
            },
        };

        // ---- Controls below the picture ----

        function makeChoice({name, help, least}, names) {
            const few = names.length < 5, said = make("output"); // of many names only the chosen one is written out
            const buttons = names.map((text, i) => make("button", {
                type: "button", textContent: few ? text : least + i, title: text, ariaLabel: few ? null : `${least + i}: ${text}`,
                onclick: () => choose({[name]: least + i})}));
            const group = make("span", {className: "choice", ariaLabel: name}, ...buttons);
            group.setAttribute("role", "group");
            parts.push(() => {
                buttons.forEach((button, i) => { button.ariaPressed = valueOf(name) === least + i; });
                said.textContent = names[valueOf(name) - least];
            });
            return few ? group : make("span", {className: "named"}, group, said);
        }

        function makeControl({name, help, least, most, step}) {
            const names = namesOf({help, least, most});
            if (names) {
                return makeChoice({name, help, least}, names);
            }
            if (most - least === step) {
                const toggle = make("button", {type: "button", textContent: help, className: "toggle",
                                               onclick: () => choose({[name]: valueOf(name) === most ? least : most})});
                parts.push(() => { toggle.ariaPressed = valueOf(name) === most; });
                return toggle;
            }
            const input = make("input", {type: "range", min: least, max: most, step}), output = make("output");
            input.addEventListener("input", () => choose({[name]: Number(input.value)}));
            parts.push(() => {
                input.value = valueOf(name);
                output.textContent = valueOf(name);
            });
            return make("label", {}, make("span", {textContent: help}), make("span", {className: "slide"}, input, output));
        }

        // The frames, to and fro about the first one, as if it swung. Nothing moves out of view, nor where somebody
        // asked for less motion.
        function makePlay() {
            const button = make("button", {type: "button", className: "toggle", onclick: () => set(!moving)});
            let moving = false, seen = true, angle = 0, last = 0;
            function set(on) {
                moving = on;
                button.textContent = moving ? "stop" : "move";
                if (moving) {
                    requestAnimationFrame(move);
                }
            }
            function move(now) {
                if (seen && !asking && now - last > 40) {
                    angle += Math.min(now - last, 100) / 1800;
                    last = now;
                    const frames = scene.frames;
                    choose({frame: 1 + (frames + Math.round(.22 * frames * Math.sin(angle))) % frames});
                }
                if (moving && button.isConnected) {
                    requestAnimationFrame(move);
                }
            }
            new IntersectionObserver(([{isIntersecting}]) => { seen = isIntersecting; }).observe(pane);
            set(!matchMedia("(prefers-reduced-motion: reduce)").matches);
            return button;
        }

        const panel = make("div", {className: "panel"});
        pane.append(canvas);
        await draw(false);
        awake.push(() => refresh());
        for (const name of shows) {
            const value = values.find(value => value.name === name) ??
                {wrong: {name, help: "wrong pixels", least: 0, most: 1, step: 1},
                 frame: {name, help: "frame", least: 1, most: scene.frames, step: 1}}[name];
            if (value) {
                const control = makeControl(value);
                control.dataset.part = name;
                panel.append(control);
            } else if (name === "play") {
                panel.append(makePlay());
            } else {
                handles[name]?.(); // a hand-out lacks some values
            }
        }
        panel.append(numbers, make("button", {type: "button", className: "more", textContent: "\u2022\u2022\u2022",
            ariaLabel: "Everything about this picture", onclick: () => openPanel(still.alt, {scene: name, ...chosen})}));
        pane.after(panel);
        wordsOf(figure).forEach(addWords);
        parts.forEach(show => show());
    }

    function fail(figure, numbers, error) {
        figure.dataset.state = "failed";
        numbers.textContent = error.message;
        if (!numbers.isConnected) {
            figure.append(make("div", {className: "panel"}, numbers));
        }
    }

    // ---- Everything else about a picture: the live page, over this one ----

    function openPanel(title, chosen) {
        const frame = make("iframe", {title, src: `${program.everything}#${new URLSearchParams(
            Object.entries(chosen).filter(([, value]) => value !== undefined))}`});
        const dialog = make("dialog", {className: "everything"},
                            make("button", {type: "button", textContent: "Close", onclick: () => dialog.close()}), frame);
        frame.addEventListener("load", () => frame.focus());
        const listen = event => event.source === frame.contentWindow && event.data === "close" && dialog.close();
        addEventListener("message", listen); // Escape, in the frame
        dialog.addEventListener("close", () => {
            removeEventListener("message", listen);
            dialog.remove();
        });
        document.body.append(dialog);
        dialog.showModal();
    }

    const awake = []; // how to draw each figure again

    // ---- They wake before they come into view ----

    const watch = new IntersectionObserver(entries => {
        for (const {target, isIntersecting} of entries) {
            if (isIntersecting) {
                watch.unobserve(target);
                wake(target).catch(error => fail(target, make("output", {className: "numbers"}), error));
            }
        }
    }, {rootMargin: "200px"});
    document.querySelectorAll("figure[data-live]").forEach(figure => watch.observe(figure));

    return {
        // What is new, or a copy of a figure, sleeps until it comes into view.
        sleep(figure) {
            figure.querySelectorAll("canvas, .handle, .panel").forEach(part => part.remove());
            delete figure.dataset.state;
            watch.observe(figure);
        },
        // The program is another one.
        refresh: () => awake.forEach(draw => draw()),
    };
})();
