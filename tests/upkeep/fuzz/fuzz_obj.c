/*
 * OBJ files of any bytes: what can be read is a valid model, can be given normals of length 1 and
 * drawn; what cannot leaves an empty model and a message. The quick way to read gives the same as
 * the careful one.
 */
#include "files/obj.h"
#include "fuzz.h"
#include "model_properties.h"

#include "unit/same_model.h"

#include <string.h>

/* The quick way gives the model of the careful one, or leaves the file to it. */
static void require_one_answer(const uint8_t *data, size_t size, unsigned parts) {
    struct model quick = {0}, careful = {0};
    struct error error_of_quick = {0}, error_of_careful = {0};
    bool done = obj_decode(&quick, data, size, parts, &error_of_quick);
    REQUIRE(obj_decode_carefully(&careful, data, size, parts, &error_of_careful) == done);
    REQUIRE(strcmp(error_of_quick.message, error_of_careful.message) == 0);
    REQUIRE(error_of_quick.line == error_of_careful.line);
    REQUIRE(!done || same_model(&quick, &careful));
    model_free(&quick);
    model_free(&careful);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    require_model(data, size);
    for (unsigned parts = 0; parts <= MODEL_ALL_PARTS; parts++) {
        require_one_answer(data, size, parts);
    }
    return 0;
}
