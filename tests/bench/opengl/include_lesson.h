/*
 * To be included before a lesson's main.c: main() becomes lesson_main(), private to the file, and
 * captures the lesson's program. No include guard is needed: each file includes one lesson.
 */
#include "lesson.h"

#define main         lesson_main
#define program_main lesson_capture
static int lesson_main(int argc, char **argv);
