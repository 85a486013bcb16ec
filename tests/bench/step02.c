/*
 * Lesson 2's benchmark: wireframes that draw sides twice, test every pixel, or cut lines badly.
 *
 * The work is the bust with a hole, enlarged so that most of it lies outside the image. The first
 * panel's error counts wrong and missing pixels, against the exact pixels of each side; the second
 * panel shows the pixels that a version looked at.
 */
#define main step02_main
int step02_main(int argc, char **argv);
#include "../../step02_wireframe/main.c"
#undef main

#include "../../step02_wireframe/attempts.h"

#include "bench.h"
#include "oracle.h"

#include <string.h>

enum { SIDE = 800 }; /* of the image */

/* How much the model is enlarged about its middle: the face fills the image. */
static const double enlargement = 6;
static const float middle_y = 0.25F, hole = 0.06F; /* before that */

struct frame {
    struct model model;
    struct drawing drawing;
    struct wireframe wireframe; /* the list of sides, each once */
    struct image timed;         /* IMAGE_BGR, as the scene is */
    struct image drawn, exact;
    size_t exact_count; /* pixels set in `exact` */
    struct work work;   /* of the last run */
};

/* ---- The versions ---- */

enum version {
    EVERY_TESTED,
    EVERY_CUT,
    ONCE_TESTED,
    ONE_DIRECTION,
    ENDS_ROUNDED,
    LIST_ANEW,
    HOUSE
};

static void frame_draw_rounded(struct frame *frame, struct image *image) {
    for (size_t i = 0; i < frame->wireframe.side_count; i++) {
        const struct model *model = &frame->model;
        struct side side = frame->wireframe.sides[i];
        struct pixel a, b;
        if (to_pixel(model->positions[side.low], SIDE, SIDE, &a) &&
            to_pixel(model->positions[side.high], SIDE, SIDE, &b)) {
            attempt_line_ends_rounded(image, a, b, color_rgb(255, 255, 255));
        }
    }
}

/* The scene as main.c draws it, from the list of sides made before or, with `anew`, made now. */
static void frame_draw_house(struct frame *frame, struct image *image, bool anew) {
    struct wireframe fresh = {0};
    struct error error;
    struct drawing *drawing = &frame->drawing;
    drawing->counter_count = 0;
    drawing->state = &frame->wireframe;
    if (anew) {
        drawing->state = &fresh;
        if (!prepare(drawing, SIDE, SIDE, &error)) {
            finish(drawing);
            return;
        }
    }
    draw_wireframe(drawing, image, &error);
    if (anew) {
        finish(drawing);
    }
    for (size_t i = 0; i < drawing->counter_count; i++) {
        if (strcmp(drawing->counters[i].name, "pixels_written") == 0) {
            frame->work.tested = drawing->counters[i].value;
        }
    }
}

static void frame_draw(struct frame *frame, int choice, struct image *image) {
    const struct model *model = &frame->model;
    const struct wireframe *list = &frame->wireframe;
    switch (choice) {
    case EVERY_TESTED:
        frame->work = attempt_1_every_side_tested(image, model);
        break;
    case EVERY_CUT:
        frame->work = attempt_2_every_side_cut(image, model);
        break;
    case ONCE_TESTED:
        frame->work = attempt_3_each_once_tested(image, model, list->sides, list->side_count);
        break;
    case ONE_DIRECTION:
        frame->work = attempt_4_one_direction(image, model);
        break;
    case ENDS_ROUNDED:
        frame_draw_rounded(frame, image);
        break;
    default:
        frame_draw_house(frame, image, choice == LIST_ANEW);
    }
}

static void frame_run(void *state, int choice) {
    struct frame *frame = state;
    frame_draw(frame, choice, &frame->timed);
}

/* ---- The errors ---- */

/* Set the exact pixels of a line that lie in the image: the ideal line tells where to look, the
 * oracle which pixel of three it is. */
static void frame_draw_exact(struct image *image, struct pixel a, struct pixel b) {
    int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y;
    bool steep = llabs(dy) > llabs(dx);
    int64_t run = steep ? dy : dx, rise = steep ? dx : dy;
    for (int u = 0; u < SIDE; u++) {
        int64_t along = u - (steep ? a.y : a.x);
        if (run != 0 ? along * run < 0 || llabs(along) > llabs(run) : along != 0) {
            continue;
        }
        int v = (int)((steep ? a.x : a.y) + (run != 0 ? rise * along / run : 0));
        for (int candidate = v - 1; candidate <= v + 1; candidate++) {
            struct pixel p = {steep ? candidate : u, steep ? u : candidate};
            if (oracle_line_has(a, b, p)) {
                image_set(image, p.x, p.y, color_grey(255));
            }
        }
    }
}

static double frame_wrong_pixels(void *state, int choice) {
    struct frame *frame = state;
    size_t wrong = 0;
    image_clear(&frame->drawn, color_grey(0));
    frame_draw(frame, choice, &frame->drawn);
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        wrong += frame->drawn.pixels[i] != frame->exact.pixels[i];
    }
    return 1000 * (double)wrong / (double)frame->exact_count;
}

static double frame_pixels_tested(void *state, int choice) {
    struct frame *frame = state;
    frame_draw(frame, choice, &frame->drawn);
    return (double)frame->work.tested / (double)frame->exact_count;
}

/* ---- The lesson ---- */

/* Read the bust, enlarged, with the middle of the face in the middle of the image. A square hole is
 * cut into it, so that it has a border. */
static bool frame_read_model(struct model *model, struct error *error) {
    if (!bench_read_model(model, "bust.obj", error)) {
        return false;
    }
    size_t kept = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vec3 p = model_position(model, face, 0);
        if (fabs(p.x) > hole || fabs(p.y - middle_y) > hole) {
            model->faces[kept++] = model->faces[face];
        }
    }
    model->face_count = kept;
    for (size_t i = 0; i < model->position_count; i++) {
        model->positions[i].x *= enlargement;
        model->positions[i].y = (model->positions[i].y - middle_y) * enlargement;
    }
    return true;
}

static bool frame_setup(void **state, struct error *error) {
    struct frame *frame = calloc(1, sizeof *frame);
    *state = frame;
    if (frame == NULL) {
        return error_set(error, "out of memory for a frame");
    }
    frame->drawing =
        (struct drawing){.model = &frame->model, .skip = true, .state = &frame->wireframe};
    if (!frame_read_model(&frame->model, error) ||
        !image_create(&frame->timed, SIDE, SIDE, IMAGE_BGR, error) ||
        !image_create(&frame->drawn, SIDE, SIDE, IMAGE_GREY, error) ||
        !image_create(&frame->exact, SIDE, SIDE, IMAGE_GREY, error) ||
        !prepare(&frame->drawing, SIDE, SIDE, error)) {
        return false;
    }
    for (size_t face = 0; face < frame->model.face_count; face++) {
        for (size_t i = 0; i < 3; i++) {
            struct pixel a, b;
            if (to_pixel(model_position(&frame->model, face, i), SIDE, SIDE, &a) &&
                to_pixel(model_position(&frame->model, face, (i + 1) % 3), SIDE, SIDE, &b)) {
                frame_draw_exact(&frame->exact, a, b);
            }
        }
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        frame->exact_count += frame->exact.pixels[i] != 0;
    }
    return true;
}

static void frame_teardown(void *state) {
    struct frame *frame = state;
    if (frame != NULL) {
        frame->drawing.state = &frame->wireframe;
        finish(&frame->drawing);
        model_free(&frame->model);
        image_free(&frame->timed);
        image_free(&frame->drawn);
        image_free(&frame->exact);
    }
    free(frame);
}

static const struct bench_version pixel_versions[] = {
    {"every side, pixels tested", EVERY_TESTED, false, frame_run, frame_wrong_pixels},
    {"every side, cut", EVERY_CUT, false, frame_run, frame_wrong_pixels},
    {"each once, pixels tested", ONCE_TESTED, false, frame_run, frame_wrong_pixels},
    {"one direction only", ONE_DIRECTION, false, frame_run, frame_wrong_pixels},
    {"each once, ends rounded", ENDS_ROUNDED, false, frame_run, frame_wrong_pixels},
    {"list made every time", LIST_ANEW, false, frame_run, frame_wrong_pixels},
    {"each once, cut (main.c)", HOUSE, true, frame_run, frame_wrong_pixels},
};

static const struct bench_version work_versions[] = {
    {"every side, pixels tested", EVERY_TESTED, false, frame_run, frame_pixels_tested},
    {"every side, cut", EVERY_CUT, false, frame_run, frame_pixels_tested},
    {"each once, pixels tested", ONCE_TESTED, false, frame_run, frame_pixels_tested},
    {"each once, cut (main.c)", HOUSE, true, frame_run, frame_pixels_tested},
};

static const struct bench_panel frame_panels[] = {
    {
        .title = "The bust with a hole, six times enlarged, on 800x800 pixels: the right pixels?",
        .error_label = "wrong and missing pixels per 1000",
        .time_label = "ms per frame",
        .against = "exact integers",
        .versions = pixel_versions,
        .version_count = sizeof pixel_versions / sizeof pixel_versions[0],
    },
    {
        .title = "The same: how much work?",
        .error_label = "pixels looked at for each pixel that is seen",
        .time_label = "ms per frame",
        .against = "the pixels of the exact picture",
        .versions = work_versions,
        .version_count = sizeof work_versions / sizeof work_versions[0],
        .budget = 0.5,
    },
};

const struct bench_lesson bench_step02 = {
    .step = "step02_wireframe",
    .title = "Step 2: a wireframe",
    .setup = frame_setup,
    .teardown = frame_teardown,
    .panels = frame_panels,
    .panel_count = sizeof frame_panels / sizeof frame_panels[0],
};
