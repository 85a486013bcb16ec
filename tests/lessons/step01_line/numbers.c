/* Lesson 1's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step01_line/main.c"
#endif
#include "numbers.h"

/* "(3,4) (2,4)": the pixels that line_list() gives. */
static struct shown called_listed(struct pixel a, struct pixel b, size_t count) {
    enum { ROOM = 16 };
    struct pixel list[ROOM] = {{0}};
    struct shown shown = {""};
    line_list(a, b, list);
    for (size_t i = 0; i < count; i++) {
        shown = show("%.180s%s(%d,%d)", shown.text, i > 0 ? " " : "", list[i].x, list[i].y);
    }
    return shown;
}

/* The pixels that line() sets. */
static struct shown called_drawn(struct pixel a, struct pixel b) {
    struct image image = black_image(12, 12);
    line(&image, a, b, rgb(255, 255, 255));
    return show_pixels(&image);
}

#define DRAWN(a, b, right)                                                                         \
    TEXT("1.2", "line(image, " #a ", " #b ", white)", called_drawn(a, b), right)
#define LISTED(a, b, count, right)                                                                 \
    TEXT("1.4", "line_list(" #a ", " #b ", list)", called_listed(a, b, count), right)

static void numbers(void) {
    DRAWN(at(0, 0), at(5, 2), "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    DRAWN(at(5, 2), at(0, 0), "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    DRAWN(at(0, 2), at(5, 0), "(4,0) (5,0) (2,1) (3,1) (0,2) (1,2)");
    DRAWN(at(7, 9), at(6, 6), "(6,6) (6,7) (7,8) (7,9)");
    DRAWN(at(5, 5), at(5, 5), "(5,5)");
    WHOLE("1.3", line_length(at(0, 0), at(5, 2)), 6);
    WHOLE("1.3", line_length(at(3, 4), at(-7, 9)), 11);
    WHOLE("1.3", line_length(at(5, 5), at(5, 5)), 1);
    WHOLE("1.3", line_length(at(9, 2), at(9, -20)), 23);
    LISTED(at(0, 0), at(5, 2), 6, "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    LISTED(at(5, 2), at(0, 0), 6, "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    LISTED(at(7, 9), at(6, 6), 4, "(6,6) (6,7) (7,8) (7,9)");
    LISTED(at(5, 5), at(5, 5), 1, "(5,5)");
    COLOR("1.5", color_along(at(10, 0), at(14, 0), rgb(0, 255, 0), rgb(0, 0, 255), at(11, 0)),
          rgb(0, 191, 64));
    COLOR("1.5", color_along(at(14, 0), at(10, 0), rgb(0, 0, 255), rgb(0, 255, 0), at(11, 0)),
          rgb(0, 191, 64));
    COLOR("1.5", color_along(at(3, 9), at(4, 6), rgb(90, 0, 0), rgb(0, 60, 30), at(4, 7)),
          rgb(30, 40, 20));
    COLOR("1.5", color_along(at(5, 5), at(5, 5), rgb(1, 2, 3), rgb(9, 9, 9), at(5, 5)),
          rgb(1, 2, 3));
}
