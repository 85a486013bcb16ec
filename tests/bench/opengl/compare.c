/*
 * Draws the scenes of lessons 4 to 10 a second time, with OpenGL (Mesa, no window), and compares:
 *
 *     compare-opengl [DIR]
 *
 * With DIR, Mesa's picture of each scene is written there as PNG. Exit status 0: the same pixels
 * are covered everywhere and no value of a channel differs by more than 1; 1: something differs; 2:
 * Mesa is missing.
 *
 * Mesa draws each scene twice. With the plain matrices it places the corners itself, in float: now
 * and then it snaps one to the next 1/256 pixel, and a pixel or two change sides; more than one in
 * PLAIN_BOUND is an error. Told the positions that the course has snapped, Mesa must cover the same
 * pixels; everything else is compared in this second picture.
 *
 * Coverage is compared for every face, hidden ones too: at each pixel the number of faces that
 * cover it and the sum of their numbers must agree, a pixel of the lesson's own picture must be
 * drawn exactly where Mesa draws one, and the nearest face must be the same.
 *
 * Mesa computes with floats of 24 bits and the course with doubles: a value close to a half may be
 * rounded to the next one. Where a formula jumps (nearest texel, toon step, the edge of the light),
 * scene.glsl says so, and the pixel may be on either side; the table of scenes says how many may.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "mesa.h"

#include "bench/timing.h"
#include "files/png.h"
#include "run/stage.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STATUS_SAME = 0, STATUS_DIFFERENT = 1, STATUS_MISSING = 2 };
enum { PLAIN_BOUND = 500, REPEATS = 15 };

/* Pixels that are counted, over all frames of a scene. */
enum count {
    COVERED,        /* show a face */
    LAYERS,         /* of all faces, hidden ones too */
    PLAIN_COVERAGE, /* covered differently when Mesa places the corners itself */
    COVERAGE,       /* and when it is told the snapped positions */
    OTHER_FACE,     /* another face is seen */
    AT_JUMP,        /* a value differs by more than 1 at a jump */
    BEYOND_BOUND,   /* and where there is no jump */
    DIFFERENT,      /* a value differs by any amount, other than at a jump */
    COUNTS
};

struct findings {
    size_t count[COUNTS];
    int largest; /* difference of values, other than at a jump */
    double ours_ms, mesa_ms;
};

struct comparison {
    struct mesa mesa;
    const char *directory; /* for pictures; or NULL */
    struct error error;
    struct findings total;
    bool good;
    /* Of the scene that is compared. */
    const struct compared_scene *scene;
    struct stage stage;
    struct image image;
    struct picture picture;
    struct seen ours, mesas; /* what the lesson draws; what Mesa draws */
    struct findings found;
    size_t pixel_count;
};

/* ---- The lesson's own picture ---- */

/* Over a background that is all black or all white. */
static bool draw_over(struct comparison *c, uint8_t value) {
    memset(c->image.pixels, value, c->pixel_count * c->image.format);
    c->stage.drawing.counter_count = 0;
    return stage_draw(&c->stage, &c->image, c->stage.drawing.frame, &c->error);
}

/* Which pixels it has drawn: those that are the same over black and over white. */
static bool draw_lesson(struct comparison *c) {
    const size_t format = c->image.format;
    struct image white = {0};
    bool done = draw_over(c, 255) && image_copy(&white, &c->image, &c->error) && draw_over(c, 0);
    for (size_t i = 0; done && i < c->pixel_count; i++) {
        const uint8_t *bgr = c->image.pixels + i * format;
        bool drawn = c->scene->fills ? c->stage.drawing.depth[i] > -INFINITY
                                     : memcmp(bgr, white.pixels + i * format, format) == 0;
        c->ours.pixels[i] =
            (struct rgba){bgr[format == IMAGE_GREY ? 0 : 2], bgr[format == IMAGE_GREY ? 0 : 1],
                          bgr[0], drawn ? 255 : 0};
    }
    image_free(&white);
    return done;
}

/* All faces by the course's edges. */
static void cover(struct comparison *c, const struct gl_part *part, const struct gl_corner *v,
                  const struct edges *edges) {
    const struct rectangle *r = &part->viewport;
    const struct span columns = {r->x, r->x + r->width};
    const struct span rows = span_overlap((struct span){edges->y_begin, edges->y_end},
                                          (struct span){r->y, r->y + r->height});
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span = span_overlap(edges_span(edges, y), columns);
        for (int x = span.begin; x < span.end; x++) {
            size_t i = (size_t)y * c->picture.width + (size_t)x;
            double depth =
                interpolate_depth(edges_weights(edges, x, y), v[0].depth, v[1].depth, v[2].depth);
            c->ours.layers[i][0] += 1;
            c->ours.layers[i][1] += v->face;
            if (part->no_depth_test || depth > c->ours.depths[i]) {
                c->ours.faces[i] = v->face;
                c->ours.depths[i] = depth;
            }
        }
    }
}

static void cover_all(struct comparison *c) {
    const struct picture *picture = &c->picture;
    for (size_t i = 0; i < picture->part_count; i++) {
        const struct gl_part *part = &picture->parts[i];
        for (size_t k = part->first; k < part->first + part->count; k += 3) {
            const struct gl_corner *v = &picture->corners[k];
            struct edges edges;
            if (edges_setup(&edges, v[0].screen, v[1].screen, v[2].screen, picture->width,
                            picture->height) &&
                part->cull != (edges.clockwise ? CULL_BACK : CULL_FRONT)) {
                cover(c, part, v, &edges);
            }
        }
    }
}

/* ---- Comparing ---- */

/* Lesson 5 shows depth as grey: the farthest that is seen is 55, the nearest 255, nothing 0. The
 * same for Mesa's depths. */
static void show_depths(struct comparison *c) {
    const double *depths = c->mesas.depths;
    double far = 1, near = 0;
    for (size_t i = 0; i < c->pixel_count; i++) {
        far = depths[i] > 0 ? fmin(far, depths[i]) : far;
        near = fmax(near, depths[i]);
    }
    for (size_t i = 0; i < c->pixel_count; i++) {
        double value = 55 + (depths[i] - far) * 200 / (near > far ? near - far : 1);
        memset(&c->mesas.pixels[i], depths[i] > 0 ? level_from(value) : 0, 3);
    }
}

static size_t count_coverage(const struct comparison *c) {
    const struct seen *ours = &c->ours, *mesas = &c->mesas;
    size_t different = 0;
    for (size_t i = 0; i < c->pixel_count; i++) {
        bool drawn = ours->pixels[i].a > 0;
        different += drawn != (mesas->pixels[i].a > 0) || drawn != (ours->faces[i] > 0) ||
                     ours->layers[i][0] != mesas->layers[i][0] ||
                     ours->layers[i][1] != mesas->layers[i][1];
    }
    return different;
}

static int value_difference(struct rgba p, struct rgba q) {
    int red = abs(p.r - q.r), green = abs(p.g - q.g), blue = abs(p.b - q.b);
    int larger = red > green ? red : green;
    return larger > blue ? larger : blue;
}

static void compare_pixels(struct comparison *c) {
    struct findings *f = &c->found;
    for (size_t i = 0; i < c->pixel_count; i++) {
        const struct rgba ours = c->ours.pixels[i], mesas = c->mesas.pixels[i];
        int difference = value_difference(ours, mesas);
        f->count[LAYERS] += (size_t)c->ours.layers[i][0];
        if (ours.a == 0 || mesas.a == 0) {
            continue;
        }
        f->count[COVERED]++;
        if (c->ours.faces[i] != c->mesas.faces[i]) {
            f->count[OTHER_FACE]++;
        } else if (difference > 1 && mesas.a == 254) {
            f->count[AT_JUMP]++;
        } else {
            f->count[BEYOND_BOUND] += difference > 1;
            f->count[DIFFERENT] += difference > 0;
            f->largest = difference > f->largest ? difference : f->largest;
        }
    }
}

/* ---- One scene ---- */

/* Mesa's picture, for the eye. */
static bool save(struct comparison *c) {
    const int width = (int)c->image.width;
    char path[1024];
    for (int i = 0; i < (int)c->pixel_count; i++) {
        const struct rgba p = c->mesas.pixels[i];
        image_set(&c->image, i % width, i / width, color_rgb(p.r, p.g, p.b));
    }
    snprintf(path, sizeof path, "%s/%s_%s.png", c->directory, c->stage.program->name,
             c->scene->name);
    return png_write(&c->image, path, &c->error);
}

/* The medians of several drawings, which take turns. Mesa draws with the plain matrices, as a
 * program would. Reading the depths back and showing them is part of its time. */
static bool measure(struct comparison *c) {
    double ours[REPEATS], mesas[REPEATS];
    for (int i = 0; i < REPEATS; i++) {
        double begin = now();
        if (!draw_over(c, 0)) {
            return false;
        }
        double middle = now();
        mesa_draw(&c->mesa, false);
        if (c->scene->shows_depth) {
            mesa_read_depths(&c->mesa, &c->mesas);
            show_depths(c);
        }
        mesas[i] = now() - middle;
        ours[i] = middle - begin;
    }
    sort_doubles(ours, REPEATS);
    sort_doubles(mesas, REPEATS);
    c->found.ours_ms = 1e3 * quantile(ours, REPEATS, 0.5);
    c->found.mesa_ms = 1e3 * quantile(mesas, REPEATS, 0.5);
    return true;
}

/* Both pictures of the frame that is loaded. */
static bool compare_loaded(struct comparison *c) {
    cover_all(c);
    if (!mesa_draw_all(&c->mesa, false, &c->mesas)) {
        return false;
    }
    c->found.count[PLAIN_COVERAGE] += count_coverage(c);
    if (!mesa_draw_all(&c->mesa, true, &c->mesas)) {
        return false;
    }
    if (c->scene->shows_depth) {
        show_depths(c);
    }
    c->found.count[COVERAGE] += count_coverage(c);
    compare_pixels(c);
    return c->stage.drawing.frame > 0 || ((c->directory == NULL || save(c)) && measure(c));
}

static bool compare_frame(struct comparison *c) {
    c->picture = (struct picture){
        .width = c->image.width,
        .height = c->image.height,
        .drawing = &c->stage.drawing,
        .image = &c->image,
        .draw = c->stage.scene.draw,
        .error = &c->error,
    };
    bool done = seen_create(&c->ours, c->pixel_count, &c->error) &&
                seen_create(&c->mesas, c->pixel_count, &c->error) && draw_lesson(c) &&
                c->scene->build(&c->picture) && mesa_load(&c->mesa, &c->picture) &&
                compare_loaded(c);
    picture_free(&c->picture);
    seen_free(&c->ours);
    seen_free(&c->mesas);
    return done;
}

static bool draw_frames(struct comparison *c, struct run *run, const struct scene *given) {
    struct scene scene = scene_complete(run->program, given);
    scene.draw = c->scene->rest != NULL ? c->scene->rest : scene.draw;
    c->pixel_count = scene.width * scene.height;
    c->found = (struct findings){0};
    bool done = image_create(&c->image, scene.width, scene.height, scene.format, &c->error) &&
                stage_begin(&c->stage, run, &scene, scene.width, scene.height, &c->error);
    for (size_t i = 0; done && i < scene.frames; i++) {
        c->stage.drawing.frame = i;
        done = compare_frame(c);
    }
    stage_end(&c->stage);
    image_free(&c->image);
    return done;
}

/* ---- All scenes ---- */

static void print_findings(const char *lesson, const char *scene, const struct findings *f,
                           bool good) {
    const size_t *count = f->count;
    printf("%s %s: coverage differs in %zu pixels, largest difference %d (in %zu of %zu pixels, "
           "%zu with hidden faces), ours %.2f ms, Mesa %.2f ms; with plain matrices coverage "
           "differs in %zu; other side of a jump in %zu; more than 1 in %zu, other face in %zu%s\n",
           lesson, scene, count[COVERAGE], f->largest, count[DIFFERENT], count[COVERED],
           count[LAYERS], f->ours_ms, f->mesa_ms, count[PLAIN_COVERAGE], count[AT_JUMP],
           count[BEYOND_BOUND], count[OTHER_FACE], good ? "" : ": WRONG");
    fflush(stdout);
}

/* Are they as the table of scenes has it? */
static bool findings_are_good(const struct comparison *c) {
    const size_t *count = c->found.count, jumps = c->scene->jumps > 0 ? c->scene->jumps : 1;
    return count[COVERAGE] == 0 && count[OTHER_FACE] == 0 && count[BEYOND_BOUND] == 0 &&
           count[COVERED] > 0 && count[PLAIN_COVERAGE] * PLAIN_BOUND <= count[COVERED] &&
           count[AT_JUMP] * 10000 <= count[COVERED] * jumps;
}

static void add_to_total(struct comparison *c) {
    for (int i = 0; i < COUNTS; i++) {
        c->total.count[i] += c->found.count[i];
    }
    c->total.ours_ms += c->found.ours_ms;
    c->total.mesa_ms += c->found.mesa_ms;
    c->total.largest = c->found.largest > c->total.largest ? c->found.largest : c->total.largest;
}

static bool compare_scene(struct comparison *c, const struct lesson *lesson, struct run *run,
                          const struct scene *scene) {
    const char *name = lesson->program->name;
    c->scene = lesson->scenes;
    while (c->scene->name != NULL && strcmp(c->scene->name, scene->name) != 0) {
        c->scene++;
    }
    if (c->scene->left_out != NULL) {
        printf("%s %s: %s: %s\n", name, scene->name,
               c->scene->build != NULL ? "left out" : "not compared", c->scene->left_out);
    }
    if (c->scene->build == NULL) {
        return c->scene->left_out != NULL ||
               error_set(&c->error, "scene %s is missing in the table of opengl.c", scene->name);
    }
    if (!draw_frames(c, run, scene)) {
        return false;
    }
    bool good = findings_are_good(c);
    print_findings(name, scene->name, &c->found, good);
    c->good = c->good && good;
    add_to_total(c);
    return true;
}

static bool compare_lesson(struct comparison *c, const struct lesson *lesson) {
    struct run run = {.program = lesson->program};
    bool done = true;
    for (size_t i = 0; done && i < lesson->program->scene_count; i++) {
        const struct scene *scene = &lesson->program->scenes[i];
        done = scene->extra || compare_scene(c, lesson, &run, scene);
    }
    run_free(&run);
    return done;
}

static int compare_all(struct comparison *c) {
    printf("%s\n", c->mesa.context.name);
    for (size_t i = 0; lessons[i] != NULL; i++) {
        if (!compare_lesson(c, lessons[i])) {
            fprintf(stderr, "compare-opengl: %s: %s\n", lessons[i]->program->name,
                    c->error.message);
            return STATUS_DIFFERENT;
        }
    }
    print_findings("all", "scenes", &c->total, c->good);
    printf("Times: medians of %d draws on this machine, both on the CPU. Mesa's are with the plain "
           "matrices;\nthe light at corners is computed beforehand for Mesa, and in our time.\n",
           REPEATS);
    return c->good ? STATUS_SAME : STATUS_DIFFERENT;
}

int main(int argc, char **argv) {
    struct comparison c = {.good = true, .directory = argc > 1 ? argv[1] : NULL};
    int status = STATUS_MISSING;
    if (mesa_open(&c.mesa, &c.error)) {
        status = compare_all(&c);
    } else {
        fprintf(stderr,
                "compare-opengl: %s\nInstall Mesa; on Debian: apt-get install libegl-dev libgl-dev "
                "libegl-mesa0 libgl1-mesa-dri\n",
                c.error.message);
    }
    mesa_close(&c.mesa);
    return status;
}
