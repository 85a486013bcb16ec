/*
 * A lesson's main.c as a part of another program, which then has all of its functions, and its
 * description by the lesson's name (&step05_zbuffer). The path is seen from this directory:
 *
 *     #define LESSON "../step05_zbuffer/main.c"
 *     #include "lesson.h"
 *
 * The lesson's main() gets another name and is private. Nobody needs to call it: it only hands the
 * description to program_main(). One file can have one lesson, so there is no include guard.
 */
static int lesson_main(int argc, char **argv) __attribute__((unused));

#define main lesson_main
#include LESSON
#undef main
