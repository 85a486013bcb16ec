/*
 * Lesson 2's benchmark: wireframes that draw sides twice, test every pixel, or cut lines badly.
 *
 * The work is the bust with a hole, enlarged so that most of it lies outside the image. The error
 * counts wrong and missing pixels of the picture that was timed, against the exact pixels of each
 * line.
 */
#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

#include "../../../step02_wireframe/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

enum { SIDE = 800 }; /* of the image */

/* How much the model is enlarged about its middle: the face fills the image. */
static const double enlargement = 6;
static const double middle_y = 0.25, hole = 0.06; /* before that */

static struct {
    struct model model;
    struct drawing drawing;
    struct wireframe wireframe; /* the list of sides, each once */
    struct image timed;         /* IMAGE_GREY */
    struct image exact;         /* IMAGE_GREY, 255 where a line should be */
    size_t pixel_count;         /* of these */
} frame;

/* ---- The exact picture ---- */

/* Set the exact pixels of a line that lie in the image: the ideal line tells where to look, the
 * oracle which pixel of three it is. */
static void add_exact_line(struct image *image, struct pixel a, struct pixel b) {
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

static void frame_find_exact(void) {
    const struct model *model = &frame.model;
    for (size_t face = 0; face < model->face_count; face++) {
        for (size_t i = 0; i < 3; i++) {
            struct pixel a, b;
            if (to_pixel(model_position(model, face, i), SIDE, SIDE, &a) &&
                to_pixel(model_position(model, face, (i + 1) % 3), SIDE, SIDE, &b)) {
                add_exact_line(&frame.exact, a, b);
            }
        }
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        frame.pixel_count += frame.exact.pixels[i] != 0;
    }
}

/* ---- The versions ---- */

enum frame_version { EVERY_TESTED, EVERY_CUT, ONCE_TESTED, ONE_DIRECTION, ENDS_ROUNDED, HOUSE };

static void frame_draw_rounded(void) {
    for (size_t i = 0; i < frame.wireframe.side_count; i++) {
        const struct model *model = &frame.model;
        struct side side = frame.wireframe.sides[i];
        struct pixel a, b;
        if (to_pixel(model->positions[side.low], SIDE, SIDE, &a) &&
            to_pixel(model->positions[side.high], SIDE, SIDE, &b)) {
            attempt_line_ends_rounded(&frame.timed, a, b, color_grey(255));
        }
    }
}

/* The scene as main.c draws it. */
static void frame_draw_house(void) {
    struct error error;
    frame.drawing.counter_count = 0;
    draw_wireframe(&frame.drawing, &frame.timed, &error);
}

/* A frame begins with an empty image. */
static void frame_run(struct bench_choice choice) {
    const struct model *model = &frame.model;
    const struct wireframe *list = &frame.wireframe;
    image_clear(&frame.timed, color_grey(0));
    switch (choice.way) {
    case EVERY_TESTED:
        attempt_1_every_side_tested(&frame.timed, model);
        break;
    case EVERY_CUT:
        attempt_2_every_side_cut(&frame.timed, model);
        break;
    case ONCE_TESTED:
        attempt_3_each_once_tested(&frame.timed, model, list->sides, list->side_count);
        break;
    case ONE_DIRECTION:
        attempt_4_one_direction(&frame.timed, model);
        break;
    case ENDS_ROUNDED:
        frame_draw_rounded();
        break;
    default:
        frame_draw_house();
    }
}

/* Wrong and missing pixels per 1000. */
static double frame_error(struct bench_choice choice) {
    size_t wrong = 0;
    (void)choice;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        wrong += frame.timed.pixels[i] != frame.exact.pixels[i];
    }
    return 1000 * (double)wrong / (double)frame.pixel_count;
}

/* ---- The lesson ---- */

/* Read the bust, enlarged, with the middle of the face in the middle of the image. A square hole is
 * cut into it, so that it has a border. */
static bool frame_read_model(struct model *model, struct error *error) {
    if (!model_read(model, BENCH_MODEL("bust.obj"), error)) {
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

static bool frame_setup(struct error *error) {
    frame.drawing =
        (struct drawing){.model = &frame.model, .skip = true, .state = &frame.wireframe};
    if (!frame_read_model(&frame.model, error) ||
        !image_create(&frame.timed, SIDE, SIDE, IMAGE_GREY, error) ||
        !image_create(&frame.exact, SIDE, SIDE, IMAGE_GREY, error) ||
        !prepare(&frame.drawing, SIDE, SIDE, error)) {
        return false;
    }
    frame_find_exact();
    return true;
}

static const struct bench_version frame_versions[] = {
    VERSION("every side, pixels tested", EVERY_TESTED),
    VERSION("every side, cut", EVERY_CUT),
    VERSION("each once, pixels tested", ONCE_TESTED),
    VERSION("one direction only", ONE_DIRECTION),
    VERSION("each once, ends rounded", ENDS_ROUNDED),
    HOUSE_VERSION("each once, cut (main.c)", HOUSE),
};

static const struct bench_panel frame_panels[] = {
    {
        .title = "The bust with a hole, six times enlarged, on 800x800 pixels",
        .error_label = "wrong and missing pixels per 1000",
        .time_label = "ms per frame",
        .against = "exact integers",
        .house_within = BENCH_EXACT,
        BENCH_VERSIONS(frame_versions),
        .run = frame_run,
        .error = frame_error,
    },
};

const struct bench_lesson bench_step02 =
    BENCH_LESSON("step02_wireframe", "Lesson 2: a wireframe", frame_setup, frame_panels);
