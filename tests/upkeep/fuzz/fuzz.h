/*
 * What the fuzz targets share. A target gets a file of any bytes from libFuzzer, reads it, and
 * holds what comes out against the promises of the header that it tests: not only "does not
 * crash".
 *
 *     REQUIRE(condition)     stops with the place and the condition when it does not hold
 *     memory_begin/most()    the most bytes that were allocated at one time in between
 *
 * Built by clang with -fsanitize=fuzzer,address,undefined (`make fuzz`), and by any compiler with
 * replay.c and -fsanitize=address,undefined (`make test`).
 */
#ifndef TESTS_UPKEEP_FUZZ_FUZZ_H
#define TESTS_UPKEEP_FUZZ_FUZZ_H

#include "base/error.h"
#include "base/file.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The entry points that libFuzzer looks for. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerInitialize(const int *argc, char ***argv);

#define REQUIRE(condition)                                                                         \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);         \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/* ---- Errors ---- */

/* A message that a test would notice if nobody wrote it. */
static inline struct error no_error(void) {
    return (struct error){0};
}

/* One line, not empty, without control characters. */
static inline void require_message(const struct error *error) {
    size_t length = strlen(error->message);
    REQUIRE(length > 0 && length < sizeof error->message);
    for (size_t i = 0; i < length; i++) {
        unsigned char byte = (unsigned char)error->message[i];
        REQUIRE(byte >= 32 && byte != 127);
    }
}

/* ---- Memory ---- */

/* Of the address sanitizer; gcc has these functions, but no header for them. */
size_t __sanitizer_get_allocated_size(const volatile void *block);
int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void *, size_t),
                                              void (*free_hook)(const volatile void *));

static size_t memory_now, memory_peak;

static void count_allocation(const volatile void *block, size_t size) {
    if (block != NULL) {
        memory_now += size;
        memory_peak = memory_now > memory_peak ? memory_now : memory_peak;
    }
}

static void count_release(const volatile void *block) {
    size_t size = block != NULL ? __sanitizer_get_allocated_size(block) : 0;
    memory_now = memory_now > size ? memory_now - size : 0;
}

/* Called once by libFuzzer before the first input. */
int LLVMFuzzerInitialize(const int *argc, char ***argv) {
    (void)argc;
    (void)argv;
    REQUIRE(__sanitizer_install_malloc_and_free_hooks(count_allocation, count_release) != 0);
    return 0;
}

static inline void memory_begin(void) {
    memory_now = memory_peak = 0;
}

/* The most bytes in use at one time since memory_begin(). */
static inline size_t memory_most(void) {
    return memory_peak;
}

/* No reader may take more memory than the file's size justifies. */
static inline void require_memory(size_t file_size, size_t times) {
    enum { ALLOWANCE = (16 + 32) * 1024 }; /* for the smallest files, and what opendir() takes */
    if (memory_most() > file_size * times + ALLOWANCE) {
        fprintf(stderr, "%zu bytes allocated for a file of %zu\n", memory_most(), file_size);
    }
    REQUIRE(memory_most() <= file_size * times + ALLOWANCE);
}

#endif
