// What scripts add to a page of the site: search, and slides. Its living figures are in figure.js.
"use strict";

// ---- Search ----

const search = document.getElementById("search"), found = document.getElementById("found");
const root = document.currentScript.src.replace(/live\/site\.js$/, "");

search.hidden = false;
search.addEventListener("focus", () => {
    const script = document.createElement("script");
    script.src = `${root}live/words.js`; // defines `words`
    script.onload = show;
    document.head.append(script);
}, {once: true});
search.addEventListener("input", show);

function element(tag, ...content) {
    const made = document.createElement(tag);
    made.append(...content);
    return made;
}

// The text around what was found, which is marked.
function excerpt(text, wanted) {
    const at = Math.max(0, text.toLowerCase().indexOf(wanted)), end = at + wanted.length;
    return element("p", text.slice(Math.max(0, at - 60), at), element("mark", text.slice(at, end)),
                   text.slice(end, end + 100));
}

// Sections that have all words: those that have them in their titles first, then those that have
// them one after the other.
function show() {
    const phrase = search.value.trim().toLowerCase(), wanted = phrase.split(/\s+/);
    const has = text => wanted.every(word => text.toLowerCase().includes(word));
    const worth = ([, title, section, text]) =>
        2 * has(`${title} ${section}`) + text.toLowerCase().includes(phrase);
    const all = phrase === "" || typeof words === "undefined" ? []
        : words.filter(row => has(row.slice(1).join(" "))).sort((a, b) => worth(b) - worth(a));
    found.replaceChildren(...all.slice(0, 30).map(([address, title, section, text]) => {
        const link = element("a", section === "" ? title : `${title}: ${section}`);
        link.href = root + address;
        return element("li", link, excerpt(text, text.toLowerCase().includes(phrase) ? phrase : wanted[0]));
    }));
    found.hidden = phrase === "";
    if (phrase !== "" && all.length === 0) {
        found.append(element("li", "Nothing is found."));
    }
}

// ---- A lesson as slides, of the same text ----

const main = document.querySelector("main"), slides = element("main"), place = element("span");
let shown = -1; // the number of the slide, or -1

// The sentence that a section begins with; with the next one, where it is as short as "Check:".
function lead(block) {
    const range = document.createRange(), texts = document.createTreeWalker(block, NodeFilter.SHOW_TEXT);
    range.selectNodeContents(block);
    while (texts.nextNode()) {
        for (const {index} of texts.currentNode.data.matchAll(/[.?!:](?=\s|$)/g)) {
            range.setEnd(texts.currentNode, index + 1);
            if (range.toString().length > 12) return range.cloneContents();
        }
    }
    range.selectNodeContents(block);
    return range.cloneContents();
}

function add(heading, ...content) {
    const slide = element("section", element("h1", ...heading.cloneNode(true).childNodes), ...content);
    slide.tabIndex = 0; // it may be higher than the window
    slide.querySelectorAll("figure").forEach(figure => figures.sleep(figure));
    slide.querySelectorAll("[id]").forEach(part => part.removeAttribute("id"));
    for (const program of slide.querySelectorAll("pre")) { // as large as its longest line allows
        program.style.setProperty("--columns", Math.max(...program.textContent.split("\n").map(line => line.length), 1));
    }
    slides.append(slide);
}

function button(sign, name, act) {
    const made = element("button", sign);
    made.type = "button";
    made.setAttribute("aria-label", name);
    made.addEventListener("click", act);
    return made;
}

// What is shown large: a picture, a program, a table; a question comes with its answer.
const exhibits = "p:has(img), figure, pre, div.wide, li:has(> details)";

function make_slides() {
    let heading = null, words = null, count = 0;
    const end = () => { // a section without anything to show is its heading and sentence
        if (heading !== null && count === 0) add(heading, words ?? "");
    };
    for (const block of main.children) {
        if (/^H[1-4]$/.test(block.tagName)) {
            end();
            [heading, words, count] = [block, null, 0];
        } else if (heading !== null) {
            // Neither links to other pages nor a line count.
            if (words === null && block.tagName === "P" && !block.matches(exhibits) && !/ \| |^.{0,30}$/.test(block.textContent)) {
                words = element("p", lead(block));
            }
            const parts = block.matches(exhibits) ? [block] : [...block.querySelectorAll(exhibits)];
            for (const part of parts.filter(part => !part.parentElement.closest(exhibits))) { // what an answer has stays there
                add(heading, count++ === 0 && words !== null ? words : "",
                    part.tagName === "LI" ? element("div", ...part.cloneNode(true).childNodes) : part.cloneNode(true));
            }
        }
    }
    end();
    slides.id = "slides";
    const bar = element("nav", button("\u2190", "Previous slide", go_back), place, button("\u2192", "Next slide", go_on),
                        button("\u2715", "Back to the text", () => show_slide(-1)));
    bar.setAttribute("aria-label", "Slides");
    slides.append(bar);
    main.after(slides);
}

function show_slide(number) {
    if (slides.childElementCount === 0) make_slides();
    const all = slides.querySelectorAll("section");
    shown = Math.max(-1, Math.min(number, all.length - 1));
    document.body.classList.toggle("lecture", shown >= 0);
    all.forEach((slide, i) => slide.classList.toggle("shown", i === shown));
    place.textContent = `${shown + 1} / ${all.length}`;
    history.replaceState(null, "", shown >= 0 ? `#slide=${shown + 1}` : location.pathname);
    all[shown]?.focus();
}

// The answer comes before the next slide.
function go_on() {
    const answer = slides.querySelector(".shown details:not([open])");
    if (answer !== null) answer.open = true;
    else show_slide(shown + 1);
}

function go_back() {
    show_slide(Math.max(0, shown - 1));
}

if (main.querySelector("h2") !== null && main.querySelector(".stage") === null) {
    const link = element("a", "Slides");
    link.href = "#slide=1";
    document.querySelector("header").prepend(link);
    const follow = () => {
        const number = /^#slide=(\d+)$/.exec(location.hash)?.[1];
        if (number !== undefined || shown >= 0) show_slide((number ?? 0) - 1);
    };
    addEventListener("hashchange", follow);
    follow();
    document.addEventListener("keydown", event => {
        const own = event.key === " " ? "input, iframe, button, summary" : "input, iframe"; // keys of these
        if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches(own) ||
            document.querySelector("dialog") !== null) return;
        const keys = shown < 0 ? {s: () => show_slide(0)} : {
            ArrowRight: go_on, PageDown: go_on, " ": go_on, ArrowLeft: go_back, PageUp: go_back,
            Home: () => show_slide(0), End: () => show_slide(Infinity), Escape: () => show_slide(-1)};
        if (keys[event.key] !== undefined) {
            event.preventDefault();
            keys[event.key]();
        }
    });
}
