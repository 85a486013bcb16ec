/*
 * Beyond lesson 10: a shadow map. Drawn by `build/step10_phong --only shadow`.
 *
 * The head is drawn twice. First as the light sees it, and only the depths are kept: the map. Then
 * as the eye sees it: each pixel finds its own place in the map, and is in the shadow where the
 * light sees something nearer. (Lance Williams, "Casting Curved Shadows on Curved Surfaces",
 * SIGGRAPH 1978.)
 */

/* What vertex and fragment function read: the lesson's uniforms, which come first, so that its own
 * functions find them, and the map. */
struct shadow_uniforms {
    struct uniforms lit;
    struct mat4 to_map;  /* from the world: x and y in pixels of the map, z towards the light */
    const double *depth; /* the map: side * side depths, row by row from the bottom */
    int side;
    double bias; /* nearer by less than this is not in front */
};

/* ---- First pass: what the light sees ---- */

static void depth_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face, (void)corner;
    varyings[0] = 0; /* nobody reads it */
}

static lanes_mask depth_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms, (void)varyings;
    *color = lanes_black();
    return lanes_all_set();
}

SHADER(depth_only, .varying_count = 1, .vertex = depth_vertex, .fragment = depth_fragment);

/* The sun is far away: its rays are parallel, so there is no perspective, and z/w is z. */
static struct draw_call light_call(const struct model *model, struct vec3 to_light, int side) {
    const struct vec3 center = {0, 0, 0}, up = {0, 1, 0};
    const double zoom = 1 / 1.75; /* a corner of the cube -1..1 is 1.73 from its center */
    return (struct draw_call){
        .model = model,
        .to_clip =
            mat4_mul(mat4_scaling((struct vec3){zoom, zoom, 1}), mat4_lookat(to_light, center, up)),
        .viewport = {0, 0, side, side},
        .cull = CULL_BACK,
    };
}

/* Clip space to pixels of the map, as the viewport does it. */
static struct mat4 clip_to_map(int side) {
    const struct vec3 scale = {side / 2.0, side / 2.0, 1}, right_and_up = {1, 1, 0};
    return mat4_mul(mat4_scaling(scale), mat4_translation(right_and_up));
}

/* Draw the map into `light`, which the caller frees; its depths stay there. */
static bool draw_shadow_map(struct pipeline *light, const struct draw_call *call,
                            struct error *error) {
    struct image unused = {0};
    size_t side = (size_t)call->viewport.width;
    bool done = image_create(&unused, side, side, IMAGE_BGR, error) &&
                pipeline_create(light, side, side, error);
    if (done) {
        light->keep_depth = true;
        done = pipeline_draw(light, call, &depth_only, NULL, 0, error) &&
               pipeline_finish(light, &unused, error);
    }
    image_free(&unused);
    return done;
}

/* ---- Second pass: what the eye sees, and of that what the light sees, too ---- */

static void shadow_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct shadow_uniforms *u = uniforms;
    struct vec4 place = mat4_point(&u->to_map, model_position(u->lit.model, face, corner));
    vertex_with_normal(&u->lit, face, corner, varyings);
    varyings[8] = place.x;
    varyings[9] = place.y;
    varyings[10] = place.z;
}

/* The depths in the map at these places. Beyond its border is what is at it. */
static lanes map_depth(const struct shadow_uniforms *u, lanes x, lanes y) {
    lanes zero = lanes_all(0), last = lanes_all((real)(u->side - 1));
    lanes_int column = lanes_to_int(lanes_min(lanes_max(x, zero), last));
    lanes_int row = lanes_to_int(lanes_min(lanes_max(y, zero), last));
    lanes_int places = row * u->side + column;
    int32_t place[LANES];
    real depth[LANES];
    lanes depths;
    memcpy(place, &places, sizeof place);
    for (int i = 0; i < LANES; i++) {
        depth[i] = (real)u->depth[place[i]];
    }
    memcpy(&depths, depth, sizeof depths);
    return depths;
}

/* Is something between these places and the light? */
static lanes_mask in_shadow(const struct shadow_uniforms *u, const lanes *varyings) {
    return map_depth(u, varyings[8], varyings[9]) > varyings[10] + (real)u->bias;
}

/* A place in the shadow gets what one gets that is turned away from the light: the ambient part. */
static lanes_mask shadow_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct shadow_uniforms *u = uniforms;
    struct surface surface = textured_surface(&u->lit, varyings);
    struct lanes3 normal =
        u->lit.normal_map != NULL ? mapped_normal(&u->lit, varyings) : mesh_normal(varyings);
    struct lanes3 away = lanes3_all(vec3_scale(u->lit.to_light, -1));
    lanes_mask shadow = in_shadow(u, varyings);
    surface.normal.x = lanes_select(shadow, away.x, normal.x);
    surface.normal.y = lanes_select(shadow, away.y, normal.y);
    surface.normal.z = lanes_select(shadow, away.z, normal.z);
    *color = illuminate(&u->lit, &surface);
    return lanes_all_set();
}

SHADER(shadowed, .varying_count = 11, .vertex = shadow_vertex, .fragment = shadow_fragment);

/* Both passes. `side` is the map's, and the shader's uniforms are a struct shadow_uniforms. */
static bool draw_with_map(struct drawing *drawing, struct image *image, int side, double bias,
                          const struct shader *shader, struct error *error) {
    struct pipeline light = {0}, *eye = pipeline_begin(drawing);
    struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0);
    struct draw_call call = pipeline_call(drawing, whole, 0.85, CULL_BACK);
    struct shadow_uniforms u = {
        .lit = make_uniforms(drawing, 0.85 * whole.width, textured_material),
        .side = side,
        .bias = bias,
    };
    if (u.lit.normal_map != NULL && u.lit.normal_map->tangent_space) {
        u.lit.normal_map = NULL; /* the normals of the mesh, as where there is no map */
    }
    struct draw_call from_light = light_call(drawing->model, u.lit.to_light, side);
    bool done = draw_shadow_map(&light, &from_light, error);
    u.to_map = mat4_mul(clip_to_map(side), from_light.to_clip);
    u.depth = light.depth;
    done = done && pipeline_draw(eye, &call, shader, &u, sizeof u, error);
    done = pipeline_end(drawing, done, image, error);
    pipeline_free(&light);
    return done;
}

static bool draw_shadow(struct drawing *drawing, struct image *image, struct error *error) {
    return draw_with_map(drawing, image, 1024, 0.01, &shadowed, error);
}
