/*
 * Files of materials of any bytes, for a model with materials of some names: nothing is refused,
 * colours are 0..1, and memory stays within what the file's size allows. The file is what follows
 * the first zero byte; before that are the names, one a line.
 */
#include "files/model_file.h"
#include "files/mtl.h"
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>

enum { NAME_LIMIT = 8, MTL_GROWTH = 4 };

/* Materials of these names. */
static void make_materials(struct model *model, const uint8_t *names, size_t size) {
    model->materials = calloc(NAME_LIMIT, sizeof *model->materials);
    REQUIRE(model->materials != NULL);
    while (size > 0 && model->material_count < NAME_LIMIT) {
        const uint8_t *end = memchr(names, '\n', size);
        size_t length = end == NULL ? size : (size_t)(end - names);
        char *name = calloc(1, length + 1);
        REQUIRE(name != NULL);
        memcpy(name, names, length);
        model->materials[model->material_count++].name = name;
        size -= length + (end != NULL);
        names += length + (end != NULL);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct error error = no_error();
    struct model model = {0};
    const uint8_t *zero = size == 0 ? NULL : memchr(data, 0, size);
    if (zero == NULL) {
        return 0;
    }
    make_materials(&model, data, (size_t)(zero - data));
    const uint8_t *file = zero + 1;
    size_t file_size = size - (size_t)(file - data);
    memory_begin();
    REQUIRE(mtl_decode(&model, file, file_size, "no/such/directory/", &error));
    require_memory(file_size, MTL_GROWTH);
    for (size_t i = 0; i < model.material_count; i++) {
        const struct model_material *material = &model.materials[i];
        for (int k = 0; k < 3; k++) {
            REQUIRE(material->color[k] >= 0 && material->color[k] <= 1);
            REQUIRE(material->ambient[k] >= 0 && material->ambient[k] <= 1);
        }
        REQUIRE(material->texture == NULL ||
                strncmp(material->texture, "no/such/directory/", 18) == 0);
        REQUIRE(material->known || material->texture == NULL);
        REQUIRE(material->specular <= 1 && material->power >= 0 && material->power <= 1e4F);
    }
    model_free(&model);
    return 0;
}
