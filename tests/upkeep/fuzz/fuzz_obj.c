/*
 * OBJ files of any bytes: what can be read is a valid model, can be given normals of length 1 and
 * drawn; what cannot leaves an empty model and a message. Without texture coordinates or normals
 * the same file gives the same positions and faces.
 */
#include "files/obj.h"
#include "fuzz.h"
#include "model_properties.h"

#include <string.h>

static void require_same_positions(const struct model *a, const struct model *b) {
    REQUIRE(a->position_count == b->position_count && a->face_count == b->face_count);
    REQUIRE(a->position_count == 0 ||
            memcmp(a->positions, b->positions, a->position_count * sizeof *a->positions) == 0);
    for (size_t i = 0; i < a->face_count; i++) {
        for (int k = 0; k < 3; k++) {
            REQUIRE(a->faces[i].corner[k].position == b->faces[i].corner[k].position);
        }
    }
}

static void require_parts(const uint8_t *data, size_t size) {
    struct model all = {0};
    struct error error = no_error();
    bool done = obj_decode(&all, data, size, MODEL_ALL_PARTS, &error);
    for (unsigned parts = 0; done && parts < (MODEL_UVS | MODEL_NORMALS); parts++) {
        struct model model = {0};
        REQUIRE(obj_decode(&model, data, size, parts, &error));
        require_same_positions(&model, &all);
        REQUIRE((parts & MODEL_UVS) != 0 ? model.uv_count == all.uv_count : model.uvs == NULL);
        REQUIRE((parts & MODEL_NORMALS) != 0 ? model.normal_count == all.normal_count
                                             : model.normals == NULL);
        model_free(&model);
    }
    model_free(&all);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    require_model(data, size);
    require_parts(data, size);
    require_lines(data, size, obj_decode);
    return 0;
}
