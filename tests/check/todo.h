/*
 * Which tasks of a main.c are as the starter has them: its comment `// to do 5.2` is still there.
 *
 * A main.c with the marks of tests/student/marks.awk has its starter's lines between them, inside
 * of a comment. Those are not looked at.
 */
#ifndef TESTS_CHECK_TODO_H
#define TESTS_CHECK_TODO_H

#include "base/bytes.h"

#include <stdbool.h>

/* Does the text (with a NUL at its end, or NULL) have the line of that task, like "5.2", or of one
 * of the part "8b"? */
bool todo_has_task(const char *text, const char *task);

/* The text of a main.c with a NUL at its end; of one that cannot be read, an empty text. The caller
 * frees it. */
struct bytes todo_read(const char *path);

#endif
