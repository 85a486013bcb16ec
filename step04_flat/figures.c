/* The pictures of step 4's README that are not references, and the numbers of its tables. */
#include "../tests/bench/figures.h"

#define LESSON "../step04_flat/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

#include <stdio.h>
#include <stdlib.h>

typedef double intensity_function(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                  struct vec3 light);

/* The face_intensity() of main.c, in the form of the attempts. */
static double intensity_of_main(struct vec3 w0, struct vec3 w1, struct vec3 w2, struct vec3 light) {
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(w2, w0), vec3_sub(w1, w0)));
    return vec3_dot(normal, light);
}

static double intensity_of_face(const struct model *model, size_t face, intensity_function *find,
                                struct vec3 light) {
    return find(model_position(model, face, 0), model_position(model, face, 1),
                model_position(model, face, 2), light);
}

/* draw_flat() with another intensity. */
static void draw_with(const struct model *model, intensity_function *find, struct vec3 light,
                      struct image *image) {
    image_clear(image, color_grey(0));
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = intensity_of_face(model, face, find, light);
        if (intensity > 0 && place_face(model, face, image, vertices)) {
            triangle(image, vertices, color_grey(level_from(intensity * 255)));
        }
    }
}

static bool draw_picture(const struct model *model, intensity_function *find, struct vec3 light,
                         const char *directory, const char *name, struct error *error) {
    struct image image;
    if (!image_create(&image, 400, 400, IMAGE_BGR, error)) {
        return false;
    }
    draw_with(model, find, light, &image);
    bool done = figure_save(&image, directory, name, error);
    image_free(&image);
    return done;
}

/* Attempt 1 as it is, and many times brighter, so that something can be seen. */
static double intensity_of_area(struct vec3 w0, struct vec3 w1, struct vec3 w2, struct vec3 light) {
    return 100 * attempt_1_not_normalized(w0, w1, w2, light);
}

static bool draw_not_normalized(const struct model *model, const char *directory,
                                struct error *error) {
    static intensity_function *const shown[2] = {attempt_1_not_normalized, intensity_of_area};
    struct sheet sheet = {.width = 400, .height = 400, .columns = 2, .rows = 1, .gap = 4};
    bool done = sheet_create(&sheet, error);
    for (int i = 0; done && i < 2; i++) {
        draw_with(model, shown[i], (struct vec3){0, 0, -1}, &sheet.panel);
        sheet_add(&sheet);
    }
    done = done && figure_save(&sheet.image, directory, "not_normalized", error);
    sheet_free(&sheet);
    return done;
}

/* Paint magenta what shows a face although another lies before it there. The nearest face of each
 * pixel is found with a depth for every pixel: that is lesson 5. */
static void mark_faults(const struct model *model, struct image *image, double *nearest,
                        double *shown) {
    size_t pixel_count = image->width * image->height;
    for (size_t i = 0; i < pixel_count; i++) {
        nearest[i] = shown[i] = -INFINITY;
    }
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        if (!(face_intensity(model, face, (struct vec3){0, 0, -1}) > 0) ||
            !place_face(model, face, image, v) ||
            !edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                         image->height)) {
            continue;
        }
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            struct span span = edges_span(&edges, y);
            for (int x = span.begin; x < span.end; x++) {
                size_t i = (size_t)y * image->width + (size_t)x;
                shown[i] =
                    interpolate(edges_weights(&edges, x, y), model_position(model, face, 0).z,
                                model_position(model, face, 1).z, model_position(model, face, 2).z);
                nearest[i] = fmax(nearest[i], shown[i]);
            }
        }
    }
    size_t faults = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        if (shown[i] < nearest[i]) {
            image_set(image, (int)(i % image->width), (int)(i / image->width),
                      color_rgb(255, 0, 160));
            faults++;
        }
    }
    printf("%zu pixels show a face that lies behind another\n", faults);
}

/* What is still wrong: parts that lie behind others are painted over them. */
static bool draw_faults(const struct model *model, const char *directory, struct error *error) {
    const struct detail ear = {490, 420, 110, 160, .zoom = 4};
    const struct detail head = {190, 200, 420, 600, .zoom = 1};
    struct image image = {0};
    double *nearest = malloc(800 * 800 * sizeof *nearest);
    double *shown = malloc(800 * 800 * sizeof *shown);
    bool done = nearest != NULL && shown != NULL;
    if (!done) {
        error_out_of_memory(error);
    }
    done = done && image_create(&image, 800, 800, IMAGE_BGR, error);
    if (done) {
        draw_with(model, intensity_of_main, (struct vec3){0, 0, -1}, &image);
        done = figure_save_detail(&image, ear, directory, "detail_ear", error);
    }
    if (done) {
        mark_faults(model, &image, nearest, shown);
        done = figure_save_detail(&image, head, directory, "faults", error);
    }
    free(nearest);
    free(shown);
    image_free(&image);
    return done;
}

/* A number in -1..1 that looks random (always the same ones): a linear congruential generator, with
 * the constants of Knuth, "The Art of Computer Programming", volume 2, section 3.3.4. */
static double random_number(uint32_t *seed) {
    *seed = *seed * 1664525U + 1013904223U;
    return (double)(*seed >> 8) / 0x1p23 - 1;
}

static struct vec3 random_vector(uint32_t *seed, double size) {
    double x = random_number(seed), y = random_number(seed), z = random_number(seed);
    return vec3_scale((struct vec3){x, y, z}, size);
}

static int compare_numbers(const void *left, const void *right) {
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* In degrees, at corner 0. */
static double angle_of_face(struct vec3 w0, struct vec3 w1, struct vec3 w2) {
    struct vec3 a = vec3_normalized(vec3_sub(w1, w0)), b = vec3_normalized(vec3_sub(w2, w0));
    return atan2(vec3_length(vec3_cross(a, b)), vec3_dot(a, b)) * 90 / acos(0);
}

/* How far the grey values of an attempt lie from the right ones, for 100,000 small faces in all
 * directions. */
static void print_values(const char *name, intensity_function *find) {
    enum { FACES = 100000 };
    static double errors[FACES];
    const struct vec3 light = {0, 0, -1};
    size_t lit = 0, wrong = 0;
    int worst_value = 0;
    uint32_t seed = 1;
    double worst = 0, worst_angle = 0;
    for (int face = 0; face < FACES; face++) {
        struct vec3 w0 = random_vector(&seed, 0.9);
        struct vec3 w1 = vec3_add(w0, random_vector(&seed, 0.05));
        struct vec3 w2 = vec3_add(w0, random_vector(&seed, 0.05));
        double right = intensity_of_main(w0, w1, w2, light), found = find(w0, w1, w2, light);
        if (!(right > 0)) {
            continue;
        }
        int difference = abs(level_from(found * 255) - level_from(right * 255));
        wrong += difference != 0;
        worst_value = difference > worst_value ? difference : worst_value;
        errors[lit] = fabs(found - right);
        if (errors[lit] > worst) {
            worst = errors[lit];
            worst_angle = angle_of_face(w0, w1, w2);
        }
        lit++;
    }
    qsort(errors, lit, sizeof *errors, compare_numbers);
    printf("%-16s %zu faces lit, %5zu with a wrong value, worst by %d; n . l: typically wrong by "
           "%.1e, worst by %.1e (a face with an angle of %.1f degrees)\n",
           name, lit, wrong, worst_value, errors[lit / 2], worst, worst_angle);
}

/* A cylinder of many sides, lit from the front: neighbours differ by little, so that steps show.
 * The upper half is right, the lower half is the attempt's. */
static bool draw_cylinder(intensity_function *find, const char *directory, const char *name,
                          struct error *error) {
    enum { SIDES = 128, WIDTH = 512, HEIGHT = 120 };
    struct image image;
    if (!image_create(&image, WIDTH, HEIGHT, IMAGE_BGR, error)) {
        return false;
    }
    for (int side = 0; side < SIDES; side++) {
        struct vec2 a = turn_direction(0.5 * side / SIDES);
        struct vec2 b = turn_direction(0.5 * (side + 1) / SIDES);
        struct vec3 w0 = {-a.x, 0, a.y}, w1 = {-b.x, 0, b.y}, w2 = {-a.x, 1, a.y};
        int x_begin = (int)((1 - a.x) * WIDTH / 2), x_end = (int)((1 - b.x) * WIDTH / 2);
        for (int half = 0; half < 2; half++) {
            intensity_function *used = half == 1 ? intensity_of_main : find;
            double intensity = used(w0, w1, w2, (struct vec3){0, 0, -1});
            for (int y = half * HEIGHT / 2; y < (half + 1) * HEIGHT / 2; y++) {
                for (int x = x_begin; x < x_end; x++) {
                    image_set(&image, x, y, color_grey(level_from(intensity * 255)));
                }
            }
        }
    }
    bool done = figure_save(&image, directory, name, error);
    image_free(&image);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    const struct vec3 front = {0, 0, -1}, side = vec3_normalized((struct vec3){1, 0, -1});
    print_values("4 float", attempt_4_float);
    print_values("5 root, 0 steps", attempt_5_root_0);
    print_values("6 root, 1 step", attempt_6_root_1);
    print_values("7 root, 2 steps", attempt_7_root_2);
    return draw_not_normalized(bust, directory, error) &&
           draw_picture(bust, attempt_2_outward, front, directory, "outward", error) &&
           draw_picture(bust, attempt_3_absolute, front, directory, "absolute", error) &&
           draw_picture(bust, intensity_of_main, side, directory, "light_side", error) &&
           draw_cylinder(attempt_5_root_0, directory, "root_0_steps", error) &&
           draw_faults(bust, directory, error);
}
