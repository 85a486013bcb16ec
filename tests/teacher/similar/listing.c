/* The pairs as a page: see listing.h. */
#include "listing.h"

#include "check/page/page.h"
#include "matches.h"

#include <stdlib.h>
#include <string.h>

enum {
    PAIRS_SHOWN = 40,        /* of which the lines are shown: they make the page large */
    BLOCKS_SHOWN = 200,      /* of a pair in a lesson: copies of the solutions have up to 13 */
    LINE_LENGTH_LIMIT = 300, /* bytes of a line that are shown */
    TAB_SPACES = 4
};

/* The colours are those of the lessons' charts. */
static const char *const style[] = {
    ":root{color-scheme:light dark;--text:#1f2328;--paper:#fff;--line:#d1d9e0;--soft:#f6f8fa;",
    "--link:#0a5cc2;--alike:#fff1b8;--edge:#b35900}",
    "@media (prefers-color-scheme:dark){:root{--text:#e6edf3;--paper:#0d1117;--line:#3d444d;",
    "--soft:#151b23;--link:#58a6ff;--alike:#433500;--edge:#f0a35c}}",
    "*{box-sizing:border-box}",
    "body{margin:0 auto;padding:0 16px 48px;max-width:1500px;background:var(--paper);",
    "color:var(--text);font:16px/1.5 sans-serif;overflow-wrap:anywhere}",
    "h1{font-size:22px}h2{font-size:18px;margin:32px 0 4px;border-top:1px solid var(--line);",
    "padding-top:16px}p{max-width:75ch}a{color:var(--link)}",
    ".note{border-left:4px solid var(--edge);background:var(--soft);padding:8px 12px}",
    "table{border-collapse:collapse}th,td{text-align:left;vertical-align:top;",
    "padding:2px 16px 2px 0;border-bottom:1px solid var(--line)}",
    "td.number,th.number{text-align:right;white-space:nowrap}",
    "details{margin:6px 0}summary{cursor:pointer;padding:2px 0}",
    ":focus-visible{outline:3px solid var(--link);outline-offset:1px}",
    ".block{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr);gap:8px;margin:8px 0}",
    "figure{margin:0}figcaption{font-size:14px}",
    "pre{margin:0;padding:6px 0;background:var(--soft);border:1px solid var(--line);",
    "font:13px/1.45 monospace;white-space:pre-wrap;tab-size:4}",
    "pre span,pre mark{display:block;padding-left:52px;text-indent:-46px;color:inherit;",
    "background:none;border-left:3px solid transparent}",
    "pre mark{background:var(--alike);border-left-color:var(--edge)}",
    "pre i{display:inline-block;width:40px;margin-right:6px;text-indent:0;text-align:right;",
    "font-style:normal;opacity:.65;user-select:none}",
    "@media (max-width:700px){.block{grid-template-columns:minmax(0,1fr);margin:8px 0 20px}",
    "td,th{padding-right:8px}}",
    NULL};

/* ---- Lines of a lesson ---- */

/* Append a line as a page can hold it: tabs as spaces, cut where it is too long. */
static bool put_line_text(struct bytes *page, const unsigned char *line, size_t size) {
    char text[LINE_LENGTH_LIMIT + TAB_SPACES + sizeof "..."];
    size_t length = 0, i = 0;
    size -= size > 0 && line[size - 1] == '\r';
    for (; i < size && length < LINE_LENGTH_LIMIT; i++) {
        size_t count = line[i] == '\t' ? TAB_SPACES : 1;
        memset(text + length, line[i] == '\t' ? ' ' : line[i] == '\0' ? '?' : line[i], count);
        length += count;
    }
    memcpy(text + length, i < size ? "..." : "", i < size ? sizeof "..." : 1);
    return page_text(page, text);
}

/* The lines of a block that stand in this file; the others are another file's. */
static bool put_file_lines(struct bytes *page, const struct source *file, struct lines lines,
                           const bool *marked) {
    const unsigned char *at = file->text.data, *end = at + file->text.size;
    for (size_t i = 0; i < file->line_count && file->text.size > 0; i++) {
        const unsigned char *line_end = at < end ? memchr(at, '\n', (size_t)(end - at)) : end;
        line_end = line_end != NULL ? line_end : end;
        size_t line = file->first_line + i;
        const char *tag = marked[line] ? "mark" : "span";
        if (line >= lines.first && line <= lines.last &&
            !(bytes_print(page, "<%s><i>%zu</i>", tag, i + 1) &&
              put_line_text(page, at, (size_t)(line_end - at)) &&
              bytes_print(page, "</%s>", tag))) {
            return false;
        }
        at = line_end < end ? line_end + 1 : end;
    }
    return true;
}

/* The file in which a line stands. */
static const struct source *file_of(const struct sources *sources, size_t line) {
    size_t i = 0;
    while (i + 1 < sources->count && sources->files[i + 1].first_line <= line) {
        i++;
    }
    return &sources->files[i];
}

/* "main.c:12" */
static bool put_place(struct bytes *page, const struct sources *sources, size_t line) {
    const struct source *file = file_of(sources, line);
    return page_text(page, file->name) && bytes_print(page, ":%zu", line - file->first_line + 1);
}

static bool put_lines(struct bytes *page, const char *name, const struct sources *sources,
                      struct lines lines, const bool *marked) {
    bool done = page_html(page, "<figure><figcaption>") && page_text(page, name) &&
                page_html(page, ", ") && put_place(page, sources, lines.first) &&
                (lines.first == lines.last ||
                 (page_html(page, " to ") && put_place(page, sources, lines.last))) &&
                page_html(page, "</figcaption><pre>");
    const struct source *last = file_of(sources, lines.last);
    for (const struct source *file = file_of(sources, lines.first); file <= last && done; file++) {
        done = put_file_lines(page, file, lines, marked);
    }
    return done && page_html(page, "</pre></figure>\n");
}

/* ---- A lesson of a pair ---- */

/* A submission's part in it. */
struct side {
    const struct submission *submission;
    struct sources sources;
};

static bool read_side(struct side *side, const struct class *class, size_t submission,
                      size_t lesson, struct error *error) {
    *side = (struct side){.submission = &class->submissions[submission]};
    char *path = string_format("%s/%s", side->submission->path, class->lessons.all[lesson]);
    bool done = path != NULL ? sources_read(&side->sources, path, LESSON_SIZE_LIMIT, error)
                             : error_out_of_memory(error);
    free(path);
    return done;
}

static bool put_blocks(struct bytes *page, const struct side *a, const struct side *b,
                       size_t lesson) {
    struct matches matches;
    bool done = matches_find(&matches, &a->submission->lessons[lesson], a->sources.line_count,
                             &b->submission->lessons[lesson], b->sources.line_count);
    for (size_t i = 0; i < matches.count && i < BLOCKS_SHOWN && done; i++) {
        const struct block *block = &matches.blocks[i];
        done = page_html(page, "<div class=block>") &&
               put_lines(page, a->submission->name, &a->sources, block->a, matches.marked_a) &&
               put_lines(page, b->submission->name, &b->sources, block->b, matches.marked_b) &&
               page_html(page, "</div>\n");
    }
    if (done && matches.count > BLOCKS_SHOWN) {
        done = bytes_print(page, "<p>and in %zu more places</p>\n", matches.count - BLOCKS_SHOWN);
    }
    matches_free(&matches);
    return done;
}

static unsigned percent(uint32_t part, uint32_t whole) {
    return whole > 0 ? (unsigned)((double)part * 100 / whole + 0.5) : 0;
}

/* "28 fingerprints in both: 93 % of anna, 80 % of ben" */
static bool put_common(struct bytes *page, const struct class *class, const struct pair *pair,
                       struct common common) {
    return bytes_print(page, "%u fingerprints in both: %u&nbsp;%% of ", common.shared,
                       percent(common.shared, common.of_a)) &&
           page_text(page, class->submissions[pair->a].name) &&
           bytes_print(page, ", %u&nbsp;%% of ", percent(common.shared, common.of_b)) &&
           page_text(page, class->submissions[pair->b].name);
}

static bool put_lesson(struct bytes *page, const struct class *class, const struct pair *pair,
                       size_t lesson) {
    struct common common = pairs_compare(class, lesson, pair->a, pair->b);
    if (common.shared == 0) {
        return true;
    }
    struct side a = {0}, b = {0};
    struct error error;
    bool read = read_side(&a, class, pair->a, lesson, &error) &&
                read_side(&b, class, pair->b, lesson, &error);
    bool done = page_html(page, "<details><summary>") &&
                page_text(page, class->lessons.all[lesson]) && page_html(page, ": ") &&
                put_common(page, class, pair, common) && page_html(page, "</summary>\n") &&
                (read ? put_blocks(page, &a, &b, lesson) : page_text(page, error.message)) &&
                page_html(page, "</details>\n");
    sources_free(&a.sources);
    sources_free(&b.sources);
    return done;
}

/* ---- The page ---- */

static bool put_head(struct bytes *page) {
    bool done =
        page_html(page, "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
                        "<meta name=viewport content=\"width=device-width,initial-scale=1\">"
                        "\n<link rel=icon href=\"data:,\">\n"
                        "<title>Submissions that are alike</title>\n<style>");
    for (size_t i = 0; style[i] != NULL && done; i++) {
        done = page_html(page, style[i]);
    }
    return done &&
           page_html(page, "</style>\n</head>\n<body>\n<h1>Submissions that are alike</h1>\n");
}

static bool put_introduction(struct bytes *page, const struct class *class,
                             const struct pairs *pairs, struct limits limits) {
    size_t count = class->submission_count;
    return page_html(page,
                     "<p class=note><strong>For a person to look at. This page judges nobody."
                     "</strong> Short tasks have few right solutions, and many of them are "
                     "alike by nature. Two people may also have worked from the same book, or "
                     "together where they were allowed to. Read the lines before you ask.</p>\n"
                     "<p>What the course gave to all is left out, and so is what many have "
                     "written. Names, numbers, comments, white space and the order of "
                     "functions do not count. Lines that are alike are marked.</p>\n") &&
           bytes_print(page,
                       "<p>%zu of %zu pairs share at least %.0f&nbsp;%% of the shorter one in all "
                       "lessons, or at least %.0f&nbsp;%% of it in one.</p>\n",
                       pairs->count, count > 0 ? count * (count - 1) / 2 : 0, limits.all * 100,
                       limits.lesson * 100);
}

/* A link to the lines where they are shown. */
static bool put_names(struct bytes *page, const struct class *class, const struct pair *pair,
                      size_t number) {
    bool shown = number < PAIRS_SHOWN;
    return (!shown || bytes_print(page, "<a href=\"#pair%zu\">", number + 1)) &&
           page_text(page, class->submissions[pair->a].name) && page_html(page, " and ") &&
           page_text(page, class->submissions[pair->b].name) &&
           page_html(page, shown ? "</a>" : "");
}

static bool put_row(struct bytes *page, const struct class *class, const struct pair *pair,
                    size_t number) {
    return page_html(page, "<tr><td>") && put_names(page, class, pair, number) &&
           bytes_print(page, "</td><td class=number>%.0f&nbsp;%%</td><td class=number>%u</td><td>",
                       common_share(pair->all) * 100, pair->all.shared) &&
           (pair->most.shared == 0 ||
            (page_text(page, class->lessons.all[pair->most_lesson]) &&
             bytes_print(page, " %.0f&nbsp;%%", common_share(pair->most) * 100))) &&
           page_html(page, "</td></tr>\n");
}

static bool put_table(struct bytes *page, const struct class *class, const struct pairs *pairs) {
    bool done = page_html(page, "<table>\n<tr><th>Pair</th><th class=number>Share</th>"
                                "<th class=number>In both</th><th>Most alike in</th></tr>\n");
    for (size_t i = 0; i < pairs->count && done; i++) {
        done = put_row(page, class, &pairs->all[i], i);
    }
    return done && page_html(page, "</table>\n") &&
           (pairs->count <= PAIRS_SHOWN ||
            bytes_print(page, "<p>The lines of the first %d are below.</p>\n", PAIRS_SHOWN));
}

static bool put_notes(struct bytes *page, const struct bytes *notes) {
    if (notes->size == 0) {
        return true;
    }
    const unsigned char *line = notes->data, *end = line + notes->size;
    bool done = page_html(page, "<h2>Not compared</h2>\n<ul>\n");
    while (line < end && done) {
        const unsigned char *line_end = memchr(line, '\n', (size_t)(end - line));
        done = page_html(page, "<li>") && put_line_text(page, line, (size_t)(line_end - line)) &&
               page_html(page, "</li>\n");
        line = line_end + 1;
    }
    return done && page_html(page, "</ul>\n");
}

static bool put_pair(struct bytes *page, const struct class *class, const struct pair *pair,
                     size_t number) {
    bool done = bytes_print(page, "<h2 id=pair%zu>", number + 1) &&
                page_text(page, class->submissions[pair->a].name) && page_html(page, " and ") &&
                page_text(page, class->submissions[pair->b].name) &&
                page_html(page, "</h2>\n<p>") && put_common(page, class, pair, pair->all) &&
                page_html(page, ".</p>\n");
    for (size_t lesson = 0; lesson < class->lessons.count && done; lesson++) {
        done = put_lesson(page, class, pair, lesson);
    }
    return done;
}

bool listing_html(struct bytes *page, const struct class *class, const struct pairs *pairs,
                  struct limits limits) {
    bool done = put_head(page) && put_introduction(page, class, pairs, limits) &&
                put_table(page, class, pairs) && put_notes(page, &class->notes);
    for (size_t i = 0; i < pairs->count && i < PAIRS_SHOWN && done; i++) {
        done = put_pair(page, class, &pairs->all[i], i);
    }
    return done && page_html(page, "</body>\n</html>\n");
}
