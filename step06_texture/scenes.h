/* Lesson 6, the given part: the pictures of README.md, and the program. */

/* ---- Scene: texture ---- */

/* The corners of a face in the parallel view; z is the depth. False for a corner too far off the
 * image to draw. */
static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex v[3]) {
    for (size_t i = 0; i < 3; i++) {
        const struct vec3 world = model_position(model, face, i);
        v[i] = (struct vertex){.depth = world.z, .uv = model_uv(model, face, i)};
        if (!screen_snap(parallel_view(world, image->width, image->height), &v[i].position)) {
            return false;
        }
    }
    return true;
}

/* All faces on which light falls, as in lesson 4. A model of several materials has several parts,
 * each with its own texture. */
static bool draw_texture(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct vec3 light = vec3_normalized(drawing->light);
    const struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t part = 0; drawing_take_part(drawing, part); part++) {
        for (size_t face = 0; face < drawing->model->face_count; face++) {
            struct vertex v[3];
            const double intensity = model_face_intensity(drawing->model, face, light);
            if (intensity > 0 && place_face(drawing->model, face, image, v)) {
                triangle(&canvas, v, drawing->diffuse, intensity);
            }
        }
    }
    return true;
}

/* ---- Patterns for the other scenes ---- */

/* A texture before it is painted: the colour of each texel. (0,0) is the lower left one. */
struct pattern {
    int width, height;
    struct color (*color)(int x, int y);
    bool clamp; /* its edge goes on outside; otherwise the pattern repeats */
};

static const struct color light_tile = {.b = 215, .g = 235, .r = 245, .a = 255};
static const struct color dark_tile = {.b = 30, .g = 45, .r = 150, .a = 255};

/* Row by row from the top: a digit is the sum of 4 for the left stroke, 2 for the middle and 1 for
 * the right one. */
static const char letters[][6] = {
    "25755", "65656", "34443", "65556", "74647", /* A B C D E */
    "74644", "34553", "55755", "72227", "11152", /* F G H I J */
    "55655", "44447", "57755", "65555", "25552", /* K L M N O */
};

/* Tiles of 32 x 32 texels with dark joints, five in a row, and three rows. The strokes of a letter
 * are 4 texels wide; column 1 and row 1 are its lower left corner. */
enum { LETTERS_WIDTH = 5 * 32, LETTERS_HEIGHT = 3 * 32 };

static struct color letters_color(int x, int y) {
    const int tile = (2 - y / 32) * 5 + x / 32, left = x % 32, below = y % 32;
    const int column = (left - 7) / 4, row = (below - 3) / 4;
    if (left < 2 || below < 2) {
        return color_rgb(70, 60, 55);
    }
    const bool on_letter = column >= 1 && column <= 3 && row >= 1 && row <= 5 &&
                           ((letters[tile][5 - row] - '0') >> (3 - column) & 1) != 0;
    return (tile % 2 == 0) != on_letter ? light_tile : dark_tile;
}

/* The letters with a border one texel wide in other colours, which shows how the edge goes on. */
static struct color bordered_color(int x, int y) {
    if (x == LETTERS_WIDTH - 1) {
        return letters_color(x - 32, y);
    }
    if (y == LETTERS_HEIGHT - 1) {
        return letters_color(x, y - 32);
    }
    return letters_color(x == 1 ? 2 : x, y == 1 ? 2 : y);
}

/* The letters, more transparent from column to column. */
static struct color fading_color(int x, int y) {
    struct color color = letters_color(x, y);
    color.a = level_from(255 * (1 - (1 - 0.3) * x / (LETTERS_WIDTH - 1)));
    return color;
}

/* Threads one texel wide. */
static struct color cloth_color(int x, int y) {
    const struct color threads[3] = {light_tile, dark_tile, color_rgb(60, 110, 130)};
    return threads[(x + y) % 3];
}

/* Two by two tiles of 128 x 128 texels. The pattern's edges run through the middle of tiles. */
static struct color checker_color(int x, int y) {
    return ((x + 64) / 128 + (y + 64) / 128) % 2 == 0 ? light_tile : dark_tile;
}

static const struct pattern lettered = {LETTERS_WIDTH, LETTERS_HEIGHT, letters_color, false};
static const struct pattern bordered = {LETTERS_WIDTH, LETTERS_HEIGHT, bordered_color, true};
static const struct pattern fading = {LETTERS_WIDTH, LETTERS_HEIGHT, fading_color, true};
static const struct pattern cloth = {64, 64, cloth_color, false};
static const struct pattern small_cloth = {3, 3, cloth_color, false};
static const struct pattern checker = {256, 256, checker_color, false};

/* The pattern as a texture, to be freed by the caller. */
static bool paint(struct texture *texture, const struct pattern *pattern, struct error *error) {
    struct image image;
    if (!image_create(&image, (size_t)pattern->width, (size_t)pattern->height, IMAGE_BGRA, error)) {
        return false;
    }
    for (int y = 0; y < pattern->height; y++) {
        for (int x = 0; x < pattern->width; x++) {
            image_set(&image, x, y, pattern->color(x, y));
        }
    }
    const bool done = texture_create(texture, &image, error);
    image_free(&image);
    if (done) {
        texture_set_clamp(texture, pattern->clamp);
    }
    return done;
}

/* ---- Surfaces ---- */

/* Four corners, counterclockwise, with a pattern between them. */
struct surface {
    const struct pattern *pattern;
    struct vec3 place[4];
    struct vec2 uv[4];
};

/* Place the corners on the screen. One whose z is 0 is given in pixels. The others say how far they
 * are to our right, above the floor and ahead: the farther, the smaller. The floor is rolled, so
 * that the distance changes along every row. */
static void place_surface(const struct surface *s, const struct image *image, struct vertex v[4]) {
    const double width = (double)image->width, height = (double)image->height;
    for (int i = 0; i < 4; i++) {
        const struct vec3 p = s->place[i];
        struct vec2 screen = {p.x, p.y};
        v[i] = (struct vertex){.uv = s->uv[i]};
        if (p.z > 0) {
            const double x = 0.96 * p.x - 0.28 * (p.y - 1.5), y = 0.28 * p.x + 0.96 * (p.y - 1.5);
            screen = (struct vec2){(0.5 + 0.5 * x / p.z) * width, (0.75 + 0.5 * y / p.z) * height};
            v[i].recip_w = 1 / p.z;
        }
        screen_snap(screen, &v[i].position); /* always within the limit */
    }
}

static bool draw_surfaces(const struct canvas *canvas, const struct surface *surfaces, size_t count,
                          struct error *error) {
    for (size_t i = 0; i < count; i++) {
        struct texture texture;
        struct vertex v[4];
        if (!paint(&texture, surfaces[i].pattern, error)) {
            return false;
        }
        place_surface(&surfaces[i], canvas->image, v);
        const struct vertex lower[3] = {v[0], v[1], v[2]}, upper[3] = {v[0], v[2], v[3]};
        if (canvas->depth != NULL) {
            triangle(canvas, lower, &texture, 1);
            triangle(canvas, upper, &texture, 1);
        } else {
            perspective_triangle(canvas, lower, &texture);
            perspective_triangle(canvas, upper, &texture);
        }
        texture_free(&texture);
    }
    return true;
}

/* ---- Scene: letters ---- */

/* The first board is larger than its pattern, and a little askew. Then comes cloth with texels as
 * large as pixels, so that each pixel centre is on the border between two texels. The last two show
 * the last column and the last row of their pattern, but so far beyond it that an int can't count
 * the texels. */
static const struct surface boards[] = {
    {&bordered,
     {{80, 24, 0}, {784, 102, 0}, {720, 576, 0}, {16, 498, 0}},
     {{-0.3, -0.4}, {1.3, -0.4}, {1.3, 1.4}, {-0.3, 1.4}}},
    {&cloth,
     {{720.5, 16.5, 0}, {784.5, 16.5, 0}, {784.5, 80.5, 0}, {720.5, 80.5, 0}},
     {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
    {&bordered,
     {{16, 528, 0}, {80, 528, 0}, {80, 588, 0}, {16, 588, 0}},
     {{1e12, 0}, {1e12, 0}, {1e12, 1}, {1e12, 1}}},
    {&bordered,
     {{88, 528, 0}, {152, 528, 0}, {152, 588, 0}, {88, 588, 0}},
     {{0, 1e12}, {1, 1e12}, {1, 1e12}, {0, 1e12}}},
};

static bool draw_letters(struct drawing *drawing, struct image *image, struct error *error) {
    const struct canvas canvas = {.image = image, .depth = drawing->depth};
    return draw_surfaces(&canvas, boards, sizeof boards / sizeof boards[0], error);
}

/* ---- Scenes: room, close, mipmapped and checker ---- */

/* The wall at the back, the floor, and the wall at the left, where v is negative. */
static const struct surface room[] = {
    {&small_cloth,
     {{-3.1, 0, 6.1}, {2.3, 0, 6.1}, {2.3, 1.7, 6.1}, {-3.1, 1.7, 6.1}},
     {{-3.1 / 0.9, 0}, {2.3 / 0.9, 0}, {2.3 / 0.9, 1.7 / 0.9}, {-3.1 / 0.9, 1.7 / 0.9}}},
    {&lettered,
     {{-3.1, 0, 1.3}, {2.3, 0, 1.3}, {2.3, 0, 6.1}, {-3.1, 0, 6.1}},
     {{-1.55, 1.3 / 1.2}, {1.15, 1.3 / 1.2}, {1.15, 6.1 / 1.2}, {-1.55, 6.1 / 1.2}}},
    {&lettered,
     {{-3.1, 0, 1.3}, {-3.1, 0, 6.1}, {-3.1, 1.7, 6.1}, {-3.1, 1.7, 1.3}},
     {{0.65, -3}, {3.05, -3}, {3.05, 1.7 / 1.2 - 3}, {0.65, 1.7 / 1.2 - 3}}},
};
enum { ROOM_SURFACES = sizeof room / sizeof room[0] };

/* A wall so near that every texel is larger than a pixel. */
static const struct surface close_wall = {
    &lettered,
    {{-0.75, 0.35, 1}, {1.05, 0.05, 1.5}, {1.05, 1.25, 1.5}, {-0.75, 1.55, 1}},
    {{-0.375, 0.35 / 1.2}, {0.525, 0.05 / 1.2}, {0.525, 1.25 / 1.2}, {-0.375, 1.55 / 1.2}},
};

/* A plane that goes to the horizon. One unit is one pattern: two tiles. */
static const struct surface plane_of_tiles = {
    &checker,
    {{-72, 0, 0.75}, {72, 0, 0.75}, {72, 0, 60}, {-72, 0, 60}},
    {{-72, 0.75}, {72, 0.75}, {72, 60}, {-72, 60}},
};

/* Draw a chart in the upper right corner: u from -2 to 2 to the right, v upwards, by quarters. */
static void draw_chart(struct image *image, const struct texture *texture) {
    const int cell = (int)image->width / 80, side = 17 * cell;
    const int left = (int)image->width - side, below = (int)image->height - side;
    for (int i = 0; i < side * side; i++) {
        const int x = i % side, y = i / side;
        const struct vec2 uv = {x / cell / 4.0 - 2, y / cell / 4.0 - 2};
        image_set(image, left + x, below + y, sample_nearest(texture, uv));
    }
}

static bool draw_room(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    const struct canvas canvas = {.image = image, .sampler = SAMPLE_NEAREST};
    struct texture texture;
    if (!draw_surfaces(&canvas, room, ROOM_SURFACES, error) || !paint(&texture, &lettered, error)) {
        return false;
    }
    draw_chart(image, &texture);
    texture_free(&texture);
    return true;
}

static bool draw_close(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    const struct canvas canvas = {.image = image, .sampler = SAMPLE_BILINEAR};
    return draw_surfaces(&canvas, &close_wall, 1, error);
}

/* Draw the levels -1 to 8 in nine cells, from the top left: across each the level grows by 1. */
static bool draw_softer(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    struct texture texture;
    if (!paint(&texture, &fading, error)) {
        return false;
    }
    for (int i = 0; i < 9; i++) {
        const struct rectangle cell = grid_cell(image->width, image->height, 3, 3, i);
        for (int k = 0; k < cell.width * cell.height; k++) {
            const int x = k % cell.width, y = k / cell.width;
            const struct vec2 uv = {(x + 0.5) / cell.width, (y + 0.5) / cell.height};
            const struct vec4 c = sample_trilinear(&texture, uv, i - 1 + uv.x);
            const double alpha = c.w / 255; /* over black: the more transparent, the darker */
            image_set(image, cell.x + x, cell.y + y,
                      color_rgb(level_from(c.x * alpha), level_from(c.y * alpha),
                                level_from(c.z * alpha)));
        }
    }
    texture_free(&texture);
    return true;
}

static bool draw_mipmapped(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    const struct canvas canvas = {.image = image, .sampler = SAMPLE_TRILINEAR};
    return draw_surfaces(&canvas, room, ROOM_SURFACES, error);
}

static bool draw_checker(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    const struct canvas canvas = {.image = image, .sampler = SAMPLE_TRILINEAR};
    return draw_surfaces(&canvas, &plane_of_tiles, 1, error);
}

/* ---- The program ---- */

enum { MODEL_AND_COLORS = NEEDS_MODEL | NEEDS_PICTURE | NEEDS_DEPTH };

static const struct scene scenes[] = {
    {.name = "texture", .needs = MODEL_AND_COLORS, .draw = draw_texture},
    {.name = "letters", .needs = NEEDS_DEPTH, .height = 600, .draw = draw_letters},
    {.name = "room", .height = 600, .draw = draw_room},
    {.name = "close", .height = 600, .draw = draw_close},
    {.name = "softer", .height = 480, .draw = draw_softer},
    {.name = "mipmapped", .height = 600, .draw = draw_mipmapped},
    {.name = "checker", .draw = draw_checker},
};

static const struct program step06_texture = {
    .name = "step06_texture",
    .summary = "pictures on triangles: nearest, bilinear and mip-mapped",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
