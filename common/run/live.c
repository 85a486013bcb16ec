/* The loop of --live: see live.h. */
#define _POSIX_C_SOURCE 200809L
#include "run/live.h"

#include "run/options.h"
#include "run/stage.h"

#include <string.h>

/* ---- What is there ---- */

static void describe_vec3(const char *name, struct vec3 v, FILE *out) {
    fprintf(out, ",\"%s\":[%g,%g,%g]", name, v.x, v.y, v.z);
}

static void describe_values(const struct scene_value *values, FILE *out) {
    for (size_t i = 0; values != NULL && values[i].name != NULL; i++) {
        const struct scene_value *v = &values[i];
        fprintf(out, "%s{\"name\":\"%s\",\"help\":\"%s\",", i > 0 ? "," : ",\"values\":[", v->name,
                v->help);
        fprintf(out, "\"least\":%g,\"most\":%g,\"step\":%g,\"value\":%g}%s", v->least, v->most,
                v->step, v->value, v[1].name == NULL ? "]" : "");
    }
}

/* A text scene is one more, with the text that one begins with. */
static void describe_text(const struct program *program, FILE *out) {
    if (program->text == NULL) {
        return;
    }
    fprintf(out, ",{\"name\":\"your own\",\"frames\":1,\"text\":\"");
    for (const char *c = program->text; *c != '\0'; c++) {
        fprintf(out, *c == '\n' ? "\\n" : "%c", *c);
    }
    fprintf(out, "\"");
    describe_values(program->text_values, out);
    fprintf(out, "}");
}

void live_describe(const struct program *program, FILE *out) {
    const struct options none = {.program = program};
    fprintf(out, "{\"program\":\"%s\",%s\"scenes\":[", program->name,
            program->skips ? "\"skips\":true," : "");
    for (size_t i = 0; i < program->scene_count; i++) {
        const struct scene scene = scene_complete(&none, &program->scenes[i]);
        fprintf(out, "%s{\"name\":\"%s\",\"width\":%zu,\"height\":%zu,\"frames\":%zu%s",
                i > 0 ? "," : "", scene.name, scene.width, scene.height, scene.frames,
                scene.extra ? ",\"extra\":true" : "");
        if (program->takes_light && scene.needs != 0) {
            describe_vec3("light", scene.light, out);
        }
        if (program->takes_camera && scene.needs != 0) {
            describe_vec3("eye", scene.eye, out);
            describe_vec3("center", scene.center, out);
            describe_vec3("up", scene.up, out);
        }
        describe_values(scene.values, out);
        fprintf(out, "}");
    }
    describe_text(program, out);
    fprintf(out, "]}\n");
    fflush(out);
}

/* ---- Frames ---- */

static size_t count_lines(const char *text) {
    size_t count = 0;
    for (; *text != '\0'; text++) {
        count += *text == '\n';
    }
    return count;
}

void live_write_frame(const struct image *image, double milliseconds, const struct drawing *drawing,
                      FILE *out) {
    fprintf(out, "frame %zu %zu %.3f %zu\n", image->width, image->height, milliseconds,
            drawing->counter_count + count_lines(drawing->notes));
    for (size_t i = 0; i < drawing->counter_count; i++) {
        const struct counter *counter = &drawing->counters[i];
        fprintf(out, "%s %llu\n", counter->name, (unsigned long long)counter->value);
    }
    for (const char *line = drawing->notes; strchr(line, '\n') != NULL;) {
        int length = (int)strcspn(line, "\n");
        fprintf(out, " %.*s\n", length, line);
        line += length + 1;
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

/* Append the next line, with its end. False at the end of the input, or without `enough` memory. */
static bool read_whole_line(FILE *in, struct bytes *line, bool *enough) {
    char piece[4096];
    bool any = false, ended = false;
    while (!ended && fgets(piece, sizeof piece, in) != NULL) {
        size_t length = strlen(piece);
        *enough = *enough && bytes_append(line, piece, length);
        ended = length > 0 && piece[length - 1] == '\n';
        any = true;
    }
    return any && *enough;
}

/* Split the line into words behind the program's name. */
static void split_line(struct live_request *request) {
    char *save = NULL, *word = strtok_r((char *)request->line.data, " \t\r\n", &save);
    for (; word != NULL && request->argc < LIVE_WORD_LIMIT;
         word = strtok_r(NULL, " \t\r\n", &save)) {
        request->argv[request->argc++] = word;
    }
}

/* Read a text scene up to its end. */
static bool read_text(FILE *in, struct bytes *text, bool *enough) {
    for (size_t begin = 0; read_whole_line(in, text, enough); begin = text->size) {
        const char *line = (const char *)text->data + begin;
        size_t length = text->size - begin;
        if ((length == 4 && memcmp(line, "end\n", 4) == 0) ||
            (length == 3 && memcmp(line, "end", 3) == 0)) {
            text->size = begin;
            return true;
        }
    }
    return false;
}

/* The next request; false at the end of the input, or without `enough` memory. */
static bool read_request(FILE *in, struct live_request *request, bool *enough) {
    request->line.size = request->text.size = 0;
    request->argc = 1;
    bool read = read_whole_line(in, &request->line, enough);
    *enough = *enough && bytes_append(&request->line, "", 1);
    if (!read || !*enough) {
        return false;
    }
    split_line(request);
    request->has_text = request->argc > 1 && strcmp(request->argv[request->argc - 1], "text") == 0;
    request->argc -= request->has_text;
    return !request->has_text || read_text(in, &request->text, enough);
}

bool live_loop(const struct program *program, FILE *in, FILE *out, live_answer *answer,
               void *context, struct error *error) {
    struct live_request request = {.argv = {(char *)(uintptr_t)program->name}};
    bool enough = true;
    while (read_request(in, &request, &enough) && !ferror(out)) {
        if (!answer(context, &request, out, error)) {
            fprintf(out, "error %s\n", error->message);
        }
        fflush(out);
    }
    bytes_free(&request.line);
    bytes_free(&request.text);
    if (!enough) {
        return error_out_of_memory(error);
    }
    return !ferror(out) || error_set(error, "cannot write to standard output");
}
