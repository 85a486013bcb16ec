/* The lock of `make check`: see lock.h. */
#define _POSIX_C_SOURCE 200809L
#include "lock.h"

#include "base/file.h"
#include "check/drawn.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

bool lock_programs(const char *programs, struct error *error) {
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    char path[DRAWN_PATH_LIMIT];
    if (!directory_create(programs, error)) {
        return false;
    }
    snprintf(path, sizeof path, "%s/check.lock", programs);
    int file = open(path, O_RDWR | O_CREAT, 0666); /* to be closed is to lose the lock */
    if (file < 0) {
        return error_set(error, "%.900s: %s", path, strerror(errno));
    }
    bool busy = fcntl(file, F_SETLK, &whole) != 0 && (errno == EAGAIN || errno == EACCES);
    if (busy) {
        fprintf(stderr, "check: waiting for another check in %s\n", programs);
        while (fcntl(file, F_SETLKW, &whole) != 0 && errno == EINTR) {
        }
    }
    return true; /* also where the file system knows no locks */
}
