// The lesson's living figures, each with its heading and the paragraph before it, drawn by the student's
// program: taken from the lesson's README.md, where their titles say what they offer.
"use strict";

const main = document.querySelector("main"), message = document.getElementById("message");

function element(tag, options, ...content) {
    const made = Object.assign(document.createElement(tag), options);
    made.append(...content);
    return made;
}

// Markdown without its signs.
const plain = text => text.replace(/!?\[([^\]]*)\]\([^)]*\)/g, "$1").replace(/[`*]/g, "").replace(/\s+/g, " ");

function show(text, step) {
    let heading = "", words = "";
    for (const block of text.split(/\n\n+/)) {
        const found = [...block.matchAll(/!\[([^\]]+)\]\(([^ )]+) "(live: [^"]+)"\)/g)];
        if (found.length > 0) {
            main.append(...heading ? [element("h2", {textContent: heading})] : [], ...words ? [element("p", {textContent: words})] : []);
            heading = words = "";
        }
        for (const [, alt, file, title] of found) {
            const image = element("img", {alt, src: file.replace(`../tests/reference/${step}/`, "reference/")});
            const figure = element("figure", {}, element("div", {className: "pane"}, image));
            figure.dataset.live = title;
            main.append(figure);
            image.addEventListener("load", () => figures.sleep(figure)); // with a size, it is in view or not
        }
        if (/^#+ /.test(block)) {
            [heading, words] = [plain(block.replace(/^#+ /, "")), ""];
        } else if (/^[^\s|<!>`#-]/.test(block)) {
            words = plain(block);
        }
    }
}

const buttons = [...document.querySelectorAll("header button")];
buttons.forEach((button, i) => button.addEventListener("click", () => {
    document.body.classList.toggle("stills", i === 1);
    buttons.forEach(other => { other.ariaPressed = other === button; });
}));

let version = 0;

async function lookForChanges() {
    try {
        const state = await program.state();
        message.textContent = state.building ? "Building ..." : state.message;
        if (version === 0) {
            document.title = document.querySelector("h1").textContent = state.step;
            show(await (await fetchFrom("text")).text(), state.step);
        } else if (state.version !== version) {
            figures.refresh();
        }
        version = state.version;
    } catch (error) {
        message.textContent = error.message;
    }
    message.hidden = message.textContent === "";
    setTimeout(lookForChanges, 500);
}

lookForChanges();
