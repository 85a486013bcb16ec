/*
 * A page of HTML that shows scenes: of each, yours, the reference and their difference.
 *
 *     struct bytes page = {.data = NULL};
 *     page_begin(&page, "step05_zbuffer");
 *     page_scene(&page, "depth", "0.7 % differ", &pictures, &error);
 *     page_end(&page);
 *
 * The page is one file that works offline: pictures are in it as PNG. It follows the light or dark
 * look of the system, shows pixels without smoothing and their values under the pointer, and all of
 * it works by keyboard. Without scripts the pictures stand side by side.
 */
#ifndef TESTS_HELP_PAGE_H
#define TESTS_HELP_PAGE_H

#include "file.h"
#include "pictures.h"

#include <stdbool.h>

/* Each appends to the page and returns false when memory runs out. Texts are escaped. */

/* Everything up to the first scene. */
bool page_begin(struct bytes *page, const char *title);

/* A scene: its name, a line about it (may be empty), and those of its pictures that are there. An
 * error may come from encoding a picture, too. */
bool page_scene(struct bytes *page, const char *name, const char *note,
                const struct pictures *pictures, struct error *error);

/* Text as HTML shows it; what a terminal would obey is made '?'. For what else a caller writes. */
bool page_text(struct bytes *page, const char *text);

/* HTML that is written as it is. */
bool page_html(struct bytes *page, const char *html);

bool page_end(struct bytes *page);

#endif
