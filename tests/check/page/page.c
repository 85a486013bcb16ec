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

static const char *const controls[] = {"<div id=top class=tools>\n<span>\n",
                                       "<button id=side>side by side</button>\n",
                                       "<button id=slide>slider</button>\n",
                                       "<button id=yours>yours</button>\n",
                                       "<button id=reference>reference</button>\n",
                                       "<button id=difference>difference</button>\n",
                                       "<button id=errors>errors</button>\n",
                                       "</span>\n<span>\n",
                                       "<button id=smaller aria-label=smaller>&minus;</button>\n",
                                       "<output id=zoom>fit</output>\n",
                                       "<button id=larger aria-label=larger>+</button>\n",
                                       "</span>\n<span>\n",
                                       "<button id=marks>marks</button>\n",
                                       "<button id=wrong>next wrong pixel</button>\n",
                                       "</span>\n</div>\n",
                                       NULL};

static const char *const legend[] = {
    "<details><summary>Keys and colours</summary>\n",
    "<p><kbd>s</kbd> side by side, <kbd>l</kbd> a slider between yours and the reference, ",
    "<kbd>y</kbd> yours, <kbd>r</kbd> reference, <kbd>d</kbd> difference, <kbd>e</kbd> errors, ",
    "<kbd>space</kbd> yours and reference in turn.</p>\n",
    "<p><kbd>+</kbd> <kbd>-</kbd> larger and smaller: at 32x the pixels' numbers are in them. ",
    "<kbd>w</kbd> the next wrong pixel, <kbd>m</kbd> wrong pixels marked or not, <kbd>n</kbd> ",
    "<kbd>p</kbd> next and previous scene. In a picture, the arrows go from pixel to pixel ",
    "(with <kbd>shift</kbd>, ten of them).</p>\n",
    "<p>In the difference, red: this pixel of yours should not be there, or has another colour; ",
    "blue: missing; dark green: differs, but does not count.</p>\n",
    "</details>\n",
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
           page_html(page, "</title>\n<style>\n") && put_all(page, page_css) &&
           page_html(page, "</style>\n</head>\n<body class=side>\n<h1>") &&
           page_text(page, title) && page_html(page, "</h1>\n") && put_all(page, controls) &&
           page_html(page, "<main>\n") && put_all(page, legend);
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
                 page_html(page, "</figcaption><div class=view><img alt=\"") &&
                 page_text(page, scene) && page_html(page, ", ") && page_text(page, name) &&
                 page_html(page, "\" src=\"");
    if (!begun) {
        return error_out_of_memory(error);
    }
    return put_image(page, image, error) &&
           (page_html(page, "\"></div></figure>\n") || error_out_of_memory(error));
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
    return page_html(page, "</main>\n<div id=values aria-live=polite>"
                           "Point at a pixel, tap it, or go to it with the arrows: its values "
                           "stand here.</div>\n<script>\n") &&
           put_all(page, page_js) && page_html(page, "</script>\n</body>\n</html>\n");
}
