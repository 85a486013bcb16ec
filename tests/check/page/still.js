// Where the frames of a page without a program come from: the pictures in its sections, which are
// seen without a script too. A click on one opens the page of `make live` over them.
"use strict";

const sections = new Map(); // by the scene's name, in a report behind the lesson's number
let lesson = "";
for (const part of document.querySelectorAll("h2[id], section")) {
    if (part.id) {
        lesson = part.id.match(/\d+/)[0] + " ";
    } else if (part.querySelector(".pictures img")) {
        sections.set(lesson + part.querySelector("h2,h3").textContent, part);
    }
}

const pictureOf = (name, which) => sections.get(name).querySelector(`.pictures [data-name="${which}"] img`);

const program = {
    still: true,
    async state() {
        const scenes = [...sections.keys()].map(name => ({name, frames: 1}));
        return {version: 0, step: document.title, message: "", program: {scenes}};
    },
    // "yours", or what is exact and has only the reference.
    async frame(request) {
        const name = request.match(/--only (.*?)( --probe .*)?\n/)[1];
        const picture = pictureOf(name, "yours") ?? pictureOf(name, "reference");
        const {width, height, pixels} = await readPicture(picture.src);
        const head = new TextEncoder().encode(`frame ${width} ${height} 0 0\n`);
        const answer = new Uint8Array(head.length + pixels.length);
        answer.set(head);
        answer.set(pixels, head.length);
        return answer;
    },
    reference: name => pictureOf(name, "reference")?.src,
    difference: name => pictureOf(name, "difference")?.src,
};

function look(name, view) {
    document.getElementById("viewer").showModal();
    [...document.getElementById("scenes").children].find(button => button.textContent === name).click();
    chooseView(view in {reference: 1, difference: 1} ? view : "yours");
    document.getElementById("picture").focus();
}

for (const [name, section] of sections) {
    for (const figure of section.querySelectorAll(".pictures figure")) {
        const button = document.createElement("button");
        button.append(figure.querySelector("img"));
        button.addEventListener("click", () => look(name, figure.dataset.name));
        figure.append(button);
    }
}
