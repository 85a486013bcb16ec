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
    bool done = true;
    for (size_t i = 0; lines[i] != NULL && done; i++) {
        done = bytes_append(page, lines[i], strlen(lines[i]));
    }
    return done;
}

bool page_begin(struct bytes *page, const char *title) {
    return markup_print(page, "<!DOCTYPE html>\n<html lang=en>\n<head>\n") && put_all(page, head) &&
           markup_print(page, "<title>%s</title>\n<style>\n", title) && put_all(page, page_live) &&
           put_all(page, page_css) &&
           markup_print(page, "</style>\n</head>\n<body>\n<h1>%s</h1>\n<main>\n", title);
}

/* A picture and its name, in the page itself. `error` says out of memory already. */
static bool put_figure(struct bytes *page, const char *scene, const char *name,
                       const struct image *image, struct error *error) {
    struct bytes png = {.data = NULL};
    bool done = png_encode(image, &png, error) &&
                markup_print(page,
                             "<figure data-name=\"%s\"><figcaption>%s</figcaption>"
                             "<img alt=\"%s, %s\" src=\"data:image/png;base64,",
                             name, name, scene, name) &&
                base64_encode(page, png.data, png.size) && markup_print(page, "\"></figure>\n");
    bytes_free(&png);
    return done;
}

bool page_scene(struct bytes *page, const struct page_scene *scene, struct error *error) {
    const unsigned level = (unsigned)scene->level;
    error_out_of_memory(error); /* unless something else goes wrong */
    bool done = markup_print(page, "<section>\n<h%u>%s</h%u>\n<p>%s</p>\n", level, scene->name,
                             level, scene->note) &&
                (scene->looks == NULL ||
                 markup_print(page, "<aside class=looks><p>%s</p>\n</aside>\n", scene->looks)) &&
                markup_print(page, "<div class=pictures>\n");
    for (int i = 0; i < PICTURE_COUNT && done; i++) {
        const struct image *image = &scene->pictures->image[i];
        done = image->width == 0 || put_figure(page, scene->name, picture_names[i], image, error);
    }
    return done && markup_print(page, "</div>\n</section>\n");
}

bool page_end(struct bytes *page) {
    return markup_print(page, "</main>\n<dialog id=viewer aria-label=Pictures>\n"
                              "<form method=dialog><button id=close>close</button></form>\n") &&
           put_all(page, page_viewer) && markup_print(page, "</dialog>\n<script>\n") &&
           put_all(page, page_still) && put_all(page, page_js) &&
           markup_print(page, "</script>\n</body>\n</html>\n");
}
