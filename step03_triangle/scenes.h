/*
 * Step 3, the given part: its scenes and the program.
 *
 * `outline` draws the sides only, `triangle` fills them, `gradient` mixes the colours of the
 * corners, `faces` fills the faces of a model, each in a colour of its own. A text scene draws the
 * triangles that it lists.
 */

/* ---- Filling ---- */

/* A triangle without spans: every pixel of its rows is tested. Returns the number of pixels
 * written. */
static uint64_t tested_triangle(struct image *image, const struct fixed2 corner[3],
                                const struct color color[3]) {
    struct edges edges;
    uint64_t written = 0;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        for (int x = 0; x < edges.width; x++) {
            if (edges_cover(&edges, x, y)) {
                image_set(image, x, y, mix_colors(triangle_weights(&edges, x, y), color));
                written++;
            }
        }
    }
    return written;
}

static bool same_color(struct color a, struct color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/* A triangle in the simplest way that its colours allow; with --no-skip always in the longest. */
static uint64_t fill_triangle(const struct drawing *drawing, struct image *image,
                              const struct fixed2 corner[3], const struct color color[3]) {
    if (!drawing->skip) {
        return tested_triangle(image, corner, color);
    }
    bool one_color = same_color(color[0], color[1]) && same_color(color[0], color[2]);
    return one_color ? triangle(image, corner, color[0]) : gradient_triangle(image, corner, color);
}

/* ---- Scenes made of listed triangles ---- */

/* The corners, given in pixels: (x,y) means the centre of pixel (x,y). False for one too far off
 * the image to draw. */
static bool place_shape(const struct text_scene_shape *shape, struct fixed2 corner[3]) {
    for (int i = 0; i < 3; i++) {
        struct vec2 screen = {shape->x[i] + 0.5, shape->y[i] + 0.5};
        if (!screen_snap(screen, &corner[i])) {
            return false;
        }
    }
    return true;
}

static void draw_shapes(struct drawing *drawing, struct image *image,
                        const struct text_scene_shape *shapes, size_t shape_count) {
    uint64_t written = 0;
    for (size_t i = 0; i < shape_count; i++) {
        struct fixed2 corner[3];
        if (place_shape(&shapes[i], corner)) {
            written += fill_triangle(drawing, image, corner, shapes[i].color);
        }
    }
    drawing_count(drawing, "pixels_written", written);
}

/* Blue, green, red, alpha, as struct color stores them. */
#define RED     0, 0, 255, 255
#define GREEN   0, 255, 0, 255
#define BLUE    255, 0, 0, 255
#define YELLOW  0, 255, 255, 255
#define CYAN    255, 255, 0, 255
#define MAGENTA 255, 0, 255, 255
#define WHITE   255, 255, 255, 255

static const struct text_scene_shape three_triangles[] = {
    {{10, 50, 70}, {70, 160, 80}, {{RED}, {RED}, {RED}}},
    {{180, 150, 70}, {50, 1, 180}, {{WHITE}, {WHITE}, {WHITE}}},
    {{180, 120, 130}, {150, 160, 180}, {{GREEN}, {GREEN}, {GREEN}}},
};
enum { THREE_TRIANGLES = sizeof three_triangles / sizeof three_triangles[0] };

/* One triangle; a hexagon of six; a rectangle of two. */
static const struct text_scene_shape colored_triangles[] = {
    {{40, 380, 210}, {440, 440, 760}, {{RED}, {GREEN}, {BLUE}}},
    {{600, 770, 685}, {590, 590, 737}, {{WHITE}, {RED}, {YELLOW}}},
    {{600, 685, 515}, {590, 737, 737}, {{WHITE}, {YELLOW}, {GREEN}}},
    {{600, 515, 430}, {590, 737, 590}, {{WHITE}, {GREEN}, {CYAN}}},
    {{600, 430, 515}, {590, 590, 443}, {{WHITE}, {CYAN}, {BLUE}}},
    {{600, 515, 685}, {590, 443, 443}, {{WHITE}, {BLUE}, {MAGENTA}}},
    {{600, 685, 770}, {590, 443, 590}, {{WHITE}, {MAGENTA}, {RED}}},
    {{40, 760, 760}, {40, 40, 380}, {{BLUE}, {GREEN}, {YELLOW}}},
    {{40, 760, 40}, {40, 380, 380}, {{BLUE}, {YELLOW}, {RED}}},
};
enum { COLORED_TRIANGLES = sizeof colored_triangles / sizeof colored_triangles[0] };

static bool draw_outline(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < THREE_TRIANGLES; i++) {
        const struct text_scene_shape *shape = &three_triangles[i];
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            struct pixel a = {(int)shape->x[k], (int)shape->y[k]};
            struct pixel b = {(int)shape->x[next], (int)shape->y[next]};
            drawing_count(drawing, "pixels_written", draw_line(image, a, b, shape->color[0]));
        }
    }
    return true;
}

static bool draw_triangle(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_shapes(drawing, image, three_triangles, THREE_TRIANGLES);
    return true;
}

static bool draw_gradient(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_shapes(drawing, image, colored_triangles, COLORED_TRIANGLES);
    return true;
}

static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_shapes(drawing, image, drawing->text->shapes, drawing->text->shape_count);
    return true;
}

/* ---- Scene: faces ---- */

/* A colour that looks random but depends on the number alone. The mixing of bits is the last step
 * of MurmurHash3 (Appleby, 2011). No channel is darker than 55. */
static struct color face_color(size_t face) {
    uint32_t h = (uint32_t)face + 1;
    h ^= h >> 16;
    h *= 0x85ebca6bU;
    h ^= h >> 13;
    h *= 0xc2b2ae35U;
    h ^= h >> 16;
    uint32_t r = h >> 16 & 255, g = h >> 8 & 255, b = h & 255;
    return color_rgb((uint8_t)(55 + r % 201), (uint8_t)(55 + g % 201), (uint8_t)(55 + b % 201));
}

/* The corners of a face in the parallel view. False for one too far off the image to draw. */
static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct fixed2 corner[3]) {
    for (size_t i = 0; i < 3; i++) {
        struct vec3 world = model_position(model, face, i);
        if (!screen_snap(parallel_view(world, image->width, image->height), &corner[i])) {
            return false;
        }
    }
    return true;
}

static bool draw_faces(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    uint64_t turned_away = 0, without_pixel = 0, written = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct fixed2 corner[3];
        if (!place_face(model, face, image, corner)) {
            continue;
        }
        if (is_turned_away(corner)) {
            turned_away++;
            continue;
        }
        struct color color = face_color(face);
        uint64_t pixels =
            fill_triangle(drawing, image, corner, (struct color[3]){color, color, color});
        without_pixel += pixels == 0;
        written += pixels;
    }
    drawing_count(drawing, "faces_turned_away", turned_away);
    drawing_count(drawing, "faces_without_pixel", without_pixel);
    drawing_count(drawing, "pixels_written", written);
    return true;
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {.name = "outline", .draw = draw_outline},
    {.name = "triangle", .draw = draw_triangle},
    {.name = "gradient", .width = 800, .height = 800, .draw = draw_gradient},
    {.name = "faces", .needs = NEEDS_MODEL, .width = 800, .height = 800, .draw = draw_faces},
};

int main(int argc, char **argv) {
    static const struct program program = {
        .name = "step03_triangle",
        .summary = "filled triangles: exact edge functions, the top-left rule, spans",
        .text_kind = TEXT_SCENE_TRIANGLES,
        .draw_text = draw_text,
        .defaults = {.width = 200, .height = 200},
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
    };
    return program_main(&program, argc, argv);
}
