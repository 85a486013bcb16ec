/* Lesson 8, the given part: the pictures of README.md, and the program. */

/* From NDC to a part of the image: the viewport, moved there. */
static struct mat4 area_to_screen(struct rectangle area) {
    const struct vec3 corner = {area.x, area.y, 0};
    return mat4_mul(mat4_translation(corner), viewport((size_t)area.width, (size_t)area.height));
}

static struct rectangle whole_image(const struct image *image) {
    return (struct rectangle){0, 0, (int)image->width, (int)image->height};
}

static void fill_area(struct image *image, struct rectangle area, struct color color) {
    for (int y = area.y; y < area.y + area.height; y++) {
        image_fill_row(image, y, area.x, area.x + area.width, color);
    }
}

/* ---- Part a: a house in the plane ---- */

/* Convex polygons, from back to front. */
static const struct part {
    struct vec2 corner[4]; /* counterclockwise; a triangle repeats its last corner */
    struct color color;
} house[] = {
    {{{0.74, 0.9}, {0.9, 0.9}, {0.9, 1.3}, {0.74, 1.3}}, {.r = 150, .g = 110, .b = 95, .a = 255}},
    {{{0, 0}, {1, 0}, {1, 0.8}, {0, 0.8}}, {.r = 236, .g = 196, .b = 110, .a = 255}},
    {{{-0.15, 0.8}, {1.15, 0.8}, {0.5, 1.35}, {0.5, 1.35}}, {.r = 206, .g = 74, .b = 52, .a = 255}},
    {{{0.14, 0}, {0.42, 0}, {0.42, 0.56}, {0.14, 0.56}}, {.r = 96, .g = 62, .b = 40, .a = 255}},
    {{{0.58, 0.32}, {0.86, 0.32}, {0.86, 0.6}, {0.58, 0.6}},
     {.r = 110, .g = 180, .b = 225, .a = 255}},
};

enum { HOUSE_PARTS = sizeof house / sizeof house[0], PANELS = 9 };

/* A part of the image that shows a part of the plane. */
struct plane {
    struct image *image;
    struct rectangle area; /* nothing is drawn outside */
    struct mat4 to_screen; /* from the plane to pixels of the image */
};

static void plane_pixel(const struct plane *plane, int x, int y, struct color color) {
    const struct rectangle *area = &plane->area;
    if (x >= area->x && x < area->x + area->width && y >= area->y && y < area->y + area->height) {
        image_set(plane->image, x, y, color);
    }
}

/* Draw a line between the pixels of two points. */
static void plane_line(const struct plane *plane, struct vec2 from, struct vec2 to,
                       struct color color) {
    struct vec2 a = to_pixels(&plane->to_screen, from), b = to_pixels(&plane->to_screen, to);
    struct pixel p = {(int)floor(a.x), (int)floor(a.y)}, q = {(int)floor(b.x), (int)floor(b.y)};
    struct line_walk walk;
    bool more = line_begin(&walk, p, q, plane->image->width, plane->image->height);
    for (; more; more = line_next(&walk)) {
        plane_pixel(plane, walk.x, walk.y, color);
    }
}

/* Draw a convex polygon as two triangles. Its corners are never too far for the screen. */
static void plane_polygon(const struct plane *plane, const struct vec2 corner[4],
                          struct color color) {
    struct fixed2 p[4] = {{0, 0}};
    struct edges edges = {.y_end = 0};
    for (int i = 0; i < 4; i++) {
        screen_snap(to_pixels(&plane->to_screen, corner[i]), &p[i]);
    }
    for (int i = 2; i < 4; i++) {
        bool covers =
            edges_setup(&edges, p[0], p[i - 1], p[i], plane->image->width, plane->image->height);
        for (int y = edges.y_begin; covers && y < edges.y_end; y++) {
            struct span span = edges_span(&edges, y);
            for (int x = span.begin; x < span.end; x++) {
                plane_pixel(plane, x, y, color);
            }
        }
    }
}

static void draw_house(const struct plane *plane) {
    for (size_t i = 0; i < HOUSE_PARTS; i++) {
        plane_polygon(plane, house[i].corner, house[i].color);
    }
}

static void outline_house(const struct plane *plane, struct color color) {
    for (size_t i = 0; i < 4 * (size_t)HOUSE_PARTS; i++) {
        const struct vec2 *corner = house[i / 4].corner;
        plane_line(plane, corner[i % 4], corner[(i + 1) % 4], color);
    }
}

/* The plane from -2 to 2 in x and y, in that area. */
static struct plane plane_in(struct image *image, struct rectangle area) {
    const struct mat4 half = mat4_scaling((struct vec3){0.5, 0.5, 1});
    return (struct plane){image, area, mat4_mul(area_to_screen(area), half)};
}

/* Draw the axes, the house through a map, and the outline of the house as it was. */
static void draw_mapped(const struct plane *plane, struct mat4 map) {
    const struct plane mapped = {plane->image, plane->area, mat4_mul(plane->to_screen, map)};
    fill_area(plane->image, plane->area, color_grey(26));
    plane_line(plane, (struct vec2){-2, 0}, (struct vec2){2, 0}, color_grey(90));
    plane_line(plane, (struct vec2){0, -2}, (struct vec2){0, 2}, color_grey(90));
    draw_house(&mapped);
    outline_house(plane, color_grey(165));
}

/* Draw the house through one of the nine maps, or as it is. A cross marks what it turns about. */
static void draw_panel(struct image *image, struct rectangle area, int panel) {
    const struct plane plane = plane_in(image, area);
    draw_mapped(&plane, panel < PANELS ? panel_map(panel) : mat4_identity());
    for (int side = -1; panel == 5 && side <= 1; side += 2) {
        plane_line(&plane, (struct vec2){pivot.x - 0.08, pivot.y - side * 0.08},
                   (struct vec2){pivot.x + 0.08, pivot.y + side * 0.08}, color_grey(255));
    }
}

/* Draw the panel of the scene's number alone. */
static bool draw_alone(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_panel(image, whole_image(image), drawing->number);
    return true;
}

static bool draw_transforms(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < PANELS; i++) {
        const struct rectangle c = grid_cell(image->width, image->height, 3, 3, i);
        const struct rectangle area = {c.x + 4, c.y + 4, c.width - 8, c.height - 8};
        if (area.width > 0 && area.height > 0) {
            draw_panel(image, area, i);
        }
    }
    return true;
}

/* ---- Cameras ---- */

/* World to view. A camera in front has nothing to turn, so it does without lookat(), which you
 * write in part d. */
static struct mat4 camera_view(const struct drawing *drawing) {
    const struct vec3 eye = drawing->eye, center = drawing->center, up = drawing->up;
    const bool in_front = eye.x == 0 && eye.y == 0 && eye.z > 0 && vec3_dot(center, center) == 0 &&
                          up.x == 0 && up.y > 0 && up.z == 0;
    return in_front ? mat4_identity() : lookat(eye, center, up);
}

/* World to clip space, in perspective: the distance is the one between eye and center. */
static struct mat4 camera_clip(const struct drawing *drawing) {
    const double distance = vec3_length(vec3_sub(drawing->eye, drawing->center));
    return mat4_mul(projection(distance), camera_view(drawing));
}

static struct canvas make_canvas(const struct drawing *drawing, struct image *image,
                                 struct rectangle area, struct mat4 to_clip) {
    return (struct canvas){
        .image = image,
        .depth = drawing->depth,
        .area = area,
        .to_clip = to_clip,
        .to_screen = area_to_screen(area),
        .normals_to_world = mat4_identity(),
        .light = vec3_normalized(drawing->light),
        .texture = drawing->diffuse,
    };
}

/* A square in a corner of the image: column and row are 0 or 1. */
static struct rectangle small_area(const struct image *image, int column, int row) {
    const int size = (int)image->width / 5;
    return (struct rectangle){column * ((int)image->width - size),
                              row * ((int)image->height - size), size, size};
}

/* ---- Part b ---- */

/* Draw the head in facets of one colour: large, and small as seen from infinitely far away. */
static bool draw_projection(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct mat4 parallel = mat4_mul(projection(INFINITY), camera_view(drawing));
    struct canvas large = make_canvas(drawing, image, whole_image(image), camera_clip(drawing));
    struct canvas small = make_canvas(drawing, image, small_area(image, 0, 1), parallel);
    large.affine = small.affine = true;
    draw_model(drawing, &large, true);
    draw_model(drawing, &small, true);
    return true;
}

/* ---- Quads with tiles on them ---- */

struct quad {
    struct vec3 corner[4]; /* counterclockwise as the camera sees them */
    struct vec2 uv[4];
};

enum { TILES = 8, TILE = 16 }; /* a side of the texture, in tiles, and of a tile, in texels */

/* Light tiles and dark ones; redder to the right, bluer upwards. */
static bool make_tiles(struct texture *texture, struct error *error) {
    struct image image;
    if (!image_create(&image, TILES * TILE, TILES * TILE, IMAGE_BGR, error)) {
        return false;
    }
    for (int i = 0; i < TILES * TILE * TILES; i++) { /* a row of one tile after the other */
        const int column = i % TILES, y = i / TILES, row = y / TILE;
        const double part = (column + row) % 2 == 1 ? 0.45 : 1;
        image_fill_row(&image, y, column * TILE, (column + 1) * TILE,
                       color_rgb(level_from((150 + 15 * column) * part), level_from(190 * part),
                                 level_from((80 + 20 * row) * part)));
    }
    bool done = texture_create_levels(texture, &image, 1, error);
    texture_set_clamp(texture, true);
    image_free(&image);
    return done;
}

/* The corners of face 0, 1 ... of some quads, two in each: 0 1 2, and 0 2 3. All normals point to
 * the light, so that the tiles have their own colours. */
static void fetch_quad_face(const struct quad *quads, size_t face, struct vec3 light,
                            struct face_corner corner[3]) {
    for (size_t i = 0; i < 3; i++) {
        const size_t at = i == 0 ? 0 : i + face % 2;
        const struct quad *quad = &quads[face / 2];
        corner[i] = (struct face_corner){quad->corner[at], light, quad->uv[at]};
    }
}

static bool draw_quads(const struct canvas *canvas, const struct quad *quads, size_t count,
                       struct error *error) {
    struct texture tiles;
    struct canvas tiled = *canvas;
    tiled.texture = &tiles;
    if (!make_tiles(&tiles, error)) {
        return false;
    }
    for (size_t face = 0; face < 2 * count; face++) {
        struct face_corner corner[3];
        fetch_quad_face(quads, face, canvas->light, corner);
        draw_face(&tiled, corner);
    }
    texture_free(&tiles);
    return true;
}

/* ---- Part c ---- */

/* A wall that leads away from the viewer, and a poster that nearly faces the viewer: there is
 * little to correct, but enough to see. */
static const struct quad wall[2] = {
    {{{-0.9, -0.45, 1.1}, {0.9, -0.45, -2}, {0.9, 0.45, -2}, {-0.9, 0.45, 1.1}},
     {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
    {{{0, 0.45, 0}, {0.98, 0.45, -0.09}, {0.98, 0.98, -0.09}, {0, 0.98, 0}},
     {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
};

static bool draw_wall(struct drawing *drawing, struct image *image, struct error *error) {
    struct canvas canvas = make_canvas(drawing, image, whole_image(image), camera_clip(drawing));
    return draw_quads(&canvas, wall, 2, error);
}

/* Leaves that are scaled. The first one is flattened by a map without an inverse, and keeps the
 * light of the leaf as it was. The map of the other one has the determinant 1, like a rotation. */
static const struct leaf {
    struct vec3 scale;
    struct quad quad;
} leaves[2] = {
    {{1, 1, 0},
     {{{-0.9, -0.9, 0.3}, {-0.6, -0.9, 0}, {-0.6, -0.6, -0.3}, {-0.9, -0.6, 0}},
      {{0, 0}, {0.375, 0}, {0.375, 0.375}, {0, 0.375}}}},
    {{0.25, 1, 4},
     {{{-3.6, 0.6, 0}, {-2.4, 0.6, 0}, {-2.4, 0.9, 0}, {-3.6, 0.9, 0}},
      {{0, 0}, {0.375, 0}, {0.375, 0.375}, {0, 0.375}}}},
};

/* A canvas for a model that goes through `to_world` before the camera, with its normals. */
static struct canvas world_canvas(const struct drawing *drawing, struct image *image,
                                  struct mat4 to_world) {
    struct mat4 to_clip = mat4_mul(camera_clip(drawing), to_world);
    struct canvas canvas = make_canvas(drawing, image, whole_image(image), to_clip);
    canvas.normals_to_world = normals_to_world(to_world);
    return canvas;
}

/* Draw the model, made narrow and then turned, and both leaves. */
static bool draw_narrow(struct drawing *drawing, struct image *image, struct error *error) {
    const struct mat4 turned = mat4_rotation((struct vec3){0, 1, 0}, 0.05);
    const struct mat4 narrow = mat4_scaling((struct vec3){0.5, 1, 1});
    struct canvas head = world_canvas(drawing, image, mat4_mul(turned, narrow));
    bool done = true;
    draw_model(drawing, &head, false);
    for (int i = 0; i < 2 && done; i++) {
        struct canvas canvas = world_canvas(drawing, image, mat4_scaling(leaves[i].scale));
        done = draw_quads(&canvas, &leaves[i].quad, 1, error);
    }
    return done;
}

/* ---- Parts d and e ---- */

/* Scenes lookat and closeup: they differ in their eye, center and up. */
static bool draw_view(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = make_canvas(drawing, image, whole_image(image), camera_clip(drawing));
    draw_model(drawing, &canvas, false);
    return true;
}

/* A floor and a wall that have no end behind the camera, a leaf right before its lens, and a sail
 * (with three corners) that four planes cut: its three corners become six, and each shows. Texture
 * coordinates are floats, as those of a model are. */
static const struct quad endless[4] = {
    {{{-1e15, -0.5, 1e14}, {1e15, -0.5, 1e14}, {8, -0.5, -14}, {-8, -0.5, -14}},
     {{-2.5e14F, -1.25e13F}, {2.5e14F, -1.25e13F}, {2.5, 2}, {-1.5, 2}}},
    {{{0.9, -1e15, 1e14}, {0.9, 1e15, 1e14}, {0.9, 4, -14}, {0.9, -4, -14}},
     {{-1.25e13F, -2.5e14F}, {-1.25e13F, 2.5e14F}, {2, 1.44F}, {2, -0.56F}}},
    {{{-0.009, 0.004, 1.97}, {-0.002, 0.002, 1.97}, {-0.001, 0.003, 1.997}, {-0.002, 0.003, 1.997}},
     {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
    {{{87, 38, -22}, {-4346, 112, 4278}, {-325, 61, -724}, {-325, 61, -724}},
     {{0.5, 0.25}, {-22, -10}, {-1.5, 2}, {-1.5, 2}}},
};

/* A sail that all five planes cut, in a small view where it hides all behind it. Its three corners
 * become eight, and the last ones show. */
static const struct quad sail = {
    {{830, -840, -30}, {-2.3, 19, 13}, {-6, 1.6, -1.1}, {-6, 1.6, -1.1}},
    {{2630, -2640}, {-24, 43}, {-14, 10}, {-14, 10}},
};

static struct rectangle sail_area(const struct image *image) {
    const int width = (int)image->width, height = (int)image->height;
    return (struct rectangle){width * 44 / 100, height * 47 / 100, width / 9, height / 9};
}

static bool draw_endless(struct drawing *drawing, struct image *image, struct error *error) {
    const struct mat4 to_clip = camera_clip(drawing);
    struct canvas canvas = make_canvas(drawing, image, whole_image(image), to_clip);
    struct canvas small = make_canvas(drawing, image, sail_area(image), to_clip);
    return draw_quads(&canvas, endless, 4, error) && draw_quads(&small, &sail, 1, error);
}

/* ---- The program ---- */

enum { NEEDS_VIEW = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_PICTURE | NEEDS_DEPTH };

static const struct scene scenes[] = {
    {.name = "house", .number = PANELS, .width = 405, .height = 363, .draw = draw_alone},
    {.name = "scale", .number = 0, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "shear", .number = 1, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn", .number = 2, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "scale_turn", .number = 3, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn_scale", .number = 4, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn_about", .number = 5, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "move_turn", .number = 6, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn_move", .number = 7, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "divided", .number = 8, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "transforms", .draw = draw_transforms},
    {.name = "projection", .needs = NEEDS_VIEW, .draw = draw_projection},
    {.name = "wall", .needs = NEEDS_DEPTH, .draw = draw_wall},
    {.name = "narrow", .needs = NEEDS_VIEW, .draw = draw_narrow},
    {.name = "lookat", .needs = NEEDS_VIEW, .eye = {1, 1, 2}, .draw = draw_view},
    {.name = "closeup",
     .detail = true,
     .needs = NEEDS_VIEW,
     .eye = {0.03, 0.47, 0.46}, /* between the eyebrows, looking down the nose */
     .center = {0.03, -0.3, 0.4},
     .up = {0, 0, 1},
     .draw = draw_view},
    {.name = "endless", .needs = NEEDS_DEPTH, .draw = draw_endless},
};

static const struct program step08_projection = {
    .name = "step08_projection",
    .summary = "matrices, perspective, and a camera anywhere",
    .takes_light = true,
    .takes_camera = true,
    .defaults =
        {.width = 800, .height = 800, .eye = {0, 0, 2}, .up = {0, 1, 0}, .light = {1, 1, 2}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
