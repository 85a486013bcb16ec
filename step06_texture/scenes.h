/*
 * Step 6, the given part: its scenes and the program.
 *
 * `texture` draws a model with its diffuse texture, nearest texel, times the intensity of the face.
 * `checker` draws a plane that reaches towards the horizon, with perspective-correct texture
 * coordinates, and a mip level chosen for every pixel.
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

/* All faces on which light falls, as in step 4. */
static bool draw_texture(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image, .depth = drawing->depth, .skip = drawing->skip};
    uint64_t placed = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = model_face_intensity(model, face, light);
        bool lit = intensity > 0;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn: where it lies does not matter */
        }
        placed++;
        if (place_face(model, face, image, vertices) && lit) {
            triangle(&canvas, vertices, drawing->diffuse, intensity);
        }
    }
    drawing_count(drawing, "faces_placed", placed);
    drawing_count(drawing, "pixels_tested", canvas.pixels_tested);
    drawing_count(drawing, "pixels_written", canvas.pixels_written);
    drawing_count(drawing, "texels_fetched", canvas.texels_fetched);
    return true;
}

/* ---- Scene: checker ---- */

struct state {
    struct texture checker;
};

enum { CHECKER_SIZE = 256 }; /* texels a side: a picture of two by two tiles */

/* The edges of the picture run through the middle of tiles, so both sides of the seam between two
 * repeated pictures have the same colour, on every mip level. */
static bool make_checker(struct texture *texture, struct error *error) {
    const struct color light = color_rgb(245, 235, 215), dark = color_rgb(150, 45, 30);
    struct image image;
    if (!image_create(&image, CHECKER_SIZE, CHECKER_SIZE, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < CHECKER_SIZE; y++) {
        for (int x = 0; x < CHECKER_SIZE; x++) {
            int column = (x + CHECKER_SIZE / 4) / (CHECKER_SIZE / 2); /* 0, 1 or 2 */
            int row = (y + CHECKER_SIZE / 4) / (CHECKER_SIZE / 2);
            image_set(&image, x, y, (column + row) % 2 == 0 ? light : dark);
        }
    }
    bool done = texture_create(texture, &image, error);
    image_free(&image);
    return done;
}

/* The camera stands at the origin and looks along -z. The plane lies PLANE_BELOW under it, rolled
 * about the line of sight so that the distance changes along every row too: (COSINE, SINE) points
 * to the right in the plane. The plane is cut off at PLANE_NEAR, below the image, and PLANE_FAR. */
#define PLANE_COSINE 0.96
#define PLANE_SINE   0.28
#define PLANE_BELOW  1.5
#define PLANE_SIDE   72.0
#define PLANE_NEAR   0.75
#define PLANE_FAR    60.0

/* A corner of the plane: `side` units to the right of the line of sight, `distance` before the
 * camera. In perspective a point appears at its x and y divided by w, the distance. One unit of the
 * plane is one picture: two tiles. */
static struct vertex place_on_plane(double side, double distance, const struct image *image) {
    double x = PLANE_COSINE * side + PLANE_SINE * PLANE_BELOW;
    double y = PLANE_SINE * side - PLANE_COSINE * PLANE_BELOW;
    struct vec2 screen = {(0.5 + 0.5 * x / distance) * (double)image->width,
                          (0.75 + 0.5 * y / distance) * (double)image->height};
    struct vertex vertex = {.uv = {side, distance}, .recip_w = 1 / distance};
    screen_snap(screen, &vertex.position); /* never beyond the limit: 0.5 * 72 / 0.75 images */
    return vertex;
}

/* The plane's corners, counterclockwise. */
static void place_plane(const struct image *image, struct vertex corners[4]) {
    corners[0] = place_on_plane(-PLANE_SIDE, PLANE_NEAR, image);
    corners[1] = place_on_plane(PLANE_SIDE, PLANE_NEAR, image);
    corners[2] = place_on_plane(PLANE_SIDE, PLANE_FAR, image);
    corners[3] = place_on_plane(-PLANE_SIDE, PLANE_FAR, image);
}

static bool draw_checker(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    struct vertex corners[4];
    place_plane(image, corners);
    const struct vertex first[3] = {corners[0], corners[1], corners[2]};
    const struct vertex second[3] = {corners[0], corners[2], corners[3]};
    struct canvas canvas = {.image = image, .skip = drawing->skip};
    perspective_triangle(&canvas, first, &state->checker);
    perspective_triangle(&canvas, second, &state->checker);
    drawing_count(drawing, "pixels_written", canvas.pixels_written);
    drawing_count(drawing, "texels_fetched", canvas.texels_fetched);
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    struct state *state = drawing->state;
    return drawing->model != NULL || make_checker(&state->checker, error);
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    texture_free(&state->checker);
}

static const struct scene scenes[] = {
    {
        .name = "texture",
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .draw = draw_texture,
    },
    {.name = "checker", .draw = draw_checker},
};

int main(int argc, char **argv) {
    static const struct program program = {
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
    return program_main(&program, argc, argv);
}
