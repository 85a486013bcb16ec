/* Step 8: its viewport() is lent to cameras.c; here its maps, camera, clipping and perspective. */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/soup.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>
#include <string.h>

struct mat4 lesson08_viewport(size_t width, size_t height) {
    return viewport(width, height);
}

/* ---- The camera ---- */

struct view_case {
    struct vec3 eye, center, up, point;
};

static void make_view(struct random *random, uint64_t index, void *made) {
    struct view_case *c = made;
    c->eye = random_vector(random, index % 2 ? 4 : 100);
    c->center = random_vector(random, index % 2 ? 4 : 100);
    c->up = random_vector(random, index % 2 ? 1 : 300);
    c->point = random_vector(random, 4);
    if (index % 4 == 1) { /* nearly along the line of sight */
        struct vec3 sight = vec3_normalized(vec3_sub(c->eye, c->center));
        c->up = vec3_add(sight, random_vector(random, (int)random_between(random, 1, 36)));
    }
    if (index % 16 == 3) {
        c->up = vec3_scale(vec3_sub(c->eye, c->center), random_bits(random) % 2 ? 1 : -3);
    }
    if (index % 16 == 7) {
        c->eye = c->center;
    }
}

/* The frame, and where the center goes. In ulp. */
static double lookat_error(const void *tried) {
    const struct view_case *c = tried;
    struct mat4 view = lookat(c->eye, c->center, c->up);
    bool last = view.m[3][0] == 0 && view.m[3][1] == 0 && view.m[3][2] == 0 && view.m[3][3] == 1;
    double error = fmax(view_frame_error(&view), view_axes_error(&view, c->eye, c->center, c->up));
    return last && view_moves_center(&view, c->center) ? error : (double)INFINITY;
}

/* x, y and z are kept, and w is the part of the distance that is left. Also a parallel view. */
static bool projection_is_right(const void *tried) {
    const struct view_case *c = tried;
    double distance = vec3_length(c->eye);
    distance = distance == 0 ? (double)INFINITY : distance;
    struct mat4 projected = projection(distance);
    struct vec4 clip = mat4_point(&projected, c->point);
    long double w = 1 - (long double)c->point.z / (long double)distance;
    return clip.x == c->point.x && clip.y == c->point.y && clip.z == c->point.z &&
           fabsl(w - (long double)clip.w) <= 0x1p-51L * (1 + fabsl(w));
}

static void print_view(const void *failing) {
    const struct view_case *c = failing;
    print_camera_options(c->eye, c->center, c->up);
    printf("    # point %.17g %.17g %.17g\n", c->point.x, c->point.y, c->point.z);
}

/* ---- Maps of the plane ---- */

struct map_case {
    struct vec2 p;
    int panel;
};

static void make_map(struct random *random, uint64_t index, void *made) {
    struct map_case *c = made;
    c->p = (struct vec2){random_real(random, -1.5, 3), random_real(random, -1.5, 3)};
    c->panel = (int)(index % 9);
}

/* An eighth of a turn counterclockwise. */
static void turn_eighth(long double *x, long double *y) {
    long double part = sqrtl(0.5L), old_x = *x;
    *x = part * (old_x - *y);
    *y = part * (old_x + *y);
}

static void exact_map(int panel, long double *x, long double *y) {
    switch (panel) {
    case 0: /* scaled */
        *x *= 1.5L, *y *= 0.5L;
        break;
    case 1: /* sheared */
        *x += *y * (long double)0.6;
        break;
    case 3: /* scaled, then turned */
        *x *= 1.5L, *y *= 0.5L;
        turn_eighth(x, y);
        break;
    case 2:
    case 4: /* turned; then scaled */
        turn_eighth(x, y);
        *x *= panel == 4 ? 1.5L : 1, *y *= panel == 4 ? 0.5L : 1;
        break;
    case 5: /* turned about (1, 0.8) */
        *x -= 1, *y -= (long double)0.8;
        turn_eighth(x, y);
        *x += 1, *y += (long double)0.8;
        break;
    case 6: /* moved, then turned */
        *x -= (long double)0.8, *y -= (long double)1.3;
        turn_eighth(x, y);
        break;
    case 7: /* turned, then moved */
        turn_eighth(x, y);
        *x -= (long double)0.8, *y -= (long double)1.3;
        break;
    default: { /* in perspective */
        long double w = 1 + *x / 2;
        *x /= w, *y /= w;
    }
    }
}

static bool map_is_right(const void *tried) {
    const struct map_case *c = tried;
    struct mat4 map = panel_map(c->panel);
    struct vec2 got = to_pixels(&map, c->p);
    long double x = c->p.x, y = c->p.y;
    exact_map(c->panel, &x, &y);
    return fabsl(x - (long double)got.x) <= 1e-14L && fabsl(y - (long double)got.y) <= 1e-14L;
}

static void print_map(const void *failing) {
    const struct map_case *c = failing;
    printf("    point %.17g %.17g in panel %d\n", c->p.x, c->p.y, c->panel);
}

/* ---- Division by w ---- */

struct divided_case {
    struct vec4 clip;
    int width, height;
};

static void make_divided(struct random *random, uint64_t index, void *made) {
    struct divided_case *c = made;
    double w = ldexp(random_real(random, 1, 2), (int)random_between(random, -10, 10));
    double reach = index % 3 == 0 ? 3e5 : 70;
    c->clip =
        (struct vec4){w * random_real(random, -reach, reach),
                      w * random_real(random, -reach, reach), w * random_real(random, -9, 9), w};
    if (index % 8 == 5) {
        c->clip.z = random_bits(random) % 2 ? 1e308 : NAN;
        c->clip.w = 0x1p-7;
    }
    c->width = (int)random_between(random, 1, DRAW_LIMIT);
    c->height = (int)random_between(random, 1, DRAW_LIMIT);
}

/* Within rounding of the nearest 1/256 pixel. */
static bool is_snapped(int32_t got, long double screen) {
    return fabsl(screen * SUBPIXELS - got) <= 0.5L + 1e-14L * (1 + fabsl(screen)) * SUBPIXELS;
}

static bool division_is_right(const void *tried) {
    const struct divided_case *c = tried;
    struct mat4 to_screen = viewport((size_t)c->width, (size_t)c->height);
    struct vertex v = {.depth = 0};
    bool placed = place(c->clip, &to_screen, &v);
    long double w = c->clip.w, z = (long double)c->clip.z / w;
    long double x = ((long double)c->clip.x / w + 1) * c->width / 2;
    long double y = ((long double)c->clip.y / w + 1) * c->height / 2;
    long double farthest = fmaxl(fabsl(x), fabsl(y));
    if (!(fabsl(z) <= 0x1p1023L) || farthest > SCREEN_LIMIT + 1) {
        return !placed;
    }
    if (farthest > SCREEN_LIMIT - 1) {
        return true;
    }
    return placed && is_snapped(v.position.x, x) && is_snapped(v.position.y, y) &&
           fabsl(z - (long double)v.depth) <= 0x1p-51L * fabsl(z) &&
           fabsl(1 / w - (long double)v.recip_w) <= 0x1p-52L / w;
}

static void print_divided(const void *failing) {
    const struct divided_case *c = failing;
    printf("    clip %.17g %.17g %.17g %.17g, %dx%d pixels\n", c->clip.x, c->clip.y, c->clip.z,
           c->clip.w, c->width, c->height);
}

/* ---- Weights in perspective ---- */

struct weights_case {
    double screen[3], recip_w[3];
};

static void make_weights(struct random *random, uint64_t index, void *made) {
    struct weights_case *c = made;
    int reach = index % 2 ? 3 : 40;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        c->screen[i] = random_bits(random) % 8 == 0 ? 0 : random_real(random, 1e-6, 1);
        sum += c->screen[i];
        c->recip_w[i] =
            ldexp(random_real(random, 1, 2), (int)random_between(random, -reach, reach));
    }
    for (int i = 0; i < 3; i++) {
        c->screen[i] = sum > 0 ? c->screen[i] / sum : 1.0 / 3;
    }
}

static double weights_error(const void *tried) {
    const struct weights_case *c = tried;
    struct vec3 screen = {c->screen[0], c->screen[1], c->screen[2]};
    struct vec3 got = correct_weights(screen, c->recip_w);
    const double weight[3] = {got.x, got.y, got.z};
    long double sum = 0;
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        sum += (long double)c->screen[i] * (long double)c->recip_w[i];
    }
    for (int i = 0; i < 3; i++) {
        long double exact = (long double)c->screen[i] * (long double)c->recip_w[i] / sum;
        double error = (double)fabsl(exact - (long double)weight[i]) * 0x1p52;
        worst = fmax(worst, isnan(error) ? (double)INFINITY : error);
    }
    return worst;
}

static void print_weights(const void *failing) {
    const struct weights_case *c = failing;
    for (int i = 0; i < 3; i++) {
        printf("    weight %.17g, 1/w %.17g\n", c->screen[i], c->recip_w[i]);
    }
}

/* ---- Clipping ---- */

/* Two faces with a common side. */
struct clip_case {
    struct vec4 corner[4];
};

static void make_clip(struct random *random, uint64_t index, void *made) {
    struct clip_case *c = made;
    double reach = index % 2 ? 3 : 200;
    for (int i = 0; i < 4; i++) {
        c->corner[i] =
            (struct vec4){random_real(random, -reach, reach), random_real(random, -reach, reach),
                          random_real(random, -3, 3), random_real(random, -1, 3)};
        if (random_bits(random) % 8 == 0) { /* on a plane */
            c->corner[i].w = near_w;
        }
    }
}

/* Written down anew: positive inside. */
static long double exact_distance(struct vec4 p, int plane) {
    static const struct real3 factors[] = {
        {0, 0, 1}, {1, 0, 64}, {-1, 0, 64}, {0, 1, 64}, {0, -1, 64}};
    struct real3 f = factors[plane];
    return f.x * p.x + f.y * p.y + f.z * p.w - (plane == 0 ? 1 / 128.0L : 0);
}

static bool is_mix(double got, struct vec3 weight, double a, double b, double c) {
    long double exact =
        (long double)weight.x * a + (long double)weight.y * b + (long double)weight.z * c;
    return fabsl(exact - (long double)got) <= 1e-13L * (fabsl(a) + fabsl(b) + fabsl(c) + 1);
}

/* Every corner of what is left is inside all planes, and is the mean of the face's corners that its
 * weights say. (That nothing is missing is seen in the soups.) */
static bool left_over_is_right(const struct vec4 corner[3]) {
    struct vec4 a = corner[0], b = corner[1], c = corner[2];
    struct polygon polygon = clip_face(a, b, c);
    for (size_t i = 0; i < polygon.count; i++) {
        struct vec4 p = polygon.corner[i].clip;
        struct vec3 w = polygon.corner[i].weight;
        for (int plane = 0; plane < 5; plane++) {
            if (exact_distance(p, plane) < -1e-11L) {
                return false;
            }
        }
        if (!(is_mix(p.x, w, a.x, b.x, c.x) && is_mix(p.y, w, a.y, b.y, c.y) &&
              is_mix(p.z, w, a.z, b.z, c.z) && is_mix(p.w, w, a.w, b.w, c.w) &&
              is_mix(1, w, 1, 1, 1) && w.x >= 0 && w.y >= 0 && w.z >= 0)) {
            return false;
        }
    }
    return polygon.count <= 8;
}

static bool is_the_same(struct vec4 a, struct vec4 b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Is every corner of the one a corner of the other, to the last bit? But for those away from the
 * common side, where the third corner has a weight. */
static bool common_cuts_agree(const struct polygon *one, const struct polygon *other) {
    for (size_t i = 0; i < one->count; i++) {
        bool found = one->corner[i].weight.z > 0;
        for (size_t k = 0; k < other->count && !found; k++) {
            found = is_the_same(one->corner[i].clip, other->corner[k].clip);
        }
        if (!found) {
            return false;
        }
    }
    return true;
}

/* Each of the two faces has the common side in its own direction, as in a mesh. At one plane both
 * must find the very same places on it. */
static bool clipping_is_right(const void *tried) {
    const struct clip_case *c = tried;
    const struct polygon one = {
        .corner = {{c->corner[0], {1, 0, 0}}, {c->corner[1], {0, 1, 0}}, {c->corner[2], {0, 0, 1}}},
        .count = 3};
    const struct polygon other = {
        .corner = {{c->corner[1], {1, 0, 0}}, {c->corner[0], {0, 1, 0}}, {c->corner[3], {0, 0, 1}}},
        .count = 3};
    for (int plane = 0; plane < 5; plane++) {
        struct polygon one_part = clip_at_plane(&one, plane);
        struct polygon other_part = clip_at_plane(&other, plane);
        if (!common_cuts_agree(&one_part, &other_part) ||
            !common_cuts_agree(&other_part, &one_part)) {
            return false;
        }
    }
    return left_over_is_right(c->corner);
}

static void print_clip(const void *failing) {
    const struct clip_case *c = failing;
    for (int i = 0; i < 4; i++) {
        printf("    clip %.17g %.17g %.17g %.17g\n", c->corner[i].x, c->corner[i].y, c->corner[i].z,
               c->corner[i].w);
    }
}

/* ---- Which sides a position is beyond ---- */

struct side_case {
    struct vec4 p;
};

/* Often exactly on a side or as near to it as doubles go. */
static void make_side(struct random *random, uint64_t index, void *made) {
    static const double ws[] = {0, 1.0 / 128, 1.0 / 256, 1, -1, NAN, INFINITY, 1e-300};
    static const double parts[] = {0, 1, -1, 64, -64, 0.99, -0.99, 63, NAN, INFINITY};
    struct vec4 *p = &((struct side_case *)made)->p;
    p->w = index % 2 ? ws[random_bits(random) % 8] : random_real(random, -0.01, 3);
    p->x = p->w * (random_bits(random) % 2 ? parts[random_bits(random) % 10]
                                           : random_real(random, -70, 70));
    p->y = p->w * (random_bits(random) % 2 ? parts[random_bits(random) % 10]
                                           : random_real(random, -70, 70));
    double *moved = random_bits(random) % 2 ? &p->x : &p->w;
    *moved = index % 3 == 0 && isfinite(*moved)
                 ? nextafter(*moved, random_bits(random) % 2 ? 1e9 : -1e9)
                 : *moved;
}

static bool sides_are_right(const void *tried) {
    const struct vec4 *p = &((const struct side_case *)tried)->p;
    long double x = p->x, y = p->y, w = p->w;
    unsigned exact = 0;
    exact |= -w <= x ? 0 : BEYOND_LEFT;
    exact |= w >= x ? 0 : BEYOND_RIGHT;
    exact |= -w <= y ? 0 : BEYOND_BOTTOM;
    exact |= w >= y ? 0 : BEYOND_TOP;
    exact |= 128 * w >= 1 ? 0 : BEYOND_NEAR;
    exact |= -64 * w <= x && x <= 64 * w && -64 * w <= y && y <= 64 * w ? 0 : BEYOND_GUARD_BAND;
    return find_beyond(*p) == exact;
}

static void print_side(const void *failing) {
    const struct vec4 *p = &((const struct side_case *)failing)->p;
    printf("    clip x %.17g y %.17g w %.17g\n", p->x, p->y, p->w);
}

/* ---- A face around the view, all of whose corners are beyond the guard band ---- */

struct around_case {
    struct mesh_data mesh;
};

static void make_around(struct random *random, uint64_t index, void *made) {
    struct around_case *c = made;
    double first = random_real(random, 0, 1);
    for (int i = 0; i < 3; i++) { /* about a third of a turn apart */
        struct vec2 to = turn_direction(first + (index % 2 ? -1 : 1) * (i / 3.0) +
                                        random_real(random, -0.1, 0.1));
        double reach = random_real(random, 91, 1000);
        c->mesh.position[i] = (struct vec3){to.x * reach, to.y * reach, random_real(random, -1, 1)};
    }
}

/* Twice the area of p, q and (x,y), by the length of the side: the distance from it. */
static long double side_distance(struct real3 p, struct real3 q, long double x, long double y) {
    long double dx = q.x - p.x, dy = q.y - p.y;
    return (dx * (y - p.y) - dy * (x - p.x)) / hypotl(dx, dy);
}

/* w is 1 everywhere: positions are NDC. Pixels within 1/64 of a side may be drawn or not. */
static bool around_is_right(const void *tried) {
    struct around_case c = *(const struct around_case *)tried;
    struct mesh mesh;
    struct position positions[3];
    struct state state = {positions};
    uint32_t texel = 0xFFFFFF;
    struct texture texture = texture_from(&texel, 1, 1);
    uint8_t pixels[3 * SCREEN_WIDTH * SCREEN_HEIGHT] = {0};
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    double depth[SCREEN_WIDTH * SCREEN_HEIGHT];
    mesh_from(&mesh, &c.mesh, 1);
    depth_clear(depth, SCREEN_WIDTH * SCREEN_HEIGHT);
    struct drawing drawing = {.model = &mesh.model,
                              .diffuse = &texture,
                              .depth = depth,
                              .skip = true,
                              .light = {0, 0, 1},
                              .state = &state};
    struct canvas canvas = make_canvas(&drawing, &image, whole_image(&image));
    struct mat4 to_clip = mat4_identity();
    draw_model(&drawing, &canvas, &to_clip);
    struct real3 p[3];
    for (int i = 0; i < 3; i++) { /* in pixels */
        p[i] = real3_from(c.mesh.position[i]);
        p[i].x = (p[i].x + 1) * SCREEN_WIDTH / 2;
        p[i].y = (p[i].y + 1) * SCREEN_HEIGHT / 2;
    }
    struct real3 normal = real3_cross(real3_sub(p[1], p[0]), real3_sub(p[2], p[0]));
    for (int i = 0; i < SCREEN_WIDTH * SCREEN_HEIGHT; i++) {
        long double x = i % SCREEN_WIDTH + 0.5L, y = i / SCREEN_WIDTH + 0.5L;
        long double inside =
            fminl(side_distance(p[0], p[1], x, y),
                  fminl(side_distance(p[1], p[2], x, y), side_distance(p[2], p[0], x, y)));
        long double z = p[0].z - ((x - p[0].x) * normal.x + (y - p[0].y) * normal.y) / normal.z;
        bool drawn = depth[i] != -INFINITY;
        if ((inside > 1 / 64.0L && !drawn) || (inside < -1 / 64.0L && drawn) ||
            (drawn && !(fabsl(z - (long double)depth[i]) <= 1e-3L))) {
            return false;
        }
    }
    return true;
}

static void print_around(const void *failing) {
    const struct around_case *c = failing;
    for (int i = 0; i < 3; i++) {
        const struct vec3 p = c->mesh.position[i];
        printf("    v %.17g %.17g %.17g\n", p.x, p.y, p.z);
    }
}

/* ---- Soups: random faces in perspective, drawn by the lesson ---- */

static void make_any_soup(struct random *random, uint64_t index, void *made) {
    uint64_t kind = index % 64 == 63 ? SOUP_WIDE + index / 64 % 2 : index % 3;
    *(struct soup_case *)made = (struct soup_case){random_bits(random), kind, SOUP_FACES};
}

static void make_small_soup(struct random *random, uint64_t index, void *made) {
    *(struct soup_case *)made = (struct soup_case){
        random_bits(random), index % 2 ? SOUP_STEEP : SOUP_CAMERA, 1 + index / 2 % SOUP_FACES};
}

static void print_soup_case(const void *failing) {
    const struct soup_case *c = failing;
    struct soup soup;
    soup_make(&soup, c->seed, (enum soup_kind)c->kind, c->faces, (long double)INFINITY);
    soup_print(&soup);
}

/* What the corners of a soup's faces look like: the same light and texture for a whole face, or
 * from the value at each corner. */
enum look { LOOK_FACE, LOOK_INTENSITY, LOOK_U, LOOK_V };

/* A soup with all that the lesson draws from, and what it draws on. */
struct scenery {
    struct soup soup;
    struct mesh_data data; /* texture coordinates and normals */
    struct face faces[SOUP_FACES];
    struct model model;
    struct position positions[SOUP_CORNERS];
    struct state state;
    uint32_t texels[4 * SOUP_FACES];
    struct texture texture;
    struct image image;
    double *depth;
};

static void scenery_free(struct scenery *scenery) {
    image_free(&scenery->image);
    free(scenery->depth);
}

static bool scenery_create(struct scenery *s, const struct soup_case *c) {
    struct error error;
    *s = (struct scenery){.depth = NULL};
    soup_make(&s->soup, c->seed, (enum soup_kind)c->kind, c->faces, (long double)INFINITY);
    s->state.positions = s->positions;
    s->model = s->soup.model;
    s->model.faces = s->faces;
    s->model.uvs = s->data.uv;
    s->model.normals = s->data.normal;
    s->model.uv_count = s->model.normal_count = SOUP_CORNERS;
    for (uint32_t i = 0; i < SOUP_CORNERS; i++) {
        s->faces[i / 3].corner[i % 3] = (struct corner){i, i, i};
    }
    s->depth = calloc(s->soup.width * s->soup.height, sizeof *s->depth);
    depth_clear(s->depth, s->depth != NULL ? s->soup.width * s->soup.height : 0);
    return s->depth != NULL &&
           image_create(&s->image, s->soup.width, s->soup.height, IMAGE_BGR, &error);
}

/* A texture with a column a face, in levels first + 1, first + 2...: each face has its own. */
static void look_like_faces(struct scenery *s, uint32_t first) {
    s->texture = texture_from(s->texels, SOUP_FACES, 1);
    for (uint32_t i = 0; i < SOUP_FACES; i++) {
        s->texels[i] = (first + i + 1) * 0x010101;
    }
    for (int i = 0; i < SOUP_CORNERS; i++) {
        s->data.uv[i][0] = (float)((i / 3 + 0.5) / SOUP_FACES);
        s->data.uv[i][1] = 0.5F;
        mesh_set(s->data.normal[i], (struct vec3){0, 0, 1});
    }
}

/* A texture that becomes brighter to the right and upwards, and the value of each corner as its
 * intensity or as a coordinate. */
static void look_like_values(struct scenery *s, enum look look) {
    s->texture = texture_from(s->texels, look == LOOK_U ? 2 : 1, look == LOOK_V ? 2 : 1);
    s->texels[0] = look == LOOK_INTENSITY ? 0xFFFFFF : 0;
    s->texels[1] = 0xFFFFFF;
    for (int i = 0; i < SOUP_CORNERS; i++) {
        double value = s->soup.value[i], shade = look == LOOK_INTENSITY ? value : 1;
        s->data.uv[i][0] = look == LOOK_U ? (float)value : 0.5F;
        s->data.uv[i][1] = look == LOOK_V ? (float)value : 0.5F;
        mesh_set(s->data.normal[i], (struct vec3){0, 3 * sqrt(1 - shade * shade), 3 * shade});
    }
}

static void draw_scenery(struct scenery *s, bool skip) {
    struct drawing drawing = {.model = &s->model,
                              .diffuse = &s->texture,
                              .depth = s->depth,
                              .light = {0, 0, 7},
                              .skip = skip,
                              .state = &s->state};
    struct canvas canvas = make_canvas(&drawing, &s->image, s->soup.viewport);
    draw_model(&drawing, &canvas, &s->soup.to_clip);
}

static bool face_is_right(const struct scenery *s, int x, int y, struct tally *tally) {
    size_t pixel = (size_t)y * s->soup.width + (size_t)x;
    int face = s->image.pixels[3 * pixel] - 1;
    struct soup_seen seen = soup_see(&s->soup, x, y, true);
    unsigned candidates = soup_candidates(&s->soup, &seen);
    tally->asked += candidates <= 1;
    tally->left_out += candidates > 1;
    if (face < 0 || face >= SOUP_FACES) {
        return face == -1 && candidates == 0 && s->depth[pixel] == -INFINITY;
    }
    struct range depth = seen.hit[face].depth;
    long double tolerance = soup_depth_tolerance(&s->soup, (size_t)face);
    return soup_may_show(&s->soup, &seen, (size_t)face) &&
           (long double)s->depth[pixel] >= depth.least - tolerance &&
           (long double)s->depth[pixel] <= depth.most + tolerance;
}

/* Of the largest images a part is looked at, and where a face begins or ends. */
static bool is_looked_at(const struct scenery *s, int x, int y) {
    if (s->soup.kind < SOUP_WIDE || (x + y) % 41 == 0) {
        return true;
    }
    bool wide = s->soup.kind == SOUP_WIDE;
    uint8_t here = image_get(&s->image, x, y).g;
    return image_get(&s->image, x - wide, y - !wide).g != here ||
           image_get(&s->image, x + wide, y + !wide).g != here;
}

/* The same faces once more, in other levels and with nothing skipped, must change nothing. */
static bool second_drawing_is_hidden(struct scenery *s) {
    struct image before;
    struct error error;
    if (!image_copy(&before, &s->image, &error)) {
        return false;
    }
    look_like_faces(s, 100);
    draw_scenery(s, false);
    size_t size = 3 * s->image.width * s->image.height;
    bool same = memcmp(before.pixels, s->image.pixels, size) == 0;
    image_free(&before);
    return same;
}

static bool judge_nearest(const void *tried, struct tally *tally) {
    struct scenery s;
    bool right = scenery_create(&s, tried);
    if (right) {
        look_like_faces(&s, 0);
        draw_scenery(&s, true);
    }
    for (int y = 0; right && y < (int)s.soup.height; y++) {
        for (int x = 0; right && x < (int)s.soup.width; x++) {
            right = !is_looked_at(&s, x, y) || face_is_right(&s, x, y, tally);
        }
    }
    right = right && second_drawing_is_hidden(&s);
    scenery_free(&s);
    return right;
}

/* The level that a value becomes. Between its two texels' centres a texture is linear. */
static long double level_of_value(long double value, enum look look) {
    long double share = look == LOOK_INTENSITY ? value : 2 * value - 0.5L;
    return 255 * fmaxl(0, fminl(1, share));
}

static bool value_is_right(const struct scenery *s, enum look look, int x, int y) {
    struct soup_seen seen = soup_see(&s->soup, x, y, true);
    bool right = false, any = false;
    for (size_t i = 0; i < s->soup.model.face_count; i++) {
        if (soup_may_show(&s->soup, &seen, i)) {
            struct range value = seen.hit[i].value;
            long double level = image_get(&s->image, x, y).g;
            any = true; /* floats of the model move a level by less than 0.001 */
            right = right || (level >= level_of_value(value.least, look) - 0.501L &&
                              level <= level_of_value(value.most, look) + 0.501L);
        }
    }
    return right || !any;
}

static bool values_are_right(const void *tried) {
    const struct soup_case *c = tried;
    struct scenery s;
    static const enum look looks[] = {LOOK_INTENSITY, LOOK_U, LOOK_V};
    enum look look = looks[c->seed % 3];
    bool right = scenery_create(&s, c);
    if (right) {
        look_like_values(&s, look);
        draw_scenery(&s, true);
    }
    for (int y = 0; right && y < (int)s.soup.height; y++) {
        for (int x = 0; right && x < (int)s.soup.width; x++) {
            right = value_is_right(&s, look, x, y);
        }
    }
    scenery_free(&s);
    return right;
}

static const struct case_kind view_cases = {sizeof(struct view_case), make_view, print_view, NULL};
static const struct case_kind map_cases = {sizeof(struct map_case), make_map, print_map, NULL};
static const struct case_kind divided_cases = {sizeof(struct divided_case), make_divided,
                                               print_divided, NULL};
static const struct case_kind weights_cases = {sizeof(struct weights_case), make_weights,
                                               print_weights, NULL};
static const struct case_kind clip_cases = {sizeof(struct clip_case), make_clip, print_clip, NULL};
static const struct case_kind side_cases = {sizeof(struct side_case), make_side, print_side, NULL};
static const struct case_kind around_cases = {sizeof(struct around_case), make_around, print_around,
                                              NULL};
static const struct case_kind any_soup_cases = {sizeof(struct soup_case), make_any_soup,
                                                print_soup_case, soup_case_shrink};
static const struct case_kind small_soup_cases = {sizeof(struct soup_case), make_small_soup,
                                                  print_soup_case, soup_case_shrink};

const struct property lesson08_properties[] = {
    PROPERTY("lesson08: camera", AGAINST_LONG_DOUBLE, 300000, view_cases, .error = lookat_error,
             .limit = 8, .error_unit = "ulp"),
    PROPERTY("lesson08: projection", AGAINST_LONG_DOUBLE, 200000, view_cases,
             .holds = projection_is_right),
    PROPERTY("lesson08: maps of the plane", AGAINST_LONG_DOUBLE, 100000, map_cases,
             .holds = map_is_right),
    PROPERTY("lesson08: division by w", AGAINST_LONG_DOUBLE, 300000, divided_cases,
             .holds = division_is_right),
    PROPERTY("lesson08: weights in perspective", AGAINST_LONG_DOUBLE, 300000, weights_cases,
             .error = weights_error, .limit = 4, .error_unit = "ulp of 1"),
    PROPERTY("lesson08: clipped corners", AGAINST_LONG_DOUBLE, 200000, clip_cases,
             .holds = clipping_is_right),
    PROPERTY("lesson08: beyond which sides", AGAINST_LONG_DOUBLE, 300000, side_cases,
             .holds = sides_are_right),
    PROPERTY("lesson08: a face around the view", AGAINST_LONG_DOUBLE, 30000, around_cases,
             .holds = around_is_right),
    PROPERTY("lesson08: the nearest by z/w", AGAINST_LONG_DOUBLE, 10000, any_soup_cases,
             .judge = judge_nearest),
    PROPERTY("lesson08: values in perspective", AGAINST_LONG_DOUBLE, 10000, small_soup_cases,
             .holds = values_are_right),
    {.name = NULL},
};
