// A lesson's text as a page: as much of Markdown as the lessons use. Pictures whose title begins with "live:"
// become living figures, and remarks make words belong to them (tests/teacher/site/figures.awk says how).
"use strict";

// addressOf(link) is where a link or a picture leads in this page; null for nowhere, and then its words remain.
function htmlOfMarkdown(text, addressOf) {
    const escape = text => text.replace(/&(?!#?\w+;)/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");
    const touch = (where, words) => `<span data-of=${where} data-touch="${words}">`;

    function picture(alt, source, title = "") {
        const image = `<img alt="${alt}" src="${addressOf(source)}">`;
        return title.startsWith("live: ") ? `<figure data-live="${title}"><div class=pane>${image}</div></figure>` : image;
    }

    function inline(text) {
        const kept = [], keep = html => `\0${kept.push(html) - 1}\0`;
        const left = text.replace(/(`+)(.+?)\1(?!`)/gs, (all, ticks, code) => keep(`<code>${escape(code).replace(/[^ ]*-[^ ]*/g, "<nobr>$&</nobr>")}</code>`))
            .replace(/<!-- (above|below): (.+?) -->/g, (all, where, words) => keep(touch(where, words)))
            .replace(/<!-- \/ -->/g, () => keep("</span>")).replace(/<!--.*?-->/gs, "")
            .replace(/!\[([^\]]*)\]\(([^ )]+)(?: "([^"]*)")?\)/g, (all, ...parts) => keep(picture(...parts)))
            .replace(/\[([^\]]*)\]\(([^ )]+)\)/g, (all, words, link) =>
                addressOf(link) === null ? words : `${keep(`<a href="${addressOf(link)}">`)}${words}${keep("</a>")}`)
            .replace(/<\/?[a-z](?:"[^"]*"|[^">])*>/g, tag => keep(tag.replace(/ title="live: [^"]*"/, "").replace(/ (src|href)="([^"]*)"/, (all, name, link) => addressOf(link) === null ? "" : ` ${name}="${addressOf(link)}"`)));
        let html = escape(left).replace(/\*\*(.+?)\*\*/gs, "<strong>$1</strong>").replace(/\*([^\s*](?:.*?[^\s])?)\*/gs, "<em>$1</em>");
        while (html.includes("\0")) { // what is kept may hold some that is kept, too
            html = html.replace(/\0(\d+)\0/g, (all, i) => kept[i]);
        }
        return html;
    }

    function code(lines, info = "") {
        const [where, ...words] = info.split(/:? /), parts = {};
        for (const [number, part] of words.map(word => word.split("="))) {
            parts[number] = [...parts[number] ?? [], part];
        }
        const isMatrix = i => /^\| /.test(lines[i] ?? "");
        const brackets = (row, i) => row.split("|").reduce((left, right, k) => // of a matrix, instead of its bars
            `${left}<i class="${k % 2 ? "l" : "r"}${isMatrix(i - 1) ? "" : " t"}${isMatrix(i + 1) ? "" : " b"}">|</i>${right}`);
        const line = (text, i) => parts[i + 1] ? `${touch(where, parts[i + 1].join(" "))}${escape(text)}</span>`
            : isMatrix(i) ? brackets(escape(text), i) : escape(text);
        return `<pre tabindex=0><code>${lines.map(line).join("\n")}\n</code></pre>`;
    }

    function table(rows) {
        const cells = (row, tag) => row.slice(1, -1).split(" |").map(cell => cell.trim() === "" ? "<td></td>"
            : `<${tag}>${inline(cell.trim())}</${tag}>`).join("");
        const [head, , ...body] = rows.map(row => `${row.trim()}`.replace(/\|$/, " |"));
        return `<div class=wide tabindex=0><table><thead><tr>${cells(head, "th")}</tr></thead>` +
               `<tbody>${body.map(row => `<tr>${cells(row, "td")}</tr>`).join("")}</tbody></table></div>`;
    }

    function blocks(lines) {
        let html = "", i = 0;
        // The lines from here on, as long as they are so.
        const take = is => {
            const begin = i;
            while (i < lines.length && is(lines[i], i - begin)) i++;
            return lines.slice(begin, i);
        };
        while (i < lines.length) {
            const line = lines[i], [, marker] = /^(- +|\d+\. +)/.exec(line) ?? [];
            if (line.trim() === "") {
                i++;
            } else if (line.startsWith("```")) {
                const [, ...block] = take((line, k) => k === 0 || !line.startsWith("```"));
                html += code(block, line.replace(/^```\w* ?/, ""));
                i++;
            } else if (/^#+ /.test(line)) {
                const level = line.indexOf(" "), words = inline(line.slice(level + 1));
                const id = words.replace(/<[^>]*>/g, "").toLowerCase().replace(/[^\p{L}\d _-]/gu, "").replaceAll(" ", "-");
                html += `<h${level} id="${id}">${words}</h${level}>`;
                i++;
            } else if (line.startsWith("    ")) {
                html += code(take(line => /^( {4}|\s*$)/.test(line)).map(line => line.slice(4)).join("\n").trimEnd().split("\n"));
            } else if (line.startsWith("|")) {
                html += table(take(line => line.startsWith("|")));
            } else if (line.startsWith("> ")) {
                html += `<blockquote>${blocks(take(line => line.startsWith(">")).map(line => line.slice(2)))}</blockquote>`;
            } else if (marker !== undefined) {
                const indent = new RegExp(`^( {${marker.length}}|\\s*$)`), list = marker[0] === "-" ? "ul" : "ol";
                const item = take((line, k) => k === 0 || indent.test(line)).map(line => line.slice(marker.length));
                html += `<${list}${list === "ol" ? ` start=${parseInt(marker)}` : ""}><li>${blocks(item)}</li></${list}>`;
            } else if (/^<\/?[a-z]/.test(line)) {
                html += `${inline(take(line => line.trim() !== "").join("\n"))}\n`;
            } else if (/^<!--/.test(line)) {
                i++;
            } else {
                const words = inline(take((line, k) => k === 0 || !/^(\s*$|```|#+ |- |> |\||<\/?details)/.test(line)).join("\n"));
                html += /^<figure/.test(words) ? words : `<p${/^<img [^>]*\.svg"/.test(words) ? " class=wide tabindex=0" : ""}>${words}</p>`;
            }
        }
        return html.replace(/<\/(ul|ol)><\1[^>]*>/g, ""); // items one after another are one list
    }

    return blocks(text.split("\n"));
}
