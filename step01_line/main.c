/*
 * Step 1: one pixel, a line, and a line whose colour changes on its way.
 *
 * A line between two pixels is walked along the axis on which it is longer, called u here; the
 * other axis is v. Every u between the two ends gets exactly one pixel: the one nearest to the
 * ideal line. Where two are equally near, the one nearer to where the walk starts (the left end, or
 * the lower end of a steep line) is taken. So the pixels do not depend on the order of the end
 * points. All arithmetic is on integers: nothing is rounded and nothing drifts.
 *
 * Scenes: `pixel`, `line`, `gradient`, or the lines of a text scene.
 */
#include "program.h"

#include <stdlib.h>

/* ---- Walking a line ---- */

/* A place on the way along a line. */
struct walk {
    int64_t u, u_last; /* now, and at the end (inclusive) */
    int64_t v;
    int v_step;        /* +1 or -1 */
    int64_t run, rise; /* length along u and along v, neither negative */
    int64_t error;     /* (how far the ideal line lies beyond v, minus 1/2) times 2 * run */
    bool steep;        /* u is y and v is x */
};

/* Start at the left end, or at the lower end of a steep line. Coordinates lie within LINE_LIMIT. */
static struct walk walk_begin(struct pixel a, struct pixel b) {
    int64_t x_distance = (int64_t)b.x - a.x, y_distance = (int64_t)b.y - a.y;
    bool steep = llabs(y_distance) > llabs(x_distance);
    if (steep ? y_distance < 0 : x_distance < 0) {
        struct pixel kept = a;
        a = b;
        b = kept;
    }
    int64_t u_start = steep ? a.y : a.x, u_end = steep ? b.y : b.x;
    int64_t v_start = steep ? a.x : a.y, v_end = steep ? b.x : b.y;
    return (struct walk){
        .u = u_start,
        .u_last = u_end,
        .v = v_start,
        .v_step = v_end < v_start ? -1 : 1,
        .run = u_end - u_start,
        .rise = llabs(v_end - v_start),
        .error = -(u_end - u_start),
        .steep = steep,
    };
}

/* One step along u. The ideal line moves on by rise / run; when it has come more than half a pixel
 * beyond v, the next v is nearer. Multiplied by 2 * run, all of this is whole numbers. (Bresenham,
 * "Algorithm for computer control of a digital plotter", 1965.) */
static void walk_next(struct walk *walk) {
    walk->u++;
    walk->error += 2 * walk->rise;
    if (walk->error > 0) {
        walk->v += walk->v_step;
        walk->error -= 2 * walk->run;
    }
}

static struct pixel walk_pixel(const struct walk *walk) {
    return walk->steep ? (struct pixel){(int)walk->v, (int)walk->u}
                       : (struct pixel){(int)walk->u, (int)walk->v};
}

/* ---- Lines ---- */

/* Draw a line in one colour. What lies outside the image is refused by image_set(). */
static void line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    for (struct walk walk = walk_begin(a, b); walk.u <= walk.u_last; walk_next(&walk)) {
        struct pixel p = walk_pixel(&walk);
        image_set(image, p.x, p.y, color);
    }
}

/* The number of pixels of a line. */
static size_t line_length(struct pixel a, struct pixel b) {
    struct walk walk = walk_begin(a, b);
    return (size_t)walk.run + 1;
}

/* The discrete line as a list of its pixels, from the left (lower) end on. The caller gives room
 * for line_length() of them. */
static void line_list(struct pixel a, struct pixel b, struct pixel list[]) {
    size_t count = 0;
    for (struct walk walk = walk_begin(a, b); walk.u <= walk.u_last; walk_next(&walk)) {
        list[count++] = walk_pixel(&walk);
    }
}

/* ---- Colours along a line ---- */

/* The nearest level to from + (to - from) * k / n, halves up, in integers; n > 0, 0 <= k <= n. */
static uint8_t mix_level(uint8_t from, uint8_t to, int64_t k, int64_t n) {
    return (uint8_t)((2 * (from * (n - k) + to * k) + n) / (2 * n));
}

/* The colour of pixel p of the line from a (colour color_a) to b (colour color_b). The share of
 * color_b is alpha = |u - u_a| / |u_b - u_a|, kept as a fraction k / n; at a point it is 0. */
static struct color color_along(struct pixel a, struct pixel b, struct color color_a,
                                struct color color_b, struct pixel p) {
    int64_t x_length = llabs((int64_t)b.x - a.x), y_length = llabs((int64_t)b.y - a.y);
    bool steep = y_length > x_length;
    int64_t k = steep ? llabs((int64_t)p.y - a.y) : llabs((int64_t)p.x - a.x);
    int64_t n = steep ? y_length : x_length;
    if (n == 0) {
        return color_a;
    }
    return color_rgb(mix_level(color_a.r, color_b.r, k, n), mix_level(color_a.g, color_b.g, k, n),
                     mix_level(color_a.b, color_b.b, k, n));
}

/* Draw a line whose colour runs from color_a at a to color_b at b. */
static bool line_gradient(struct image *image, struct pixel a, struct pixel b, struct color color_a,
                          struct color color_b, struct error *error) {
    size_t length = line_length(a, b);
    struct pixel *list = calloc(length, sizeof *list);
    if (list == NULL) {
        return error_set(error, "not enough memory for a line of %zu pixels", length);
    }
    line_list(a, b, list);
    for (size_t i = 0; i < length; i++) {
        image_set(image, list[i].x, list[i].y, color_along(a, b, color_a, color_b, list[i]));
    }
    free(list);
    return true;
}

/* ---- Scenes ---- */

static bool draw_pixel(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    count(drawing, "pixels_written", image_set(image, 52, 41, color_rgb(255, 0, 0)));
    return true;
}

static bool draw_line(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct pixel a = {13, 20}, b = {80, 40}, c = {20, 13}, d = {40, 80};
    line(image, a, b, color_rgb(255, 255, 255));
    line(image, c, d, color_rgb(255, 0, 0));
    count(drawing, "lines", 2);
    count(drawing, "pixels_tested", line_length(a, b) + line_length(c, d));
    return true;
}

/* A star: the four axes, the four diagonals, a line in each of the eight octants, and a point. */
static bool draw_gradient(struct drawing *drawing, struct image *image, struct error *error) {
    const struct color red = color_rgb(255, 0, 0), yellow = color_rgb(255, 255, 0);
    const struct color green = color_rgb(0, 255, 0), blue = color_rgb(0, 0, 255);
    const struct color white = color_rgb(255, 255, 255), dark = color_rgb(32, 32, 32);
    const struct {
        struct pixel a, b;
        struct color color_a, color_b;
    } lines[] = {
        {{58, 50}, {97, 50}, red, yellow}, {{50, 58}, {50, 97}, red, yellow},
        {{42, 50}, {3, 50}, red, yellow},  {{50, 42}, {50, 3}, red, yellow},
        {{56, 56}, {84, 84}, white, dark}, {{44, 56}, {16, 84}, white, dark},
        {{44, 44}, {16, 16}, white, dark}, {{56, 44}, {84, 16}, white, dark},
        {{58, 53}, {95, 68}, green, blue}, {{53, 58}, {68, 95}, green, blue},
        {{47, 58}, {32, 95}, green, blue}, {{42, 53}, {5, 68}, green, blue},
        {{5, 32}, {42, 47}, green, blue},  {{32, 5}, {47, 42}, green, blue},
        {{68, 5}, {53, 42}, green, blue},  {{95, 32}, {58, 47}, green, blue},
        {{50, 50}, {50, 50}, green, blue},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        if (!line_gradient(image, lines[i].a, lines[i].b, lines[i].color_a, lines[i].color_b,
                           error)) {
            return false;
        }
        count(drawing, "lines", 1);
        count(drawing, "pixels_tested", line_length(lines[i].a, lines[i].b));
    }
    return true;
}

/* Only the pixels inside the image: the house version, line_begin() and line_next(), leaps over the
 * others. Step 2 shows how. Returns how many there are. */
static size_t draw_visible(struct image *image, struct pixel a, struct pixel b,
                           struct color color_a, struct color color_b) {
    struct line_walk walk;
    size_t visible = 0;
    bool more = line_begin(&walk, a, b, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        struct pixel p = {walk.x, walk.y};
        image_set(image, p.x, p.y, color_along(a, b, color_a, color_b, p));
        visible++;
    }
    return visible;
}

/* Draw the lines of a text scene. They may be far longer than the image: what lies outside is
 * skipped, or with --no-skip walked over pixel by pixel. */
static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    for (size_t i = 0; i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        struct pixel a = {(int)shape->x[0], (int)shape->y[0]};
        struct pixel b = {(int)shape->x[1], (int)shape->y[1]};
        size_t length = line_length(a, b), tested = length;
        if (drawing->skip) {
            tested = draw_visible(image, a, b, shape->color[0], shape->color[1]);
        } else if (!line_gradient(image, a, b, shape->color[0], shape->color[1], error)) {
            return false;
        }
        count(drawing, "lines", 1);
        count(drawing, "pixels_tested", tested);
        count(drawing, "pixels_outside_skipped", length - tested);
    }
    return true;
}

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {.name = "pixel", .width = 100, .height = 100, .draw = draw_pixel},
        {.name = "line", .width = 100, .height = 100, .draw = draw_line},
        {.name = "gradient", .width = 100, .height = 100, .draw = draw_gradient},
    };
    static const struct program program = {
        .name = "step01_line",
        .summary = "a pixel, lines, and lines whose colour changes",
        .text_kind = TEXT_SCENE_LINES,
        .text_scene = {.width = 100, .height = 100, .draw = draw_text},
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
    };
    return program_main(&program, argc, argv);
}
