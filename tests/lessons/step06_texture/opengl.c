/* Lesson 6 by OpenGL: see picture.h. */
#include "bench/opengl/context.h"
#include "bench/opengl/picture.h"

#define LESSON "../step06_texture/main.c"
#include "lesson.h"

static bool build_texture(struct picture *picture) {
    return picture_add_lit_faces(
        picture, (struct gl_part){.formula = "nearest()", .maps = {picture->drawing->diffuse}});
}

/* ---- Boards of four corners, as two faces ---- */

struct board {
    struct vec3 position[4];
    struct vertex vertex[4]; /* as the lesson has placed them, with u and v */
};

/* Varyings: u, v in perspective; otherwise intensity, u, v. */
static bool board_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct board *board = given;
    const size_t i = corner > 0 ? corner + face : 0;
    const struct vec2 uv = board->vertex[i].uv;
    const bool facing = board->vertex[i].recip_w == 0;
    *to = facing ? (struct corner_data){board->position[i], {1, uv.x, uv.y}}
                 : (struct corner_data){board->position[i], {uv.x, uv.y}};
    return true;
}

/* A board that faces us, in full light. */
static bool add_facing(struct picture *picture, const struct texture *texture,
                       struct board *board) {
    const double width = (double)picture->width, height = (double)picture->height;
    const struct gl_part part = {
        .formula = "nearest()",
        .maps = {texture},
        .viewport = whole_picture(picture),
        .to_clip = parallel_clip(mat4_identity()),
    };
    for (int i = 0; i < 4; i++) {
        const struct fixed2 screen = board->vertex[i].position;
        board->position[i] = (struct vec3){2.0 * screen.x / (width * SUBPIXELS) - 1,
                                           2.0 * screen.y / (height * SUBPIXELS) - 1, 0};
    }
    return picture_add(picture, &part, 2, board_corner, board);
}

static bool build_letters(struct picture *picture) {
    const struct state *state = picture->drawing->state;
    struct board boards[4];
    place_board(picture->image, boards[0].vertex);
    place_cloth(picture->image, boards[1].vertex);
    place_far_board(picture->image, 0, boards[2].vertex);
    place_far_board(picture->image, 1, boards[3].vertex);
    return add_facing(picture, &state->bordered, &boards[0]) &&
           add_facing(picture, &state->cloth, &boards[1]) &&
           add_facing(picture, &state->bordered, &boards[2]) &&
           add_facing(picture, &state->bordered, &boards[3]);
}

/* A board in perspective. Its corners become (side, distance, height): the matrix does what
 * place_over_plane() does, with w the distance. */
static bool add_standing(struct picture *picture, const struct texture *texture,
                         const struct surface_corner places[4]) {
    const struct gl_part part = {
        .formula = "trilinear()",
        .maps = {texture},
        .no_depth_test = true,
        .not_cut = true,
        .viewport = whole_picture(picture),
        .to_clip = {{{PLANE_COSINE, 0, -PLANE_SINE, PLANE_SINE * PLANE_BELOW},
                     {PLANE_SINE, 0.5, PLANE_COSINE, -PLANE_COSINE * PLANE_BELOW},
                     {0, 0, 0, NEAR_W},
                     {0, 1, 0, 0}}},
    };
    struct board board;
    place_surface(picture->image, places, board.vertex);
    for (int i = 0; i < 4; i++) {
        board.position[i] = (struct vec3){places[i].side, places[i].distance, places[i].height};
    }
    return picture_add(picture, &part, 2, board_corner, &board);
}

static bool build_close(struct picture *picture) {
    const struct state *state = picture->drawing->state;
    return add_standing(picture, &state->letters, close_corners);
}

static bool build_room(struct picture *picture) {
    const struct state *state = picture->drawing->state;
    return add_standing(picture, &state->mosaic, back_corners) &&
           add_standing(picture, &state->letters, floor_corners) &&
           add_standing(picture, &state->letters, wall_corners);
}

static bool build_checker(struct picture *picture) {
    const struct state *state = picture->drawing->state;
    return add_standing(picture, &state->checker, plane_corners);
}

static const struct compared_scene table[] = {
    {"texture", .build = build_texture},
    /* On the cloth every pixel's centre is on the border of two texels. */
    {"letters", .build = build_letters, .jumps = 210},
    {"close", .build = build_close},
    {"mipmapped", .build = build_room},
    {"checker", .build = build_checker},
    {"room", .left_out = "no formula here repeats a picture by its nearest texel"},
    {"softer", .left_out = "the level of a pixel is not that of a triangle"},
    {.name = NULL},
};

const struct lesson lesson_step06 = {&step06_texture, table};
