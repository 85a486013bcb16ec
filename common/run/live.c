/* The loop of --live: see live.h. */
#define _POSIX_C_SOURCE 200809L
#include "run/live.h"

#include "base/array.h"
#include "base/bytes.h"
#include "run/options.h"
#include "run/stage.h"

#include <stdlib.h>
#include <string.h>

/* ---- What is there ---- */

static void describe_vec3(const char *name, struct vec3 v, FILE *out) {
    fprintf(out, ",\"%s\":[%g,%g,%g]", name, v.x, v.y, v.z);
}

void live_describe(const struct program *program, FILE *out) {
    fprintf(out, "{\"program\":\"%s\",\"text\":%s,\"scenes\":[", program->name,
            program->draw_text == NULL               ? "null"
            : program->text_kind == TEXT_SCENE_LINES ? "\"line\""
                                                     : "\"triangle\"");
    for (size_t i = 0; i < program->scene_count; i++) {
        const struct scene scene = scene_complete(program, &program->scenes[i]);
        fprintf(out, "%s{\"name\":\"%s\",\"width\":%zu,\"height\":%zu,\"frames\":%zu",
                i > 0 ? "," : "", scene.name, scene.width, scene.height, scene.frames);
        if (program->takes_light) {
            describe_vec3("light", scene.light, out);
        }
        if (program->takes_camera) {
            describe_vec3("eye", scene.eye, out);
            describe_vec3("center", scene.center, out);
            describe_vec3("up", scene.up, out);
        }
        fprintf(out, "}");
    }
    fprintf(out, "]}\n");
    fflush(out);
}

/* ---- Frames ---- */

void live_write_frame(const struct image *image, double milliseconds,
                      const struct counter *counters, size_t counter_count, FILE *out) {
    fprintf(out, "frame %zu %zu %.3f %zu\n", image->width, image->height, milliseconds,
            counter_count);
    for (size_t i = 0; i < counter_count; i++) {
        fprintf(out, "%s %llu\n", counters[i].name, (unsigned long long)counters[i].value);
    }
    uint8_t row[4 * DRAW_LIMIT];
    for (int y = (int)image->height - 1; y >= 0; y--) {
        for (int x = 0; x < (int)image->width; x++) {
            struct color c = image_get(image, x, y);
            const uint8_t pixel[] = {c.r, c.g, c.b, 255};
            memcpy(row + 4 * x, pixel, sizeof pixel);
        }
        fwrite(row, 4, image->width, out);
    }
}

/* ---- Requests ---- */

/* Append the next line, with its end. False at the end of the input. */
static bool read_line(FILE *in, struct bytes *line, bool *memory) {
    char piece[4096];
    bool any = false, ended = false;
    while (!ended && fgets(piece, sizeof piece, in) != NULL) {
        size_t length = strlen(piece);
        *memory = *memory && bytes_append(line, piece, length);
        ended = length > 0 && piece[length - 1] == '\n';
        any = true;
    }
    return any && *memory;
}

/* What is read of one request. */
struct request_memory {
    struct bytes line, text;
    char **words;
    size_t capacity;
};

/* Split the line into words behind the program's name. False when memory runs out. */
static bool split_line(struct live_request *request, struct request_memory *memory) {
    char *save = NULL;
    for (char *word = strtok_r((char *)memory->line.data, " \t\r\n", &save); word != NULL;
         word = strtok_r(NULL, " \t\r\n", &save)) {
        char **words = array_reserve(memory->words, &memory->capacity, (size_t)request->argc + 1,
                                     sizeof *words);
        if (words == NULL) {
            return false;
        }
        memory->words = words;
        words[request->argc++] = word;
    }
    request->argv = memory->words;
    return true;
}

/* Read a text scene up to its end. */
static bool read_text(FILE *in, struct request_memory *memory, bool *enough) {
    for (size_t begin = 0; read_line(in, &memory->text, enough); begin = memory->text.size) {
        const char *line = (const char *)memory->text.data + begin;
        size_t length = memory->text.size - begin;
        if ((length == 4 && memcmp(line, "end\n", 4) == 0) ||
            (length == 3 && memcmp(line, "end", 3) == 0)) {
            memory->text.size = begin;
            return true;
        }
    }
    return false;
}

/* The next request; false at the end of the input, or when there is not `enough` memory. */
static bool read_request(FILE *in, const struct program *program, struct request_memory *memory,
                         struct live_request *request, bool *enough) {
    static char text_word[] = "text";
    *request = (struct live_request){.argc = 1};
    memory->line.size = memory->text.size = 0;
    if (!read_line(in, &memory->line, enough)) {
        return false;
    }
    char **words = array_reserve(memory->words, &memory->capacity, 1, sizeof *words);
    memory->words = words != NULL ? words : memory->words;
    *enough = words != NULL && bytes_append(&memory->line, "", 1);
    if (!*enough) {
        return false;
    }
    memory->words[0] = (char *)(uintptr_t)program->name;
    *enough = split_line(request, memory);
    if (*enough && request->argc > 1 && strcmp(request->argv[request->argc - 1], text_word) == 0) {
        request->argc--;
        if (!read_text(in, memory, enough)) {
            return false;
        }
        request->text = (const char *)memory->text.data;
        request->text_size = memory->text.size;
    }
    return *enough;
}

bool live_loop(const struct program *program, FILE *in, FILE *out, live_answer *answer,
               void *context, struct error *error) {
    struct request_memory memory = {.words = NULL};
    struct live_request request;
    bool enough = true;
    live_describe(program, out);
    while (read_request(in, program, &memory, &request, &enough) && !ferror(out)) {
        if (!answer(context, &request, out, error)) {
            fprintf(out, "error %s\n", error->message);
        }
        fflush(out);
    }
    bytes_free(&memory.line);
    bytes_free(&memory.text);
    free(memory.words);
    if (!enough) {
        return error_out_of_memory(error);
    }
    return !ferror(out) || error_set(error, "cannot write to standard output");
}
