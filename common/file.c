/* Whole files in and out; see file.h. POSIX calls: open, fstat, read, write, rename. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with realpath() */

#include "file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    FILE_SIZE_LIMIT = 1 << 30, /* bytes of the largest file that is read: 1 GiB */
    SHOWN_PATH_LIMIT = 512,    /* a longer path is shown without its beginning */
    TEMPORARY_NAME_TRIES = 1000
};

/* ---- Messages ---- */

/* A file name may hold any byte; a message stays one line whatever it quotes. */
static void hide_control_characters(char *text) {
    for (char *c = text; *c != '\0'; c++) {
        unsigned char byte = (unsigned char)*c;
        if (byte < 32 || byte == 127) {
            *c = '?';
        }
    }
}

bool error_set(struct error *error, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    if (vsnprintf(error->message, sizeof error->message, format, arguments) < 0) {
        error->message[0] = '\0';
    }
    va_end(arguments);
    hide_control_characters(error->message);
    return false;
}

bool error_out_of_memory(struct error *error) {
    return error_set(error, "out of memory");
}

bool error_name_file(struct error *error, const char *path) {
    struct error plain = *error;
    size_t length = strlen(path);
    bool cut = length > SHOWN_PATH_LIMIT;
    return error_set(error, "%s%s: %s", cut ? "..." : "",
                     cut ? path + length - SHOWN_PATH_LIMIT : path, plain.message);
}

/* "PATH: what the system says", from errno. */
static bool error_from_system(struct error *error, const char *path) {
    error_set(error, "%s", strerror(errno));
    return error_name_file(error, path);
}

static bool error_in_file(struct error *error, const char *path, const char *what) {
    error_set(error, "%s", what);
    return error_name_file(error, path);
}

/* ---- Blocks of bytes ---- */

bool bytes_reserve(struct bytes *bytes, size_t size) {
    if (size <= bytes->capacity - bytes->size) {
        return true;
    }
    if (size > SIZE_MAX - bytes->size) {
        return false;
    }
    size_t capacity = bytes->size + size;
    /* Growing by at least half keeps the total cost of many small appends linear. */
    size_t grown = bytes->capacity + bytes->capacity / 2;
    if (grown > capacity) {
        capacity = grown;
    }
    unsigned char *data = realloc(bytes->data, capacity);
    if (data == NULL) {
        return false;
    }
    bytes->data = data;
    bytes->capacity = capacity;
    return true;
}

bool bytes_append(struct bytes *bytes, const void *data, size_t size) {
    if (size == 0) {
        return true;
    }
    if (!bytes_reserve(bytes, size)) {
        return false;
    }
    memcpy(bytes->data + bytes->size, data, size);
    bytes->size += size;
    return true;
}

void bytes_free(struct bytes *bytes) {
    free(bytes->data);
    *bytes = (struct bytes){0};
}

/* ---- Reading ---- */

/* As read(), but tried again when a signal interrupts it. */
static ssize_t read_some(int file, void *data, size_t size) {
    ssize_t got;
    do {
        got = read(file, data, size);
    } while (got < 0 && errno == EINTR);
    return got;
}

/* Read up to the end of an open file, whose size is not known or may have changed. */
static bool read_to_end(int file, const char *name, struct bytes *bytes, struct error *error) {
    for (;;) {
        /* The block may be just as large as the file, so the end is looked for in a small buffer.
         */
        unsigned char more[16384];
        bool full = bytes->size == bytes->capacity;
        size_t room = full ? sizeof more : bytes->capacity - bytes->size;
        ssize_t got = read_some(file, full ? more : bytes->data + bytes->size, room);
        if (got < 0) {
            return error_from_system(error, name);
        }
        if (got == 0) {
            return true;
        }
        if ((size_t)got > FILE_SIZE_LIMIT - bytes->size) {
            return error_in_file(error, name, "is larger than 1 GiB");
        }
        if (!full) {
            bytes->size += (size_t)got;
        } else if (!bytes_append(bytes, more, (size_t)got)) {
            return error_in_file(error, name, "not enough memory to read the file");
        }
    }
}

static bool read_open_file(int file, const char *name, struct bytes *bytes, struct error *error) {
    struct stat status;
    if (fstat(file, &status) != 0) {
        return error_from_system(error, name);
    }
    if (S_ISDIR(status.st_mode)) {
        return error_in_file(error, name, "is a directory");
    }
    if (S_ISREG(status.st_mode) && status.st_size > 0) {
        if (status.st_size > FILE_SIZE_LIMIT) {
            return error_in_file(error, name, "is larger than 1 GiB");
        }
        if (!bytes_reserve(bytes, (size_t)status.st_size)) {
            return error_in_file(error, name, "not enough memory to read the file");
        }
    }
    return read_to_end(file, name, bytes, error);
}

bool file_read(const char *path, struct bytes *bytes, struct error *error) {
    *bytes = (struct bytes){0};
    bool standard_input = strcmp(path, "-") == 0;
    const char *name = standard_input ? "standard input" : path;
    int file = standard_input ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return error_from_system(error, name);
    }
    bool done = read_open_file(file, name, bytes, error);
    if (!done) {
        bytes_free(bytes);
    }
    if (!standard_input) {
        close(file);
    }
    return done;
}

/* ---- Writing ---- */

/* Write everything; false with the reason in errno. */
static bool write_all(int file, const void *data, size_t size) {
    const unsigned char *next = data;
    while (size > 0) {
        ssize_t put = write(file, next, size);
        if (put < 0 && errno == EINTR) {
            continue;
        }
        if (put <= 0) {
            errno = put == 0 ? ENOSPC : errno;
            return false;
        }
        next += put;
        size -= (size_t)put;
    }
    return true;
}

/* Write and close; false with the reason in errno. Some file systems tell of a full disk only when
 * the file is closed. */
static bool write_and_close(int file, const void *data, size_t size) {
    bool written = write_all(file, data, size);
    int reason = errno;
    bool closed = close(file) == 0;
    if (!written) {
        errno = reason;
    }
    return written && closed;
}

/* A device or a pipe: there is nothing to rename over. */
static bool write_directly(const char *path, const void *data, size_t size, struct error *error) {
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0 || !write_and_close(file, data, size)) {
        return error_from_system(error, path);
    }
    return true;
}

/* Create a new file in the directory of `path`. Its name goes to `name`, an allocated string of at
 * least `name_size` bytes. Returns the open file, or -1 with the reason in errno. */
static int create_temporary(const char *path, char *name, size_t name_size) {
    const char *slash = strrchr(path, '/');
    int directory_length = slash == NULL ? 0 : (int)(slash - path + 1);
    for (int i = 0; i < TEMPORARY_NAME_TRIES; i++) {
        snprintf(name, name_size, "%.*s.part-%ld-%d", directory_length, path, (long)getpid(), i);
        int file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) {
            return file;
        }
    }
    return -1;
}

/* Write a new file beside `path` and rename it. `mode` holds the permissions of the file that is
 * replaced, or -1. */
static bool write_and_rename(const char *path, long mode, const void *data, size_t size,
                             struct error *error) {
    size_t name_size = strlen(path) + 64;
    char *name = malloc(name_size);
    if (name == NULL) {
        return error_in_file(error, path, "not enough memory to write the file");
    }
    int file = create_temporary(path, name, name_size);
    if (file < 0) {
        error_from_system(error, path);
        goto fail;
    }
    if (mode >= 0) {
        (void)fchmod(file, (mode_t)mode); /* not every file system has permissions to keep */
    }
    if (!write_and_close(file, data, size) || rename(name, path) != 0) {
        error_from_system(error, path);
        unlink(name);
        goto fail;
    }
    free(name);
    return true;
fail:
    free(name);
    return false;
}

bool file_write(const char *path, const void *data, size_t size, struct error *error) {
    struct stat status;
    bool device_name = strncmp(path, "/dev/", 5) == 0; /* /dev/stdout may be a regular file */
    if (stat(path, &status) != 0) {
        if (errno != ENOENT || path[0] == '\0') {
            return error_from_system(error, path);
        }
        return write_and_rename(path, -1, data, size, error);
    }
    if (S_ISDIR(status.st_mode)) {
        return error_in_file(error, path, "is a directory");
    }
    if (!S_ISREG(status.st_mode) || device_name) {
        return write_directly(path, data, size, error);
    }
    if (access(path, W_OK) != 0) { /* renaming would get round a write protection */
        return error_from_system(error, path);
    }
    char *target = realpath(path, NULL); /* a symbolic link stays, the file behind it is replaced */
    if (target == NULL) {
        return error_from_system(error, path);
    }
    bool done = write_and_rename(target, (long)(status.st_mode & 07777), data, size, error);
    free(target);
    return done;
}
