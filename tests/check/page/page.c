/* A page of HTML that shows scenes: see page.h. */
#include "page.h"

#include "base64.h"
#include "escape.h"
#include "files/png.h"

#include <string.h>

/* Nothing is loaded from anywhere. */
static const char *const head[] = {
    "<meta charset=utf-8>\n",
    "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n",
    "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; img-src data:; ",
    "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n",
    "<link rel=icon href=\"data:,\">\n",
    NULL};

static bool put_all(struct bytes *page, const char *const *lines) {
    for (size_t i = 0; lines[i] != NULL; i++) {
        if (!page_html(page, lines[i])) {
            return false;
        }
    }
    return true;
}

bool page_html(struct bytes *page, const char *html) {
    return bytes_append(page, html, strlen(html));
}

bool page_text(struct bytes *page, const char *text) {
    return escape_markup(page, text);
}

bool page_begin(struct bytes *page, const char *title) {
    return page_html(page, "<!DOCTYPE html>\n<html lang=en>\n<head>\n") && put_all(page, head) &&
           page_html(page, "<title>") && page_text(page, title) &&
           page_html(page, "</title>\n<style>\n") && put_all(page, page_live) &&
           put_all(page, page_css) && page_html(page, "</style>\n</head>\n<body>\n<h1>") &&
           page_text(page, title) && page_html(page, "</h1>\n<main>\n");
}

/* The picture as the address of an <img>. */
static bool put_image(struct bytes *page, const struct image *image, struct error *error) {
    struct bytes png = {.data = NULL};
    bool encoded = png_encode(image, &png, error);
    bool done = encoded && page_html(page, "data:image/png;base64,") &&
                base64_encode(page, png.data, png.size);
    bytes_free(&png);
    return done || (encoded && error_out_of_memory(error));
}

static bool put_figure(struct bytes *page, const char *scene, const char *name,
                       const struct image *image, struct error *error) {
    bool begun = page_html(page, "<figure data-name=\"") && page_text(page, name) &&
                 page_html(page, "\"><figcaption>") && page_text(page, name) &&
                 page_html(page, "</figcaption><img alt=\"") && page_text(page, scene) &&
                 page_html(page, ", ") && page_text(page, name) && page_html(page, "\" src=\"");
    if (!begun) {
        return error_out_of_memory(error);
    }
    return put_image(page, image, error) &&
           (page_html(page, "\"></figure>\n") || error_out_of_memory(error));
}

/* What it looks like, and the two small pictures by which that is seen. */
static bool put_looks(struct bytes *page, const struct page_scene *scene, struct error *error) {
    if (scene->looks == NULL) {
        return true;
    }
    bool done = (page_html(page, "<aside class=looks><p>") && page_text(page, scene->looks) &&
                 page_html(page, "</p>\n")) ||
                error_out_of_memory(error);
    if (done && scene->mistake->width > 0) {
        done = put_figure(page, scene->name, "the mistake", scene->mistake, error) &&
               put_figure(page, scene->name, "yours, as small", scene->small, error);
    }
    return done && (page_html(page, "</aside>\n") || error_out_of_memory(error));
}

bool page_scene(struct bytes *page, const struct page_scene *scene, struct error *error) {
    const char *const tag = scene->level > 2 ? "h3>" : "h2>";
    bool done =
        (page_html(page, "<section>\n<") && page_html(page, tag) && page_text(page, scene->name) &&
         page_html(page, "</") && page_html(page, tag) && page_html(page, "\n<p>") &&
         page_text(page, scene->note) && page_html(page, "</p>\n")) ||
        error_out_of_memory(error);
    done = done && put_looks(page, scene, error) &&
           (page_html(page, "<div class=pictures>\n") || error_out_of_memory(error));
    for (int i = 0; i < PICTURE_COUNT && done; i++) {
        const struct image *image = &scene->pictures->image[i];
        done = image->width == 0 || put_figure(page, scene->name, picture_names[i], image, error);
    }
    return done && (page_html(page, "</div>\n</section>\n") || error_out_of_memory(error));
}

bool page_end(struct bytes *page) {
    return page_html(page, "</main>\n<dialog id=viewer aria-label=Pictures>\n") &&
           page_html(page, "<form method=dialog><button id=close>close</button></form>\n") &&
           put_all(page, page_viewer) && page_html(page, "</dialog>\n<script>\n") &&
           put_all(page, page_still) && put_all(page, page_js) &&
           page_html(page, "</script>\n</body>\n</html>\n");
}
