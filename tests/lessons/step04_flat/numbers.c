/* Lesson 4's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step04_flat/main.c"
#endif
#include "numbers.h"

static struct shown called_placed(struct vec3 a, struct vec3 b, struct vec3 c, size_t width,
                                  size_t height) {
    const struct image image = {.width = width, .height = height};
    struct vec3 corners[3] = {a, b, c};
    const struct model model = one_face(corners);
    struct vertex v[3] = {{{0, 0}}};
    if (!place_face(&model, 0, &image, v)) {
        return show("false");
    }
    return show("(%d,%d) (%d,%d) (%d,%d)", v[0].position.x, v[0].position.y, v[1].position.x,
                v[1].position.y, v[2].position.x, v[2].position.y);
}

static struct vertex called_on(int x, int y) {
    return (struct vertex){{x, y}};
}

/* In an image of that size: its pixels, and those of eight rows behind it. */
static struct shown called_drawn(struct vertex a, struct vertex b, struct vertex c, size_t width,
                                 size_t height) {
    struct image sheet = black_image(width, height + 8), image = sheet;
    image.height = height;
    triangle(&image, (struct vertex[3]){a, b, c}, rgb(255, 255, 255));
    return show_pixels(&sheet);
}

/* The grey of the text's face, moved and `size` times as large, in 255ths. */
static long called_grey(struct vec3 moved, double size, struct vec3 to_light) {
    struct vec3 corners[3] = {xyz(0, 0, 0), xyz(2, 0, 1), xyz(0, 1, 1)};
    for (int i = 0; i < 3; i++) {
        corners[i] = vec3_add(vec3_scale(corners[i], size), moved);
    }
    const struct model model = one_face(corners);
    return (long)floor(face_intensity(&model, 0, to_light) * 255 + 0.5);
}

#define PLACED(a, b, c, width, height, right)                                                      \
    TEXT("4.1", "place_face(" #a " " #b " " #c ", " #width " x " #height ")",                      \
         called_placed(xyz a, xyz b, xyz c, width, height), right)
#define DRAWN(image, width, height, a, b, c, right)                                                \
    TEXT("4.2", "triangle(" image ", " #a " " #b " " #c ", white)",                                \
         called_drawn(called_on a, called_on b, called_on c, width, height), right)
#define GREY(face, moved, size, to_light, right)                                                   \
    AS_WHOLE("4.3", "255 * face_intensity(" face ", l " #to_light ")",                             \
             called_grey(xyz moved, size, xyz to_light), right)

static void numbers(void) {
    PLACED((0, 0, 0), (0.5, 0, 0), (0, 0.5, 0.3), 200, 100,
           "(25600,12800) (38400,12800) (25600,19200)");
    PLACED((-1, -1, 0), (3, -1, 0), (-1, 2, 0), 200, 100, "(0,0) (102400,0) (0,38400)");
    PLACED((0, 0, 0), (0.5, 0, 0), (0, 0.5, 0.3), 201, 67,
           "(25728,8576) (38592,8576) (25728,12864)");
    PLACED((1e9, 0, 0), (0.5, 0, 0), (0, 0.5, 0), 200, 100, "false");
    PLACED((0, 0, 0), (0.5, 0, 0), (0, -1e9, 0), 200, 100, "false");
    DRAWN("image", 8, 8, (256, 256), (1280, 256), (256, 1024),
          "(1,1) (2,1) (3,1) (1,2) (2,2) (1,3)");
    DRAWN("image", 8, 8, (256, 256), (256, 1024), (1280, 256),
          "(1,1) (2,1) (3,1) (1,2) (2,2) (1,3)");
    DRAWN("image", 8, 8, (256, 256), (512, 256), (768, 256), "none");
    DRAWN("image of 5 x 3", 5, 3, (-512, -512), (5120, -512), (-512, 5120),
          "(0,0) (1,0) (2,0) (3,0) (4,0) (0,1) (1,1) (2,1) (3,1) (4,1) (0,2) (1,2) (2,2) (3,2) "
          "(4,2)");
    DRAWN("image", 8, 8, (992, 272), (1520, 1216), (1552, 1984), "(4,2) (5,4) (5,5)");
    GREY("(0, 0, 0) (2, 0, 1) (0, 1, 1)", (0, 0, 0), 1, (0, 0, 1), 170);
    GREY("(3, 4, 5) (5, 4, 6) (3, 5, 6)", (3, 4, 5), 1, (0, 0, 1), 170);
    GREY("(0, 0, 0) (2, 0, 1) (0, 1, 1)", (0, 0, 0), 1, (-0.6, 0, 0.8), 187);
    GREY("(0, 0, 0) (2, 0, 1) (0, 1, 1)", (0, 0, 0), 1, (0, -0.6, 0.8), 238);
    GREY("(0, 0, 0) (2, 0, 1) (0, 1, 1)", (0, 0, 0), 1, (-0.48, 0.6, 0.64), 48);
    GREY("(0, 0, 0) (2, 0, 1) (0, 1, 1)", (0, 0, 0), 1, (0, 0, -1), -170);
    GREY("a thousandth of that face", (0, 0, 0), 0.001, (0, 0, 1), 170);
}
