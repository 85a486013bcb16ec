// The lesson's text as it is on the web pages, with its figures drawn by the student's program, or still, by the
// lesson's. Its second page is figures.html?CAMERA.md.
"use strict";

const main = document.querySelector("main"), message = document.getElementById("message");
const file = location.search.slice(1) || "README.md";

// Pictures are served as they lie, and the lesson's pages; other lessons and files are not.
function addressOf(link) {
    if (/\.(png|svg)$/.test(link)) {
        return link.replace("../", "");
    }
    const [, page, place] = /^([A-Z]+\.md)?(#.*)?$/.exec(link) ?? [];
    return page !== undefined ? `figures.html?${page}${place ?? ""}` : place ?? (/^https?:/.test(link) ? link : null);
}

function show(text) {
    const rest = text.replace(/\n\n\[.* \| .*\n/, "\n"); // without the links to other lessons
    main.innerHTML = htmlOfMarkdown(rest, addressOf);
    document.title = main.querySelector("h1").textContent;
    for (const figure of main.querySelectorAll("figure[data-live]")) {
        const image = figure.querySelector("img"); // with a size, it is in view or not
        image.addEventListener("load", () => figures.sleep(figure));
        if (image.complete) {
            figures.sleep(figure);
        }
    }
    document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
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
            show(await (await fetchFrom(`text/${file}`)).text());
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
