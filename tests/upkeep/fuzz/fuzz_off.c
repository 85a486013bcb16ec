/* OFF files of any bytes: the same promises as for OBJ files; see fuzz_obj.c. */
#include "fuzz.h"
#include "model_properties.h"

/* Does OFF stand near the beginning? Without it the file would be read as OBJ. */
static bool may_be_off(const uint8_t *data, size_t size) {
    for (size_t i = 0; i + 3 <= size && i < 32; i++) {
        if (memcmp(data + i, "OFF", 3) == 0) {
            return true;
        }
    }
    return false;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (may_be_off(data, size)) {
        require_model(data, size);
    }
    return 0;
}
