/*
 * Tries given files on a fuzz target, without libFuzzer, so that every compiler can:
 *
 *     fuzz_NAME FILE...
 *
 * Names each file before it is tried: a target stops the program at the first one of which a
 * promise does not hold, and the last name is then that file's.
 */
#include "base/bytes.h"
#include "base/error.h"
#include "base/file.h"

#include <stdint.h>
#include <stdio.h>

/* A target's two functions: see fuzz.h. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(const int *argc, char ***argv);

static bool try_file(const char *path) {
    struct bytes file = {0};
    struct error error;
    fprintf(stderr, "%s\n", path);
    if (!file_read(path, &file, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    LLVMFuzzerTestOneInput(file.data, file.size);
    bytes_free(&file);
    return true;
}

int main(int argc, char **argv) {
    bool done = argc > 1;
    LLVMFuzzerInitialize(&argc, &argv);
    for (int i = 1; i < argc; i++) {
        done = try_file(argv[i]) && done;
    }
    return done ? 0 : 1;
}
