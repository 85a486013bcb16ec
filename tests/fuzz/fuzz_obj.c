/*
 * OBJ files of any bytes: what can be read is a valid model, can be given normals of length 1 and
 * drawn; what cannot leaves an empty model and a message.
 */
#include "fuzz.h"
#include "model_properties.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    require_model(data, size);
    return 0;
}
