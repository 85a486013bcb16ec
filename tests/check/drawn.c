#define _POSIX_C_SOURCE 200809L

#include "drawn.h"
#include "base/file.h"
#include "base/platform.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef _WIN32
#define lstat(path, status) windows_stat(path, status)
#endif

enum {
    TGA_HEADER_SIZE = 18,
    HUGE_PIXELS = 1 << 24, /* a picture of the wrong size is not read from this size on */
    STATS_SIZE = 1 << 18,  /* counters come last, behind whatever a student prints */
    MESSAGE_WIDTH = 200
};

bool drawn_program(struct drawn_path *path, const char *programs, const char *name,
                   struct error *error) {
    char here[DRAWN_PATH_LIMIT];
    if (getcwd(here, sizeof here) == NULL) {
        return error_set(error, "the current directory has no name: %s", strerror(errno));
    }
    bool is_absolute = platform_is_absolute(programs);
    int length = snprintf(path->text, sizeof path->text, "%s%s%s/%s", is_absolute ? "" : here,
                          is_absolute ? "" : "/", programs, name);
    return (length >= 0 && (size_t)length < sizeof path->text) ||
           error_set(error, "%s: name too long", programs);
}

bool drawn_run(const char *programs, const char *step, const char *directory, const char *scene,
               const char *output, const struct run_limits *limits, struct run_result *result,
               struct error *error) {
    *result = (struct run_result){.end = RUN_EXITED};
    struct drawn_path path;
    if (!drawn_program(&path, programs, step, error)) {
        return false;
    }
    const char *arguments[7] = {path.text, "-o", directory};
    size_t count = 3;
    if (output != NULL) {
        arguments[count++] = "--stats";
    }
    arguments[count++] = "--only";
    arguments[count++] = scene[0] != '\0' ? scene : "all";
    struct run_command command = {.arguments = arguments,
                                  .directory = directory,
                                  .output = output,
                                  .output_bytes = STATS_SIZE,
                                  .contained = true,
                                  .limits = *limits};
    return run(&command, result, error);
}

/* Does a file that looks like a TGA claim another size than the wanted one? The claim is judged
 * before the pixels are read: a small file can claim 65535x65535. */
static bool claims_other_size(const struct bytes *file, const struct image *wanted, size_t *width,
                              size_t *height) {
    if (wanted == NULL || file->size < TGA_HEADER_SIZE) {
        return false;
    }
    unsigned type = file->data[2] & ~8u; /* 8 is run-length coding */
    *width = file->data[12] | (size_t)file->data[13] << 8;
    *height = file->data[14] | (size_t)file->data[15] << 8;
    return type >= 1 && type <= 3 && (*width != wanted->width || *height != wanted->height);
}

static enum drawn_state decode(struct image *image, const struct bytes *file,
                               const struct image *wanted, struct error *error) {
    size_t width = 0, height = 0;
    struct error reason;
    bool other_size = claims_other_size(file, wanted, &width, &height);
    if (!other_size || width * height < HUGE_PIXELS) {
        if (!tga_decode(image, file->data, file->size, &reason)) {
            error_set(error, "unreadable: %.900s", reason.message);
            return DRAWN_UNREADABLE;
        }
    }
    if (other_size) {
        error_set(error, "%zux%zu pixels instead of %zux%zu", width, height, wanted->width,
                  wanted->height);
        return DRAWN_WRONG_SIZE;
    }
    return DRAWN_READ;
}

enum drawn_state drawn_read(struct image *image, const char *directory, const char *scene,
                            const struct image *wanted, struct error *error) {
    *image = (struct image){.pixels = NULL};
    char path[DRAWN_PATH_LIMIT];
    struct stat status;
    if ((size_t)snprintf(path, sizeof path, "%s/%s.tga", directory, scene) >= sizeof path ||
        lstat(path, &status) != 0) {
        error_set(error, "missing (no %s.tga was written)", scene);
        return DRAWN_MISSING;
    }
    if (!S_ISREG(status.st_mode)) { /* a link or a pipe could lead anywhere, or nowhere */
        error_set(error, "unreadable: not a plain file");
        return DRAWN_UNREADABLE;
    }
    struct bytes file = {.data = NULL};
    struct error reason;
    if (!file_read(path, &file, &reason)) {
        error_set(error, "unreadable: %.900s", reason.message);
        return DRAWN_UNREADABLE;
    }
    enum drawn_state state = decode(image, &file, wanted, error);
    bytes_free(&file);
    return state;
}

struct message_line drawn_message(const char *text) {
    struct message_line line = {""};
    while (*text != '\0') {
        size_t length = strcspn(text, "\n"), letters = 0;
        for (size_t i = 0; i < length; i++) {
            letters += isalpha((unsigned char)text[i]) != 0;
        }
        if (letters > 0) {
            size_t kept = length < MESSAGE_WIDTH ? length : MESSAGE_WIDTH;
            memcpy(line.text, text, kept);
            line.text[kept] = '\0';
            text_make_printable(line.text, ' ');
            strcpy(line.text + kept, kept < length ? "..." : "");
            return line;
        }
        text += length + (text[length] == '\n');
    }
    return line;
}

const char *message_line_start(const char *text, const char *at) {
    while (at > text && at[-1] != '\n') {
        at--;
    }
    return at;
}
