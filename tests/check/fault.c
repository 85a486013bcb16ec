#include "fault.h"

#include "drawn.h"

#include <stdio.h>
#include <string.h>

/* How AddressSanitizer calls a fault, and what it is. */
static const struct {
    const char *name, *words;
} faults[] = {
    {"heap-buffer-overflow", "outside of the memory that it was given"},
    {"stack-buffer-overflow", "outside of an array"},
    {"stack-buffer-underflow", "outside of an array"},
    {"dynamic-stack-buffer-overflow", "outside of an array"},
    {"global-buffer-overflow", "outside of an array"},
    {"heap-use-after-free", "memory that was freed already"},
    {"stack-use-after-scope", "a variable that is no longer there"},
    {"stack-use-after-return", "a variable of a function that has returned"},
    {"SEGV", "where there is no memory (a pointer that is NULL, or was never set)"},
};

/* The number behind ":" of a place like "main.c:120:5". */
static int line_of(const char *place) {
    int line = 0;
    const char *colon = strchr(place, ':');
    return colon != NULL && sscanf(colon + 1, "%d", &line) == 1 ? line : 0;
}

/* A line "PATH/STEP/main.c:120:5: runtime error: index 9 out of bounds". When it names a file
 * elsewhere (what main.c has called), the place is that of the first frame in the step's directory
 * below it, where there is one: "    #2 0x55d0 in line PATH/STEP/main.c:120". */
static bool describe_undefined(struct result_text *text, const char *step, const char *messages) {
    static const char words[] = "runtime error: ";
    const char *error = strstr(messages, words);
    if (error == NULL) {
        return false;
    }
    char directory[SCENE_NAME_LIMIT + 2];
    snprintf(directory, sizeof directory, "%s/", step);
    const char *line = message_line_start(messages, error), *own = strstr(line, directory);
    const char *place = own != NULL ? own : line;
    result_say(text, "%.*s:%d: %s", (int)strcspn(place, ":\n"), place, line_of(place),
               drawn_message(error + strlen(words)).text);
    return true;
}

/* "reads", "writes", or "uses" where it does not say. */
static const char *access_of(const char *report) {
    const char *reads = strstr(report, "\nREAD of"), *writes = strstr(report, "\nWRITE of");
    const char *read_hint = strstr(report, "caused by a READ"),
               *write_hint = strstr(report, "caused by a WRITE");
    return reads != NULL || read_hint != NULL     ? "reads"
           : writes != NULL || write_hint != NULL ? "writes"
                                                  : "uses";
}

/* The first frame of the report in the step's directory: "    #1 0x55d0 in line PATH:120". */
static void describe_frame(struct result_text *text, const char *step, const char *report) {
    char directory[SCENE_NAME_LIMIT + 2];
    snprintf(directory, sizeof directory, "%s/", step);
    const char *end = strstr(report, "\n\n"); /* of the first stack: others are of older events */
    const char *place = strstr(report, directory);
    if (place == NULL || (end != NULL && place > end)) {
        result_say(text, "%s/main.c: it", step);
        return;
    }
    const char *line = message_line_start(report, place);
    char function[64] = "it";
    const char *in = strstr(line, " in ");
    if (in != NULL && in < place && sscanf(in, " in %59[A-Za-z0-9_]", function) == 1) {
        strcat(function, "()");
    }
    const char *file = place + strlen(directory);
    result_say(text, "%s%.*s:%d: %s", directory, (int)strcspn(file, ":\n"), file, line_of(file),
               function);
}

/* abort() does not say why; assert() does, before it: "main.c:4: f: Assertion `n > 1' failed." */
static void describe_abort(struct result_text *text, const char *messages) {
    const char *assertion = strstr(messages, "Assertion ");
    result_say(text, " stops the program: %s",
               assertion != NULL ? drawn_message(assertion).text : "abort()");
}

static bool describe_address(struct result_text *text, const char *step, const char *messages) {
    static const char words[] = "AddressSanitizer: ";
    const char *report = strstr(messages, words);
    if (report == NULL) {
        return false;
    }
    const char *name = report + strlen(words);
    describe_frame(text, step, report);
    if (strncmp(name, "stack-overflow", strlen("stack-overflow")) == 0) {
        result_say(text, " calls itself without end, or has too large an array");
        return true;
    }
    if (strncmp(name, "ABRT", strlen("ABRT")) == 0) {
        describe_abort(text, messages);
        return true;
    }
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        if (strncmp(name, faults[i].name, strlen(faults[i].name)) == 0) {
            result_say(text, " %s %s", access_of(report), faults[i].words);
            return true;
        }
    }
    result_say(text, " has a fault: %s", drawn_message(name).text);
    return true;
}

bool fault_describe(struct result_text *text, const char *step, const char *messages) {
    return messages != NULL &&
           (describe_undefined(text, step, messages) || describe_address(text, step, messages));
}
