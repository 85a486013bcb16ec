/*
 * The options on the command line of a program of the tests.
 *
 *     struct options { const char *directory; size_t frames; bool quick; } o = {"build", 15, 0};
 *     const struct argument known[] = {
 *         {"-o", "DIR", "where the pictures go", argument_text, &o.directory},
 *         {"--frames", "N", "frames that are timed", argument_number, &o.frames},
 *         {"--quick", "", "only three frames", argument_flag, &o.quick},
 *     };
 *     int count = arguments_read(known, 3, argc, argv, &error);
 *
 * Options and other arguments may be mixed; "--" ends the options.
 */
#ifndef TESTS_CHECK_ARGUMENTS_H
#define TESTS_CHECK_ARGUMENTS_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

/* Reads the value ("" for an option without one) into the target. False when it can't be that. */
typedef bool argument_reader(const char *value, void *target);

struct argument {
    const char *name;  /* "--size" */
    const char *value; /* as the help shows it, "WxH"; "" for an option without one */
    const char *help;  /* further lines begin after a newline */
    argument_reader *read;
    void *target;
};

argument_reader argument_text;   /* a const char *: any text */
argument_reader argument_flag;   /* a bool, which becomes true */
argument_reader argument_number; /* a size_t: a whole number, 1 to 10^9 */

/* Read all options. What is none moves to the front: argv[1], argv[2] ... Returns how many of these
 * there are, and a NULL follows them; -1, with a message, where an option is unknown or its value
 * is missing or wrong. */
int arguments_read(const struct argument *known, size_t known_count, int argc, char **argv,
                   struct error *error);

/* Print a line or more for each option, and one for -h and --help. */
void arguments_print_help(const struct argument *known, size_t known_count);

/* Is the whole command line -h or --help? */
bool arguments_want_help(int argc, char **argv);

#endif
