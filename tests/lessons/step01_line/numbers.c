/* Lesson 1's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step01_line/main.c"
#endif
#include "numbers.h"

/* "(52,41) is 255,0,0": the pixels of an image of that size that are not black. */
static struct shown called_first(size_t width, size_t height) {
    struct image image = black_image(width, height);
    first_pixel(&image);
    struct color color = image_get(&image, 52, 41);
    struct shown pixels = show_pixels(&image);
    return show("%.150s%s%s", pixels.text, color.r + color.g + color.b > 0 ? " is " : "",
                color.r + color.g + color.b > 0 ? show_color(color).text : "");
}

/* The pixels that line() sets in a small image. */
static struct shown called_drawn(struct pixel a, struct pixel b, size_t width, size_t height) {
    struct image image = black_image(width, height);
    line(&image, a, b, rgb(255, 255, 255));
    return show_pixels(&image);
}

static struct shown called_color(struct pixel a, struct pixel b, struct color color) {
    struct image image = black_image(12, 12);
    line(&image, a, b, color);
    color = image_get(&image, a.x, a.y);
    image_free(&image);
    return show_color(color);
}

enum { CALLED_ROOM = 100 };

/* "(3,4) (2,4)". */
static struct shown called_show_list(const struct pixel *list, size_t count) {
    struct shown shown = {""};
    for (size_t i = 0; i < count; i++) {
        shown = show("%.180s%s(%d,%d)", shown.text, i > 0 ? " " : "", list[i].x, list[i].y);
    }
    return shown;
}

/* The pixels that line_list() gives. */
static struct shown called_listed(struct pixel a, struct pixel b, size_t count) {
    struct pixel list[CALLED_ROOM] = {{0}};
    line_list(a, b, list);
    return called_show_list(list, count);
}

/* A list of the pixels that line() sets, right or wrong. It draws in the middle of an image, so
 * that pixels beyond the ends are seen, too. */
static struct shown called_as_drawn(struct pixel a, struct pixel b, size_t count) {
    enum { SIDE = 48, MIDDLE = 16 };
    struct image image = black_image(SIDE, SIDE);
    struct pixel list[CALLED_ROOM] = {{0}};
    bool steep = abs(b.y - a.y) > abs(b.x - a.x);
    size_t found = 0;
    line(&image, at(a.x + MIDDLE, a.y + MIDDLE), at(b.x + MIDDLE, b.y + MIDDLE),
         rgb(255, 255, 255));
    for (int i = 0; i < SIDE * SIDE && found < count; i++) {
        struct pixel p = steep ? at(i % SIDE, i / SIDE) : at(i / SIDE, i % SIDE);
        if (image_get(&image, p.x, p.y).r > 0) {
            list[found++] = at(p.x - MIDDLE, p.y - MIDDLE);
        }
    }
    image_free(&image);
    return called_show_list(list, count);
}

/* How many pixels line_list() writes, and how many line() sets. */
static struct shown called_written(struct pixel a, struct pixel b) {
    struct pixel list[CALLED_ROOM];
    size_t count = 0;
    for (size_t i = 0; i < CALLED_ROOM; i++) {
        list[i] = at(-1, -1);
    }
    line_list(a, b, list);
    for (size_t i = 0; i < CALLED_ROOM; i++) {
        count += list[i].x != -1 || list[i].y != -1;
    }
    return show("%zu", count);
}

static struct shown called_set(struct pixel a, struct pixel b) {
    struct image image = black_image(CALLED_ROOM, CALLED_ROOM);
    size_t count = 0;
    line(&image, a, b, rgb(255, 255, 255));
    for (int i = 0; i < CALLED_ROOM * CALLED_ROOM; i++) {
        count += image_get(&image, i % CALLED_ROOM, i / CALLED_ROOM).r > 0;
    }
    image_free(&image);
    return show("%zu", count);
}

/* A pixel of the list of a long line, and the one that line() sets there. */
static struct shown called_one_listed(struct pixel a, struct pixel b, size_t index) {
    struct pixel list[CALLED_ROOM] = {{0}};
    line_list(a, b, list);
    return show("(%d,%d)", list[index].x, list[index].y);
}

static struct shown called_one_drawn(struct pixel a, struct pixel b, int index) {
    struct image image = black_image(CALLED_ROOM, CALLED_ROOM);
    int x = a.x + index, y = 0;
    line(&image, a, b, rgb(255, 255, 255));
    while (y < CALLED_ROOM && image_get(&image, x, y).r == 0) {
        y++;
    }
    image_free(&image);
    return y < CALLED_ROOM ? show("(%d,%d)", x, y) : show("(0,0)"); /* as in an empty list */
}

#define DRAWN(a, b, right)                                                                         \
    TEXT("1.2", "line(image, " #a ", " #b ", white)", called_drawn(a, b, 12, 12), right)
#define LISTED(a, b, count, right)                                                                 \
    TEXT_WITH("1.4", "line_list(" #a ", " #b ", list)", called_listed(a, b, count), right,         \
              called_as_drawn(a, b, count))

static void numbers(void) {
    TEXT("1.1", "first_pixel(image)", called_first(100, 100), "(52,41) is 255,0,0");
    DRAWN(at(0, 0), at(5, 2), "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    DRAWN(at(5, 2), at(0, 0), "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    DRAWN(at(0, 2), at(5, 0), "(4,0) (5,0) (2,1) (3,1) (0,2) (1,2)");
    DRAWN(at(7, 9), at(6, 6), "(6,6) (6,7) (7,8) (7,9)");
    DRAWN(at(4, 4), at(4, 1), "(4,1) (4,2) (4,3) (4,4)");
    DRAWN(at(5, 5), at(5, 5), "(5,5)");
    DRAWN(at(0, -1), at(4, 0), "(3,0) (4,0)");
    TEXT("1.2", "line(image of 4 x 9, (0, 1), (3, 8), white)",
         called_drawn(at(0, 1), at(3, 8), 4, 9), "(0,1) (0,2) (1,3) (1,4) (2,5) (2,6) (3,7) (3,8)");
    TEXT("1.2", "line(image, (2, 3), (4, 3), (255, 128, 0))",
         called_color(at(2, 3), at(4, 3), rgb(255, 128, 0)), "255,128,0");
    DRAWN(at(0, 0), at(2, 1), "(0,0) (1,0) (2,1)"); /* ties */
    DRAWN(at(2, 1), at(0, 0), "(0,0) (1,0) (2,1)");
    DRAWN(at(0, 0), at(12, 7),
          "(0,0) (1,1) (2,1) (3,2) (4,2) (5,3) (6,3) (7,4) (8,5) (9,5) (10,6) (11,6)");
    DRAWN(at(-16, -9), at(28, 16),
          "(0,0) (1,1) (2,1) (3,2) (4,2) (5,3) (6,3) (7,4) (8,5) (9,5) (10,6) (11,6)");
    DRAWN(at(-1000000, -307697), at(999999, 307708),
          "(0,6) (1,6) (2,6) (3,7) (4,7) (5,7) (6,8) (7,8) (8,8) (9,8) (10,9) (11,9)");
    DRAWN(at(-1000000, -230757), at(999999, 230761),
          "(0,2) (1,2) (2,3) (3,3) (4,3) (5,3) (6,3) (7,4) (8,4) (9,4) (10,4) (11,5)");
    WHOLE("1.3", line_length(at(0, 0), at(5, 2)), 6);
    WHOLE("1.3", line_length(at(3, 4), at(-7, 9)), 11);
    WHOLE("1.3", line_length(at(5, 5), at(5, 5)), 1);
    WHOLE("1.3", line_length(at(9, 2), at(9, -20)), 23);
    LISTED(at(0, 0), at(5, 2), 6, "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    LISTED(at(5, 2), at(0, 0), 6, "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    LISTED(at(7, 9), at(6, 6), 4, "(6,6) (6,7) (7,8) (7,9)");
    LISTED(at(5, 5), at(5, 5), 1, "(5,5)");
    LISTED(at(4, 4), at(4, 1), 4, "(4,1) (4,2) (4,3) (4,4)");
    LISTED(at(4, 2), at(1, 2), 4, "(1,2) (2,2) (3,2) (4,2)");
    LISTED(at(1, 4), at(4, 1), 4, "(1,4) (2,3) (3,2) (4,1)");
    TEXT_WITH("1.4", "line_list((0, 0), (5, 2), list): pixels written",
              called_written(at(0, 0), at(5, 2)), "6", called_set(at(0, 0), at(5, 2)));
    TEXT_WITH("1.4", "line_list((3, 96), (93, 99), list)[45]",
              called_one_listed(at(3, 96), at(93, 99), 45), "(48,97)",
              called_one_drawn(at(3, 96), at(93, 99), 45));
    COLOR("1.5", color_along(at(10, 0), at(14, 0), rgb(0, 255, 0), rgb(0, 0, 255), at(11, 0)),
          rgb(0, 191, 64));
    COLOR("1.5", color_along(at(10, 0), at(14, 0), rgb(0, 255, 0), rgb(0, 0, 255), at(12, 0)),
          rgb(0, 128, 128));
    COLOR("1.5", color_along(at(10, 0), at(12, 0), rgb(0, 255, 0), rgb(0, 0, 255), at(11, 0)),
          rgb(0, 128, 128));
    COLOR("1.5", color_along(at(14, 0), at(10, 0), rgb(0, 0, 255), rgb(0, 255, 0), at(11, 0)),
          rgb(0, 191, 64));
    COLOR("1.5", color_along(at(3, 9), at(4, 6), rgb(90, 0, 0), rgb(0, 60, 30), at(4, 7)),
          rgb(30, 40, 20));
    COLOR("1.5", color_along(at(0, 0), at(4, 3), rgb(0, 80, 0), rgb(200, 0, 0), at(1, 1)),
          rgb(50, 60, 0));
    COLOR("1.5", color_along(at(5, 5), at(5, 5), rgb(1, 2, 3), rgb(9, 9, 9), at(5, 5)),
          rgb(1, 2, 3));
}
