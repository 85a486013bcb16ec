/* OFF files of any bytes: the same promises as for OBJ files; see fuzz_obj.c. */
#include "files/off.h"
#include "fuzz.h"
#include "model_properties.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (off_recognize(data, size)) { /* otherwise the file would be read as OBJ */
        require_model(data, size);
        require_lines(data, size, off_decode);
    }
    return 0;
}
