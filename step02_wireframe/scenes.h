/*
 * Lesson 2, the given part: its scenes and the program.
 *
 * `square` draws the sides of two faces, `points` the positions of a model as pixels, and
 * `wireframe` its sides, white on black. `border` draws a quarter of its faces and `enlarged` the
 * model much larger than the image, in images that are not square. `cut` draws single lines, and
 * `walked` how many pixels each of these and two long ones have in the image.
 */
#ifdef LINE_IS_MINE /* make LINE=mine: the line() of lesson 1 draws */
#include "run/mine.h"
#define line        my_line
#define line_inside my_line
#endif

#include "attempts.h"

/* What is drawn: a list of sides, made before the drawing. */
struct wireframe {
    struct side *sides;
    size_t side_count;
};

static bool is_greater(struct side a, struct side b) {
    return a.low > b.low || (a.low == b.low && a.high > b.high);
}

static struct side greatest_side(const struct side *sides, size_t side_count) {
    struct side greatest = {0, 0};
    for (size_t i = 0; i < side_count; i++) {
        greatest = is_greater(sides[i], greatest) ? sides[i] : greatest;
    }
    return greatest;
}

/* How many sides the model has, of faces and, behind these, lines of its file. */
static size_t sides_of(const struct model *model) {
    return 3 * model->face_count + model->line_count;
}

/* With --no-skip, a side that two faces share is in the list twice. Behind the list its greatest
 * side is repeated: code that reads beyond the end takes that for an equal one. */
static bool wireframe_create(struct wireframe *wireframe, const struct model *model, bool skip,
                             struct error *error) {
    size_t side_count = sides_of(model);
    wireframe->sides = calloc(side_count + 1, sizeof *wireframe->sides);
    if (wireframe->sides == NULL) {
        return error_set(error, "out of memory for %zu sides", side_count);
    }
    list_sides(model, wireframe->sides);
    for (size_t i = 0; i < model->line_count; i++) {
        uint32_t p = model->lines[i][0], q = model->lines[i][1];
        wireframe->sides[3 * model->face_count + i] = (struct side){p < q ? p : q, p < q ? q : p};
    }
    wireframe->sides[side_count] = greatest_side(wireframe->sides, side_count);
    wireframe->side_count = skip ? keep_one_of_each(wireframe->sides, side_count) : side_count;
    return true;
}

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    return drawing->model == NULL || /* the square, and single lines */
           wireframe_create(drawing->state, drawing->model, drawing->skip, error);
}

static void finish(struct drawing *drawing) {
    struct wireframe *wireframe = drawing->state;
    free(wireframe->sides);
}

/* ---- Points ---- */

enum { FAR_BOX = 8, FAR_STEP = 12 }; /* pixels of a side, and to the next box */

/* Far outside an image of this size: three positions within LINE_LIMIT, three exactly at it, the
 * others beyond. */
enum { FAR_WIDTH = 256, FAR_HEIGHT = 128 };
static const struct vec3 far_positions[] = {
    {4e6, 0, 0},        {0, -5e6, 0},     {-4e6, 5e6, 0}, {4194303.004, 0, 0},
    {0, 8388607, 0},    {0, -8388609, 0}, {6e6, 0, 0},    {0, -1e7, 0},
    {-4194303, 1e7, 0}, {-1e30, 0, 0},    {0, 1e30, 0},   {1e30, -1e30, 0},
};
enum { FAR_POSITIONS = sizeof far_positions / sizeof far_positions[0] };

/* A box at the top left for each of these that has a pixel: green, or a little bluer where the
 * pixel's x or y is odd; red, for one that has none but whose pixel was changed. */
static void draw_far_positions(struct image *image) {
    for (int i = 0; i < FAR_POSITIONS; i++) {
        struct pixel pixel = {-7, -7};
        bool found = to_pixel(far_positions[i], FAR_WIDTH, FAR_HEIGHT, &pixel);
        if (!found && pixel.x == -7 && pixel.y == -7) {
            continue;
        }
        uint8_t blue = (uint8_t)((pixel.x & 1) * 128 + (pixel.y & 1) * 64);
        for (int k = 0; k < FAR_BOX * FAR_BOX; k++) {
            image_set(image, FAR_BOX / 2 + FAR_STEP * i + k % FAR_BOX,
                      (int)image->height - 2 * FAR_BOX + k / FAR_BOX,
                      found ? color_rgb(0, 255, blue) : color_rgb(255, 0, 0));
        }
    }
}

static bool draw_points(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_far_positions(image);
    for (size_t i = 0; i < drawing->model->position_count; i++) {
        struct pixel pixel;
        if (to_pixel(drawing->model->positions[i], image->width, image->height, &pixel)) {
            image_set(image, pixel.x, pixel.y, color_rgb(255, 255, 255));
        }
    }
    return true;
}

/* ---- Wireframes ---- */

/* What lies at (x,y) of the model comes to the middle of the image, `scale` times as large. */
struct view {
    double x, y, scale;
};

static struct vec3 seen(struct vec3 position, struct view view) {
    return (struct vec3){(position.x - view.x) * view.scale, (position.y - view.y) * view.scale,
                         position.z};
}

#define LINE_ATTEMPTS "0 line_inside(), 1 every pixel tested, 2 ends rounded"

/* Part b: by an attempt, or by what the lesson writes. */
static attempt_line *line_of(const struct drawing *drawing) {
    static attempt_line *const lines[] = {line_inside, line, attempt_line_ends_rounded};
    return lines[(int)drawing_value(drawing, "attempt")];
}

/* With line() in part a: what is written in part b can't spoil its pictures. */
static void draw_sides(struct drawing *drawing, const struct wireframe *wireframe,
                       const struct vec3 *positions, struct view view, attempt_line *draw,
                       struct image *image) {
    uint64_t drawn = 0, off_image = 0, too_far = 0;
    for (size_t i = 0; i < wireframe->side_count; i++) {
        struct side side = wireframe->sides[i];
        struct pixel a, b;
        if (!to_pixel(seen(positions[side.low], view), image->width, image->height, &a) ||
            !to_pixel(seen(positions[side.high], view), image->width, image->height, &b)) {
            too_far++;
            continue;
        }
        uint64_t walked = draw(image, a, b, color_rgb(255, 255, 255));
        /* line() draws whole lines, whatever it returns. */
        bool is_off = draw != line && walked == 0;
        drawing_count(drawing, "pixels_walked", walked);
        off_image += is_off;
        drawn += !is_off;
    }
    drawing_count(drawing, "lines_drawn", drawn);
    drawing_count(drawing, "lines_off_image", off_image);
    drawing_count(drawing, "lines_too_far", too_far);
}

static bool draw_wireframe(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct wireframe *wireframe = drawing->state;
    draw_sides(drawing, wireframe, drawing->model->positions, (struct view){0, 0, 1}, line, image);
    drawing_count(drawing, "lines_shared_skipped",
                  sides_of(drawing->model) - wireframe->side_count);
    return true;
}

static bool draw_part(struct drawing *drawing, const struct model *part, struct view view,
                      struct image *image, struct error *error) {
    struct wireframe wireframe = {0};
    bool made = wireframe_create(&wireframe, part, drawing->skip, error);
    if (made && drawing_value(drawing, "attempt") > 0) {
        wireframe.side_count = attempt_one_direction(part, wireframe.sides);
    }
    if (made) {
        draw_sides(drawing, &wireframe, part->positions, view, line, image);
        drawing_count(drawing, "lines_shared_skipped", sides_of(part) - wireframe.side_count);
    }
    free(wireframe.sides);
    return made;
}

/* Two faces, which share a side, of a model with many positions: the greatest number is
 * `greatest`. The first face is repeated, front and back, so its sides belong to many faces; the
 * other one comes last. */
static bool draw_two_faces(struct drawing *drawing, uint32_t greatest, size_t face_count,
                           struct view view, struct image *image, struct error *error) {
    enum { D = 1, B = 2, C = 501 };
    const uint32_t kinds[3][3] = {{greatest, B, C}, {C, B, greatest}, {greatest, C, D}};
    struct vec3 *positions = calloc(greatest + 1, sizeof *positions);
    struct face *faces = calloc(face_count, sizeof *faces);
    if (positions == NULL || faces == NULL) {
        free(positions);
        free(faces);
        return error_out_of_memory(error);
    }
    positions[greatest] = (struct vec3){-0.5, -0.5, 0};
    positions[B] = (struct vec3){0.5, -0.5, 0};
    positions[C] = (struct vec3){0.5, 0.5, 0};
    positions[D] = (struct vec3){-0.5, 0.5, 0};
    for (size_t i = 0; i < 3 * face_count; i++) {
        const uint32_t *corners = kinds[i / 3 == face_count - 1 ? 2 : i / 3 % 2];
        faces[i / 3].corner[i % 3].position = corners[i % 3];
    }
    const struct model model = {.positions = positions,
                                .position_count = greatest + 1,
                                .faces = faces,
                                .face_count = face_count};
    bool done = draw_part(drawing, &model, view, image, error);
    free(positions);
    free(faces);
    return done;
}

/* Once as it is; once so large that its upper right corner is seen, and others are far away; once
 * with its lower left corner some pixels, and a part of one, outside. Numbers of positions with up
 * to five digits, and more than 16 bits; and more sides than the bust has. */
static bool draw_square(struct drawing *drawing, struct image *image, struct error *error) {
    struct view whole = {0, 0, 1}, large = {0.5 - 2e-5, 0.5 - 2.4e-5, 3e4};
    return draw_two_faces(drawing, 1501, 3, whole, image, error) &&
           draw_two_faces(drawing, 10501, 3, large, image, error) &&
           draw_two_faces(drawing, 66037, 6000, (struct view){1.2836, 1.4869, 0.61}, image, error);
}

static const struct scene_value border_values[] = {
    {"attempt", "0 each side once, 1 sides in one direction", 0, 1, 1, 0},
    {.name = NULL},
};

/* A quarter of the faces: a mesh with a border. */
static bool draw_border(struct drawing *drawing, struct image *image, struct error *error) {
    struct model part = *drawing->model;
    part.faces += part.face_count / 8;
    part.face_count = (part.face_count + 3) / 4;
    part.line_count = 0;
    return draw_part(drawing, &part, (struct view){0.26, 0.1, 2.4}, image, error);
}

/* The middle of the window is a point to drag over the model. */
static const struct scene_value window_values[] = {
    {"middle_x", "middle of the window", -1, 1, 0.01, 0.08},
    {"middle_y", "middle of the window", -1, 1, 0.01, 0.42},
    {"larger", "times as large", 1, 40, 0.5, 6},
    {"attempt", LINE_ATTEMPTS, 0, 2, 1, 0},
    {.name = NULL},
};

/* One side of the face, six times as large: most of the model lies outside. */
static bool draw_enlarged(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct vec2 middle = drawing_point(drawing, "middle");
    draw_sides(drawing, drawing->state, drawing->model->positions,
               (struct view){middle.x, middle.y, drawing_value(drawing, "larger")},
               line_of(drawing), image);
    return true;
}

/* ---- Single lines ---- */

enum { CUT_WIDTH = 160, CUT_HEIGHT = 100, RIGHT = CUT_WIDTH - 1, TOP = CUT_HEIGHT - 1, WIDE = 300 };

enum line_color { WHITE, RED, GREEN, BLUE };

/* Lines that leave the image on every side, end on its outermost pixels, run along its edges, or
 * never come in. The ones along the edges lie below the others. */
static const struct cut_line {
    struct pixel a, b;
    enum line_color color;
} cut_lines[] = {
    /* along the edges */
    {{-5, 0}, {RIGHT + 5, 0}, GREEN},
    {{RIGHT + 1000000, TOP}, {-1000000, TOP}, GREEN},
    {{0, TOP + 9}, {0, -9}, GREEN},
    {{RIGHT, -1000000}, {RIGHT, 1000000}, GREEN},
    /* across all of the image, to its outermost pixels */
    {{0, 10}, {RIGHT, TOP - 10}, BLUE},
    {{0, TOP - 10}, {RIGHT, 10}, BLUE},
    {{30, TOP}, {50, 0}, BLUE},
    {{RIGHT - 30, 0}, {RIGHT - 50, TOP}, BLUE},
    /* in on the left, the right, at the bottom, at the top */
    {{-17, -9}, {RIGHT + 30, TOP + 22}, WHITE},
    {{RIGHT + 51, -14}, {-30, TOP + 29}, WHITE},
    {{RIGHT - 20, -40}, {33, TOP + 71}, WHITE},
    {{40, TOP + 90}, {RIGHT + 10, -301}, WHITE},
    {{-1000000, -612345}, {999999, 612421}, WHITE},
    {{-499979, 1000000}, {500121, -999901}, WHITE},
    /* one end inside, the other just outside the image, or far away */
    {{80, 50}, {RIGHT + 1, 77}, RED},
    {{80, 50}, {-1, 20}, RED},
    {{80, 50}, {101, TOP + 200}, RED},
    {{80, 50}, {48, -150}, RED},
    /* a tie in the first pixel inside */
    {{-2, 60}, {18, 65}, BLUE},
    {{18, 70}, {-2, 75}, BLUE},
    {{20, -5}, {21, 5}, BLUE},
    {{100, 90}, {120, 100}, WHITE}, /* ... and in the last one */
    {{100, -1}, {120, 9}, WHITE},
    /* in with its last step aside alone */
    {{10, -7}, {60, 0}, WHITE},
    {{RIGHT + 7, 90}, {RIGHT, 30}, WHITE},
    /* outside: left or right, above and below, past a corner */
    {{-9, -5}, {-1, TOP + 5}, WHITE},
    {{RIGHT + 1, -5}, {RIGHT + 1, TOP + 5}, WHITE},
    {{-5, TOP + 1}, {RIGHT + 9, TOP + 2}, WHITE},
    {{-5, -1}, {RIGHT + 9, -1}, WHITE},
    {{-70, 50}, {60, TOP + 80}, WHITE},
    {{RIGHT + 2, -1}, {RIGHT + 2, -1}, WHITE},
    /* out at the bottom; steep: in at the right, out on the left */
    {{24, 5}, {54, -10}, RED},
    {{RIGHT + 10, 14}, {RIGHT - 10, 64}, RED},
    {{10, 10}, {-10, 60}, RED},
    /* a single pixel inside, a point */
    {{-2, 2}, {2, -2}, RED},
    {{RIGHT, 50}, {RIGHT + 31, 60}, RED},
    {{70, 30}, {70, 30}, RED},
    /* in just beyond the half of an odd length; at a tie, of a line that falls and a steep one */
    {{60, -1}, {63, 0}, RED},
    {{10, TOP + 2}, {30, TOP - 3}, RED},
    {{-2, 10}, {3, 30}, RED},
};
enum { CUT_LINES = sizeof cut_lines / sizeof cut_lines[0] };

static struct color cut_color(enum line_color color) {
    return color_rgb(color == WHITE || color == RED ? 255 : (color == BLUE ? 96 : 0),
                     color == WHITE || color == GREEN ? 255 : (color == BLUE ? 160 : 0),
                     color == WHITE || color == BLUE ? 255 : 0);
}

static const struct scene_value cut_values[] = {
    {"attempt", LINE_ATTEMPTS, 0, 2, 1, 0},
    {.name = NULL},
};

static bool draw_cut(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    attempt_line *const draw = line_of(drawing);
    for (size_t i = 0; i < CUT_LINES; i++) {
        const struct cut_line *l = &cut_lines[i];
        drawing_count(drawing, "pixels_walked", draw(image, l->a, l->b, cut_color(l->color)));
    }
    return true;
}

/* A bar as long as the part of a line in an image of that size; the bars are stacked. */
static void draw_bar(struct image *image, int index, const struct cut_line *l, size_t width,
                     size_t height) {
    struct steps steps = steps_inside(l->a, l->b, width, height);
    for (int x = 0; x < (int)image->width && x <= steps.last - steps.first; x++) {
        for (int y = 1; y < 4; y++) {
            image_set(image, x, 4 * (CUT_LINES + 1 - index) + y, cut_color(l->color));
        }
    }
}

/* A bar for each of these lines. The lowest two are for a line in a wide image and for the longest
 * line allowed, which passes so near to the lower left pixel that with a double it would come in
 * there. */
static bool draw_walked(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    const struct cut_line wide = {{-2, 0}, {WIDE + 1, 2}, RED};
    const struct cut_line longest = {
        {-LINE_LIMIT, -LINE_LIMIT / 2}, {LINE_LIMIT, LINE_LIMIT / 2 - 1}, GREEN};
    for (int i = 0; i < CUT_LINES; i++) {
        draw_bar(image, i, &cut_lines[i], CUT_WIDTH, CUT_HEIGHT);
    }
    draw_bar(image, CUT_LINES, &wide, WIDE, 3);
    draw_bar(image, CUT_LINES + 1, &longest, CUT_WIDTH, CUT_HEIGHT);
    return true;
}

/* ---- The program ---- */

/* The whole model again, in images that are not square, or small. */
#define WIREFRAME(scene_name, scene_width, scene_height)                                           \
    {                                                                                              \
        .name = (scene_name), .detail = true, .needs = NEEDS_MODEL, .width = (scene_width),        \
        .height = (scene_height), .draw = draw_wireframe                                           \
    }

static const struct scene scenes[] = {
    {.name = "square", .width = 100, .height = 100, .draw = draw_square},
    {.name = "points",
     .needs = NEEDS_MODEL | NEEDS_LINES,
     .width = 241,
     .height = 201,
     .draw = draw_points},
    {.name = "wireframe", .needs = NEEDS_MODEL | NEEDS_LINES, .draw = draw_wireframe},
    {.name = "border",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 480,
     .height = 360,
     .values = border_values,
     .draw = draw_border},
    {.name = "walked", .width = 320, .height = 4 * (CUT_LINES + 2), .draw = draw_walked},
    {.name = "enlarged",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 480,
     .height = 360,
     .values = window_values,
     .draw = draw_enlarged},
    {.name = "cut",
     .width = CUT_WIDTH,
     .height = CUT_HEIGHT,
     .values = cut_values,
     .draw = draw_cut},
    WIREFRAME("wide", 203, 67),
    WIREFRAME("high", 61, 181),
    WIREFRAME("small", 23, 13),
    WIREFRAME("one_pixel", 1, 1),
};

static const struct program step02_wireframe = {
    .name = "step02_wireframe",
    .summary = "the sides of a model's faces",
    .defaults = {.width = 800, .height = 800},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
    .state_size = sizeof(struct wireframe),
    .prepare = prepare,
    .finish = finish,
};
