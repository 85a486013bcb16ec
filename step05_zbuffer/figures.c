/* The pictures of step 5's README that are not references, and the numbers of its tables. */
#include "../tests/bench/figures.h"

#define LESSON "../step05_zbuffer/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
#include "files/model_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Lists of triangles ---- */

struct list {
    struct drawn *items;
    size_t count;
};

/* A colour that tells the number of a triangle. */
static struct color number_color(size_t number) {
    return color_rgb((uint8_t)(number >> 16 & 255), (uint8_t)(number >> 8 & 255),
                     (uint8_t)(number & 255));
}

/* A model as a scene shows it. */
struct view {
    const char *name;
    const struct model *model;
    struct vec3 light;
};

/* The lit faces of the model, as draw_zbuffer() draws them, moved to the right by `shift`; numbered
 * from 1 instead of grey when `numbered` is set. */
static bool list_from_model(struct list *list, const struct view *view, const struct image *image,
                            double shift, bool numbered, struct error *error) {
    const struct model *model = view->model;
    const struct vec3 light = vec3_normalized(view->light);
    *list = (struct list){.items = malloc(model->face_count * sizeof *list->items)};
    if (list->items == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t face = 0; face < model->face_count; face++) {
        struct drawn *d = &list->items[list->count];
        double intensity = model_face_intensity(model, face, light);
        if (!(intensity > 0) || !place_face(model, face, image, d->v)) {
            continue;
        }
        for (int i = 0; i < 3; i++) {
            d->v[i].position.x += (int32_t)(shift * (double)image->width / 2 * SUBPIXELS);
        }
        list->count++;
        d->color = numbered ? number_color(list->count) : color_grey(level_from(intensity * 255));
    }
    return true;
}

static void list_free(struct list *list) {
    free(list->items);
    *list = (struct list){0};
}

/* What main.c draws: the depth in double. */
static void draw_right(struct image *image, const struct drawn *items, size_t count,
                       double *depth) {
    struct canvas canvas = {.image = image, .depth = depth};
    depth_clear(depth, image->width * image->height);
    for (size_t i = 0; i < count; i++) {
        triangle(&canvas, items[i].v, items[i].color);
    }
}

/* Exchange items at random (always the same way): every order comes out equally often. */
static void shuffle(struct list *list, uint32_t seed) {
    for (size_t i = list->count; i > 1; i--) {
        seed = seed * 1664525U + 1013904223U;
        size_t other = (size_t)((uint64_t)seed * i >> 32);
        struct drawn kept = list->items[i - 1];
        list->items[i - 1] = list->items[other];
        list->items[other] = kept;
    }
}

/* ---- The bust by every version ---- */

typedef void attempt_function(struct image *image, const struct drawn *list, size_t count,
                              void *buffer);

static void draw_file_order(struct image *image, const struct drawn *list, size_t count,
                            void *buffer) {
    (void)buffer;
    attempt_1_file_order(image, list, count);
}

/* The painter sorts, so he gets a list of his own, in the buffer. */
static void draw_painter(struct image *image, const struct drawn *list, size_t count,
                         void *buffer) {
    memcpy(buffer, list, count * sizeof *list);
    attempt_2_painter(image, buffer, count);
}

struct version {
    const char *name;
    attempt_function *draw;
};

static const struct version versions[] = {
    {"1 order of the file", draw_file_order},
    {"2 painter's order", draw_painter},
    {"3 mean depth", attempt_3_mean_depth},
    {"4 cleared to 0", attempt_4_cleared_to_0},
    {"5 farthest", attempt_5_farthest},
    {"6 8 bits", attempt_6_depth_8},
    {"7 16 bits", attempt_7_depth_16},
    {"8 24 bits", attempt_8_depth_24},
    {"9 float", attempt_9_float},
    {"10 float, 1 - near/distance", attempt_10_float_from_near},
    {"11 float, near/distance", attempt_11_float_reversed},
};
enum { VERSION_COUNT = sizeof versions / sizeof versions[0] };

/* Draw the list with the first versions and count the pixels that show another face than main.c
 * does. */
static void print_wrong_pixels(const char *name, const struct list *list, size_t version_count,
                               struct image *right, struct image *image, double *depth,
                               void *buffer) {
    image_clear(right, color_grey(0));
    draw_right(right, list->items, list->count, depth);
    for (size_t i = 0; i < version_count; i++) {
        image_clear(image, color_grey(0));
        versions[i].draw(image, list->items, list->count, buffer);
        size_t wrong = different_pixels(image, right);
        image_clear(image, color_grey(0));
        printf("%-6s %-28s %6zu pixels wrong of %zu\n", name, versions[i].name, wrong,
               different_pixels(image, right));
    }
}

/* The same triangles in other orders. */
static bool print_shuffled(const struct list *list, struct image *right, struct image *image,
                           double *depth, struct error *error) {
    struct list shuffled = {.items = malloc(list->count * sizeof *list->items)};
    size_t different = 0;
    if (shuffled.items == NULL) {
        return error_out_of_memory(error);
    }
    memcpy(shuffled.items, list->items, list->count * sizeof *list->items);
    shuffled.count = list->count;
    for (uint32_t i = 0; i < 100; i++) {
        shuffle(&shuffled, i);
        image_clear(image, color_grey(0));
        draw_right(image, shuffled.items, shuffled.count, depth);
        different += different_pixels(image, right);
    }
    printf("bust   100 shuffled orders          %6zu pixels different\n", different);
    list_free(&shuffled);
    return true;
}

/* Pictures of the attempts that look wrong from afar. */
static bool draw_attempts(const struct view *view, const char *directory, double *depth,
                          void *buffer, struct error *error) {
    static const struct version shown[] = {
        {"cleared_to_0", attempt_4_cleared_to_0},
        {"farthest", attempt_5_farthest},
    };
    struct image image = {0};
    struct list list = {0}, moved = {0};
    bool done = image_create(&image, 400, 400, IMAGE_GREY, error) &&
                list_from_model(&list, view, &image, 0, false, error) &&
                list_from_model(&moved, view, &image, 0.25, false, error);
    for (size_t i = 0; done && i < sizeof shown / sizeof shown[0]; i++) {
        image_clear(&image, color_grey(0));
        shown[i].draw(&image, list.items, list.count, buffer);
        done = figure_save(&image, directory, shown[i].name, error);
    }
    if (done) { /* a second frame: the image is cleared, the depth is not */
        struct canvas canvas = {.image = &image, .depth = depth};
        draw_right(&image, list.items, list.count, depth);
        image_clear(&image, color_grey(0));
        for (size_t i = 0; i < moved.count; i++) {
            triangle(&canvas, moved.items[i].v, moved.items[i].color);
        }
        done = figure_save(&image, directory, "not_cleared", error);
    }
    list_free(&list);
    list_free(&moved);
    image_free(&image);
    return done;
}

/* Print how many pixels the first versions show wrong; of all the orders of the bust too. */
static bool print_view(const struct view *view, size_t version_count, double *depth, void *buffer,
                       struct error *error) {
    struct list list = {0};
    struct image right = {0}, image = {0};
    bool done = image_create(&right, 800, 800, IMAGE_BGR, error) &&
                image_create(&image, 800, 800, IMAGE_BGR, error) &&
                list_from_model(&list, view, &image, 0, true, error);
    if (done) {
        print_wrong_pixels(view->name, &list, version_count, &right, &image, depth, buffer);
        done = version_count < VERSION_COUNT || print_shuffled(&list, &right, &image, depth, error);
    }
    list_free(&list);
    image_free(&right);
    image_free(&image);
    return done;
}

/* ---- What lesson 4 draws ---- */

static bool draw_painted_over(const struct view *views, size_t view_count, const char *directory,
                              struct error *error) {
    struct sheet sheet = {.width = 400,
                          .height = 400,
                          .columns = view_count,
                          .rows = 1,
                          .gap = 8,
                          .format = IMAGE_GREY};
    bool done = sheet_create(&sheet, error);
    for (size_t i = 0; done && i < view_count; i++) {
        struct list list = {0};
        done = list_from_model(&list, &views[i], &sheet.panel, 0, false, error);
        if (done) {
            attempt_1_file_order(&sheet.panel, list.items, list.count);
            sheet_add(&sheet);
        }
        list_free(&list);
    }
    done = done && figure_save(&sheet.image, directory, "painted_over", error);
    sheet_free(&sheet);
    return done;
}

static bool draw_models(const struct model *bust, const struct model *knot, const char *directory,
                        double *depth, void *buffer, struct error *error) {
    const struct view views[] = {
        {"knot", knot, {0, 0, -1}},
        {"side", bust, {1, 0, -1}},
        {"bust", bust, {0, 0, -1}},
    };
    return print_view(&views[0], 3, depth, buffer, error) &&
           print_view(&views[1], 3, depth, buffer, error) &&
           print_view(&views[2], VERSION_COUNT, depth, buffer, error) &&
           draw_painted_over(views, 2, directory, error) &&
           draw_attempts(&views[2], directory, depth, buffer, error);
}

/* ---- Three bars in a circle ---- */

static struct vertex place(double x, double y, double depth) {
    struct vertex v = {.depth = depth};
    screen_snap((struct vec2){x, y}, &v.position); /* always within the limit here */
    return v;
}

/* Three long triangles, each over the next: the thick end is near, the point is far. */
static void make_circle(struct drawn bars[3]) {
    static const struct vec2 corner[3] = {{-70, -10}, {-70, -70}, {130, -45}};
    static const double depth[3] = {0.5, 0.5, -0.5};
    static const double cosine[3] = {1, -0.5, -0.5};
    static const double sine[3] = {0, 0.8660254037844386, -0.8660254037844386};
    const struct color color[3] = {color_rgb(220, 60, 50), color_rgb(60, 170, 70),
                                   color_rgb(60, 90, 220)};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            struct vec2 c = corner[k];
            bars[i].v[k] = place(118 + c.x * cosine[i] - c.y * sine[i],
                                 105 + c.x * sine[i] + c.y * cosine[i], depth[k]);
        }
        bars[i].color = color[i];
    }
}

/* ---- Small things on a large floor ---- */

enum { FLOOR_TREES = 6, FLOOR_COUNT = FLOOR_TREES + 2 };

/* A floor seen from obliquely above, of two triangles: its depth falls from 0.9 at the bottom of
 * the picture to -0.9 at the top. The trees stand on it upright: one depth each. */
static void make_floor(struct drawn list[FLOOR_COUNT]) {
    static const struct vec2 foot[FLOOR_TREES] = {{60, 150}, {130, 120}, {205, 140},
                                                  {170, 85}, {90, 60},   {220, 40}};
    const struct vertex a = place(10, 10, 0.9), b = place(250, 10, 0.9);
    const struct vertex c = place(250, 190, -0.9), d = place(10, 190, -0.9);
    list[0] = (struct drawn){{a, b, c}, color_rgb(170, 140, 100)};
    list[1] = (struct drawn){{a, c, d}, color_rgb(190, 160, 120)};
    for (int i = 0; i < FLOOR_TREES; i++) {
        double depth = 0.9 - 1.8 * (foot[i].y - 10) / 180;
        list[i + 2] = (struct drawn){{place(foot[i].x - 16, foot[i].y, depth),
                                      place(foot[i].x + 16, foot[i].y, depth),
                                      place(foot[i].x, foot[i].y + 55, depth)},
                                     color_rgb(30, (uint8_t)(110 + 20 * i), 60)};
    }
}

/* ---- Large triangles ---- */

/* From left to right: with a depth buffer, by the painter, by mean depth. */
static bool draw_large(const char *name, const struct drawn *list, size_t count,
                       const char *directory, double *depth, void *buffer, struct error *error) {
    struct sheet sheet = {.width = 260, .height = 250, .columns = 3, .rows = 1};
    struct image right = {0};
    bool done = sheet_create(&sheet, error) &&
                image_create(&right, sheet.width, sheet.height, IMAGE_BGR, error);
    if (done) {
        draw_right(&right, list, count, depth);
        sheet_add_detail(&sheet, &right, detail_of_whole(&right, 1, 0));
        for (int i = 1; i <= 2; i++) { /* attempts 2 and 3 */
            versions[i].draw(&sheet.panel, list, count, buffer);
            printf("%-6s %-28s %6zu pixels wrong\n", name, versions[i].name,
                   different_pixels(&right, &sheet.panel));
            sheet_add(&sheet);
        }
        done = figure_save(&sheet.image, directory, name, error);
    }
    image_free(&right);
    sheet_free(&sheet);
    return done;
}

static bool draw_circle_and_floor(const char *directory, double *depth, void *buffer,
                                  struct error *error) {
    struct drawn bars[3], floor_list[FLOOR_COUNT];
    make_circle(bars);
    make_floor(floor_list);
    return draw_large("circle", bars, 3, directory, depth, buffer, error) &&
           draw_large("floor", floor_list, FLOOR_COUNT, directory, depth, buffer, error);
}

/* ---- Two sheets close to each other ---- */

enum { SHEETS_WIDTH = 560, SHEETS_HEIGHT = 40 };

/* A blue sheet, and an orange one before it: nearer by 0 at the left end and by 1e-4 at the right
 * one. Both rise by 0.1 from bottom to top. The blue one comes first. */
static void make_sheets(struct drawn list[4]) {
    const double w = SHEETS_WIDTH, h = SHEETS_HEIGHT, low = 0.3, high = 0.4, gap = 1e-4;
    const struct color blue = color_rgb(70, 100, 190), orange = color_rgb(255, 150, 30);
    const struct vertex back[4] = {place(0, 0, low), place(w, 0, low), place(w, h, high),
                                   place(0, h, high)};
    const struct vertex front[4] = {place(0, 0, low), place(w, 0, low + gap),
                                    place(w, h, high + gap), place(0, h, high)};
    list[0] = (struct drawn){{back[0], back[1], back[2]}, blue};
    list[1] = (struct drawn){{back[0], back[2], back[3]}, blue};
    list[2] = (struct drawn){{front[0], front[1], front[2]}, orange};
    list[3] = (struct drawn){{front[0], front[2], front[3]}, orange};
}

static bool draw_sheets(const char *directory, double *depth, void *buffer, struct error *error) {
    enum { FIRST = 5, STRIPS = 7 };
    struct sheet sheet = {
        .width = SHEETS_WIDTH, .height = SHEETS_HEIGHT, .columns = 1, .rows = STRIPS, .gap = 6};
    struct drawn list[4];
    struct image right = {0};
    bool done = sheet_create(&sheet, error) &&
                image_create(&right, SHEETS_WIDTH, SHEETS_HEIGHT, IMAGE_BGR, error);
    make_sheets(list);
    if (done) {
        image_clear(&right, list[2].color); /* the orange sheet is nowhere behind the blue one */
        for (int i = 0; i < STRIPS; i++) {
            bool last = i == STRIPS - 1;
            if (last) {
                draw_right(&sheet.panel, list, 4, depth);
            } else {
                versions[FIRST + i].draw(&sheet.panel, list, 4, buffer);
            }
            printf("sheets %-28s %6zu pixels wrong\n",
                   last ? "double (main.c)" : versions[FIRST + i].name,
                   different_pixels(&sheet.panel, &right));
            sheet_add(&sheet);
        }
        done = figure_save(&sheet.image, directory, "sheets", error);
    }
    image_free(&right);
    sheet_free(&sheet);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    struct model knot = {0};
    if (!model_read(&knot, COURSE_BUILD "/models/knot.off", error)) {
        return false;
    }
    /* The buffer holds 4 bytes a pixel, or the list of the painter. */
    size_t depths_size = 800 * 800 * sizeof(uint32_t);
    size_t most_faces = bust->face_count > knot.face_count ? bust->face_count : knot.face_count;
    size_t list_size = most_faces * sizeof(struct drawn);
    double *depth = malloc(800 * 800 * sizeof *depth);
    void *buffer = malloc(list_size > depths_size ? list_size : depths_size);
    bool done = depth != NULL && buffer != NULL;
    done = done ? draw_models(bust, &knot, directory, depth, buffer, error) &&
                      draw_circle_and_floor(directory, depth, buffer, error) &&
                      draw_sheets(directory, depth, buffer, error)
                : error_out_of_memory(error);
    free(depth);
    free(buffer);
    model_free(&knot);
    return done;
}
