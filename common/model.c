/* Models: see model.h. */
#include "model.h"

#include <stdlib.h>

void model_warn(struct model *model, enum model_warning warning, size_t line, const char *name) {
    if (model->warning_line[warning] == 0) {
        model->warning_line[warning] = line;
        model->warning_name[warning] = name;
    }
}

void model_free(struct model *model) {
    for (int i = 0; i < MODEL_TEXTURE_KINDS; i++) {
        texture_free(&model->textures[i]);
    }
    free(model->positions);
    free(model->uvs);
    free(model->normals);
    free(model->colors);
    free(model->face_colors);
    free(model->faces);
    free(model->lines);
    for (size_t i = 0; i < model->material_count; i++) {
        free(model->materials[i].name);
        free(model->materials[i].texture);
        free(model->materials[i].shine);
        free(model->materials[i].bumps);
    }
    free(model->materials);
    free(model->face_materials);
    free(model->face_groups);
    for (size_t i = 0; i < model->library_count; i++) {
        free(model->libraries[i].name);
    }
    free(model->libraries);
    free(model->path);
    *model = (struct model){0};
}
