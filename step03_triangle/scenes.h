/* Lesson 3, the given part: the pictures of README.md, and the program. */
#include <string.h>

/* ---- Scenes: outline, signs ---- */

/* Blue, green, red, alpha, as struct color stores them. */
#define RED     0, 0, 255, 255
#define GREEN   0, 255, 0, 255
#define BLUE    255, 0, 0, 255
#define YELLOW  0, 255, 255, 255
#define CYAN    255, 255, 0, 255
#define MAGENTA 255, 0, 255, 255
#define WHITE   255, 255, 255, 255

/* The corners are in pixels: (x,y) means the centre of pixel (x,y). `outline` draws only the first
 * three. The others leave the image: at the left and at the top, at the right, at the bottom. */
static const struct text_scene_shape few_triangles[] = {
    {{10, 50, 70}, {70, 160, 80}, {{RED}, {RED}, {RED}}},
    {{180, 150, 70}, {50, 1, 180}, {{WHITE}, {WHITE}, {WHITE}}},
    {{180, 120, 130}, {150, 160, 180}, {{GREEN}, {GREEN}, {GREEN}}},
    {{-30.4, 20.3, 40.2}, {165.3, 250.4, 185.1}, {{CYAN}, {CYAN}, {CYAN}}},
    {{172.3, 240.4, 230.2}, {90.4, 130.3, 20.6}, {{YELLOW}, {YELLOW}, {YELLOW}}},
    {{88.3, 141.6, 110.4}, {7.4, 5.2, -30.7}, {{MAGENTA}, {MAGENTA}, {MAGENTA}}},
};

static void draw_outline(struct drawing *drawing, struct image *image,
                         const struct text_scene_shape *shape) {
    for (int i = 0; i < 3; i++) {
        const int k = (i + 1) % 3;
        const struct pixel a = {(int)shape->x[i], (int)shape->y[i]};
        const struct pixel b = {(int)shape->x[k], (int)shape->y[k]};
        drawing_count(drawing, "pixels_written", draw_line(image, a, b, shape->color[0]));
    }
}

static bool draw_outlines(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (int i = 0; i < 3; i++) {
        draw_outline(drawing, image, &few_triangles[i]);
    }
    return true;
}

static void place_shape(const struct text_scene_shape *shape, struct vec2 screen[3]) {
    for (int i = 0; i < 3; i++) {
        screen[i] = (struct vec2){shape->x[i] + 0.5, shape->y[i] + 0.5};
    }
}

static void draw_by_signs(struct drawing *drawing, struct image *image,
                          const struct text_scene_shape *shape) {
    struct vec2 screen[3];
    place_shape(shape, screen);
    drawing_count(drawing, "pixels_written", box_triangle(image, screen, shape->color[0]));
}

static bool draw_signs(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < sizeof few_triangles / sizeof few_triangles[0]; i++) {
        draw_by_signs(drawing, image, &few_triangles[i]);
    }
    for (double x = 6; x < 86; x += 4) { /* a row of dots: triangles smaller than a pixel */
        const struct text_scene_shape dot = {{x - 0.3, x + 0.4, x}, {9.8, 9.8, 10.6}, {{WHITE}}};
        draw_by_signs(drawing, image, &dot);
    }
    return true;
}

/* ---- Filling ---- */

/* Fill a triangle with one colour. --no-skip asks the edges at every pixel of the rows, so that you
 * see them before you have written spans. */
static uint64_t fill_triangle(const struct drawing *drawing, struct image *image,
                              const struct fixed2 corner[3], struct color color) {
    struct edges edges;
    uint64_t written = 0;
    if (drawing->skip) {
        return triangle(image, corner, color);
    }
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        for (int x = 0; x < edges.width; x++) {
            written += edges_cover(&edges, x, y) && image_set(image, x, y, color);
        }
    }
    return written;
}

/* False for a triangle too far off the image to draw. */
static bool snap_corners(const struct vec2 screen[3], struct fixed2 corner[3]) {
    return screen_snap(screen[0], &corner[0]) && screen_snap(screen[1], &corner[1]) &&
           screen_snap(screen[2], &corner[2]);
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

enum { FACES, BUST };

/* Draw the faces that show their front: `faces` by spans, `bust` by three signs. */
static bool draw_faces(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t face = 0; face < drawing->model->face_count; face++) {
        const struct color color = face_color(face);
        struct vec2 screen[3];
        struct fixed2 corner[3];
        face_on_screen(drawing->model, face, image, screen);
        const bool is_back = is_turned_away(screen);
        drawing_count(drawing, "faces_turned_away", is_back);
        if (!is_back && snap_corners(screen, corner)) {
            drawing_count(drawing, "pixels_written",
                          drawing->number == BUST ? box_triangle(image, screen, color)
                                                  : fill_triangle(drawing, image, corner, color));
        }
    }
    return true;
}

/* ---- Scenes: sheet, fan ---- */

/* How often is each pixel of a mesh drawn? Once is grey, more is orange, not at all is magenta. The
 * triangles are drawn one by one in a small image, whose pixels are shown as blocks. */
enum { BLOCK = 4 };
static const struct color not_drawn = {.r = 255, .b = 160, .a = 255};

static void show_pixel(struct image *image, int x, int y, struct color color) {
    for (int i = 0; i < BLOCK * BLOCK; i++) {
        image_set(image, x * BLOCK + i % BLOCK, y * BLOCK + i / BLOCK, color);
    }
}

/* Show the pixels that a triangle has drawn, in its grey, and make the small image black again. */
static void show_drawn(struct image *small, int grey, struct image *image) {
    const uint8_t *pixel = small->pixels;
    for (int y = 0; y < (int)small->height; y++) {
        for (int x = 0; x < (int)small->width; x++, pixel += small->format) {
            if (*pixel != 0) {
                const struct color now = image_get(image, x * BLOCK, y * BLOCK);
                const bool first = now.r == not_drawn.r && now.b == not_drawn.b;
                show_pixel(image, x, y, first ? color_grey((uint8_t)grey) : color_rgb(255, 150, 0));
            }
        }
    }
    image_clear(small, color_grey(0));
}

enum {
    SHEET_CELLS = 14,
    SHEET_CELL = 12,  /* pixels */
    SHEET_BEGIN = 16, /* pixels */
    SHEET_END = SHEET_BEGIN + SHEET_CELLS * SHEET_CELL
};

/* A corner of the sheet is a point of a grid, moved by halves of a pixel. So corners lie on pixel
 * centres or half-way between them, where the rule for ties counts most; those of the upper half
 * lie just below, where it must not count. The border is far from all centres. */
static struct fixed2 sheet_corner(int column, int row) {
    const int x = (SHEET_BEGIN + column * SHEET_CELL) * SUBPIXELS;
    const int y = (SHEET_BEGIN + row * SHEET_CELL) * SUBPIXELS;
    const uint32_t h = (uint32_t)(row * 1009 + column) * 2654435761U;
    if (column % SHEET_CELLS == 0 || row % SHEET_CELLS == 0) {
        return (struct fixed2){x + SUBPIXELS / 4, y + SUBPIXELS / 4};
    }
    return (struct fixed2){x + ((int)(h >> 29) - 4) * SUBPIXELS / 2,
                           y + ((int)(h >> 26 & 7) - 4) * SUBPIXELS / 2 - (row > SHEET_CELLS / 2)};
}

/* Every cell is cut into two triangles, of which the upper one is given clockwise. Returns the grey
 * of triangle i. */
static int place_in_sheet(int i, struct fixed2 corner[3]) {
    const int column = i / 2 % SHEET_CELLS, row = i / 2 / SHEET_CELLS, upper = i % 2;
    corner[0] = sheet_corner(column, row);
    corner[1] = sheet_corner(column + !upper, row + upper);
    corner[2] = sheet_corner(column + 1, row + 1);
    return 90 + 17 * (i % 4) + 80 * upper;
}

enum { FAN_BLADES = 24, FAN_REACH = 668 * SUBPIXELS + 91 }; /* the rim is 6 times as far */

/* A corner on the rim of the fan, a square around its middle: -6..6 in x and y. */
static struct pixel fan_rim(int i) {
    struct pixel rim = {6, i % 6 * 2 - 6};
    for (int turns = i / 6 % 4; turns > 0; turns--) {
        rim = (struct pixel){-rim.y, rim.x};
    }
    return rim;
}

/* The blades meet in a pixel centre, and together they cover the image. Every other edge from the
 * middle to the rim passes through many pixel centres. */
static int place_in_fan(int i, const struct image *image, struct fixed2 corner[3]) {
    corner[0] = (struct fixed2){(int)image->width / 2 * SUBPIXELS + SUBPIXELS / 2,
                                (int)image->height / 2 * SUBPIXELS + SUBPIXELS / 2};
    for (int k = 0; k < 2; k++) {
        const struct pixel rim = fan_rim(i + k);
        const int stray = (i + k) % 2 * 1009 * (i + k);
        corner[k + 1].x = corner[0].x + rim.x * FAN_REACH + stray;
        corner[k + 1].y = corner[0].y + rim.y * FAN_REACH - stray;
    }
    return 90 + 17 * (i % 4);
}

enum { SHEET, FAN };

static bool draw_mesh(struct drawing *drawing, struct image *image, struct error *error) {
    const bool is_fan = drawing->number == FAN;
    const int count = is_fan ? FAN_BLADES : 2 * SHEET_CELLS * SHEET_CELLS;
    const int begin = is_fan ? 0 : SHEET_BEGIN; /* it covers these columns and rows */
    const int end = is_fan ? DRAW_LIMIT : SHEET_END;
    struct image small;
    if (!image_create(&small, (image->width + BLOCK - 1) / BLOCK,
                      (image->height + BLOCK - 1) / BLOCK, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = begin; y < end && y < (int)small.height; y++) {
        for (int x = begin; x < end && x < (int)small.width; x++) {
            show_pixel(image, x, y, not_drawn);
        }
    }
    for (int i = 0; i < count; i++) {
        struct fixed2 corner[3];
        const int grey = is_fan ? place_in_fan(i, &small, corner) : place_in_sheet(i, corner);
        fill_triangle(drawing, &small, corner, color_grey(255));
        show_drawn(&small, grey, image);
    }
    image_free(&small);
    return true;
}

/* ---- Scene: gradient, and text scenes ---- */

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

/* Fill a shape with one colour, or with a mixture of its corners' colours. */
static void fill_shape(struct drawing *drawing, struct image *image, const struct fixed2 corner[3],
                       const struct color color[3]) {
    const bool one_color = memcmp(&color[0], &color[1], 2 * sizeof color[0]) == 0;
    drawing_count(drawing, "pixels_written",
                  one_color ? fill_triangle(drawing, image, corner, color[0])
                            : gradient_triangle(image, corner, color));
}

static void draw_shape(struct drawing *drawing, struct image *image,
                       const struct text_scene_shape *shape) {
    struct vec2 screen[3];
    struct fixed2 corner[3];
    place_shape(shape, screen);
    if (snap_corners(screen, corner)) {
        fill_shape(drawing, image, corner, shape->color);
    }
}

static bool draw_gradient(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < sizeof colored_triangles / sizeof colored_triangles[0]; i++) {
        draw_shape(drawing, image, &colored_triangles[i]);
    }
    return true;
}

static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < drawing->text->shape_count; i++) {
        draw_shape(drawing, image, &drawing->text->shapes[i]);
    }
    return true;
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {.name = "outline", .draw = draw_outlines},
    {.name = "signs", .draw = draw_signs},
    {.name = "bust",
     .needs = NEEDS_MODEL,
     .width = 800,
     .height = 800,
     .number = BUST,
     .draw = draw_faces},
    {.name = "sheet", .width = 800, .height = 800, .number = SHEET, .draw = draw_mesh},
    {.name = "fan", .width = 800, .height = 800, .number = FAN, .draw = draw_mesh},
    {.name = "faces", .needs = NEEDS_MODEL, .width = 800, .height = 800, .draw = draw_faces},
    {.name = "gradient", .width = 800, .height = 800, .draw = draw_gradient},
};

static const struct program step03_triangle = {
    .name = "step03_triangle",
    .summary = "filled triangles: exact edge functions, the top-left rule, spans",
    .text_kind = TEXT_SCENE_TRIANGLES,
    .draw_text = draw_text,
    .skips = true,
    .defaults = {.width = 200, .height = 200},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
