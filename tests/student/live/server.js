// Where the page's frames come from: the server of `make live`. The course's web pages bring a
// `program` of their own, which answers the same.
"use strict";

async function fetchFrom(path, options) {
    try {
        return await fetch(path, options);
    } catch {
        throw new Error("Nobody answers: has make live ended?");
    }
}

const program = {
    // What common/run/live.h says of the scenes, and the messages of the build:
    // {version, building, step, message, printed, todo, program}.
    async state() {
        return (await fetchFrom("state")).json();
    },
    // The bytes of the answer to a request, as live.h has them.
    async frame(request) {
        const answer = await fetchFrom("frame", {method: "POST", body: request});
        return new Uint8Array(await answer.arrayBuffer());
    },
    everything: "./", // the page with all that can be asked of it
    // The address of a picture. A program without this has no references to show.
    reference(scene) {
        return `reference/${scene}.png`;
    },
};
