/*
 * Lists submissions that are near copies of one another, for a person to look at. It judges nobody:
 * short tasks have few right solutions.
 *
 * Exit status: 0 done, whatever was found; 1 the starters cannot be read, or a file not written; 2
 * wrong usage.
 */
#include "base/text.h"
#include "class.h"
#include "common.h"
#include "listing.h"
#include "pairs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STATUS_FAILED = 1, STATUS_USAGE = 2, PAIRS_PRINTED = 20 };

static const char help[] =
    "Usage: similar --starters DIR [options] SUBMISSION...\n"
    "List submissions that are near copies of one another, for a person to look at.\n"
    "SUBMISSION is a directory with step05_zbuffer/main.c and the like, or NAME=DIRECTORY.\n"
    "\n"
    "  --starters DIR      what everybody got: the .c and .h files of DIR/step05_zbuffer and the\n"
    "                      like, and of DIR/common; a directory of `make handout` is one\n"
    "  --html FILE         the pairs with their lines side by side\n"
    "  --csv FILE          a line for each pair and lesson\n"
    "  --all N             list pairs that share N %% of their fingerprints in all lessons (%d)\n"
    "  --lesson N          list also those that share N %% in one lesson (%d)\n"
    "  -h, --help\n"
    "\n"
    "Exit status: 0 done, whatever was found; 1 something cannot be read or written; 2 wrong\n"
    "usage.\n";

struct settings {
    const char *starters, *html, *csv, *all, *lesson;
    struct limits limits;
};

/* ---- The command line ---- */

/* A share 0..1 from a percentage; what `share` was where there is none. */
static bool read_percentage(double *share, const char *option, const char *text,
                            struct error *error) {
    int64_t percent;
    if (text == NULL) {
        return true;
    }
    if (!word_to_integer((struct word){text, strlen(text)}, &percent) || percent < 0 ||
        percent > 100) {
        return error_set(error, "%s is '%.50s', not a whole number, 0..100", option, text);
    }
    *share = (double)percent / 100;
    return true;
}

static bool read_options(struct settings *settings, int argc, char **argv, int *first,
                         struct error *error) {
    const struct {
        const char *name;
        const char **value;
    } known[] = {{"--starters", &settings->starters},
                 {"--html", &settings->html},
                 {"--csv", &settings->csv},
                 {"--all", &settings->all},
                 {"--lesson", &settings->lesson}};
    int i = 1;
    for (; i < argc && argv[i][0] == '-' && strcmp(argv[i], "--") != 0; i += 2) {
        size_t k = 0, count = sizeof known / sizeof known[0];
        while (k < count && strcmp(argv[i], known[k].name) != 0) {
            k++;
        }
        if (k == count || i + 1 == argc) {
            return error_set(error, k == count ? "unknown option '%.100s'" : "%s needs a value",
                             argv[i]);
        }
        *known[k].value = argv[i + 1];
    }
    *first = i + (i < argc && argv[i][0] == '-');
    if (settings->starters == NULL) {
        return error_set(error, "say what everybody got: --starters DIR");
    }
    settings->limits =
        (struct limits){DEFAULT_PERCENT_OF_ALL / 100.0, DEFAULT_PERCENT_OF_LESSON / 100.0};
    return read_percentage(&settings->limits.all, "--all", settings->all, error) &&
           read_percentage(&settings->limits.lesson, "--lesson", settings->lesson, error);
}

/* "a" of a=some/where, "b" of some/b and some/b/, which loses its slash. */
static struct submission name_submission(char *argument) {
    char *equals = strchr(argument, '='), *slash = strchr(argument, '/');
    if (equals != NULL && equals != argument && (slash == NULL || equals < slash)) {
        *equals = '\0';
        return (struct submission){.name = argument, .path = equals + 1};
    }
    size_t length = strlen(argument);
    while (length > 1 && argument[length - 1] == '/') {
        argument[--length] = '\0';
    }
    slash = strrchr(argument, '/');
    return (struct submission){.name = slash != NULL && slash[1] != '\0' ? slash + 1 : argument,
                               .path = argument};
}

/* ---- What is done ---- */

/* "  87 %  anna  ben  (100 % of step05_zbuffer)" */
static void print_pair(const struct class *class, const struct pair *pair) {
    char *line =
        string_format("  %3.0f %%  %s  %s  (%.0f %% of %s)", common_share(pair->all) * 100,
                      class->submissions[pair->a].name, class->submissions[pair->b].name,
                      common_share(pair->most) * 100, class->lessons.all[pair->most_lesson]);
    if (line != NULL) {
        text_make_printable(line, '?');
        puts(line);
    }
    free(line);
}

static void print_pairs(const struct class *class, const struct pairs *pairs) {
    size_t count = class->submission_count;
    printf("similar: %zu of %zu pairs are to be looked at\n", pairs->count,
           count * (count - 1) / 2);
    for (size_t i = 0; i < pairs->count && i < PAIRS_PRINTED; i++) {
        print_pair(class, &pairs->all[i]);
    }
    if (pairs->count > PAIRS_PRINTED) {
        puts("  ...");
    }
}

static bool write_files(const struct class *class, const struct pairs *pairs,
                        const struct settings *settings, struct error *error) {
    struct bytes page = {0}, table = {0};
    bool done = true;
    if (settings->html != NULL) {
        bool encoded =
            listing_html(&page, class, pairs, settings->limits) || error_out_of_memory(error);
        done = file_write_encoded(settings->html, encoded, &page, error);
    }
    if (done && settings->csv != NULL) {
        bool encoded = listing_csv(&table, class, pairs) || error_out_of_memory(error);
        done = file_write_encoded(settings->csv, encoded, &table, error);
    }
    return done;
}

static void print_notes(const struct bytes *notes) {
    fwrite(notes->data, 1, notes->size, stderr);
}

static bool list(struct class *class, const struct settings *settings, struct error *error) {
    struct pairs pairs = {0};
    bool done = class_read_given(class, settings->starters, error) &&
                (class_read(class) || error_out_of_memory(error));
    print_notes(&class->notes);
    done = done &&
           ((common_forget(class) && pairs_find(&pairs, class, settings->limits)) ||
            error_out_of_memory(error)) &&
           write_files(class, &pairs, settings, error);
    if (done) {
        print_pairs(class, &pairs);
    }
    pairs_free(&pairs);
    return done;
}

static bool take_submissions(struct class *class, int count, char **arguments,
                             struct error *error) {
    class->submissions = calloc((size_t)count + 1, sizeof *class->submissions);
    if (class->submissions == NULL) {
        return error_out_of_memory(error);
    }
    for (int i = 0; i < count; i++) {
        class->submissions[class->submission_count++] = name_submission(arguments[i]);
    }
    return true;
}

static int fail(int status, const struct error *error) {
    fprintf(stderr, "similar: %s\n", error->message);
    return status;
}

int main(int argc, char **argv) {
    struct settings settings = {0};
    struct class class = {0};
    struct error error;
    int first = argc;
    if (argc > 1 && (strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "--help") == 0)) {
        printf(help, DEFAULT_PERCENT_OF_ALL, DEFAULT_PERCENT_OF_LESSON);
        return EXIT_SUCCESS;
    }
    if (!read_options(&settings, argc, argv, &first, &error)) {
        return fail(STATUS_USAGE, &error);
    }
    bool done = take_submissions(&class, argc - first, argv + first, &error) &&
                list(&class, &settings, &error);
    class_free(&class);
    return done ? EXIT_SUCCESS : fail(STATUS_FAILED, &error);
}
