/* The parts of a model: see parts.h. */
#include "run/parts.h"

#include "base/array.h"
#include "files/model_file.h"
#include "run/atlas.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Faces by their materials ---- */

/* The place of a face's material among all, those without one behind the last. */
static size_t slot_of(const struct model *model, size_t face) {
    uint32_t material = model->face_materials[face];
    return material == MODEL_NONE ? model->material_count : material;
}

/* Where the faces of each material begin, once they are sorted, and where the last of them end. */
static void find_begins(const struct model *model, size_t *begins) {
    for (size_t i = 0; i < model->face_count; i++) {
        begins[slot_of(model, i) + 1]++;
    }
    for (size_t i = 0; i <= model->material_count; i++) {
        begins[i + 1] += begins[i];
    }
}

/* Bring each of the items, if there are any, to its new place. */
static bool reorder(void *items, size_t size, const size_t *to, size_t count) {
    char *sorted = items == NULL ? NULL : malloc(count * size + 1);
    if (sorted == NULL) {
        return items == NULL;
    }
    for (size_t i = 0; i < count; i++) {
        memcpy(sorted + to[i] * size, (const char *)items + i * size, size);
    }
    memcpy(items, sorted, count * size);
    free(sorted);
    return true;
}

/* Faces of one material keep their order. */
static bool sort_faces(struct model *model, const size_t *begins) {
    size_t count = model->face_count, slots = model->material_count + 1;
    size_t *next = malloc(slots * sizeof *next), *to = malloc((count + 1) * sizeof *to);
    bool done = next != NULL && to != NULL;
    if (done) {
        memcpy(next, begins, slots * sizeof *next);
    }
    for (size_t i = 0; done && i < count; i++) {
        to[i] = next[slot_of(model, i)]++;
    }
    done = done && reorder(model->faces, sizeof *model->faces, to, count) &&
           reorder(model->face_materials, sizeof *model->face_materials, to, count) &&
           reorder(model->face_groups, sizeof *model->face_groups, to, count) &&
           reorder(model->face_colors, sizeof *model->face_colors, to, count);
    free(next);
    free(to);
    return done;
}

/* ---- Textures ---- */

static const float white[3] = {1, 1, 1};

/* False when memory runs out. */
static bool keep_picture(struct parts *parts, const struct picture *picture) {
    size_t capacity = parts->picture_count; /* few, and each is large */
    if (!array_extend(&parts->pictures, &capacity, parts->picture_count + 1,
                      sizeof *parts->pictures)) {
        return false;
    }
    parts->pictures[parts->picture_count++] = *picture;
    return true;
}

/* How steep the bumps of a map in tangent space are: its values along the surface over that away
 * from it. */
static void find_steepness(float bump, float tint[3]) {
    tint[0] = tint[1] = bump < 1 ? bump : 1;
    tint[2] = bump > 1 ? 1 / bump : 1;
}

static uint32_t multiplied(uint8_t level, float zero, float factor) {
    return (uint32_t)(zero + ((float)level - zero) * factor + 0.5F);
}

/* Multiply red, green and blue, which count from a level `zero`. */
static void multiply(struct texture *texture, const float tint[3], float zero) {
    for (size_t i = 0; i < texture->level_count; i++) {
        const struct texture_level *level = &texture->level[i];
        for (size_t k = 0; k < level->pitch * (level->height + 1); k++) {
            struct color c = color_from_texel(level->texels[k]);
            level->texels[k] = multiplied(c.b, zero, tint[2]) |
                               multiplied(c.g, zero, tint[1]) << 8 |
                               multiplied(c.r, zero, tint[0]) << 16 | (uint32_t)c.a << 24;
        }
    }
}

static bool read_picture(struct picture *picture, const int *turns, size_t level_limit,
                         struct error *why) {
    struct texture *texture = &picture->texture;
    const float *tint = picture->tint;
    bool done = turns != NULL ? model_read_normal_map(texture, picture->path, turns, why)
                              : model_read_texture(texture, picture->path, level_limit, why);
    bool is_tinted = tint[0] != 1 || tint[1] != 1 || tint[2] != 1;
    if (is_tinted && (turns == NULL || texture->tangent_space)) {
        multiply(texture, tint, turns != NULL ? 127.5F : 0);
    }
    return done;
}

/* A texture of one texel. */
static bool make_color(struct picture *picture, struct error *why) {
    uint8_t bgr[3];
    for (int i = 0; i < 3; i++) {
        bgr[i] = (uint8_t)(picture->tint[2 - i] * 255 + 0.5F);
    }
    const struct image image = {.width = 1, .height = 1, .format = IMAGE_BGR, .pixels = bgr};
    return texture_create(&picture->texture, &image, why);
}

static bool is_same(const struct picture *a, const struct picture *b) {
    bool same_path =
        a->path == NULL || b->path == NULL ? a->path == b->path : strcmp(a->path, b->path) == 0;
    return same_path && a->is_normal_map == b->is_normal_map &&
           memcmp(a->tint, b->tint, sizeof a->tint) == 0;
}

/* The texture of a file, multiplied by a colour, read at the first call; of no level where it
 * cannot be read. Without a file (NULL) it is the colour. With `turns` it is a normal map of a
 * model that was turned so. */
static bool find_picture(struct parts *parts, const char *path, const float tint[3],
                         const int *turns, struct texture *texture, struct error *why) {
    struct picture picture = {.path = path, .is_normal_map = turns != NULL};
    memcpy(picture.tint, tint, sizeof picture.tint);
    for (size_t i = 0; i < parts->picture_count; i++) {
        if (is_same(&parts->pictures[i], &picture)) {
            *texture = parts->pictures[i].texture;
            return true;
        }
    }
    bool is_read = path != NULL ? read_picture(&picture, turns, parts->level_limit, why)
                                : make_color(&picture, why);
    if (picture.texture.space_guessed) {
        error_set(why, "blue, so it is read as a normal map in tangent space");
        error_name_file(why, path);
    }
    if ((path == NULL && !is_read) || !keep_picture(parts, &picture)) {
        texture_free(&picture.texture);
        return false;
    }
    *texture = picture.texture;
    return true;
}

/* Give a part the normal map of its material. */
static bool give_normal_map(struct parts *parts, struct drawing_part *part,
                            const struct model_material *material) {
    struct error why = {0};
    float tint[3];
    int turns[3]; /* a copy: clang-tidy takes the part's own for NULL */
    memcpy(turns, part->model.turns, sizeof turns);
    find_steepness(material->bump, tint);
    if (!find_picture(parts, material->bumps, tint, turns, &part->normal_map, &why)) {
        return false;
    }
    bool is_read = part->normal_map.level_count > 0;
    bool is_news = parts->note.message[0] == '\0' || (parts->is_note_of_guess && !is_read);
    if (why.message[0] != '\0' && is_news && !(is_read && material->is_norm)) {
        error_set(&parts->note, "%s%s", why.message,
                  is_read ? "" : "; the mesh's normals instead (--normal-map)");
        parts->is_note_of_guess = is_read;
    }
    part->normal_map.tangent_space = part->normal_map.tangent_space || material->is_norm;
    return true;
}

/* What a part shows of a colour of its material: its picture in this colour or, where it has none
 * that can be read, the colour alone. */
static bool give_colors(struct parts *parts, const struct drawing_part *part,
                        const struct model_material *material, const float color[3],
                        struct texture *texture, struct error *why) {
    if (material != NULL && material->texture != NULL && part->model.uv_count > 0) {
        float tint[3];
        find_tint(color, tint);
        if (!find_picture(parts, material->texture, tint, NULL, texture, why)) {
            return false;
        }
        texture_set_clamp(texture, material->clamp);
    }
    return texture->level_count > 0 || find_picture(parts, NULL, color, NULL, texture, why);
}

/* The textures of a part; none where its corners have no places in them. */
static bool give_textures(struct parts *parts, struct drawing_part *part,
                          const struct model_material *material, struct error *missing) {
    struct error why = {0}, ignored;
    bool has_places = part->model.uv_count > 0;
    if (!give_colors(parts, part, material, material != NULL ? material->color : white,
                     &part->diffuse, &why)) {
        return false;
    }
    if (why.message[0] != '\0' && missing->message[0] == '\0') {
        error_set(missing, "%s; the material's colour instead (--texture)", why.message);
    }
    if (material != NULL && material->has_ambient &&
        !give_colors(parts, part, material, material->ambient, &part->ambient, &ignored)) {
        return false;
    }
    if (material != NULL && material->shine != NULL && has_places &&
        !find_picture(parts, material->shine, white, NULL, &part->specular, &ignored)) {
        return false;
    }
    return material == NULL || material->bumps == NULL || !has_places || !parts->with_normal_maps ||
           give_normal_map(parts, part, material);
}

/* ---- Parts ---- */

/* Twice the area of the faces. */
static double surface_of(const struct model *model) {
    double sum = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        sum += vec3_length(model_face_normal(model, i));
    }
    return sum;
}

/* Twice the area that the faces have in the plane of u and v, where a picture has the area 1. */
static double pictures_on(const struct model *model) {
    double sum = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        struct vec2 a = model_uv(model, i, 0), b = model_uv(model, i, 1), c = model_uv(model, i, 2);
        sum += fabs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    }
    return sum;
}

double parts_repeats(const struct model *faces, const struct model *whole, bool two_sided) {
    double share = faces == whole ? 1 : surface_of(faces) / surface_of(whole);
    return sqrt(pictures_on(faces) / (two_sided ? 4 : 2) / share);
}

static bool add_part(struct parts *parts, const struct model *model, const size_t *begins,
                     size_t slot, struct error *missing) {
    const struct model_material *material =
        slot < model->material_count ? &model->materials[slot] : NULL;
    if (begins[slot] == begins[slot + 1] || (material != NULL && material->hidden)) {
        return true;
    }
    struct drawing_part *part = &parts->part[parts->count++];
    *part = (struct drawing_part){.model = *model, .specular_weight = -1};
    part->model.faces += begins[slot];
    part->model.face_count = begins[slot + 1] - begins[slot];
    if (model->face_colors != NULL) {
        part->model.face_colors += begins[slot];
    }
    if (!give_textures(parts, part, material, missing)) {
        return false;
    }
    if (material != NULL && part->specular.level_count == 0) { /* a map counts before a number */
        part->specular_weight = (double)material->specular;
    }
    part->power = material != NULL ? (double)material->power : 0;
    part->repeats = model->uv_count == 0 ? 1 : parts_repeats(&part->model, model, parts->two_sided);
    return true;
}

/* Does a picture cover the part, or do other maps need its coordinates? */
static bool has_pictures(const struct parts *parts, const struct drawing_part *part) {
    bool has = part->normal_map.level_count > 0 || part->specular.level_count > 0;
    for (size_t i = 0; i < parts->picture_count; i++) {
        const struct picture *picture = &parts->pictures[i];
        has = has || (picture->path != NULL && picture->texture.texels == part->diffuse.texels);
    }
    return has;
}

/* Parts without a picture show the colours of their faces, where the model has any. */
static bool paint_parts(struct parts *parts, struct model *model, struct error *error) {
    uint8_t *painted = calloc(model->face_count + 1, 1);
    bool done = painted != NULL, any = false;
    for (size_t i = 0; done && i < parts->count; i++) {
        const struct drawing_part *part = &parts->part[i];
        if (!has_pictures(parts, part)) {
            memset(painted + (part->model.faces - model->faces), 1, part->model.face_count);
            any = true;
        }
    }
    if (done && any && parts->atlas.level_count == 0) {
        done = atlas_make(&parts->atlas, model, painted, error);
    }
    for (size_t i = 0; done && any && i < parts->count; i++) {
        struct drawing_part *part = &parts->part[i];
        part->model.uvs = model->uvs;
        part->model.uv_count = model->uv_count;
        if (painted[part->model.faces - model->faces]) {
            part->diffuse = parts->atlas;
        }
    }
    free(painted);
    return done;
}

bool parts_make(struct parts *parts, struct model *model, struct error *missing,
                struct error *error) {
    size_t slots = model->material_count + 1;
    size_t *begins = calloc(slots + 1, sizeof *begins);
    free(parts->part);
    parts->part = calloc(slots + 1, sizeof *parts->part);
    parts->count = 0;
    bool done = begins != NULL && parts->part != NULL;
    if (done) {
        find_begins(model, begins);
        done = sort_faces(model, begins);
    }
    for (size_t slot = 0; done && slot < slots; slot++) {
        done = add_part(parts, model, begins, slot, missing);
    }
    if (done && model_has_colors(model)) {
        done = paint_parts(parts, model, error);
    }
    if (done && parts->count == 0) { /* all are hidden */
        done = find_picture(parts, NULL, white, NULL, &parts->part[0].diffuse, error);
    }
    if (done) {
        parts->part[parts->count] = parts->part[0];
        parts->part[parts->count].model = *model;
    }
    free(begins);
    return done || error_out_of_memory(error);
}

/* Does a material put its picture elsewhere than the coordinates say? */
static bool moves(const struct model_material *m) {
    return m->scale[0] != 1 || m->scale[1] != 1 || m->offset[0] != 0 || m->offset[1] != 0;
}

/* Behind the others, all coordinates as one material has them. */
static void move_coordinates(struct model *model, size_t count, uint32_t material) {
    const struct model_material *m = &model->materials[material];
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 2; k++) {
            model->uvs[model->uv_count + i][k] = m->offset[k] + m->scale[k] * model->uvs[i][k];
        }
    }
    for (size_t i = 0; i < model->face_count; i++) {
        for (int k = 0; model->face_materials[i] == material && k < 3; k++) {
            uint32_t *uv = &model->faces[i].corner[k].uv;
            *uv = *uv == MODEL_NONE ? MODEL_NONE : *uv + (uint32_t)model->uv_count;
        }
    }
    model->uv_count += count;
}

bool parts_move_coordinates(struct model *model, struct error *error) {
    const size_t count = model->uv_count;
    for (uint32_t i = 0; count > 0 && i < model->material_count; i++) {
        if (!moves(&model->materials[i]) || model->uv_count + count >= MODEL_NONE) {
            continue;
        }
        size_t capacity = model->uv_count;
        if (!array_extend(&model->uvs, &capacity, model->uv_count + count, sizeof *model->uvs)) {
            return error_out_of_memory(error);
        }
        move_coordinates(model, count, i);
    }
    return true;
}

void parts_free(struct parts *parts) {
    for (size_t i = 0; i < parts->picture_count; i++) {
        texture_free(&parts->pictures[i].texture);
    }
    texture_free(&parts->atlas);
    free(parts->pictures);
    free(parts->part);
    *parts = (struct parts){0};
}
