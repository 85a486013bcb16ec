/* The figures and tables of BEYOND.md; a part of figures.c. */
#include "../tests/bench/timing.h"

#include <stdio.h>

enum { SHADOW_SIDE = 800, EXACT_SIDE = 400, RUNS = 9 };

/* The camera and the light of the scene `shadow`, and a pipeline that keeps its depths. */
static bool begin_shadow(struct drawing *drawing, struct model *model, struct pipeline *pipeline,
                         struct image *image, size_t side, struct error *error) {
    *drawing = make_drawing(model);
    drawing->light = (struct vec3){-1, 1, 1};
    drawing->state = pipeline;
    bool done = load_textures(drawing, model, error) &&
                image_create(image, side, side, IMAGE_BGR, error) &&
                pipeline_create(pipeline, side, side, error);
    pipeline->keep_depth = true;
    return done;
}

/* Face and shoulder, with biases of 0, 0.01 and 0.1. */
static bool draw_shadow_figure(struct model *model, const char *directory, struct error *error) {
    static const double biases[] = {0, 0.01, 0.1};
    const struct detail detail = {.x = 240, .y = 170, .width = 360, .height = 420, .zoom = 1};
    struct sheet sheet = {.width = 360, .height = 420, .columns = 3, .rows = 1, .gap = 4};
    struct drawing drawing;
    struct pipeline pipeline = {0};
    struct image image = {0};
    bool done = sheet_create(&sheet, error) &&
                begin_shadow(&drawing, model, &pipeline, &image, SHADOW_SIDE, error);
    for (int i = 0; done && i < 3; i++) {
        image_clear(&image, (struct color){0, 0, 0, 0});
        done = draw_with_map(&drawing, &image, 1024, biases[i], &shadowed, error);
        sheet_add_detail(&sheet, &image, detail);
    }
    done = done && figure_save(&sheet.image, directory, "shadow", error);
    sheet_free(&sheet);
    image_free(&image);
    pipeline_free(&pipeline);
    return done;
}

/* ---- The shadow map against rays ---- */

/* What the map says, in place of a colour: red where it says shadow, green where the surface faces
 * the light, so that it matters; blue where there is a surface. */
static lanes_mask say_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct shadow_uniforms *u = uniforms;
    lanes no = lanes_all(0), yes = lanes_all(255);
    lanes facing = lanes3_dot(mapped_normal(&u->lit, varyings), lanes3_all(u->lit.to_light));
    *color = lanes_rgb(lanes_select(in_shadow(u, varyings), yes, no),
                       lanes_select(facing > 0, yes, no), yes);
    return lanes_all_set();
}

static const struct shader say = {
    .varying_count = 8, .vertex = shadow_vertex, .fragment = say_fragment};

/* Twice the area of a, b, p as the light sees them, with a sign. */
static double light_area(struct vec3 a, struct vec3 b, struct vec3 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/* Does the ray that leaves a place along z, towards the light, meet the face? */
static bool ray_meets(const struct vec3 corner[3], struct vec3 place) {
    /* So that a face does not meet itself: corners were moved by up to 1/512 pixel to be drawn. */
    const double far_enough = 3e-4;
    double a = light_area(corner[1], corner[2], place);
    double b = light_area(corner[2], corner[0], place);
    double c = light_area(corner[0], corner[1], place);
    bool inside = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    double z = (a * corner[0].z + b * corner[1].z + c * corner[2].z) / (a + b + c);
    return inside && z > place.z + far_enough;
}

static struct vec3 transformed(const struct mat4 *matrix, struct vec3 p) {
    struct vec4 r = mat4_point(matrix, p);
    return (struct vec3){r.x / r.w, r.y / r.w, r.z / r.w};
}

/* The truth for each pixel that the eye sees: is its place in the shadow? Every face is asked. */
static bool find_shadows(const struct drawing *drawing, const struct mat4 *to_clip, bool *shadow) {
    const struct pipeline *pipeline = drawing->state;
    const struct model *model = drawing->model;
    const struct draw_call light = light_call(model, drawing->light, 1);
    struct vec3(*faces)[3] = calloc(model->face_count, sizeof *faces);
    struct mat4 to_world;
    bool done = faces != NULL && mat4_inverse(*to_clip, &to_world);
    for (size_t i = 0; done && i < 3 * model->face_count; i++) {
        faces[i / 3][i % 3] = transformed(&light.to_clip, model_position(model, i / 3, i % 3));
    }
    for (size_t i = 0; done && i < EXACT_SIDE * EXACT_SIDE; i++) {
        struct vec3 on_screen = {2 * ((double)(i % EXACT_SIDE) + 0.5) / EXACT_SIDE - 1,
                                 2 * ((double)(i / EXACT_SIDE) + 0.5) / EXACT_SIDE - 1,
                                 pipeline->depth[i]};
        shadow[i] = false;
        if (pipeline->depth[i] > -INFINITY) {
            struct vec3 place = transformed(&light.to_clip, transformed(&to_world, on_screen));
            for (size_t face = 0; !shadow[i] && face < model->face_count; face++) {
                shadow[i] = ray_meets(faces[face], place);
            }
        }
    }
    free(faces);
    return done;
}

/* Shares of the pixels that face the light, in percent. */
struct wrong {
    double dark, lit;
};

static struct wrong compare_shadows(const struct image *said, const bool *shadow) {
    size_t facing = 0, dark = 0, lit = 0;
    for (size_t i = 0; i < EXACT_SIDE * EXACT_SIDE; i++) {
        const uint8_t *pixel = said->pixels + i * IMAGE_BGR;
        if (pixel[1] > 0) {
            facing++;
            dark += pixel[2] > 0 && !shadow[i];
            lit += pixel[2] == 0 && shadow[i];
        }
    }
    return (struct wrong){100 * (double)dark / (double)facing, 100 * (double)lit / (double)facing};
}

/* The shortest of some runs, in milliseconds, of drawing with a map; NAN where one fails. */
static double time_with_map(struct drawing *drawing, struct image *image, int side,
                            struct error *error) {
    double best = INFINITY;
    for (int run = 0; run < RUNS; run++) {
        struct stopwatch start = stopwatch_start();
        if (!draw_with_map(drawing, image, side, 0.01, &shadowed, error)) {
            return NAN;
        }
        best = fmin(best, 1e3 * stopwatch_seconds(start));
    }
    return best;
}

static bool print_shadow_rows(struct drawing *drawing, struct image *image, const bool *shadow,
                              struct error *error) {
    static const double biases[] = {0, 0.003, 0.01, 0.03, 0.1};
    printf(
        "wrongly dark + wrongly lit, percent of the pixels that face the light\n"
        "map     bias 0         0.003          0.01           0.03           0.1            ms\n");
    for (int side = 256; side <= 2048; side *= 2) {
        printf("%-6d", side);
        for (int i = 0; i < 5; i++) {
            if (!draw_with_map(drawing, image, side, biases[i], &say, error)) {
                return false;
            }
            struct wrong wrong = compare_shadows(image, shadow);
            printf("%6.2f +%5.2f  ", wrong.dark, wrong.lit);
        }
        double ms = time_with_map(drawing, image, side, error);
        if (isnan(ms)) {
            return false;
        }
        printf("%6.1f\n", ms);
    }
    return true;
}

static bool print_shadow_table(struct model *model, struct error *error) {
    struct drawing drawing;
    struct pipeline pipeline = {0};
    struct image image = {0};
    bool *shadow = calloc(EXACT_SIDE * EXACT_SIDE, sizeof *shadow);
    if (shadow == NULL) {
        return error_set(error, "no exact shadows: out of memory");
    }
    bool done = begin_shadow(&drawing, model, &pipeline, &image, EXACT_SIDE, error) &&
                draw_with_map(&drawing, &image, 1, 0, &say, error); /* for the depths */
    if (done) {
        struct rectangle whole = grid_cell(EXACT_SIDE, EXACT_SIDE, 1, 1, 0, 0);
        struct draw_call call = pipeline_call(&drawing, whole, 0.85, CULL_BACK);
        done = find_shadows(&drawing, &call.to_clip, shadow) ||
               error_set(error, "no exact shadows: out of memory");
    }
    done = done && print_shadow_rows(&drawing, &image, shadow, error);
    free(shadow);
    image_free(&image);
    pipeline_free(&pipeline);
    return done;
}

/* ---- Samples ---- */

enum { SAMPLED_SIDE = 200, EXACT_SAMPLES = 16 };

/* The parts of a figure about samples: a picture of the head, and what it should be. */
struct sampled {
    struct drawing drawing;
    struct image image, exact;
    struct image samples; /* of the exact one */
};

static bool draw_one(struct sampled *sampled, int side, enum averaging averaging,
                     struct error *error) {
    struct rectangle whole = {0, 0, SAMPLED_SIDE, SAMPLED_SIDE};
    return draw_sampled(&sampled->drawing, &sampled->image, whole, side, averaging, error);
}

/* The picture from 256 samples a pixel, which are kept. */
static bool begin_samples(struct sampled *sampled, struct model *model, struct error *error) {
    enum { LARGE = SAMPLED_SIDE * EXACT_SAMPLES };
    struct rectangle whole = {0, 0, SAMPLED_SIDE, SAMPLED_SIDE};
    sampled->drawing = make_drawing(model);
    bool done = load_textures(&sampled->drawing, model, error) &&
                image_create(&sampled->image, SAMPLED_SIDE, SAMPLED_SIDE, IMAGE_BGR, error) &&
                image_create(&sampled->exact, SAMPLED_SIDE, SAMPLED_SIDE, IMAGE_BGR, error) &&
                image_create(&sampled->samples, LARGE, LARGE, IMAGE_BGRA, error) &&
                draw_head(&sampled->drawing, &sampled->samples, error);
    if (done) {
        average_into(&sampled->exact, whole, &sampled->samples, EXACT_SAMPLES, MEAN_OF_LIGHT);
    }
    return done;
}

/* A piece of the shoulder, enlarged. Above 1, 4 and 16 samples; below 256, and 4 and 16
 * of which the values were averaged. */
static bool draw_samples_figure(struct sampled *sampled, const char *directory,
                                struct error *error) {
    static const int sides[] = {1, 2, 4, 0, 2, 4};
    const struct detail detail = {.x = 132, .y = 36, .width = 40, .height = 40, .zoom = 8};
    struct sheet sheet = {.width = 320, .height = 320, .columns = 3, .rows = 2, .gap = 4};
    bool done = sheet_create(&sheet, error);
    for (int i = 0; done && i < 6; i++) {
        done = sides[i] == 0 ||
               draw_one(sampled, sides[i], i < 3 ? MEAN_OF_LIGHT : MEAN_OF_VALUES, error);
        if (done) {
            sheet_add_detail(&sheet, sides[i] == 0 ? &sampled->exact : &sampled->image, detail);
        }
    }
    done = done && figure_save(&sheet.image, directory, "samples", error);
    sheet_free(&sheet);
    return done;
}

/* Is a pixel on the outline: do some of its 256 samples show the head, and some not? */
static bool on_outline(const struct image *samples, int x, int y) {
    int count = 0;
    for (int i = 0; i < EXACT_SAMPLES * EXACT_SAMPLES; i++) {
        count += image_get(samples, x * EXACT_SAMPLES + i % EXACT_SAMPLES,
                           y * EXACT_SAMPLES + i / EXACT_SAMPLES)
                     .a > 0;
    }
    return count > 0 && count < EXACT_SAMPLES * EXACT_SAMPLES;
}

static double squared_difference(struct color a, struct color b) {
    return ((a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b)) /
           3.0;
}

/* Root mean square of the error on the outline, and its pixels. */
static double outline_error(const struct sampled *sampled, int *pixels) {
    double sum = 0;
    *pixels = 0;
    for (int i = 0; i < SAMPLED_SIDE * SAMPLED_SIDE; i++) {
        int x = i % SAMPLED_SIDE, y = i / SAMPLED_SIDE;
        if (on_outline(&sampled->samples, x, y)) {
            sum += squared_difference(image_get(&sampled->image, x, y),
                                      image_get(&sampled->exact, x, y));
            ++*pixels;
        }
    }
    return sqrt(sum / *pixels);
}

/* The error and the shortest time of some runs. */
static bool print_sampled(struct sampled *sampled, int side, enum averaging averaging,
                          struct error *error) {
    double best = INFINITY;
    int pixels;
    for (int run = 0; run < RUNS; run++) {
        struct stopwatch start = stopwatch_start();
        if (!draw_one(sampled, side, averaging, error)) {
            return false;
        }
        best = fmin(best, 1e3 * stopwatch_seconds(start));
    }
    printf("%10.1f %7.1f", outline_error(sampled, &pixels), best);
    return true;
}

static bool print_samples_table(struct sampled *sampled, struct error *error) {
    static const int sides[] = {1, 2, 4, 8, 16};
    int pixels;
    bool done = true;
    outline_error(sampled, &pixels);
    printf("\nRMSE on the outline (%d pixels), and ms\n"
           "samples     light      ms    values      ms\n",
           pixels);
    for (int i = 0; done && i < 5; i++) {
        printf("%-7d", sides[i] * sides[i]);
        done = print_sampled(sampled, sides[i], MEAN_OF_LIGHT, error) &&
               print_sampled(sampled, sides[i], MEAN_OF_VALUES, error);
        printf("\n");
    }
    return done;
}

static bool show_samples(struct model *model, const char *directory, struct error *error) {
    struct sampled sampled = {0};
    bool done = begin_samples(&sampled, model, error) &&
                draw_samples_figure(&sampled, directory, error) &&
                print_samples_table(&sampled, error);
    image_free(&sampled.image);
    image_free(&sampled.exact);
    image_free(&sampled.samples);
    return done;
}
