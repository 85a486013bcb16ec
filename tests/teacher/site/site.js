// What scripts add to a page of the site: search, and the live page in a picture's place.
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

// ---- The live page ----

let opened = null; // the link, and the frame in its place: one at a time

function open(link) {
    const frame = document.createElement("iframe");
    frame.src = link.href;
    frame.title = `${link.firstElementChild.alt}, live`;
    opened?.frame.replaceWith(opened.link);
    link.replaceWith(frame);
    opened = {link, frame};
    frame.focus();
}

for (const link of document.querySelectorAll("a.live")) {
    link.addEventListener("click", event => {
        if (!event.ctrlKey && !event.metaKey && !event.shiftKey) {
            event.preventDefault();
            open(link);
        }
    });
}
