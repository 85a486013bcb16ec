/*
 * What a lesson teaches is given from the next lesson on. The headers in this directory hold our
 * versions of it; those of common include them at their ends.
 *
 * `make` says which lesson it compiles: COURSE_LESSON. In that lesson and before it, whoever names
 * one of these functions gets an error that says why. A program of your own is given everything.
 */
#ifndef COMMON_GIVEN_LATER_H
#define COMMON_GIVEN_LATER_H

#ifndef COURSE_LESSON
#define COURSE_LESSON 99
#endif

/* The function, with an error before it: the only one, since the function is declared. */
#define GIVEN_LATER(f, there, then)                                                                \
    GIVEN_NOT(you write f() in there; it is given from lesson then on, and yours has another name) f
#define GIVEN_NOT(...)       GIVEN_PRAGMA(GCC error #__VA_ARGS__)
#define GIVEN_PRAGMA(pragma) _Pragma(#pragma)

#endif
