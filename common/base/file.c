/* Whole files in and out; see file.h. Of POSIX, only what platform.h has on Windows and what
 * WebAssembly (WASI) has: no getpid(), no realpath(), and no access(), which allows everything. */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"

#include "base/platform.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if !defined(_WIN32) && !defined(__wasi__) /* else capitals count for nothing, or there is none */
#define LISTS_DIRECTORIES
#include <dirent.h>
#endif

#ifdef _WIN32
#define O_CLOEXEC               (_O_NOINHERIT | _O_BINARY)
#define open(path, ...)         windows_open(path, __VA_ARGS__)
#define read(file, data, size)  windows_read(file, data, size)
#define write(file, data, size) windows_write(file, data, size)
#define stat(path, status)      windows_stat(path, status)
#define lstat(path, status)     windows_stat(path, status)
#define rename(from, to)        windows_rename(from, to)
#define unlink(path)            windows_unlink(path)
#define mkdir(path, mode)       windows_mkdir(path)
#endif
#if defined(_WIN32) || defined(__wasi__) /* a file has no permissions to keep */
#define fchmod(file, mode) ((void)(file), (void)(mode))
#endif

enum {
    FILE_SIZE_LIMIT = 1 << 30, /* bytes of the largest file that is read: 1 GiB */
    OPENED_PATH_LIMIT = 4096,  /* no system opens what has a longer path */
    TEMPORARY_NAME_TRIES = 1000
};

static bool is_standard_input(const char *path) {
    return strcmp(path, "-") == 0;
}

bool error_name_input(struct error *error, const char *path) {
    return error_name_file(error, is_standard_input(path) ? "standard input" : path);
}

/* What the system says, from errno. */
static bool error_from_system(struct error *error) {
    return error_set(error, "%s", strerror(errno));
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
static bool read_to_end(int file, struct bytes *bytes, struct error *error) {
    enum { MORE = 16384 };
    for (;;) {
        if (bytes->size == bytes->capacity && !bytes_reserve(bytes, MORE)) {
            return error_out_of_memory(error);
        }
        ssize_t got = read_some(file, bytes->data + bytes->size, bytes->capacity - bytes->size);
        if (got < 0) {
            return error_from_system(error);
        }
        if (got == 0) {
            return true;
        }
        bytes->size += (size_t)got;
        if (bytes->size > FILE_SIZE_LIMIT) {
            return error_set(error, "is larger than 1 GiB");
        }
    }
}

static bool read_open_file(int file, struct bytes *bytes, struct error *error) {
    struct stat status;
    if (fstat(file, &status) != 0) {
        return error_from_system(error);
    }
    if (S_ISDIR(status.st_mode)) {
        return error_set(error, "is a directory");
    }
    if (S_ISREG(status.st_mode) && status.st_size > 0) {
        if (status.st_size > FILE_SIZE_LIMIT) {
            return error_set(error, "is larger than 1 GiB");
        }
        if (!bytes_reserve(bytes, (size_t)status.st_size + 1)) { /* and one to see the end */
            return error_out_of_memory(error);
        }
    }
    return read_to_end(file, bytes, error);
}

bool file_read(const char *path, struct bytes *bytes, struct error *error) {
    *bytes = (struct bytes){0};
    bool standard_input = is_standard_input(path);
    int file = standard_input ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    bool done = file >= 0 ? read_open_file(file, bytes, error) : error_from_system(error);
    if (file >= 0 && !standard_input) {
        close(file);
    }
    if (!done) {
        bytes_free(bytes);
        error_name_input(error, path);
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
 * the file is closed. The signal of a file that grows too large would end the program before. */
static bool write_and_close(int file, const void *data, size_t size) {
#ifdef SIGXFSZ
    struct sigaction ignored = {.sa_handler = SIG_IGN}, before;
    sigaction(SIGXFSZ, &ignored, &before);
#endif
    bool written = write_all(file, data, size);
    int reason = errno;
#ifdef SIGXFSZ
    sigaction(SIGXFSZ, &before, NULL);
#endif
    bool closed = close(file) == 0;
    if (!written) {
        errno = reason;
    }
    return written && closed;
}

/* A device, a pipe or a symbolic link, which stays: there is nothing to rename over. */
static bool write_directly(const char *path, const void *data, size_t size, struct error *error) {
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0 || !write_and_close(file, data, size)) {
        return error_from_system(error);
    }
    return true;
}

/* How much of `path` names the directory: up to the last slash, or nothing. */
static int directory_length(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash == NULL ? 0 : (int)(slash - path + 1);
}

/* Create a new file in the directory of `path`. Its name goes to `name`, an allocated string of at
 * least `name_size` bytes. O_EXCL sees that no two programs get the same name. Returns the open
 * file, or -1 with the reason in errno. */
static int create_temporary(const char *path, char *name, size_t name_size) {
    for (int i = 0; i < TEMPORARY_NAME_TRIES; i++) {
        snprintf(name, name_size, "%.*s.part-%d", directory_length(path), path, i);
        int file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) {
            return file;
        }
    }
    return -1;
}

/* Write a new file next to `path` and rename it. `mode` holds the permissions of the file that is
 * replaced, or -1. */
static bool write_and_rename(const char *path, long mode, const void *data, size_t size,
                             struct error *error) {
    size_t name_size = strlen(path) + 64;
    char *name = malloc(name_size);
    if (name == NULL) {
        return error_out_of_memory(error);
    }
    bool done = false;
    int file = create_temporary(path, name, name_size);
    if (file < 0) {
        error_from_system(error);
        goto end;
    }
    if (mode >= 0) {
        (void)fchmod(file, (mode_t)mode); /* not every file system has permissions to keep */
    }
    if (!write_and_close(file, data, size) || rename(name, path) != 0) {
        error_from_system(error);
        unlink(name);
        goto end;
    }
    done = true;
end:
    free(name);
    return done;
}

/* Renaming would get round a write protection. Opening for writing changes nothing. */
static bool check_writable(const char *path, struct error *error) {
    int file = open(path, O_WRONLY | O_CLOEXEC);
    return (file >= 0 && close(file) == 0) || error_from_system(error);
}

/* As file_write(), but messages do not name the file. */
static bool write_whole(const char *path, const void *data, size_t size, struct error *error) {
    struct stat status;
    bool device_name = strncmp(path, "/dev/", 5) == 0; /* /dev/stdout may be a regular file */
    long mode = -1;
    if (lstat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode)) {
            return error_set(error, "is a directory");
        }
        if (!S_ISREG(status.st_mode) || device_name) {
            return write_directly(path, data, size, error);
        }
        mode = (long)(status.st_mode & 07777);
    } else if (errno != ENOENT || path[0] == '\0') {
        return error_from_system(error);
    }
    if (mode >= 0 && !check_writable(path, error)) {
        return false;
    }
    signal_set before; /* what would end the program waits, so that no part of a file is left */
    signals_hold(&before);
    bool done = write_and_rename(path, mode, data, size, error);
    signals_release(&before);
    return done;
}

bool file_write(const char *path, const void *data, size_t size, struct error *error) {
    return write_whole(path, data, size, error) || error_name_file(error, path);
}

bool file_write_encoded(const char *path, bool encoded, struct bytes *bytes, struct error *error) {
    bool done =
        encoded ? file_write(path, bytes->data, bytes->size, error) : error_name_file(error, path);
    bytes_free(bytes);
    return done;
}

/* ---- Directories ---- */

bool file_exists(const char *path) {
    struct stat status;
    return stat(path, &status) == 0;
}

#ifdef LISTS_DIRECTORIES
/* Count the files that fit the path in any letters, and copy one's path to `found`. What comes
 * before `at` is a directory in `tried`; the next one is taken as it is written, where that leads
 * to a file. */
static size_t count_fitting(const char *path, size_t at, char *tried, char *found) {
    const struct word name = {path + at, strcspn(path + at, "/")};
    const size_t end = at + name.length;
    const bool is_last = path[end] == '\0';
    size_t fitting = 0;
    memcpy(tried + at, name.start, name.length);
    tried[end] = '\0';
    if (!is_last && (end == 0 || file_exists(tried))) {
        tried[end] = '/';
        fitting = count_fitting(path, end + 1, tried, found);
    }
    if (fitting > 0) {
        return fitting;
    }
    tried[at] = '\0';
    DIR *list = opendir(at == 0 ? "." : tried);
    for (const struct dirent *entry; list != NULL && (entry = readdir(list)) != NULL;) {
        if (word_matches(name, entry->d_name) && (is_last || !word_is(name, entry->d_name))) {
            memcpy(tried + at, entry->d_name, name.length);
            tried[end] = path[end];
            fitting += is_last ? 1 : count_fitting(path, end + 1, tried, found);
            if (is_last) {
                memcpy(found, tried, end + 1);
            }
        }
    }
    if (list != NULL) {
        closedir(list);
    }
    return fitting;
}
#endif

bool file_find(char *path) {
    bool is_found = file_exists(path);
#ifdef LISTS_DIRECTORIES
    char tried[OPENED_PATH_LIMIT], found[OPENED_PATH_LIMIT];
    if (!is_found && strlen(path) < OPENED_PATH_LIMIT &&
        count_fitting(path, 0, tried, found) == 1) {
        memcpy(path, found, strlen(found));
        is_found = true;
    }
#endif
    return is_found;
}

uint64_t file_size(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 ? (uint64_t)status.st_size : 0;
}

/* Why no directory is there: a link may lead to nothing, or to itself. 0 where one is. */
static int directory_fault(const char *path) {
    struct stat status;
    return stat(path, &status) != 0 ? errno : S_ISDIR(status.st_mode) ? 0 : ENOTDIR;
}

bool directory_create(const char *path, struct error *error) {
    char *partial = string_format("%s", path);
    if (partial == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 1; i <= strlen(path); i++) {
        if (path[i] != '/' && path[i] != '\0') {
            continue;
        }
        partial[i] = '\0';
        int reason = mkdir(partial, 0777) == 0 ? 0 : errno;
        int fault = reason == 0 ? 0 : directory_fault(partial);
        if (fault != 0) {
            error_set(error, "cannot make the directory: %s",
                      strerror(reason == EEXIST ? fault : reason));
            error_name_file(error, partial);
            free(partial);
            return false;
        }
        partial[i] = path[i];
    }
    free(partial);
    return true;
}
