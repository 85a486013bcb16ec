/*
 * Lesson 6, the given part: its scenes and the program.
 *
 * `texture` draws a model with its diffuse texture, nearest texel, times the intensity of the face.
 * `letters` draws a board that is larger than its clamped picture, two small boards far beyond that
 * picture, and a piece of cloth on which each pixel's centre is on the border between two texels.
 * `room` repeats the picture, without its border, on a floor and a wall in perspective, with the
 * nearest texel; the wall at the back has a smaller picture. A chart shows how whole numbers
 * repeat. `close` is a wall right before the camera, bilinear. `softer` shows the mip levels of
 * that picture, and what is between them. `mipmapped` is the room with a mip level for every pixel,
 * and `checker` is a plane of tiles towards the horizon, with mip levels, too. `wide` and `high`
 * draw the same in images of other shapes, `small` and `one_pixel` a board that covers all of
 * theirs.
 */

/* ---- Scene: texture ---- */

/* The corners of a face in the parallel view; z is the depth. False for a corner too far off the
 * image to draw. */
static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        struct vec3 world = model_position(model, face, i);
        vertices[i] = (struct vertex){.depth = world.z, .uv = model_uv(model, face, i)};
        if (!screen_snap(parallel_view(world, image->width, image->height),
                         &vertices[i].position)) {
            return false;
        }
    }
    return true;
}

static void count_pixels(struct drawing *drawing, const struct canvas *canvas) {
    drawing_count(drawing, "pixels_tested", canvas->pixels_tested);
    drawing_count(drawing, "pixels_written", canvas->pixels_written);
    drawing_count(drawing, "texels_fetched", canvas->texels_fetched);
}

/* All faces on which light falls, as in lesson 4. Returns how many had to be placed. */
static uint64_t draw_faces(const struct drawing *drawing, struct canvas *canvas) {
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    uint64_t placed = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = model_face_intensity(model, face, light);
        bool lit = intensity > 0;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn, so its place does not matter */
        }
        placed++;
        if (place_face(model, face, canvas->image, vertices) && lit) {
            triangle(canvas, vertices, drawing->diffuse, intensity);
        }
    }
    return placed;
}

static bool draw_texture(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = {.image = image, .depth = drawing->depth, .skip = drawing->skip};
    uint64_t placed = 0;
    for (size_t i = 0; drawing_take_part(drawing, i); i++) {
        placed += draw_faces(drawing, &canvas);
    }
    drawing_count(drawing, "faces_placed", placed);
    count_pixels(drawing, &canvas);
    return true;
}

/* ---- Scene: letters ---- */

/* What the probed pixel covers of a texture: a parallelogram. */
struct footprint {
    const struct texture *texture; /* NULL: of none */
    struct vec2 uv, right, up;     /* its middle, and its sides */
};

/* The pictures that the lesson makes itself. */
enum { LETTERS, BORDERED, FADING, CLOTH, MOSAIC, CHECKER, COLORED, PICTURES };

struct state {
    struct texture picture[PICTURES];
    struct footprint footprint;
};

/* A picture of 5 x 3 tiles with the letters A to O, so that every mix-up shows. */
enum {
    LETTERS_COLUMNS = 5,
    LETTERS_ROWS = 3,
    LETTERS_TILE = 32, /* texels a side */
    LETTERS_WIDTH = LETTERS_COLUMNS * LETTERS_TILE,
    LETTERS_HEIGHT = LETTERS_ROWS * LETTERS_TILE,
    LETTERS_STROKE = 4, /* texels; a letter is 3 strokes wide and 5 high */
    LETTERS_LEFT = 11,  /* texels of a tile left of a letter */
    LETTERS_BELOW = 7,
    LETTERS_JOINT = 2 /* dark texels at the left and lower side of a tile */
};

/* Each letter row by row from the top: a digit is the sum of 4 for the left stroke, 2 for the
 * middle and 1 for the right one. */
static const char letters[LETTERS_COLUMNS * LETTERS_ROWS][6] = {
    "25755", "65656", "34443", "65556", "74647", /* A B C D E */
    "74644", "34553", "55755", "72227", "11152", /* F G H I J */
    "55655", "44447", "57755", "65555", "25552", /* K L M N O */
};

/* Is texel (x,y) of a tile, (0,0) being its lower left one, part of its letter? */
static bool letter_covers(const char letter[6], int x, int y) {
    int column = (x - LETTERS_LEFT + LETTERS_STROKE) / LETTERS_STROKE - 1;
    int row = (y - LETTERS_BELOW + LETTERS_STROKE) / LETTERS_STROKE - 1;
    return column >= 0 && column < 3 && row >= 0 && row < 5 &&
           ((letter[4 - row] - '0') >> (2 - column) & 1) != 0;
}

static struct color letters_color(int x, int y) {
    const struct color light = color_rgb(245, 235, 215), dark = color_rgb(150, 45, 30);
    int column = x / LETTERS_TILE, row = y / LETTERS_TILE;
    int left = x % LETTERS_TILE, below = y % LETTERS_TILE;
    if (left < LETTERS_JOINT || below < LETTERS_JOINT) {
        return color_rgb(70, 60, 55);
    }
    const char *letter = letters[(LETTERS_ROWS - 1 - row) * LETTERS_COLUMNS + column];
    bool is_light = (column + row) % 2 == 0;
    return is_light != letter_covers(letter, left, below) ? light : dark;
}

/* The same with a border one texel wide that differs from what it surrounds: the dark joint at the
 * left and lower side, the colour of the next tile at the others. */
static struct color bordered_color(int x, int y) {
    if (x == LETTERS_WIDTH - 1) {
        return letters_color(x - LETTERS_TILE, y);
    }
    if (y == LETTERS_HEIGHT - 1) {
        return letters_color(x, y - LETTERS_TILE);
    }
    return letters_color(x == 1 ? LETTERS_JOINT : x, y == 1 ? LETTERS_JOINT : y);
}

/* The letters, more transparent from column to column. */
static struct color fading_color(int x, int y) {
    struct color color = letters_color(x, y);
    color.a = level_from(255 * (1 - (1 - 0.3) * x / (LETTERS_WIDTH - 1)));
    return color;
}

/* A texture from a function of its texels. */
static bool paint_picture(struct texture *texture, int width, int height,
                          struct color (*color)(int x, int y), struct error *error) {
    struct image image;
    if (!image_create(&image, (size_t)width, (size_t)height, IMAGE_BGRA, error)) {
        return false;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            image_set(&image, x, y, color(x, y));
        }
    }
    bool done = texture_create(texture, &image, error);
    image_free(&image);
    return done;
}

enum {
    CLOTH_SIDE = 64,   /* texels, and pixels */
    CLOTH_MARGIN = 16, /* pixels to the border of the image */
    MOSAIC_SIDE = 3    /* texels: the threads go on where the picture begins again */
};

/* Threads one texel wide, in three colours. */
static struct color cloth_color(int x, int y) {
    const struct color threads[3] = {color_rgb(245, 235, 215), color_rgb(150, 45, 30),
                                     color_rgb(60, 110, 130)};
    return threads[(x + y) % 3];
}

/* A board that faces us: where its corners are in the image, whose width and height are 1, and in
 * its picture. */
struct board {
    struct vec2 place[4], uv[4];
};

/* A little askew, and larger than its picture. */
static const struct board large_board = {{{0.10, 0.04}, {0.98, 0.17}, {0.90, 0.96}, {0.02, 0.83}},
                                         {{-0.3, -0.4}, {1.3, -0.4}, {1.3, 1.4}, {-0.3, 1.4}}};

/* Two small ones at the upper left. One shows the last column of its picture, the other the last
 * row: they are so far to the right of it, or above it, that an int cannot count the texels. */
static const struct board far_boards[] = {
    {{{0.02, 0.88}, {0.10, 0.88}, {0.10, 0.98}, {0.02, 0.98}},
     {{1e12, 0}, {1e12, 0}, {1e12, 1}, {1e12, 1}}},
    {{{0.11, 0.88}, {0.19, 0.88}, {0.19, 0.98}, {0.11, 0.98}},
     {{0, 1e12}, {1, 1e12}, {1, 1e12}, {0, 1e12}}},
};

/* At the lower right, with texels as large as pixels. The corners are at pixel centres, so all
 * pixel centres are at corners of texels. The side is a power of 2, so nothing is rounded. */
static struct board place_cloth(const struct image *image) {
    const double right = (double)image->width - CLOTH_MARGIN + 0.5, left = right - CLOTH_SIDE;
    const double low = CLOTH_MARGIN + 0.5, high = low + CLOTH_SIDE;
    return (struct board){{{left, low}, {right, low}, {right, high}, {left, high}},
                          {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
}

/* `scale` is the size of the image in pixels, or 1 for a board that is placed in pixels. */
static void draw_board(struct canvas *canvas, const struct board *board, struct vec2 scale,
                       const struct texture *texture, double intensity) {
    struct vertex v[4];
    for (int i = 0; i < 4; i++) {
        struct vec2 screen = {board->place[i].x * scale.x, board->place[i].y * scale.y};
        v[i] = (struct vertex){.uv = board->uv[i]};
        screen_snap(screen, &v[i].position); /* always within the limit */
    }
    triangle(canvas, (struct vertex[]){v[0], v[1], v[2]}, texture, intensity);
    triangle(canvas, (struct vertex[]){v[0], v[2], v[3]}, texture, intensity);
}

/* Larger than the image on all sides, which shows nearly all of its picture. */
static const struct board covering_board = {{{-0.4, -0.7}, {1.6, -0.3}, {1.4, 1.8}, {-0.3, 1.4}},
                                            {{-0.3, -0.4}, {1.5, -0.2}, {1.4, 1.5}, {-0.2, 1.3}}};

static bool draw_covered(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct texture *picture = ((struct state *)drawing->state)->picture;
    const struct vec2 size = {(double)image->width, (double)image->height};
    struct canvas canvas = {.image = image, .depth = drawing->depth, .skip = drawing->skip};
    draw_board(&canvas, &covering_board, size, &picture[MOSAIC], 1);
    return true;
}

static bool draw_letters(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct texture *picture = ((struct state *)drawing->state)->picture;
    const struct vec2 size = {(double)image->width, (double)image->height};
    const struct board cloth = place_cloth(image);
    struct canvas canvas = {.image = image, .depth = drawing->depth, .skip = drawing->skip};
    draw_board(&canvas, &large_board, size, &picture[BORDERED], 1);
    /* The same board again, darker: it is no nearer, so it must stay hidden. */
    draw_board(&canvas, &large_board, size, &picture[BORDERED], 0.5);
    draw_board(&canvas, &cloth, (struct vec2){1, 1}, &picture[CLOTH], 1);
    draw_board(&canvas, &far_boards[0], size, &picture[BORDERED], 1);
    draw_board(&canvas, &far_boards[1], size, &picture[BORDERED], 1);
    count_pixels(drawing, &canvas);
    return true;
}

/* ---- Scene: checker ---- */

enum { CHECKER_SIZE = 256 }; /* texels a side: a picture of two by two tiles */

/* The edges of the picture run through the middle of tiles, so both sides of the seam between two
 * repeated pictures have the same colour, on every mip level. */
static struct color checker_color(int x, int y) {
    int column = (x + CHECKER_SIZE / 4) / (CHECKER_SIZE / 2); /* 0, 1 or 2 */
    int row = (y + CHECKER_SIZE / 4) / (CHECKER_SIZE / 2);
    return (column + row) % 2 == 0 ? color_rgb(245, 235, 215) : color_rgb(150, 45, 30);
}

static bool make_checker(struct texture *texture, struct error *error) {
    return paint_picture(texture, CHECKER_SIZE, CHECKER_SIZE, checker_color, error);
}

/* A texel, made lighter and then multiplied by a colour: all tiles stay visible. */
static uint32_t tinted(uint32_t texel, uint32_t color) {
    uint32_t result = 0xFF000000;
    for (int shift = 0; shift < 24; shift += 8) {
        uint32_t part = texel >> shift & 255, of = color >> shift & 255;
        result |= ((part + 255) / 2 * of / 255) << shift;
    }
    return result;
}

/* The tiles, in another colour on each level: white, yellow, light blue, green, orange... */
static bool make_colored(struct texture *texture, struct error *error) {
    static const uint32_t colors[] = {0xFFFFFF, 0xF0E442, 0x56B4E9, 0x009E73, 0xE69F00,
                                      0xD55E00, 0xCC79A7, 0x0072B2, 0x404040};
    bool done = make_checker(texture, error);
    for (size_t i = 0; done && i < texture->level_count; i++) {
        const struct texture_level *level = &texture->level[i];
        for (size_t k = 0; k < level->pitch * level->height; k++) {
            level->texels[k] = tinted(level->texels[k], colors[i]);
        }
    }
    return done;
}

/* The camera is at the origin and looks along -z. The plane is PLANE_BELOW under it, rolled about
 * the line of sight so that the distance changes along every row: (COSINE, SINE) points to the
 * right in the plane. The plane ends at PLANE_NEAR, below the image, and at PLANE_FAR. */
#define PLANE_COSINE 0.96
#define PLANE_SINE   0.28
#define PLANE_BELOW  1.5
#define PLANE_SIDE   72.0
#define PLANE_NEAR   0.75
#define PLANE_FAR    60.0

#include "attempts.h"

/* What one can change: every scene has its own sampler. */
#define VIEW_VALUES(sampler)                                                                       \
    {                                                                                              \
        {"sampler", "0 nearest, 1 bilinear, 2 with mip levels", 0, 2, 1, sampler},                 \
            {"attempt", "0 the sampler, 1 nearest by rounding, 2 bilinear from corners", 0, 2, 1,  \
             0},                                                                                   \
            {"affine", "u and v are mixed without 1/w", 0, 1, 1, 0},                               \
            {"level", "the finest mip level that is read", 0, 8, 1, 0},                            \
            {"colors", "every mip level has its own colour", 0, 1, 1, 0},                          \
            {"footprint", "the pixel under the cursor on the texture", 0, 1, 1, 0},                \
            {"walk", "how far the camera walks ahead", -2, 0.5, 0.05, 0}, {                        \
            .name = NULL                                                                           \
        }                                                                                          \
    }
static const struct scene_value nearest_values[] = VIEW_VALUES(SAMPLE_NEAREST);
static const struct scene_value bilinear_values[] = VIEW_VALUES(SAMPLE_BILINEAR);
static const struct scene_value trilinear_values[] = VIEW_VALUES(SAMPLE_TRILINEAR);

/* Where a point appears: `side` units to the right of the line of sight, `height` over the plane,
 * `distance` before the camera. In perspective that is its x and y divided by w, the distance. */
static struct vertex place_over_plane(double side, double height, double distance,
                                      const struct image *image) {
    double above = height - PLANE_BELOW;
    double x = PLANE_COSINE * side - PLANE_SINE * above;
    double y = PLANE_SINE * side + PLANE_COSINE * above;
    struct vec2 screen = {(0.5 + 0.5 * x / distance) * (double)image->width,
                          (0.75 + 0.5 * y / distance) * (double)image->height};
    struct vertex vertex = {.recip_w = 1 / distance};
    screen_snap(screen, &vertex.position); /* never beyond the limit: 0.5 * 72 / 0.75 images */
    return vertex;
}

/* A corner of a surface: its place over the plane, and its texture coordinates. */
struct surface_corner {
    double side, height, distance;
    struct vec2 uv;
};

static void place_surface(const struct drawing *drawing, const struct image *image,
                          const struct surface_corner places[4], struct vertex corners[4]) {
    const bool affine = drawing_value(drawing, "affine") != 0;
    for (int i = 0; i < 4; i++) {
        corners[i] = place_over_plane(places[i].side, places[i].height,
                                      places[i].distance - drawing_value(drawing, "walk"), image);
        corners[i].uv = places[i].uv;
        corners[i].recip_w = affine ? 1 : corners[i].recip_w;
    }
}

/* The plane itself, counterclockwise. One unit of it is one picture: two tiles. */
static const struct surface_corner plane_corners[4] = {
    {-PLANE_SIDE, 0, PLANE_NEAR, {-PLANE_SIDE, PLANE_NEAR}},
    {PLANE_SIDE, 0, PLANE_NEAR, {PLANE_SIDE, PLANE_NEAR}},
    {PLANE_SIDE, 0, PLANE_FAR, {PLANE_SIDE, PLANE_FAR}},
    {-PLANE_SIDE, 0, PLANE_FAR, {-PLANE_SIDE, PLANE_FAR}},
};

/* A point of the footprint, `right` and `up` from its middle, in texels. */
static struct vec2 footprint_texel(const struct footprint *f, double right, double up) {
    const struct texture_level *level = &f->texture->level[0];
    return (struct vec2){(right * f->right.x + up * f->up.x) * (double)level->width,
                         (right * f->right.y + up * f->up.y) * (double)level->height};
}

/* Texel i of a picture that repeats. */
static size_t repeated(double i, size_t size) {
    return (size_t)(i - floor(i / (double)size) * (double)size);
}

/* Show the texels around the footprint in a corner of the image, with its outline. */
static void show_footprint(struct image *image, const struct footprint *f) {
    static const double half[][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const struct texture_level *level = &f->texture->level[0];
    const int side = (int)image->height / 3;
    struct vec2 corner[4];
    double reach = 2;
    for (int i = 0; i < 4; i++) {
        corner[i] = footprint_texel(f, half[i][0], half[i][1]);
        reach = fmax(reach, fmax(fabs(corner[i].x), fabs(corner[i].y)));
    }
    const double texels = 4 * reach / side; /* in a pixel */
    for (int i = 0; i < side * side; i++) {
        const double x = f->uv.x * (double)level->width + (i % side + 0.5 - side / 2.0) * texels;
        const double y = f->uv.y * (double)level->height + (i / side + 0.5 - side / 2.0) * texels;
        const uint32_t texel = texture_texel(level, repeated(floor(x), level->width),
                                             repeated(floor(y), level->height));
        image_set(image, i % side, i / side, color_from_texel(texel));
    }
    for (int i = 0; i < 4; i++) {
        const struct vec2 a = corner[i], b = corner[(i + 1) % 4];
        const struct pixel from = {side / 2 + (int)floor(a.x / texels),
                                   side / 2 + (int)floor(a.y / texels)};
        const struct pixel to = {side / 2 + (int)floor(b.x / texels),
                                 side / 2 + (int)floor(b.y / texels)};
        struct line_walk walk;
        bool more = line_begin(&walk, from, to, image->width, image->height);
        for (; more; more = line_next(&walk)) {
            image_set(image, walk.x, walk.y, color_rgb(255, 0, 255));
        }
    }
}

/* After all else that the probed pixel may show. */
static bool end_view(struct drawing *drawing, struct image *image) {
    struct state *state = drawing->state;
    if (state->footprint.texture != NULL && drawing_value(drawing, "footprint") != 0) {
        show_footprint(image, &state->footprint);
    }
    state->footprint.texture = NULL;
    return true;
}

/* What the probed pixel shows of a triangle. */
static void note_texel(struct drawing *drawing, const struct image *image, const struct vertex v[3],
                       const struct texture *texture) {
    struct state *state = drawing->state;
    const int x = drawing->probe.x, y = drawing->probe.y;
    struct quotients plane;
    if (!drawing->probed || !plane_begin(&plane, image, v) || !edges_cover(&plane.edges, x, y)) {
        return;
    }
    double w;
    const struct vec2 uv = plane_uv(&plane, x, y, &w);
    const struct vec2 right = uv_step(plane.right, uv, w), up = uv_step(plane.up, uv, w);
    const struct footprint footprint = {texture, uv, right, up};
    const struct vec2 r = footprint_texel(&footprint, 1, 0), u = footprint_texel(&footprint, 0, 1);
    state->footprint = footprint;
    drawing_note(drawing, "u %.4f  v %.4f  w %.4f", uv.x, uv.y, w);
    drawing_note(drawing, "u/w %.4f  v/w %.4f  1/w %.4f", uv.x / w, uv.y / w, 1 / w);
    drawing_note(drawing, "texels to the next pixel: right (%.2f, %.2f), up (%.2f, %.2f)", r.x, r.y,
                 u.x, u.y);
    drawing_note(drawing, "mip level %.2f", mip_level(right, up, texture));
}

/* The texture without the levels below that one. */
static struct texture from_level(const struct texture *texture, size_t first) {
    struct texture coarse = *texture;
    first = first < texture->level_count ? first : texture->level_count - 1;
    coarse.level_count -= first;
    for (size_t i = 0; i < coarse.level_count; i++) {
        coarse.level[i] = texture->level[first + i];
    }
    return coarse;
}

/* By an attempt, or by what the lesson writes. */
static void draw_plane(struct drawing *drawing, struct image *image, const struct vertex corners[4],
                       const struct texture *texture) {
    const struct vertex first[3] = {corners[0], corners[1], corners[2]};
    const struct vertex second[3] = {corners[0], corners[2], corners[3]};
    const struct state *state = drawing->state;
    const enum sampler sampler = (enum sampler)drawing_value(drawing, "sampler");
    struct canvas canvas = {.image = image, .sampler = sampler, .skip = drawing->skip};
    note_texel(drawing, image, first, texture);
    note_texel(drawing, image, second, texture);
    texture = drawing_value(drawing, "colors") != 0 ? &state->picture[COLORED] : texture;
    const struct texture coarse = from_level(texture, (size_t)drawing_value(drawing, "level"));
    static attempt_function *const attempts[] = {attempt_1_rounded, attempt_3_unshifted};
    const int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt > 0) {
        attempt_quad(image, corners, &coarse, attempts[attempt - 1]);
        return;
    }
    perspective_triangle(&canvas, first, &coarse);
    perspective_triangle(&canvas, second, &coarse);
    drawing_count(drawing, "pixels_written", canvas.pixels_written);
    drawing_count(drawing, "texels_fetched", canvas.texels_fetched);
}

static void draw_surface(struct drawing *drawing, struct image *image,
                         const struct surface_corner places[4], const struct texture *texture) {
    struct vertex corners[4];
    place_surface(drawing, image, places, corners);
    draw_plane(drawing, image, corners, texture);
}

static bool draw_checker(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    draw_surface(drawing, image, plane_corners, &state->picture[CHECKER]);
    return end_view(drawing, image);
}

/* ---- Scenes: room, close and mipmapped ---- */

/* A wall on the plane of scene checker, along the left side of a floor. */
#define ROOM_LEFT  (-3.1)
#define ROOM_RIGHT 2.3
#define ROOM_NEAR  1.3
#define ROOM_FAR   6.1
#define ROOM_HIGH  1.7

/* A place of a wall or the floor, in units of the room. The picture of the letters is 2 units wide
 * and 1.2 high, so that its tiles are squares. */
#define ROOM_UV(across, along)                                                                     \
    { (across) / 2, (along) / 1.2 }

static const struct surface_corner floor_corners[4] = {
    {ROOM_LEFT, 0, ROOM_NEAR, ROOM_UV(ROOM_LEFT, ROOM_NEAR)},
    {ROOM_RIGHT, 0, ROOM_NEAR, ROOM_UV(ROOM_RIGHT, ROOM_NEAR)},
    {ROOM_RIGHT, 0, ROOM_FAR, ROOM_UV(ROOM_RIGHT, ROOM_FAR)},
    {ROOM_LEFT, 0, ROOM_FAR, ROOM_UV(ROOM_LEFT, ROOM_FAR)},
};

/* At the floor v is -3, and so negative on the whole wall. */
static const struct surface_corner wall_corners[4] = {
    {ROOM_LEFT, 0, ROOM_NEAR, {ROOM_NEAR / 2, -3}},
    {ROOM_LEFT, 0, ROOM_FAR, {ROOM_FAR / 2, -3}},
    {ROOM_LEFT, ROOM_HIGH, ROOM_FAR, {ROOM_FAR / 2, ROOM_HIGH / 1.2 - 3}},
    {ROOM_LEFT, ROOM_HIGH, ROOM_NEAR, {ROOM_NEAR / 2, ROOM_HIGH / 1.2 - 3}},
};

/* Its picture has fewer texels than that of the letters, and so fewer levels. */
static const struct surface_corner back_corners[4] = {
    {ROOM_LEFT, 0, ROOM_FAR, {ROOM_LEFT * (1 / 0.9), 0}},
    {ROOM_RIGHT, 0, ROOM_FAR, {ROOM_RIGHT * (1 / 0.9), 0}},
    {ROOM_RIGHT, ROOM_HIGH, ROOM_FAR, {ROOM_RIGHT * (1 / 0.9), ROOM_HIGH *(1 / 0.9)}},
    {ROOM_LEFT, ROOM_HIGH, ROOM_FAR, {ROOM_LEFT * (1 / 0.9), ROOM_HIGH *(1 / 0.9)}},
};

/* A piece of wall right before the camera: a texel is larger than a pixel everywhere. */
static const struct surface_corner close_corners[4] = {
    {-0.75, 0.35, 1.0, ROOM_UV(-0.75, 0.35)},
    {1.05, 0.05, 1.5, ROOM_UV(1.05, 0.05)},
    {1.05, 1.25, 1.5, ROOM_UV(1.05, 1.25)},
    {-0.75, 1.55, 1.0, ROOM_UV(-0.75, 1.55)},
};

static bool draw_close(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    draw_surface(drawing, image, close_corners, &state->picture[LETTERS]);
    return end_view(drawing, image);
}

static void draw_surfaces(struct drawing *drawing, struct image *image) {
    const struct state *state = drawing->state;
    /* First the picture with few levels: those with more must not be read as if they had as few. */
    draw_surface(drawing, image, back_corners, &state->picture[MOSAIC]);
    draw_surface(drawing, image, floor_corners, &state->picture[LETTERS]);
    draw_surface(drawing, image, wall_corners, &state->picture[LETTERS]);
}

/* In the upper right corner: u goes from -2 to 2 to the right, v upwards, in steps of a quarter. At
 * whole numbers, negative ones too, the picture begins again with its first texels. */
static void draw_chart(struct image *image, const struct texture *texture) {
    const int side = (int)image->width / 80, cells = 17;
    const int left = (int)image->width - side * cells, below = (int)image->height - side * cells;
    for (int row = 0; row < cells; row++) {
        for (int column = 0; column < cells; column++) {
            struct vec2 uv = {column / 4.0 - 2, row / 4.0 - 2};
            struct color color = sample_nearest(texture, uv);
            for (int i = 0; i < side * side; i++) {
                image_set(image, left + column * side + i % side, below + row * side + i / side,
                          color);
            }
        }
    }
}

static bool draw_room(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    draw_surfaces(drawing, image);
    draw_chart(image, &state->picture[LETTERS]);
    return end_view(drawing, image);
}

static bool draw_mipmapped(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_surfaces(drawing, image);
    return end_view(drawing, image);
}

/* ---- Scene: softer ---- */

enum { SOFTER_SIDE = 3 }; /* cells in a row, and rows */

/* One cell: the whole picture, one level finer at its left edge than at its right one. */
static void draw_softer_cell(struct image *image, struct rectangle cell,
                             const struct texture *texture, double coarsest) {
    for (int y = 0; y < cell.height; y++) {
        for (int x = 0; x < cell.width; x++) {
            struct vec2 uv = {(x + 0.5) / cell.width, (y + 0.5) / cell.height};
            struct vec4 c = sample_trilinear(texture, uv, coarsest - 1 + uv.x);
            double alpha = c.w / 255; /* over black: the more transparent, the darker */
            image_set(image, cell.x + x, cell.y + y,
                      color_rgb(level_from(c.x * alpha), level_from(c.y * alpha),
                                level_from(c.z * alpha)));
        }
    }
}

/* Levels -1 to 8, from the top left. There are levels 0 to 7 of the letters; they fade to the right
 * by their alpha alone, so that even the last two are not alike. */
static bool draw_softer(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    for (int i = 0; i < SOFTER_SIDE * SOFTER_SIDE; i++) {
        struct rectangle cell = grid_cell(image->width, image->height, SOFTER_SIDE, SOFTER_SIDE, i);
        draw_softer_cell(image, cell, &state->picture[FADING], i);
    }
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    struct state *state = drawing->state;
    if (drawing->model != NULL) {
        return true;
    }
    struct texture *picture = state->picture;
    bool made =
        paint_picture(&picture[LETTERS], LETTERS_WIDTH, LETTERS_HEIGHT, letters_color, error) &&
        paint_picture(&picture[BORDERED], LETTERS_WIDTH, LETTERS_HEIGHT, bordered_color, error) &&
        paint_picture(&picture[FADING], LETTERS_WIDTH, LETTERS_HEIGHT, fading_color, error) &&
        paint_picture(&picture[CLOTH], CLOTH_SIDE, CLOTH_SIDE, cloth_color, error) &&
        paint_picture(&picture[MOSAIC], MOSAIC_SIDE, MOSAIC_SIDE, cloth_color, error) &&
        make_checker(&picture[CHECKER], error) && make_colored(&picture[COLORED], error);
    texture_set_clamp(&picture[BORDERED], true);
    texture_set_clamp(&picture[FADING], true);
    return made;
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    for (int i = 0; i < PICTURES; i++) {
        texture_free(&state->picture[i]);
    }
}

static const struct scene scenes[] = {
    {
        .name = "texture",
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .draw = draw_texture,
    },
    {
        .name = "letters",
        .needs = NEEDS_DEPTH,
        .width = 800,
        .height = 600,
        .draw = draw_letters,
    },
    {.name = "room", .width = 800, .height = 600, .values = nearest_values, .draw = draw_room},
    {.name = "close", .width = 800, .height = 600, .values = bilinear_values, .draw = draw_close},
    {.name = "softer", .width = 800, .height = 480, .draw = draw_softer},
    {
        .name = "mipmapped",
        .width = 800,
        .height = 600,
        .values = trilinear_values,
        .draw = draw_mipmapped,
    },
    {.name = "checker", .values = trilinear_values, .draw = draw_checker},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {
        .name = "wide",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .width = 203,
        .height = 67,
        .draw = draw_texture,
    },
    {
        .name = "high",
        .detail = true,
        .width = 61,
        .height = 181,
        .values = trilinear_values,
        .draw = draw_mipmapped,
    },
    {
        .name = "small",
        .detail = true,
        .needs = NEEDS_DEPTH,
        .width = 23,
        .height = 13,
        .draw = draw_covered,
    },
    {
        .name = "one_pixel",
        .detail = true,
        .needs = NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .draw = draw_covered,
    },
};

static const struct program step06_texture = {
    .name = "step06_texture",
    .summary = "pictures on triangles: nearest, bilinear and mip-mapped",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
    .state_size = sizeof(struct state),
    .prepare = prepare,
    .finish = finish,
};
