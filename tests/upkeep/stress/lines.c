/* Lines against exact integers. */
#include "lessons.h"
#include "stress.h"

enum { WIDTH = 13, HEIGHT = 11 }; /* of the image that the lines cross */
enum { LIST_LIMIT = 256 };        /* pixels of a short line */

/* ---- Cases ---- */

static int near_image(struct random *random, int64_t reach) {
    return (int)random_between(random, -reach, WIDTH + reach);
}

/* A line of any length through a pixel in or near the image: most long random lines miss it. */
static struct line_case through_image(struct random *random, int64_t reach) {
    int64_t x = near_image(random, 1), y = near_image(random, 1);
    int64_t dx = random_between(random, -reach, reach), dy = random_between(random, -reach, reach);
    int64_t from = random_between(random, 0, 16), to = random_between(random, 0, 16);
    return (struct line_case){{(int)(x - dx * from / 16), (int)(y - dy * from / 16)},
                              {(int)(x + dx * to / 16), (int)(y + dy * to / 16)}};
}

void make_any_line(struct random *random, uint64_t index, void *made) {
    struct line_case *c = made;
    switch (index % 6) {
    case 0: /* short ones, in and around the image: many ties */
        c->a = (struct pixel){near_image(random, 6), near_image(random, 6)};
        c->b = (struct pixel){near_image(random, 6), near_image(random, 6)};
        break;
    case 1: /* horizontal, vertical, diagonal, and points */
        c->a = (struct pixel){near_image(random, 9), near_image(random, 9)};
        c->b = c->a;
        {
            int length = (int)random_between(random, -40, 40) / (index % 12 == 1 ? 1 : 16);
            int direction = (int)random_between(random, 0, 3);
            c->b.x += direction != 1 ? length : 0;
            c->b.y += direction == 0 ? 0 : direction == 3 ? -length : length;
        }
        break;
    case 2:
        *c = through_image(random, 100);
        break;
    case 3:
        *c = through_image(random, 1000000);
        break;
    case 4:
        *c = through_image(random, LINE_LIMIT - 100);
        break;
    default: /* at the limits */
        c->a = (struct pixel){random_bits(random) % 2 ? LINE_LIMIT : -LINE_LIMIT,
                              (int)random_between(random, -LINE_LIMIT, LINE_LIMIT)};
        c->b = (struct pixel){-c->a.x + (c->a.x > 0 ? (int)random_between(random, 0, 40)
                                                    : -(int)random_between(random, 0, 40)),
                              WIDTH - c->a.y > LINE_LIMIT    ? LINE_LIMIT
                              : WIDTH - c->a.y < -LINE_LIMIT ? -LINE_LIMIT
                                                             : WIDTH - c->a.y};
    }
}

static void make_short_line(struct random *random, uint64_t index, void *made) {
    struct line_case *c = made;
    *c = index % 2 ? through_image(random, 60)
                   : (struct line_case){{near_image(random, 6), near_image(random, 6)},
                                        {near_image(random, 6), near_image(random, 6)}};
}

/* ---- Properties ---- */

/* Does each pixel have level 1 where the line is, and 0 elsewhere? */
static bool is_exact(const struct image *image, const struct line_case *c) {
    int width = (int)image->width, height = (int)image->height;
    for (int i = 0; i < width * height; i++) {
        if (image->pixels[i] != oracle_line_has(c->a, c->b, (struct pixel){i % width, i / width})) {
            return false;
        }
    }
    return true;
}

/* The pixel becomes a level brighter each time; false outside the image. */
static bool draw_pixel(struct image *image, int x, int y) {
    return image_set(image, x, y, color_grey((uint8_t)(image_get(image, x, y).b + 1)));
}

static bool line_is_exact(const void *tried) {
    const struct line_case *c = tried;
    uint8_t pixels[HEIGHT * WIDTH] = {0};
    struct image image = {WIDTH, HEIGHT, IMAGE_GREY, pixels};
    struct line_walk walk;
    int64_t across = (int64_t)c->b.x - c->a.x, up = (int64_t)c->b.y - c->a.y;
    bool inside = true, steep = up * up > across * across;
    if (line_begin(&walk, c->a, c->b, WIDTH, HEIGHT)) {
        do {
            inside = walk.steep == steep && draw_pixel(&image, walk.x, walk.y);
        } while (inside && line_next(&walk));
    }
    return inside && is_exact(&image, c);
}

/* The lesson's own list of a line: all of it, of which the image shows a part. */
static bool list_is_exact(const struct line_case *c) {
    struct pixel list[LIST_LIMIT];
    uint8_t pixels[HEIGHT * WIDTH] = {0};
    struct image image = {WIDTH, HEIGHT, IMAGE_GREY, pixels};
    size_t count = lesson01_list(c->a, c->b, list);
    bool right = true;
    for (size_t i = 0; i < count; i++) {
        draw_pixel(&image, list[i].x, list[i].y);
        right = right && oracle_line_has(c->a, c->b, list[i]);
    }
    return right && is_exact(&image, c);
}

/* The lesson's own line(), on an image, and its list. */
static bool lesson_line_is_exact(const void *tried) {
    const struct line_case *c = tried;
    uint8_t pixels[HEIGHT * WIDTH] = {0};
    struct image image = {WIDTH, HEIGHT, IMAGE_GREY, pixels};
    lesson01_line(&image, c->a, c->b, color_grey(1));
    return is_exact(&image, c) && list_is_exact(c);
}

/* ---- Lesson 2: the same on images of any size, of which a line may have little inside ---- */

struct cut_case {
    struct line_case line;
    int width, height;
};

static void make_cut(struct random *random, uint64_t index, void *made) {
    struct cut_case *c = made;
    make_any_line(random, random_bits(random), &c->line);
    c->width = index % 8 == 0 ? 1 : (int)random_between(random, 1, WIDTH);
    c->height = index % 8 <= 1 ? 1 : (int)random_between(random, 1, HEIGHT);
}

/* It must also tell how many pixels it drew. */
static bool cut_is_exact(const void *tried) {
    const struct cut_case *c = tried;
    uint8_t pixels[HEIGHT * WIDTH] = {0};
    struct image image = {(size_t)c->width, (size_t)c->height, IMAGE_GREY, pixels};
    uint64_t told = lesson02_line(&image, c->line.a, c->line.b, color_grey(1)), drawn = 0;
    for (int i = 0; i < c->width * c->height; i++) {
        drawn += pixels[i];
    }
    return told == drawn && is_exact(&image, &c->line);
}

const struct property line_properties[] = {
    PROPERTY("line: nearest pixels", AGAINST_INTEGERS, 1000000, struct line_case, make_any_line,
             .holds = line_is_exact),
    PROPERTY("line: lesson 1, nearest pixels", AGAINST_INTEGERS, 300000, struct line_case,
             make_short_line, .holds = lesson_line_is_exact),
    PROPERTY("line: lesson 2, cut to the image", AGAINST_INTEGERS, 500000, struct cut_case,
             make_cut, .holds = cut_is_exact),
    {.name = NULL},
};
