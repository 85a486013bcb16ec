/*
 * A page of HTML that shows scenes: of each, yours, the reference and their difference.
 *
 *     struct bytes page = {.data = NULL};
 *     page_begin(&page, "step05_zbuffer");
 *     page_scene(&page, &scene, &error);
 *     page_end(&page);
 *
 * The page is one file that works offline: pictures are in it as PNG, side by side. A click on one
 * opens the page of `make live` over them (still.js), which shows single pixels and their values.
 * What else a caller writes it escapes by markup_print().
 */
#ifndef TESTS_CHECK_PAGE_PAGE_H
#define TESTS_CHECK_PAGE_PAGE_H

#include "base/bytes.h"
#include "base/error.h"
#include "pictures.h"

#include <stdbool.h>

/* Its style and its script: page.css and still.js, line by line; then NULL. And those of the page
 * of `make live`, with what is in its body. Written by make. */
extern const char *const page_css[], *const page_still[];
extern const char *const page_live[], *const page_js[], *const page_viewer[];

/* What is shown of a scene. */
struct page_scene {
    const char *name, *note; /* the note may be "" */
    int level;               /* of its heading: 2, or 3 below a heading of level 2 */
    const struct pictures *pictures;
    const char *looks; /* what it looks like, or NULL */
};

/* Each appends to the page and returns false when memory runs out. Texts are escaped. */

/* Everything up to the first scene. */
bool page_begin(struct bytes *page, const char *title);

/* A scene, with those of its pictures that are there. False, with a message, also when a picture
 * cannot be encoded. */
bool page_scene(struct bytes *page, const struct page_scene *scene, struct error *error);

bool page_end(struct bytes *page);

#endif
