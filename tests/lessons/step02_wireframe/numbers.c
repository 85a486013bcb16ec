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

/* Behind the sides is the greatest once more: code that reads there takes it for an equal one. */
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

/* "6: (0,0) (1,0)": what it returns, and the pixels that it sets. */
static struct shown called_drawn(struct pixel a, struct pixel b, size_t width, size_t height) {
    struct image image = black_image(width, height);
    unsigned long long count = line(&image, a, b, rgb(255, 255, 255));
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

static struct shown called_found(struct pixel a, struct pixel b, size_t width, size_t height) {
    struct steps steps = steps_inside(a, b, width, height);
    return steps.first > steps.last
               ? show("none")
               : show("%lld to %lld", (long long)steps.first, (long long)steps.last);
}

static struct shown called_part(struct pixel a, struct pixel b, int first, int last) {
    struct image image = black_image(12, 12);
    draw_steps(&image, a, b, (struct steps){first, last}, rgb(255, 255, 255));
    return show_pixels(&image);
}

#define PLACED(p, width, height, right)                                                            \
    TEXT("2a.2", "to_pixel(" #p ", " #width ", " #height ", &pixel)",                              \
         called_placed(p, width, height), right)
#define DRAWN(a, b, right)                                                                         \
    TEXT("2a.3", "line(image, " #a ", " #b ", white)", called_drawn(a, b, 12, 12), right)
#define FOUND(a, b, width, height, right)                                                          \
    TEXT("2b.1", "steps_inside(" #a ", " #b ", " #width ", " #height ")",                          \
         called_found(a, b, width, height), right)
#define PART(a, b, first, last, right)                                                             \
    TEXT("2b.2", "draw_steps(image, " #a ", " #b ", " #first " to " #last ", white)",              \
         called_part(a, b, first, last), right)

static void numbers(void) {
    const struct side square_sides[] = {{0, 1}, {1, 2}, {0, 2}, {0, 2}, {2, 3}, {0, 3}};
    const struct side same_sides[] = {{4, 6}, {4, 6}, {4, 6}};
    const struct side apart_sides[] = {{2, 3}, {1, 4}, {2, 3}, {1, 5}, {1, 4}};
    const struct side large_sides[] = {{1, 1003}, {1, 10003}, {1, 65539}, {2, 3}};
    TEXT("2a.1", "list_sides(square, sides)", called_listed(called_square_faces, 2),
         "0-1 0-2 0-2 0-3 1-2 2-3");
    TEXT("2a.1", "list_sides(face 7 5 9, sides)", called_listed(&called_single_face, 1),
         "5-7 5-9 7-9");
    PLACED(xyz(-0.5, -0.5, 0), 100, 100, "(25,25)");
    PLACED(xyz(0.5, -0.25, 0.7), 100, 64, "(75,24)");
    PLACED(xyz(-1.01, -1.03, 0), 100, 100, "(-1,-2)");
    PLACED(xyz(0.115, -0.2, 0), 25, 13, "(13,5)");
    PLACED(xyz(0, -1e30, 0), 100, 100, "false");
    PLACED(xyz(4194303.004, 0, 0), 256, 128, "(536870912,64)"); /* LINE_LIMIT */
    DRAWN(at(0, 0), at(5, 2), "6: (0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    DRAWN(at(5, 2), at(0, 4), "6: (4,2) (5,2) (2,3) (3,3) (0,4) (1,4)");
    DRAWN(at(7, 9), at(6, 6), "4: (6,6) (6,7) (7,8) (7,9)");
    DRAWN(at(2, 1), at(0, 0), "3: (0,0) (1,0) (2,1)");
    DRAWN(at(5, 5), at(5, 5), "1: (5,5)");
    TEXT("2a.3", "line(image of 4 x 9, (0, 1), (3, 8), white)",
         called_drawn(at(0, 1), at(3, 8), 4, 9),
         "8: (0,1) (0,2) (1,3) (1,4) (2,5) (2,6) (3,7) (3,8)");
    TEXT("2a.4", "keep_one_of_each(sides of the square, 6)",
         called_kept(square_sides, 6, (struct side){2, 3}), "0-1 0-2 0-3 1-2 2-3");
    TEXT("2a.4", "keep_one_of_each(4-6 4-6 4-6, 3)",
         called_kept(same_sides, 3, (struct side){4, 6}), "4-6");
    TEXT("2a.4", "keep_one_of_each(2-3 1-4 2-3 1-5 1-4, 5)",
         called_kept(apart_sides, 5, (struct side){2, 3}), "1-4 1-5 2-3");
    TEXT("2a.4", "keep_one_of_each(1-1003 1-10003 1-65539 2-3, 4)",
         called_kept(large_sides, 4, (struct side){2, 3}), "1-1003 1-10003 1-65539 2-3");
    FOUND(at(-17, -9), at(89, 31), 60, 24, "23 to 76");
    FOUND(at(89, 31), at(-17, -9), 60, 24, "23 to 76");
    FOUND(at(-17, 32), at(89, -8), 60, 24, "23 to 76"); /* it falls */
    FOUND(at(-9, -17), at(31, 89), 24, 60, "23 to 76"); /* it is steep */
    FOUND(at(32, -17), at(-8, 89), 24, 60, "23 to 76");
    FOUND(at(3, 4), at(20, 9), 60, 24, "0 to 17");
    FOUND(at(-5, 0), at(65, 0), 60, 24, "5 to 64");
    FOUND(at(5, 5), at(5, 5), 60, 24, "0 to 0");
    FOUND(at(-9, -5), at(-1, 30), 60, 24, "none");
    FOUND(at(-1, 6), at(0, 0), 24, 60, "0 to 3");
    FOUND(at(24, 4), at(23, 7), 24, 60, "2 to 3");
    FOUND(at(-536870912, -536870912), at(536870912, 536870912), 60, 24, "536870912 to 536870935");
    FOUND(at(-536870912, -268435456), at(536870912, 268435455), 60, 24, "536870913 to 536870960");
    PART(at(-17, -9), at(89, 31), 23, 26, "(6,0) (7,0) (8,0) (9,1)");
    PART(at(0, 0), at(12, 7), 5, 8, "(5,3) (6,3) (7,4) (8,5)");
    PART(at(3, 1), at(0, 0), 2, 3, "(2,1) (3,1)");
    PART(at(0, 9), at(4, 7), 3, 4, "(4,7) (3,8)"); /* it falls */
    PART(at(7, 0), at(9, 4), 3, 4, "(8,3) (9,4)"); /* it is steep */
    PART(at(5, 5), at(5, 5), 0, 0, "(5,5)");
    PART(at(-536870912, -268435456), at(536870912, 268435455), 536870913, 536870915,
         "(1,0) (2,0) (3,1)");
}
