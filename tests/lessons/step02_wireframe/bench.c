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

/* The face fills the image; half a side of the hole in its middle. */
static const struct view enlarged = {0, 0.25, 6};
static const double hole = 0.06;

static struct {
    struct model model;
    struct drawing drawing;
    struct wireframe once;  /* the sides, each once */
    struct wireframe every; /* room for all that the faces have */
    struct image timed;     /* IMAGE_GREY */
    struct image exact;     /* IMAGE_GREY, 255 where a line should be */
    size_t pixel_count;     /* of these */
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
            if (pixel_in_view(model_position(model, face, i), enlarged, &frame.exact, &a) &&
                pixel_in_view(model_position(model, face, (i + 1) % 3), enlarged, &frame.exact,
                              &b)) {
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

static line_function *const frame_lines[] = {
    [EVERY_TESTED] = line,
    [EVERY_CUT] = line_inside,
    [ONCE_TESTED] = line,
    [ONE_DIRECTION] = line_inside,
    [ENDS_ROUNDED] = attempt_line_ends_rounded,
    [HOUSE] = line_inside,
};

/* The sides that it draws. If that is not each of them once, they are listed while time counts. */
static const struct wireframe *frame_list(int way) {
    if (way == EVERY_TESTED || way == EVERY_CUT) {
        list_sides(&frame.model, frame.every.sides);
        frame.every.side_count = 3 * frame.model.face_count;
        return &frame.every;
    }
    if (way == ONE_DIRECTION) {
        frame.every.side_count = attempt_one_direction(&frame.model, frame.every.sides);
        return &frame.every;
    }
    return &frame.once;
}

/* A frame begins with an empty image. */
static void frame_run(struct bench_choice choice) {
    image_clear(&frame.timed, color_grey(0));
    frame.drawing.counter_count = 0;
    draw_sides(&frame.drawing, frame_list(choice.way), frame.model.positions, enlarged,
               frame_lines[choice.way], &frame.timed);
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

/* Read the bust. A square hole is cut into it, so that it has a border. */
static bool frame_read_model(struct model *model, struct error *error) {
    if (!model_read(model, BENCH_MODEL("bust.obj"), error)) {
        return false;
    }
    size_t kept = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vec3 p = model_position(model, face, 0);
        if (fabs(p.x) > hole || fabs(p.y - enlarged.y) > hole) {
            model->faces[kept++] = model->faces[face];
        }
    }
    model->face_count = kept;
    return true;
}

static bool frame_setup(struct error *error) {
    if (!frame_read_model(&frame.model, error) ||
        !image_create(&frame.timed, SIDE, SIDE, IMAGE_GREY, error) ||
        !image_create(&frame.exact, SIDE, SIDE, IMAGE_GREY, error) ||
        !wireframe_create(&frame.once, &frame.model, error) ||
        !wireframe_create(&frame.every, &frame.model, error)) {
        return false;
    }
    frame.once.side_count = keep_one_of_each(frame.once.sides, frame.once.side_count);
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
