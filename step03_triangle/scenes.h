/*
 * Lesson 3, the given part: its scenes and the program.
 *
 * Part a: `outline` draws the edges of three triangles, `leaving` those of triangles that leave the
 * image; `signs` fills triangles by three signs, and `bust` the faces of a model, each in a colour
 * for itself. Part b draws the triangles and the model again, in `triangle` and `faces`; in `far`
 * triangles leave the image on all sides; `sheet` and `fan` show how often each pixel of a mesh is
 * drawn. Part c: `gradient` mixes the colours of the corners. `wide`, `high`, `small` and
 * `one_pixel` are `faces` in images of other sizes. A text scene draws its own triangles.
 */
#ifdef LINE_IS_MINE /* make LINE=mine: the line() of lesson 1 draws */
#include "run/mine.h"
#define draw_line my_line
#endif
#include <stdlib.h>

/* ---- Filling ---- */

static bool same_color(struct color a, struct color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/* A triangle without spans: every pixel of its rows is tested. Returns the number of pixels
 * written. */
static uint64_t tested_triangle(struct image *image, const struct fixed2 corner[3],
                                const struct color color[3], bool one_color) {
    struct edges edges;
    uint64_t written = 0;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        for (int x = 0; x < edges.width; x++) {
            if (edges_cover(&edges, x, y)) {
                struct color mixed =
                    one_color ? color[0] : mix_colors(triangle_weights(&edges, x, y), color);
                image_set(image, x, y, mixed);
                written++;
            }
        }
    }
    return written;
}

/* A triangle in one colour, or in one that runs from corner to corner. */
static uint64_t fill_triangle(const struct drawing *drawing, struct image *image,
                              const struct fixed2 corner[3], const struct color color[3]) {
    bool one_color = same_color(color[0], color[1]) && same_color(color[0], color[2]);
    if (!drawing->skip) {
        return tested_triangle(image, corner, color, one_color);
    }
    return one_color ? triangle(image, corner, color[0]) : gradient_triangle(image, corner, color);
}

/* ---- Scenes made of listed triangles ---- */

/* False for a triangle too far off the image to draw. */
static bool snap_corners(const struct vec2 screen[3], struct fixed2 corner[3]) {
    return screen_snap(screen[0], &corner[0]) && screen_snap(screen[1], &corner[1]) &&
           screen_snap(screen[2], &corner[2]);
}

/* The corners, given in pixels: (x,y) means the centre of pixel (x,y). */
static void place_shape(const struct text_scene_shape *shape, struct vec2 screen[3]) {
    for (int i = 0; i < 3; i++) {
        screen[i] = (struct vec2){shape->x[i] + 0.5, shape->y[i] + 0.5};
    }
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

/* The blue and the yellow one reach far out of the image and cover its lowest and its highest rows:
 * their long edges meet these rows at an x that does not fit in an int. The green, the red and the
 * cyan one have a corner in the image, but most of their rows miss it. The first white one and the
 * magenta one are very long and narrow, and the other white ones small: their edges pass through
 * pixel centres or 1/256 pixel past them, as the level edge of the cyan one does. */
static const struct text_scene_shape far_triangles[] = {
    {{-900000, 900000, 900000}, {-900000, 899999.96, 900000.04}, {{WHITE}, {WHITE}, {WHITE}}},
    {{1000000, -1000000, 0}, {7.00390625, 7, -1000000}, {{BLUE}, {BLUE}, {BLUE}}},
    {{220, 300, 300}, {40, 40, 150}, {{GREEN}, {GREEN}, {GREEN}}},
    {{20, -60, -60}, {120, 40, 130}, {{RED}, {RED}, {RED}}},
    {{-5, -3, 18}, {20, 36, 36}, {{CYAN}, {CYAN}, {CYAN}}},
    {{118, 122, 114}, {-60000, 60000, 0}, {{MAGENTA}, {MAGENTA}, {MAGENTA}}},
    {{59.61328125, 61.55078125, 57.26953125},
     {99.609375, 101.56640625, 101.56640625},
     {{WHITE}, {WHITE}, {WHITE}}},
    {{71, 71, 75}, {104, 101, 101}, {{WHITE}, {WHITE}, {WHITE}}},
    {{84.9921875, 85.0078125, 85},
     {101.9921875, 101.9921875, 102.0078125},
     {{WHITE}, {WHITE}, {WHITE}}},
    {{1000000, -1000000, 0}, {146.00390625, 146, 1000000}, {{YELLOW}, {YELLOW}, {YELLOW}}},
};

/* Outlines that leave the image on all sides, and one outside it, which draws nothing. */
static const struct text_scene_shape leaving_triangles[] = {
    {{-30, 60, 100}, {30, -25, 55}, {{RED}, {RED}, {RED}}},
    {{130, 160, 40}, {20, 45, 75}, {{GREEN}, {GREEN}, {GREEN}}},
    {{-50, -20, -35}, {10, 30, 50}, {{WHITE}, {WHITE}, {WHITE}}},
};

/* Triangles that leave the image: at the left and at the top, at the right, at the bottom. Their
 * edges are far from all pixel centres where they meet the border. Then two with an area of 0, a
 * line and a point, through pixel centres: they draw nothing. */
static const struct text_scene_shape special_triangles[] = {
    {{-30.4, 20.3, 40.2}, {165.3, 250.4, 185.1}, {{CYAN}, {CYAN}, {CYAN}}},
    {{172.3, 240.4, 230.2}, {90.4, 130.3, 20.6}, {{YELLOW}, {YELLOW}, {YELLOW}}},
    {{88.3, 141.6, 110.4}, {7.4, 5.2, -30.7}, {{MAGENTA}, {MAGENTA}, {MAGENTA}}},
    {{10, 70, 130}, {30, 30, 30}, {{YELLOW}, {YELLOW}, {YELLOW}}},
    {{60, 60, 60}, {20, 20, 20}, {{YELLOW}, {YELLOW}, {YELLOW}}},
};

/* One triangle, given clockwise; a hexagon of six; a rectangle of two; one that leaves the image at
 * the top. */
static const struct text_scene_shape colored_triangles[] = {
    {{40, 210, 380}, {440, 760, 440}, {{RED}, {BLUE}, {GREEN}}},
    {{600, 770, 685}, {590, 590, 737}, {{WHITE}, {RED}, {YELLOW}}},
    {{600, 685, 515}, {590, 737, 737}, {{WHITE}, {YELLOW}, {GREEN}}},
    {{600, 515, 430}, {590, 737, 590}, {{WHITE}, {GREEN}, {CYAN}}},
    {{600, 430, 515}, {590, 590, 443}, {{WHITE}, {CYAN}, {BLUE}}},
    {{600, 515, 685}, {590, 443, 443}, {{WHITE}, {BLUE}, {MAGENTA}}},
    {{600, 685, 770}, {590, 443, 590}, {{WHITE}, {MAGENTA}, {RED}}},
    {{40, 760, 760}, {40, 40, 380}, {{BLUE}, {GREEN}, {YELLOW}}},
    {{40, 760, 40}, {40, 380, 380}, {{BLUE}, {YELLOW}, {RED}}},
    {{340, 440, 390}, {700, 700, 1000}, {{RED}, {GREEN}, {WHITE}}},
};

/* What the scenes draw: the lists and how long they are, by the number of the scene. */
enum { THREE, FAR, LEAVING, SPECIAL, COLORED };

#define LIST(triangles)                                                                            \
    { triangles, sizeof(triangles) / sizeof(triangles)[0] }
static const struct {
    const struct text_scene_shape *shapes;
    size_t count;
} lists[] = {
    [THREE] = LIST(three_triangles),     [FAR] = LIST(far_triangles),
    [LEAVING] = LIST(leaving_triangles), [SPECIAL] = LIST(special_triangles),
    [COLORED] = LIST(colored_triangles),
};

static bool draw_outlines(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < 3 * lists[drawing->number].count; i++) {
        const struct text_scene_shape *shape = &lists[drawing->number].shapes[i / 3];
        size_t k = i % 3, next = (k + 1) % 3;
        struct pixel a = {(int)shape->x[k], (int)shape->y[k]};
        struct pixel b = {(int)shape->x[next], (int)shape->y[next]};
        drawing_count(drawing, "pixels_written", draw_line(image, a, b, shape->color[0]));
    }
    return true;
}

/* A triangle by three signs. */
static void draw_by_signs(struct drawing *drawing, struct image *image,
                          const struct text_scene_shape *shape) {
    struct vec2 screen[3];
    place_shape(shape, screen);
    drawing_count(drawing, "pixels_written", box_triangle(image, screen, shape->color[0]));
}

/* The three triangles, three that leave the image, two that draw nothing, and a row of dots:
 * triangles smaller than a pixel. */
static bool draw_signs(struct drawing *drawing, struct image *image, struct error *error) {
    enum { DOTS = 20 };
    (void)error;
    for (size_t i = 0; i < lists[THREE].count; i++) {
        draw_by_signs(drawing, image, &three_triangles[i]);
    }
    for (size_t i = 0; i < lists[SPECIAL].count; i++) {
        draw_by_signs(drawing, image, &special_triangles[i]);
    }
    for (int i = 0; i < DOTS; i++) {
        double x = 6 + 4 * i;
        const struct text_scene_shape dot = {{x - 0.3, x + 0.4, x}, {9.8, 9.8, 10.6}, {{WHITE}}};
        draw_by_signs(drawing, image, &dot);
    }
    return true;
}

static bool draw_list(struct drawing *drawing, struct image *image, struct error *error) {
    uint64_t written = 0;
    (void)error;
    for (size_t i = 0; i < lists[drawing->number].count; i++) {
        const struct text_scene_shape *shape = &lists[drawing->number].shapes[i];
        struct vec2 screen[3];
        struct fixed2 corner[3];
        place_shape(shape, screen);
        if (snap_corners(screen, corner)) {
            written += fill_triangle(drawing, image, corner, shape->color);
        }
    }
    drawing_count(drawing, "pixels_written", written);
    return true;
}

/* ---- Scenes: sheet, fan ---- */

/* Place triangle `i` of a mesh on an image of that size. Returns its grey: one of four, and lighter
 * where it is given clockwise. */
typedef uint8_t mesh_function(int i, const struct image *image, struct fixed2 corner[3]);

/* Triangles that cover a square part of the image without gap or overlap. */
struct covering {
    mesh_function *place;
    int triangle_count;
    size_t begin, end; /* the columns, and the rows, that it covers; end exclusive */
};

enum {
    COUNT_ZOOM = 4, /* a pixel of a mesh is shown as a block of 4 x 4 */
    SHEET_CELLS = 14,
    SHEET_CELL = 12,   /* pixels */
    SHEET_MARGIN = 16, /* pixels */
    SHEET_END = SHEET_MARGIN + SHEET_CELLS * SHEET_CELL,
    SHEET_TRIANGLES = 2 * SHEET_CELLS * SHEET_CELLS,
    FAN_BLADES = 24,
    FAN_REACH = 668 * SUBPIXELS + 91 /* the rim is 6 times as far from the middle */
};

/* A corner of the sheet: a point of a grid, moved by halves of a pixel. So corners lie on pixel
 * centres or half-way between them, where the rule for ties counts most; those of the upper half
 * lie just below, where it must not count. The border is straight and far from all centres: there
 * no rule is asked. */
static struct fixed2 sheet_corner(int column, int row) {
    const int half = SUBPIXELS / 2;
    uint32_t h = (uint32_t)(row * 1009 + column) * 2654435761U;
    int x = 2 * (SHEET_MARGIN + column * SHEET_CELL), y = 2 * (SHEET_MARGIN + row * SHEET_CELL);
    if (column % SHEET_CELLS == 0 || row % SHEET_CELLS == 0) {
        return (struct fixed2){x * half + half / 2, y * half + half / 2};
    }
    int lower = row > SHEET_CELLS / 2; /* 1/256 pixel */
    return (struct fixed2){(x + (int)(h >> 29) - 4) * half,
                           (y + (int)(h >> 26 & 7) - 4) * half - lower};
}

/* Every cell is cut into two triangles. Half of them are given clockwise. */
static uint8_t place_in_sheet(int i, const struct image *image, struct fixed2 corner[3]) {
    int column = i / 2 % SHEET_CELLS, row = i / 2 / SHEET_CELLS;
    bool upper = i % 2 != 0;
    (void)image;
    corner[0] = sheet_corner(column, row);
    corner[1] = sheet_corner(column + !upper, row + upper);
    corner[2] = sheet_corner(column + 1, row + 1);
    return (uint8_t)(90 + 17 * (i % 4) + 80 * upper);
}

/* A corner on the rim of the fan, a square around its middle: -6..6 in x and y. */
static struct pixel fan_rim(int i) {
    const int side = FAN_BLADES / 4;
    struct pixel rim = {side, i % side * 2 - side};
    for (int turns = i / side % 4; turns > 0; turns--) {
        rim = (struct pixel){-rim.y, rim.x};
    }
    return rim;
}

/* Every other one lies so that the edge from the middle to it passes through many pixel centres. */
static struct fixed2 fan_corner(int i, struct fixed2 middle) {
    struct pixel rim = fan_rim(i);
    int stray = i % 2 == 0 ? 0 : 1009 * i;
    return (struct fixed2){middle.x + rim.x * FAN_REACH + stray,
                           middle.y + rim.y * FAN_REACH - stray};
}

/* The blades of the fan meet in a pixel centre; together they cover the image. */
static uint8_t place_in_fan(int i, const struct image *image, struct fixed2 corner[3]) {
    corner[0] = (struct fixed2){(int)image->width / 2 * SUBPIXELS + SUBPIXELS / 2,
                                (int)image->height / 2 * SUBPIXELS + SUBPIXELS / 2};
    corner[1] = fan_corner(i, corner[0]);
    corner[2] = fan_corner(i + 1, corner[0]);
    return (uint8_t)(90 + 17 * (i % 4));
}

/* The meshes, by the number of the scene. */
enum { SHEET, FAN };
static const struct covering meshes[] = {
    [SHEET] = {place_in_sheet, SHEET_TRIANGLES, SHEET_MARGIN, SHEET_END},
    [FAN] = {place_in_fan, FAN_BLADES, 0, SIZE_MAX},
};

/* What is known of a pixel of a mesh. */
struct counted {
    uint8_t draws;  /* how many triangles have drawn it; 255 means more, too */
    uint8_t shade;  /* grey of the last of them */
    uint8_t wanted; /* how many must draw it */
};

/* Count the pixels that a triangle has drawn in white, and make them black again. */
static void count_draws(struct image *image, uint8_t shade, struct counted *counted) {
    for (size_t i = 0; i < image->width * image->height; i++) {
        if (image->pixels[i * IMAGE_BGR] != 0) {
            counted[i].draws = (uint8_t)(counted[i].draws + (counted[i].draws < 255));
            counted[i].shade = shade;
        }
    }
    image_clear(image, color_grey(0));
}

/* Grey: drawn as often as it must be. Orange: drawn too often. Magenta: not drawn. */
static struct color counted_color(struct counted counted) {
    return counted.draws > counted.wanted   ? color_rgb(255, 150, 0)
           : counted.draws < counted.wanted ? color_rgb(255, 0, 160)
                                            : color_grey(counted.shade);
}

/* What was counted in an image of that size, enlarged. */
static void show_counted(struct drawing *drawing, struct image *image, size_t width, size_t height,
                         const struct counted *counted, int zoom) {
    uint64_t too_often = 0, missing = 0;
    for (size_t i = 0; i < width * height; i++) {
        too_often += counted[i].draws > counted[i].wanted;
        missing += counted[i].draws < counted[i].wanted;
    }
    for (int y = 0; y < (int)image->height; y++) {
        for (int x = 0; x < (int)image->width; x++) {
            size_t column = (size_t)(x / zoom), row = (size_t)(y / zoom);
            image_set(image, x, y, counted_color(counted[row * width + column]));
        }
    }
    drawing_count(drawing, "pixels_too_often", too_often);
    drawing_count(drawing, "pixels_missing", missing);
}

/* How often each pixel of a mesh is drawn. Its triangles are drawn one by one in a small image. */
static void count_mesh(struct drawing *drawing, struct image *small, const struct covering *mesh,
                       struct counted *counted) {
    const struct color white[3] = {{WHITE}, {WHITE}, {WHITE}};
    for (int i = 0; i < mesh->triangle_count; i++) {
        struct fixed2 corner[3];
        uint8_t shade = mesh->place(i, small, corner);
        fill_triangle(drawing, small, corner, white);
        count_draws(small, shade, counted);
    }
    for (size_t i = 0; i < small->width * small->height; i++) {
        size_t x = i % small->width, y = i / small->width;
        counted[i].wanted = x >= mesh->begin && x < mesh->end && y >= mesh->begin && y < mesh->end;
    }
}

static bool draw_mesh(struct drawing *drawing, struct image *image, struct error *error) {
    size_t width = (image->width + COUNT_ZOOM - 1) / COUNT_ZOOM;
    size_t height = (image->height + COUNT_ZOOM - 1) / COUNT_ZOOM;
    struct image small;
    if (!image_create(&small, width, height, IMAGE_BGR, error)) {
        return false;
    }
    struct counted *counted = calloc(width * height, sizeof *counted);
    if (counted != NULL) {
        count_mesh(drawing, &small, &meshes[drawing->number], counted);
        show_counted(drawing, image, width, height, counted, COUNT_ZOOM);
    }
    bool done = counted != NULL || error_out_of_memory(error);
    free(counted);
    image_free(&small);
    return done;
}

/* ---- Text scenes ---- */

#include "attempts.h"

static const struct scene_value text_values[] = {
    {"attempt",
     "0 triangle(), 1 sweep in whole numbers, 2 sweep in float, 3 box in float, 4 box in double, "
     "5 open sides, 6 a tolerance, 7 edges in float",
     0, 7, 1, 0},
    {"snap", "bits of a corner's fraction", 0, 8, 1, 8},
    {"counted", "orange is drawn too often, magenta is missing", 0, 1, 1, 0},
    {.name = NULL},
};

/* The corners, snapped to so many bits. */
static bool place_snapped(const struct drawing *drawing, const struct text_scene_shape *shape,
                          struct vec2 screen[3], struct fixed2 corner[3]) {
    const double steps = ldexp(1, (int)drawing_value(drawing, "snap"));
    place_shape(shape, screen);
    for (int i = 0; i < 3; i++) {
        screen[i] = (struct vec2){floor(screen[i].x * steps + 0.5) / steps,
                                  floor(screen[i].y * steps + 0.5) / steps};
    }
    return snap_corners(screen, corner);
}

/* By an attempt, or by what the lesson writes. */
static uint64_t fill_shape(const struct drawing *drawing, struct image *image,
                           const struct vec2 screen[3], const struct fixed2 corner[3],
                           const struct color color[3]) {
    const int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt == 0) {
        return fill_triangle(drawing, image, corner, color);
    }
    fill_attempt(attempt)(image, screen, color[0]);
    return 0;
}

/* What the three edges say of the probed pixel: part b's, or before it is written, part a's; and
 * the weights there. */
static void note_edges(struct drawing *drawing, const struct image *image,
                       const struct vec2 screen[3], const struct fixed2 corner[3], size_t number) {
    struct edges edges;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        const struct vec2 center = {drawing->probe.x + 0.5, drawing->probe.y + 0.5};
        for (int i = 0; i < 3; i++) {
            drawing_note(drawing, "triangle %zu: E%d = %+.4f", number, i,
                         side_of(screen[(i + 1) % 3], screen[(i + 2) % 3], center));
        }
        return;
    }
    for (int i = 0; i < 3; i++) {
        const struct edge *e = &edges.edge[i];
        int64_t value = e->origin + e->dx * drawing->probe.x + e->dy * drawing->probe.y;
        drawing_note(drawing, "triangle %zu: E%d = %+.4f, %s", number, i,
                     (double)value / SUBPIXELS / SUBPIXELS,
                     value == 0          ? e->least == 0 ? "on it, a top or left edge" : "on it"
                     : value >= e->least ? "inside"
                                         : "outside");
    }
    const struct vec3 weight = triangle_weights(&edges, drawing->probe.x, drawing->probe.y);
    drawing_note(drawing, "triangle %zu: weights %.4f, %.4f, %.4f", number, weight.x, weight.y,
                 weight.z);
}

/* Should the pixel be drawn? Its centre is inside, and a hair to its right and below as well. */
static bool is_wanted(const struct fixed2 corner[3], int x, int y) {
    const int64_t px = (int64_t)x * SUBPIXELS + SUBPIXELS / 2;
    const int64_t py = (int64_t)y * SUBPIXELS + SUBPIXELS / 2;
    int left = 0, right = 0; /* edges that have the centre there */
    for (int i = 0; i < 3; i++) {
        const struct fixed2 a = corner[i], b = corner[(i + 1) % 3];
        const int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y;
        int64_t side = dx * (py - a.y) - dy * (px - a.x);
        side = side != 0 ? side : dy != 0 ? -dy : -dx;
        left += side > 0;
        right += side < 0;
    }
    return left == 3 || right == 3;
}

/* The shape is in the image, in white. */
static void count_shape(struct image *image, const struct fixed2 corner[3], uint8_t shade,
                        struct counted *counted) {
    for (size_t i = 0; i < image->width * image->height; i++) {
        int x = (int)(i % image->width), y = (int)(i / image->width);
        counted[i].wanted = (uint8_t)(counted[i].wanted + is_wanted(corner, x, y));
    }
    count_draws(image, shade, counted);
}

static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    const struct color white[3] = {{WHITE}, {WHITE}, {WHITE}};
    const bool counts = drawing_value(drawing, "counted") != 0;
    struct counted *counted = NULL;
    uint64_t written = 0;
    if (counts && (counted = calloc(image->width * image->height, sizeof *counted)) == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        struct vec2 screen[3];
        struct fixed2 corner[3];
        if (!place_snapped(drawing, shape, screen, corner)) {
            continue;
        }
        written += fill_shape(drawing, image, screen, corner, counts ? white : shape->color);
        if (counts) {
            count_shape(image, corner, (uint8_t)(90 + 50 * (i % 4)), counted);
        }
        if (drawing->probed) {
            note_edges(drawing, image, screen, corner, i + 1);
        }
    }
    if (drawing_value(drawing, "attempt") == 0) {
        drawing_count(drawing, "pixels_written", written);
    }
    if (counts) {
        show_counted(drawing, image, image->width, image->height, counted, 1);
    }
    free(counted);
    return true;
}

/* ---- Scenes: bust, faces ---- */

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

/* The corners of a face in the parallel view. */
static void face_on_screen(const struct model *model, size_t face, const struct image *image,
                           struct vec2 screen[3]) {
    for (size_t i = 0; i < 3; i++) {
        screen[i] = parallel_view(model_position(model, face, i), image->width, image->height);
    }
}

static bool draw_bust(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    uint64_t turned_away = 0, written = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vec2 screen[3];
        struct fixed2 corner[3];
        face_on_screen(model, face, image, screen);
        if (!snap_corners(screen, corner)) {
            continue;
        }
        if (is_turned_away(screen)) {
            turned_away++;
            continue;
        }
        written += box_triangle(image, screen, face_color(face));
    }
    drawing_count(drawing, "faces_turned_away", turned_away);
    drawing_count(drawing, "pixels_written", written);
    return true;
}

static struct vec2 in_pixels(struct fixed2 p) {
    return (struct vec2){(double)p.x / SUBPIXELS, (double)p.y / SUBPIXELS};
}

/* The snapped corners of a face that is to be drawn. False, and the reason counted, for another. */
static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct fixed2 corner[3], uint64_t *turned_away) {
    struct vec2 screen[3];
    face_on_screen(model, face, image, screen);
    if (!snap_corners(screen, corner)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        screen[i] = in_pixels(corner[i]);
    }
    bool is_back = is_turned_away(screen);
    *turned_away += is_back;
    return !is_back;
}

static bool draw_faces(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    uint64_t turned_away = 0, without_pixel = 0, written = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct fixed2 corner[3];
        if (place_face(model, face, image, corner, &turned_away)) {
            struct color color = face_color(face);
            uint64_t pixels =
                fill_triangle(drawing, image, corner, (struct color[3]){color, color, color});
            without_pixel += pixels == 0;
            written += pixels;
        }
    }
    drawing_count(drawing, "faces_turned_away", turned_away);
    drawing_count(drawing, "faces_without_pixel", without_pixel);
    drawing_count(drawing, "pixels_written", written);
    return true;
}

/* ---- The program ---- */

/* `faces` again, in images that are not square, or small. */
#define FACES(scene_name, scene_width, scene_height)                                               \
    {                                                                                              \
        .name = (scene_name), .detail = true, .needs = NEEDS_MODEL, .width = (scene_width),        \
        .height = (scene_height), .draw = draw_faces                                               \
    }

static const struct scene scenes[] = {
    {.name = "outline", .number = THREE, .draw = draw_outlines},
    {.name = "leaving", .width = 120, .height = 60, .number = LEAVING, .draw = draw_outlines},
    {.name = "signs", .draw = draw_signs},
    {.name = "bust", .needs = NEEDS_MODEL, .width = 800, .height = 800, .draw = draw_bust},
    {.name = "triangle", .number = THREE, .draw = draw_list},
    {.name = "far", .width = 240, .height = 160, .number = FAR, .draw = draw_list},
    {.name = "sheet", .width = 800, .height = 800, .number = SHEET, .draw = draw_mesh},
    {.name = "fan", .width = 800, .height = 800, .number = FAN, .draw = draw_mesh},
    {.name = "faces", .needs = NEEDS_MODEL, .width = 800, .height = 800, .draw = draw_faces},
    {.name = "gradient", .width = 800, .height = 800, .number = COLORED, .draw = draw_list},
    FACES("wide", 203, 67),
    FACES("high", 61, 181),
    FACES("small", 23, 13),
    FACES("one_pixel", 1, 1),
};

static const struct program step03_triangle = {
    .name = "step03_triangle",
    .summary = "filled triangles: exact edge functions, the top-left rule, spans",
    .text_kind = TEXT_SCENE_TRIANGLES,
    .draw_text = draw_text,
    .text_values = text_values,
    .text = "size 40 40\n"
            "triangle 4 4 30 10 14 34 255 140 0\n"
            "triangle 30 10 36 36 14 34 80 80 255\n",
    .defaults = {.width = 200, .height = 200},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
