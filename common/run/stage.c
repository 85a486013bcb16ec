/* A scene on its stage: see stage.h. */
#include "run/stage.h"

#include "base/file.h"
#include "files/fit.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "files/sides.h"
#include "run/atlas.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Counting ---- */

void drawing_count(struct drawing *drawing, const char *name, uint64_t amount) {
    size_t i = 0;
    while (i < drawing->counter_count && strcmp(drawing->counters[i].name, name) != 0) {
        i++;
    }
    if (i == drawing->counter_count) {
        assert(i < COUNTER_LIMIT);
        drawing->counters[i] = (struct counter){.name = name};
        drawing->counter_count++;
    }
    drawing->counters[i].value += amount;
}

void drawing_note(struct drawing *drawing, const char *format, ...) {
    char line[sizeof drawing->notes];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    string_append(drawing->notes, sizeof drawing->notes, "%s\n", line);
}

/* ---- Parts ---- */

bool drawing_take_part(struct drawing *drawing, size_t i) {
    if (drawing->parts == NULL) {
        return i == 0;
    }
    bool is_part = i < drawing->part_count;
    const struct drawing_part *part = &drawing->parts[is_part ? i : drawing->part_count];
    drawing->model = &part->model;
    drawing->diffuse = &part->diffuse;
    drawing->normal_map =
        part->normal_map.level_count > 0 ? &part->normal_map : drawing->whole_normal_map;
    drawing->specular = part->specular.level_count > 0 ? &part->specular : drawing->whole_specular;
    drawing->ambient = part->ambient.level_count > 0 ? &part->ambient : NULL;
    drawing->specular_weight = part->specular_weight;
    drawing->power = part->power;
    drawing->repeats = part->repeats;
    return is_part;
}

/* ---- Numbers of scenes ---- */

double drawing_value(const struct drawing *drawing, const char *name) {
    const struct chosen_value wanted = {.name = name, .length = strlen(name)};
    const struct scene_value *value = find_value(drawing->values, &wanted);
    return value != NULL ? drawing->value[value - drawing->values] : 0;
}

struct vec2 drawing_point(const struct drawing *drawing, const char *name) {
    char x[64], y[64];
    snprintf(x, sizeof x, "%s_x", name);
    snprintf(y, sizeof y, "%s_y", name);
    return (struct vec2){drawing_value(drawing, x), drawing_value(drawing, y)};
}

/* The scene's defaults, then what was chosen. */
static void set_values(struct drawing *drawing, const struct scene *scene, const struct run *run) {
    drawing->values = scene->values;
    for (size_t i = 0; scene->values != NULL && scene->values[i].name != NULL; i++) {
        assert(i < VALUE_LIMIT);
        drawing->value[i] = scene->values[i].value;
    }
    for (size_t i = 0; i < run->asked->set_count; i++) {
        const struct chosen_value *chosen = &run->asked->set[i];
        const struct scene_value *value = find_value(scene->values, chosen);
        if (value != NULL) {
            drawing->value[value - scene->values] = chosen->value;
        }
    }
}

/* ---- Scenes: what they leave at zero is the program's ---- */

static size_t first_of(size_t option, size_t given, size_t otherwise) {
    return option > 0 ? option : given > 0 ? given : otherwise;
}

static struct vec3 first_vec3_of(struct vec3_option option, struct vec3 given,
                                 struct vec3 otherwise) {
    bool is_zero = given.x == 0 && given.y == 0 && given.z == 0;
    return option.given ? option.value : is_zero ? otherwise : given;
}

struct scene scene_complete(const struct options *options, const struct scene *given) {
    const struct scene *defaults = &options->program->defaults;
    struct scene scene = *given;
    scene.model = given->model != NULL ? given->model : DEFAULT_MODEL;
    scene.width = first_of(options->size.width, given->width, defaults->width);
    scene.height = first_of(options->size.height, given->height, defaults->height);
    scene.format = given->format != 0 ? given->format : IMAGE_BGR;
    scene.frames = given->frames > 0 ? given->frames : 1;
    scene.eye = first_vec3_of(options->eye, given->eye, defaults->eye);
    scene.center = first_vec3_of(options->center, given->center, defaults->center);
    scene.up = first_vec3_of(options->up, given->up, defaults->up);
    scene.light = first_vec3_of(options->light, given->light, defaults->light);
    return scene;
}

/* ---- Loading ---- */

struct loaded run_loaded(const struct run *run) {
    struct loaded loaded = run->unloaded;
    loaded.textures_present += model_textures_present(run->model);
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        loaded.textures_read += run->model->textures[kind].level_count > 0;
    }
    for (size_t i = 0; i < run->parts.picture_count; i++) {
        const struct picture *picture = &run->parts.pictures[i];
        bool is_read = picture->path != NULL && picture->texture.level_count > 0;
        loaded.textures_present += is_read;
        loaded.textures_read += is_read;
    }
    return loaded;
}

static void free_models(struct run *run) {
    for (size_t i = 0; i < MODELS_LIMIT; i++) {
        model_free(&run->model[i]);
    }
}

static void unload_model(struct run *run) {
    run->unloaded = run_loaded(run);
    free_models(run);
    run->model_file = NULL;
    parts_free(&run->parts);
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        run->is_replaced[kind] = false;
    }
}

/* What of a model's file such scenes look at. */
static unsigned needed_parts(unsigned needs) {
    unsigned normals = NEEDS_NORMALS | NEEDS_COLORS;
    unsigned textures = NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR;
    return ((needs & normals) != 0 ? MODEL_NORMALS : 0) |
           ((needs & textures) != 0 ? MODEL_UVS : 0) |
           ((needs & textures & ~(unsigned)NEEDS_PICTURE) != 0 ? MODEL_LEVELS : 0) |
           ((needs & NEEDS_COLORS) != 0 ? MODEL_MATERIALS : 0) |
           ((needs & NEEDS_LINES) != 0 ? MODEL_LINES : 0);
}

/* Turn it, show its faces from both sides, fit it into view, as the options say. */
static bool place_model(const struct run *run, struct model *model, bool need_normals,
                        struct error *error) {
    const struct options *options = &run->options;
    const int *turns = options->turns;
    model->hard_given = options->smooth.given;
    model->hard_degrees = options->smooth.degrees;
    if (turns[0] != 0 || turns[1] != 0 || turns[2] != 0) {
        model_turn(model, turns);
    }
    if (options->two_sided && !model_add_other_sides(model, need_normals, error)) {
        return false;
    }
    if (options->fit) {
        model_fit(model, options->program->takes_camera);
    }
    return true;
}

/* One of the course's own. */
static bool read_own_model(struct model *model, const char *file, unsigned parts,
                           struct error *error) {
    char *path = string_format("%s/%s", MODELS_DIRECTORY, file);
    if (path == NULL) {
        return error_out_of_memory(error);
    }
    bool done = file_exists(path) ? model_read_parts(model, path, parts, error)
                                  : error_set(error, "%s: no such file; `make` sculpts it", path);
    free(path);
    return done;
}

/* The models of the command line or else the scene's, unless they are loaded already. */
static bool load_models(struct run *run, const struct scene *scene, struct error *error) {
    const struct options *options = &run->options;
    const bool is_own = options->input_count == 0;
    const char *file = is_own ? scene->model : options->input[0];
    unsigned needs = run->needs | scene->needs;
    if (!is_own && (needs & NEEDS_NORMAL_MAP) != 0) {
        needs |= NEEDS_NORMALS; /* it may have no map, and then it is drawn by these */
    }
    unsigned parts = needed_parts(needs);
    if (run->model_file != NULL && strcmp(run->model_file, file) == 0 &&
        (parts & ~run->model_parts) == 0) {
        return true;
    }
    unload_model(run);
    run->model_parts = parts;
    run->model_count = is_own ? 1 : options->input_count;
    bool done = !is_own || read_own_model(run->model, file, parts, error);
    for (size_t i = 0; done && i < options->input_count; i++) {
        done = model_read_parts(&run->model[i], options->input[i], parts, error);
    }
    memcpy(run->model->texture_files, options->textures, sizeof options->textures);
    run->has_places = run->model->uv_count > 0;
    run->has_materials = (needs & NEEDS_DIFFUSE) != 0 && options->textures[MODEL_DIFFUSE] == NULL &&
                         model_has_materials(run->model);
    done = done && (!run->has_materials || parts_move_coordinates(run->model, error));
    for (size_t i = 0; done && i < run->model_count; i++) {
        done = place_model(run, &run->model[i], (parts & MODEL_NORMALS) != 0, error);
    }
    run->model_file = done ? file : NULL;
    return done;
}

/* One texel, where the texture is empty yet. */
static bool make_texel(struct texture *texture, uint8_t level, struct error *error) {
    const struct image image = {.width = 1, .height = 1, .format = IMAGE_GREY, .pixels = &level};
    return texture->level_count > 0 || texture_create(texture, &image, error);
}

enum { SHINY = 64 }; /* the level of a specular map: a power of 16, as lesson 10 reads it */

/* Is the model drawn in its own colours, since it has no picture? Not where other maps need its
 * coordinates. */
static bool shows_own_colors(const struct run *run) {
    bool maps = false, found;
    for (int kind = MODEL_NORMAL_MAP; run->has_places && kind < MODEL_TEXTURE_KINDS; kind++) {
        free(model_find_texture(run->model, (enum model_texture_kind)kind, &found));
        maps = maps || found;
    }
    return model_has_colors(run->model) && !maps;
}

/* What is drawn instead of a missing texture: NULL for a normal map. */
static bool replace_texture(struct run *run, enum model_texture_kind kind,
                            const struct texture **texture, struct error *error) {
    if (kind == MODEL_NORMAL_MAP) {
        *texture = NULL;
        return model_need_normals(run->model, error);
    }
    if (kind == MODEL_DIFFUSE && shows_own_colors(run)) {
        *texture = &run->parts.atlas;
        return run->parts.atlas.level_count > 0 ||
               atlas_make(&run->parts.atlas, run->model, NULL, error);
    }
    struct texture *instead = kind == MODEL_DIFFUSE ? &run->white : &run->shiny;
    *texture = instead;
    return make_texel(instead, kind == MODEL_DIFFUSE ? 255 : SHINY, error);
}

/* What is drawn where there is no texture, and the option that names one. */
static const struct {
    unsigned need;
    const char *instead, *option;
} replacements[MODEL_TEXTURE_KINDS] = {
    [MODEL_DIFFUSE] = {NEEDS_DIFFUSE, "white", "--texture"},
    [MODEL_NORMAL_MAP] = {NEEDS_NORMAL_MAP, "the mesh's normals", "--normal-map"},
    [MODEL_SPECULAR] = {NEEDS_SPECULAR, "the same shine everywhere", "--specular"},
};

static const char *instead_of(const struct run *run, enum model_texture_kind kind) {
    return kind == MODEL_DIFFUSE && shows_own_colors(run) ? "its own colours"
                                                          : replacements[kind].instead;
}

/* Say in one message which of the textures that the scenes need are not there. */
static bool note_missing(struct run *run, unsigned needs, struct error *error) {
    char names[200] = "", instead[200] = "", options[200] = "";
    struct error *note = NULL;
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        bool found;
        if ((needs & replacements[kind].need) == 0 || run->is_replaced[kind]) {
            continue;
        }
        char *path = model_find_texture(run->model, (enum model_texture_kind)kind, &found);
        if (path == NULL) {
            return error_out_of_memory(error);
        }
        if (!found) {
            const char *slash = strrchr(path, '/'), *comma = note == NULL ? "" : ", ";
            string_append(names, sizeof names, "%s%s", comma, slash == NULL ? path : slash + 1);
            string_append(instead, sizeof instead, "%s%s", comma,
                          instead_of(run, (enum model_texture_kind)kind));
            string_append(options, sizeof options, "%s%s", comma, replacements[kind].option);
            note = note == NULL ? &run->replaced[kind] : note;
            run->is_replaced[kind] = true;
        }
        free(path);
    }
    if (note != NULL) {
        error_set(note, "no %s next to it, nor other usual names; %s instead (%s)", names, instead,
                  options);
        error_name_input(note, run->model->path);
    }
    return true;
}

/* A texture that the scene needs. One that the command line names must be there; others are
 * replaced, and those of a model whose corners have no place in a picture are not looked for. */
static bool load_texture(struct run *run, unsigned needs, enum model_texture_kind kind,
                         const struct texture **texture, struct error *error) {
    if ((needs & replacements[kind].need) == 0) {
        return true;
    }
    if (!run->has_places && run->options.textures[kind] != NULL) {
        error_set(error, "has no texture coordinates, without which %s cannot be drawn",
                  run->options.textures[kind]);
        return error_name_input(error, run->model->path);
    }
    if (run->has_materials && kind == MODEL_DIFFUSE) {
        return true; /* take_parts() gives it */
    }
    if (run->has_places && !run->has_materials && !note_missing(run, needs | run->needs, error)) {
        return false;
    }
    bool found = true;
    if (run->has_places && run->has_materials) { /* what they do not name is no loss */
        free(model_find_texture(run->model, kind, &found));
    }
    if (!run->has_places || !found || run->is_replaced[kind]) {
        return replace_texture(run, kind, texture, error);
    }
    *texture = model_texture(run->model, kind, error);
    bool *guessed = &run->model->textures[kind].space_guessed;
    if (*guessed) {
        error_set(&run->replaced[kind], "the normal map is blue, so it is read as one in tangent "
                                        "space, as if its name ended in _tangent");
        error_name_input(&run->replaced[kind], run->model->path);
        *guessed = false; /* it is said */
    }
    if (*texture != NULL || run->options.textures[kind] != NULL) {
        return *texture != NULL;
    }
    error_set(&run->replaced[kind], "%s; %s instead (%s)", error->message, instead_of(run, kind),
              replacements[kind].option);
    run->is_replaced[kind] = true;
    return replace_texture(run, kind, texture, error);
}

bool scene_needs_model(const struct scene *scene) {
    return (scene->needs & ~(unsigned)NEEDS_DEPTH) != 0;
}

/* The parts of a model with materials. */
static bool take_parts(struct run *run, unsigned needs, struct drawing *drawing,
                       struct error *error) {
    const struct options *options = &run->options;
    if (!run->has_materials) {
        drawing->repeats =
            !run->has_places ? 1 : parts_repeats(run->model, run->model, options->two_sided);
        return true;
    }
    run->parts.two_sided = options->two_sided;
    run->parts.level_limit = run->model->level_limit;
    run->parts.with_normal_maps =
        (needs & NEEDS_NORMAL_MAP) != 0 && options->textures[MODEL_NORMAL_MAP] == NULL;
    if (!parts_make(&run->parts, run->model, &run->replaced[MODEL_DIFFUSE], error)) {
        return false;
    }
    if (run->parts.note.message[0] != '\0') {
        run->replaced[MODEL_NORMAL_MAP] = run->parts.note;
        run->parts.note.message[0] = '\0';
    }
    drawing->parts = run->parts.part;
    drawing->part_count = run->parts.count;
    drawing->whole_normal_map = drawing->normal_map;
    drawing->whole_specular = drawing->specular;
    drawing_take_part(drawing, drawing->part_count);
    return true;
}

/* All that the scene needs, except for its depth buffer. */
static bool load_needs(struct run *run, const struct scene *scene, struct drawing *drawing,
                       struct error *error) {
    unsigned needs = scene->needs;
    if (!scene_needs_model(scene)) {
        return true;
    }
    if (!load_models(run, scene, error)) {
        return false;
    }
    drawing->model = run->model;
    drawing->model_count = run->model_count;
    for (size_t i = 0; i < run->model_count; i++) {
        drawing->models[i] = &run->model[i];
        if ((needs & NEEDS_NORMALS) != 0 && !model_need_normals(&run->model[i], error)) {
            return false;
        }
    }
    return ((needs & NEEDS_COLORS) == 0 || model_need_colors(run->model, error)) &&
           load_texture(run, needs, MODEL_DIFFUSE, &drawing->diffuse, error) &&
           load_texture(run, needs, MODEL_NORMAL_MAP, &drawing->normal_map, error) &&
           load_texture(run, needs, MODEL_SPECULAR, &drawing->specular, error) &&
           ((needs & NEEDS_DIFFUSE) == 0 || take_parts(run, needs, drawing, error));
}

/* ---- The stage ---- */

/* Memory for the depth buffer, where the scene needs one, and for the program's state. */
static bool allocate(struct stage *stage, size_t width, size_t height, struct error *error) {
    struct drawing *drawing = &stage->drawing;
    if (stage->program->state_size > 0) {
        drawing->state = calloc(1, stage->program->state_size);
        if (drawing->state == NULL) {
            return error_out_of_memory(error);
        }
    }
    if ((stage->scene.needs & NEEDS_DEPTH) != 0) {
        drawing->depth = malloc(width * height * sizeof *drawing->depth);
        if (drawing->depth == NULL) {
            return error_set(error, "out of memory for a depth buffer of %zux%zu pixels", width,
                             height);
        }
    }
    return true;
}

bool stage_begin(struct stage *stage, struct run *run, const struct scene *scene, size_t width,
                 size_t height, struct error *error) {
    const struct program *program = run->options.program;
    *stage = (struct stage){
        .program = program,
        .scene = *scene,
        .drawing = {.text = run->text,
                    .eye = scene->eye,
                    .center = scene->center,
                    .up = scene->up,
                    .light = scene->light,
                    .skip = !run->asked->no_skip,
                    .stats = run->asked->stats,
                    .probed = run->asked->probe.given,
                    .probe = run->asked->probe.value,
                    .number = scene->number},
        .pixel_count = width * height,
    };
    set_values(&stage->drawing, scene, run);
    if (!load_needs(run, scene, &stage->drawing, error) || !allocate(stage, width, height, error)) {
        return false;
    }
    stage->prepared = true;
    return program->prepare == NULL || program->prepare(&stage->drawing, width, height, error);
}

bool stage_draw(struct stage *stage, struct image *image, size_t frame, struct error *error) {
    struct drawing *drawing = &stage->drawing;
    if (drawing->depth != NULL) {
        depth_clear(drawing->depth, stage->pixel_count);
    }
    drawing->frame = frame;
    return stage->scene.draw(drawing, image, error);
}

void stage_end(struct stage *stage) {
    if (stage->prepared && stage->program->finish != NULL) {
        stage->program->finish(&stage->drawing);
    }
    free(stage->drawing.depth);
    free(stage->drawing.state);
    *stage = (struct stage){0};
}

void run_free(struct run *run) {
    free_models(run);
    parts_free(&run->parts);
    texture_free(&run->white);
    texture_free(&run->shiny);
    *run = (struct run){0};
}
