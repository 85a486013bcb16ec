/* The options on the command line of a program of the tests: see arguments.h. */
#include "arguments.h"

#include "base/text.h"

#include <stdio.h>
#include <string.h>

bool argument_text(const char *value, void *target) {
    *(const char **)target = value;
    return true;
}

bool argument_flag(const char *value, void *target) {
    (void)value;
    *(bool *)target = true;
    return true;
}

bool argument_number(const char *value, void *target) {
    enum { MOST = 1000000000 };
    int64_t number;
    bool understood = word_to_integer((struct word){value, strlen(value)}, &number) &&
                      number >= 1 && number <= MOST;
    *(size_t *)target = understood ? (size_t)number : 0;
    return understood;
}

static const struct argument *find(const struct argument *known, size_t count, const char *name) {
    for (size_t i = 0; i < count; i++) {
        if (strcmp(known[i].name, name) == 0) {
            return &known[i];
        }
    }
    return NULL;
}

/* Read the option; `value` is the argument behind it, or NULL. */
static bool read_one(const struct argument *option, const char *value, struct error *error) {
    bool takes_value = option->value[0] != '\0';
    if (takes_value && value == NULL) {
        return error_set(error, "%s needs a value", option->name);
    }
    return option->read(takes_value ? value : "", option->target) ||
           error_set(error, "%s %.200s: not understood", option->name, value);
}

int arguments_read(const struct argument *known, size_t known_count, int argc, char **argv,
                   struct error *error) {
    bool ended = false; /* by "--" */
    int others = 0;
    for (int i = 1; i < argc; i++) {
        if (ended || argv[i][0] != '-') {
            argv[++others] = argv[i];
            continue;
        }
        if (strcmp(argv[i], "--") == 0) {
            ended = true;
            continue;
        }
        const struct argument *option = find(known, known_count, argv[i]);
        if (option == NULL) {
            error_set(error, "unknown option '%.100s'", argv[i]);
            return -1;
        }
        if (!read_one(option, argv[i + 1], error)) {
            return -1;
        }
        i += option->value[0] != '\0';
    }
    if (others + 1 < argc) {
        argv[others + 1] = NULL;
    }
    return others;
}

void arguments_print_help(const struct argument *known, size_t known_count) {
    enum { COLUMN = 22 }; /* where the help of an option begins */
    for (size_t i = 0; i < known_count; i++) {
        int used = printf("  %s %s", known[i].name, known[i].value);
        for (const char *line = known[i].help; *line != '\0'; used = 0) {
            size_t length = strcspn(line, "\n");
            printf("%*s%.*s\n", used < COLUMN ? COLUMN - used : 1, "", (int)length, line);
            line += length + (line[length] == '\n');
        }
    }
    printf("  %-*s%s\n", COLUMN - 2, "-h, --help", "this text");
}

bool arguments_want_help(int argc, char **argv) {
    return argc == 2 && (strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "--help") == 0);
}
