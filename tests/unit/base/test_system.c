/*
 * When the system says no: every system call of common/base/file.c fails in turn, the first, the
 * second and so on, one in each run. Each time there must be a message that names the file, the old
 * file must still be whole, and no temporary file may be left behind. Interrupted and partial reads
 * and writes, which are no errors, must not be noticed.
 *
 * This program is linked with -Wl,--wrap=open and the like, so that the calls of the course's code
 * come to the functions __wrap_... below (GNU ld manual, option --wrap).
 */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "base/bytes.h"
#include "base/error.h"
#include "unit/place.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>

/* ---- System calls that fail ---- */

int __real_open(const char *path, int flags, ...);
int __real_close(int file);
int __real_fstat(int file, struct stat *status);
int __real_stat(const char *path, struct stat *status);
int __real_rename(const char *from, const char *to);
ssize_t __real_read(int file, void *data, size_t size);
ssize_t __real_write(int file, const void *data, size_t size);
int __wrap_open(const char *path, int flags, ...);
int __wrap_close(int file);
int __wrap_fstat(int file, struct stat *status);
int __wrap_stat(const char *path, struct stat *status);
int __wrap_rename(const char *from, const char *to);
ssize_t __wrap_read(int file, void *data, size_t size);
ssize_t __wrap_write(int file, const void *data, size_t size);

enum { NEVER = -1 };

static struct system_calls {
    bool on;
    long calls;        /* made since it was switched on */
    long failing;      /* the call that fails, from 0, or NEVER */
    int reason;        /* its errno */
    bool failed;       /* it came to that */
    bool interrupt;    /* every second read and write is interrupted, and the others are short */
    bool full;         /* write() takes no byte and gives no error */
    bool grows;        /* a file claims to have 1 GiB, and has one byte more */
    size_t grown;      /* of them, read so far; there is nothing in them */
    long taken;        /* so many names of temporary files exist already */
    size_t interrupts; /* so far */
} system_calls;

static bool fails(void) {
    if (!system_calls.on || system_calls.calls++ != system_calls.failing) {
        return false;
    }
    system_calls.failed = true;
    errno = system_calls.reason;
    return true;
}

static bool interrupted(void) {
    if (!system_calls.on || !system_calls.interrupt || system_calls.interrupts++ % 2 != 0) {
        return false;
    }
    errno = EINTR;
    return true;
}

/* How much of `size` bytes is read or written at once. */
static size_t part_of(size_t size) {
    return system_calls.on && system_calls.interrupt && size > 3 ? 3 : size;
}

int __wrap_open(const char *path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    unsigned mode = (flags & O_CREAT) != 0 ? va_arg(arguments, unsigned) : 0;
    va_end(arguments);
    if (system_calls.on && (flags & O_EXCL) != 0 && system_calls.taken-- > 0) {
        errno = EEXIST;
        return -1;
    }
    return fails() ? -1 : __real_open(path, flags, mode);
}

int __wrap_close(int file) {
    int result = __real_close(file); /* a close that fails closes all the same */
    return fails() ? -1 : result;
}

int __wrap_fstat(int file, struct stat *status) {
    if (fails() || __real_fstat(file, status) != 0) {
        return -1;
    }
    status->st_size = system_calls.on && system_calls.grows ? 1 << 30 : status->st_size;
    return 0;
}

int __wrap_stat(const char *path, struct stat *status) {
    return fails() ? -1 : __real_stat(path, status);
}

/* The devices of the system stay, whatever a wrong program under test would put in their places. */
int __wrap_rename(const char *from, const char *to) {
    return fails() || strncmp(to, "/dev/", 5) == 0 ? -1 : __real_rename(from, to);
}

ssize_t __wrap_read(int file, void *data, size_t size) {
    if (fails() || interrupted()) {
        return -1;
    }
    if (!system_calls.on || !system_calls.grows) {
        return __real_read(file, data, part_of(size));
    }
    size_t left = ((size_t)1 << 30) + 1 - system_calls.grown, got = size < left ? size : left;
    system_calls.grown += got;
    return (ssize_t)got;
}

ssize_t __wrap_write(int file, const void *data, size_t size) {
    if (fails() || interrupted()) {
        return -1;
    }
    return system_calls.on && system_calls.full ? 0 : __real_write(file, data, part_of(size));
}

/* ---- A directory with an old file in it ---- */

static const char old_text[] = "the old text of the file";
static const char new_text[] = "and another one";

static struct place place_with_old(void) {
    struct place place = place_create();
    CHECK(put_text(name_file(&place, "old"), old_text));
    return place;
}

/* ---- Tests ---- */

enum task { READ_OLD, WRITE_FRESH, WRITE_OLD, WRITE_DEVICE, TASKS };

/* The path stays in the place. */
static const char *task_path(enum task task, struct place *place) {
    return task == WRITE_DEVICE ? "/dev/null"
                                : name_file(place, task == WRITE_FRESH ? "fresh" : "old");
}

static bool run_task(enum task task, struct place *place, struct error *error) {
    const char *path = task_path(task, place);
    if (task != READ_OLD) {
        return file_write(path, new_text, strlen(new_text), error);
    }
    struct bytes bytes;
    bool done = file_read(path, &bytes, error);
    CHECK(done ? bytes.size == strlen(old_text) : bytes.data == NULL);
    CHECK(!done || memcmp(bytes.data, old_text, bytes.size) == 0);
    bytes_free(&bytes);
    return done;
}

/* Is the directory as it should be? Brings it back to its first state. */
static void check_place(enum task task, struct place *place, bool done) {
    CHECK(file_is(name_file(place, "old"), done && task == WRITE_OLD ? new_text : old_text));
    CHECK(put_text(place->path, old_text));
    if (done && task == WRITE_FRESH) {
        CHECK(file_is(name_file(place, "fresh"), new_text) && unlink(place->path) == 0);
    }
    CHECK(place_count(place) == 1); /* nothing half-written */
}

/* Does the message say where and why? */
static bool tells(const struct error *error, const char *path, int reason) {
    size_t length = strlen(path);
    return strncmp(error->message, path, length) == 0 && error->message[length] == ':' &&
           strstr(error->message, strerror(reason)) != NULL;
}

/* The number that the next file to be opened gets: it grows when one stays open. */
static int next_file(void) {
    int file = open("/dev/null", O_RDONLY);
    close(file);
    return file;
}

/* Run a task with system calls that fail as the fields say, and look at the directory. */
static bool attempt(enum task task, struct place *place, struct system_calls fields,
                    struct error *error) {
    int next = next_file();
    *error = (struct error){0};
    system_calls = fields;
    system_calls.on = true;
    bool done = run_task(task, place, error);
    system_calls.on = false;
    CHECK(next_file() == next);
    check_place(task, place, done);
    return done;
}

static void test_each_call_fails(void) {
    struct place place = place_with_old();
    struct error error;
    for (enum task task = READ_OLD; task < TASKS; task++) {
        long n = 0;
        do {
            bool done =
                attempt(task, &place, (struct system_calls){.failing = n, .reason = EIO}, &error);
            /* What was read before a close that fails has been read. */
            CHECK(done ? !system_calls.failed || task == READ_OLD
                       : tells(&error, task_path(task, &place), EIO));
            n++;
        } while (system_calls.failed);
        CHECK(n > 3);
    }
    place_remove(&place, "old");
}

/* Interrupted calls, and a disk that takes nothing, which is full. */
static void test_interrupted_and_full(void) {
    struct place place = place_with_old();
    struct error error;
    for (enum task task = READ_OLD; task < TASKS; task++) {
        struct system_calls interrupt = {.failing = NEVER, .interrupt = true};
        CHECK(attempt(task, &place, interrupt, &error) && system_calls.interrupts > 4);
        struct system_calls full = {.failing = NEVER, .full = true};
        CHECK(attempt(task, &place, full, &error) == (task == READ_OLD));
        CHECK(task == READ_OLD || tells(&error, task_path(task, &place), ENOSPC));
    }
    place_remove(&place, "old");
}

/* Names of temporary files that are taken are passed over; when all are, that is an error. */
static void test_taken_names(void) {
    struct place place = place_with_old();
    struct error error;
    CHECK(
        attempt(WRITE_FRESH, &place, (struct system_calls){.failing = NEVER, .taken = 3}, &error));
    CHECK(!attempt(WRITE_FRESH, &place, (struct system_calls){.failing = NEVER, .taken = 999999999},
                   &error));
    CHECK(tells(&error, name_file(&place, "fresh"), EEXIST));
    place_remove(&place, "old");
}

/* A name without a directory, and one below /dev that means a regular file: that is written
 * as it is, not replaced, since whoever opened it looks there. */
static void test_seldom_names(void) {
    struct place place = place_with_old();
    struct error error;
    char name[32];
    int here = open(".", O_RDONLY);
    CHECK(here >= 0);
    CHECK(chdir(place.directory) == 0);
    CHECK(file_write("fresh", new_text, strlen(new_text), &error));
    CHECK(fchdir(here) == 0);
    close(here);
    check_place(WRITE_FRESH, &place, true);
    int file = open(name_file(&place, "old"), O_RDWR);
    struct stat before, after;
    snprintf(name, sizeof name, "/dev/fd/%d", file);
    if (access(name, W_OK) == 0) { /* not every system has them */
        CHECK(fstat(file, &before) == 0);
        CHECK(file_write(name, new_text, strlen(new_text), &error));
        CHECK(fstat(file, &after) == 0 && after.st_ino == before.st_ino);
        CHECK(after.st_size == (off_t)strlen(new_text));
        check_place(WRITE_OLD, &place, true);
    }
    close(file);
    place_remove(&place, "old");
}

/* A file that grows past the limit while it is read. */
static void test_growing_file(void) {
    struct place place = place_with_old();
    struct bytes bytes;
    struct error error = {0};
    system_calls = (struct system_calls){.on = true, .failing = NEVER, .grows = true};
    bool done = file_read(name_file(&place, "old"), &bytes, &error);
    system_calls.on = false;
    CHECK(!done && bytes.data == NULL && strstr(error.message, ": is larger than 1 GiB") != NULL);
    CHECK(system_calls.grown == ((size_t)1 << 30) + 1);
    place_remove(&place, "old");
}

UNIT_MAIN(TEST(test_taken_names), TEST(test_seldom_names), TEST(test_each_call_fails),
          TEST(test_interrupted_and_full), TEST(test_growing_file))
