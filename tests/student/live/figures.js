// The lesson's text as it is on the web pages, with its figures drawn by the student's program, or still, by the
// lesson's. Others of the course are figures.html?step06_texture/README.md: their pictures are still.
"use strict";

const main = document.querySelector("main"), message = document.getElementById("message");
let file = location.search.slice(1); // as it lies in the course

// Texts become pages like this one; pictures and sources are served as they lie.
function addressOf(link) {
    if (/^(https?:|#)/.test(link)) {
        return link;
    }
    const {pathname, hash} = new URL(link, `http://course/${file}`), path = pathname.slice(1);
    return path.endsWith(".md") ? `figures.html?${path}${hash}` : /\.(png|svg|c|h)$/.test(path) ? path : null;
}

// Another lesson's figures are drawn by another program.
function still(figures) {
    figures.forEach(figure => delete figure.dataset.live);
    document.querySelector("header .choice").remove();
    const [, number] = /step(\d+)/.exec(figures[0]?.innerHTML) ?? [];
    if (number !== undefined) {
        main.querySelector("h1").insertAdjacentHTML("afterend",
            `<p>The figures of this page are still here. <code>make live STEP=${number}</code> brings them under the mouse.</p>`);
    }
}

function show(text, step) {
    main.innerHTML = htmlOfMarkdown(text, addressOf);
    document.title = main.querySelector("h1").textContent;
    if (!file.startsWith(`${step}/`)) {
        still(main.querySelectorAll("figure[data-live]"));
    }
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
            file ||= `${state.step}/README.md`;
            show(await (await fetchFrom(file)).text(), state.step);
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
