/* The lock of `make check`: two checks in one directory would remove each other's programs. */
#ifndef TESTS_HIDDEN_LOCK_H
#define TESTS_HIDDEN_LOCK_H

#include "base/error.h"

#include <stdbool.h>

/* Take the lock that tests/check/check.c takes, and say so where that means to wait. It is this
 * process's until it ends, also as another program (exec), and not that of its children. False,
 * with a message, when the directory cannot be written. */
bool lock_programs(const char *programs, struct error *error);

#endif
