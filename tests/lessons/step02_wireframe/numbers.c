/* Lesson 2's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step02_wireframe/main.c"
#endif
#include "numbers.h"

enum { CALLED_ROOM = 8 }; /* sides, and one more behind them */

/* The square of the text. A corner's second and third number are others than the first. */
static const struct face called_square_faces[] = {{{{0, 1, 3}, {1, 2, 0}, {2, 3, 1}}},
                                                  {{{0, 1, 3}, {2, 3, 1}, {3, 0, 2}}}};
static const struct face called_single_face = {{{7, 0, 1}, {5, 2, 3}, {9, 4, 5}}};

static int called_order(const void *a, const void *b) {
    const struct side *p = a, *q = b;
    return p->low != q->low ? (p->low > q->low) - (p->low < q->low)
                            : (p->high > q->high) - (p->high < q->high);
}

/* "0-1 0-2", sorted: any order is right, also the larger number first, if it is so in all. */
static struct shown called_show_sides(struct side *sides, size_t count) {
    struct shown shown = {""};
    bool turned = true;
    for (size_t i = 0; i < count; i++) {
        turned = turned && sides[i].low > sides[i].high;
    }
    for (size_t i = 0; turned && i < count; i++) {
        sides[i] = (struct side){sides[i].high, sides[i].low};
    }
    qsort(sides, count, sizeof *sides, called_order);
    for (size_t i = 0; i < count; i++) {
        shown = show("%.150s%s%u-%u", shown.text, i > 0 ? " " : "", (unsigned)sides[i].low,
                     (unsigned)sides[i].high);
    }
    return shown;
}

static struct shown called_listed(const struct face *faces, size_t face_count) {
    struct vec3 positions[10] = {{0}};
    struct face copy[2];
    struct side sides[CALLED_ROOM] = {{0}};
    memcpy(copy, faces, face_count * sizeof *faces);
    const struct model model = {
        .positions = positions, .position_count = 10, .faces = copy, .face_count = face_count};
    list_sides(&model, sides);
    return called_show_sides(sides, 3 * face_count);
}

/* Behind the sides is the greatest once more, as in scenes.h. */
static struct shown called_kept(const struct side *sides, size_t count, struct side greatest) {
    struct side list[CALLED_ROOM] = {{0}};
    memcpy(list, sides, count * sizeof *sides);
    list[count] = greatest;
    size_t left = keep_one_of_each(list, count);
    return left <= count ? called_show_sides(list, left) : show("%zu sides", left);
}

static struct shown called_placed(struct vec3 position, size_t width, size_t height) {
    struct pixel pixel = {7, 7};
    bool near = to_pixel(position, width, height, &pixel);
    if (!near && pixel.x == 7 && pixel.y == 7) {
        return show("false");
    }
    return show("%s(%d,%d)", near ? "" : "false, but ", pixel.x, pixel.y);
}

static struct shown called_drawn(struct pixel a, struct pixel b) {
    struct image image = black_image(12, 12);
    line(&image, a, b, rgb(255, 255, 255));
    return show_pixels(&image);
}

/* In an image of 60 x 24. */
static uint64_t called_walked(struct pixel a, struct pixel b) {
    struct image image = black_image(60, 24);
    uint64_t count = line(&image, a, b, rgb(255, 255, 255));
    image_free(&image);
    return count;
}

#define PLACED(p, width, height, right)                                                            \
    TEXT("2a.2", "to_pixel(" #p ", " #width ", " #height ", &pixel)",                              \
         called_placed(p, width, height), right)
#define DRAWN(a, b, right)                                                                         \
    TEXT("2a.3", "line(image, " #a ", " #b ", white)", called_drawn(a, b), right)
#define WALKED(a, b, right)                                                                        \
    AS_WHOLE("2b.2", "line(image, " #a ", " #b ", white)", called_walked(a, b), right)

static void numbers(void) {
    const struct side square_sides[] = {{0, 1}, {1, 2}, {0, 2}, {0, 2}, {2, 3}, {0, 3}};
    const struct side same_sides[] = {{4, 6}, {4, 6}, {4, 6}};
    TEXT("2a.1", "list_sides(square, sides)", called_listed(called_square_faces, 2),
         "0-1 0-2 0-2 0-3 1-2 2-3");
    TEXT("2a.1", "list_sides(face 7 5 9, sides)", called_listed(&called_single_face, 1),
         "5-7 5-9 7-9");
    PLACED(xyz(-0.5, -0.5, 0), 100, 100, "(25,25)");
    PLACED(xyz(0.5, -0.25, 0.7), 100, 64, "(75,24)");
    PLACED(xyz(-1.01, -1.03, 0), 100, 100, "(-1,-2)");
    PLACED(xyz(0, -1e30, 0), 100, 100, "false");
    DRAWN(at(0, 0), at(5, 2), "(0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    DRAWN(at(7, 9), at(6, 6), "(6,6) (6,7) (7,8) (7,9)");
    TEXT("2a.4", "keep_one_of_each(sides of the square, 6)",
         called_kept(square_sides, 6, (struct side){2, 3}), "0-1 0-2 0-3 1-2 2-3");
    TEXT("2a.4", "keep_one_of_each(4-6 4-6 4-6, 3)",
         called_kept(same_sides, 3, (struct side){4, 6}), "4-6");
    WALKED(at(-17, -9), at(89, 31), 54);
    WALKED(at(89, 31), at(-17, -9), 54);
    WALKED(at(-9, -5), at(-1, 30), 0);
}
