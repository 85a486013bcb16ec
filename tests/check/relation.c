/* Two pictures of the same program that must agree: see relation.h. */
#include "relation.h"

#include "check/page/pictures.h"
#include "compare.h"
#include "unseen.h"

#include <stdio.h>
#include <string.h>

enum { SEED = 5, RIGHT = 3, UP = 2 };

/* How a relation writes the input again, and what is said of it. */
static const struct {
    struct variant variant;
    const char *size; /* of the second picture */
    const char *says;
} table[RELATION_COUNT] = {
    [RELATION_SHUFFLED] = {{.shuffled = true}, "256x256", "in another order"},
    [RELATION_TURNED] = {{.turned = 1}, "256x256", "the corners of each triangle turned"},
    [RELATION_REVERSED] = {{.reversed = true}, "256x256", "the ends of each line exchanged"},
    [RELATION_MOVED] = {{.right = RIGHT, .up = UP}, "256x256", "moved by (3,2)"},
    [RELATION_HALVED] = {{.right = 0}, "512x512", "drawn twice as large and halved"},
};

/* What the scene is drawn from. */
static enum input_kind kind_for(const char *step, const char *scene) {
    if (!unseen_takes_text(step)) {
        return INPUT_MODEL;
    }
    bool lines = strncmp(step, "step01_", 7) == 0;
    if (strcmp(scene, "gradient") == 0) {
        return lines ? INPUT_GRADIENT_LINES : INPUT_GRADIENT_TRIANGLES;
    }
    return lines ? INPUT_LINES : INPUT_TRIANGLES;
}

/* Draw one of the two pictures. False when the check cannot; where the program did not draw it,
 * the image is empty, and `ended` says how, when not well. */
static bool draw(struct image *image, const char *programs, const char *step, const char *scene,
                 enum input_kind kind, const struct variant *variant, const char *size,
                 const struct run_limits *limits, struct run_text *ended, struct error *error) {
    const bool text = unseen_takes_text(step);
    const char *const options[] = {"-s", size, "--only", scene, NULL};
    const char *const nothing[] = {NULL};
    struct drawn_path program;
    struct unseen_place place;
    struct run_result end;
    struct error reason;
    *image = (struct image){.pixels = NULL};
    if (!drawn_program(&program, programs, step, error) || !unseen_begin(&place, error)) {
        return false;
    }
    bool done = unseen_draw(&place, program.text, text ? nothing : options, kind, SEED, variant,
                            limits, &end, error);
    struct run_text description = done ? run_ended_by(&end, limits) : (struct run_text){""};
    if (done && description.text[0] != '\0') {
        *ended = description;
    } else if (done) {
        drawn_read(image, place.pictures, text ? "scene" : scene, NULL, &reason);
    }
    bytes_free(&end.messages);
    unseen_end(&place);
    return done;
}

/* Halved, an edge may be a pixel off: there only what has no match next to it counts. */
static bool compare(struct relation_result *result, enum relation relation,
                    const struct image *first, const struct image *second, struct error *error) {
    const struct variant *variant = &table[relation].variant;
    size_t right = (size_t)variant->right, up = (size_t)variant->up;
    size_t width = first->width - right, height = first->height - up;
    struct image before, after;
    if (!picture_part(&before, first, 0, 0, 1, width, height, error)) {
        return false;
    }
    if (!picture_part(&after, second, right, up, relation == RELATION_HALVED ? 2 : 1, width, height,
                      error)) {
        image_free(&before);
        return false;
    }
    struct comparison found = compare_images(&before, &after);
    const struct tally *tally = relation == RELATION_HALVED ? &found.wrong : &found.apart;
    result->differing = tally->count;
    result->drawn_pixels = found.drawn;
    result->drawn = found.drawn > 0;
    if (result->drawn) {
        snprintf(result->text, sizeof result->text, "%s: %llu of %llu pixels of a new scene differ",
                 table[relation].says, (unsigned long long)tally->count,
                 (unsigned long long)found.drawn);
    } else {
        snprintf(result->text, sizeof result->text, "of a new scene nothing is drawn");
    }
    image_free(&before);
    image_free(&after);
    return true;
}

bool relation_try(const char *programs, const char *step, const char *scene, enum relation relation,
                  const struct run_limits *limits, struct relation_result *result,
                  struct error *error) {
    enum input_kind kind = kind_for(step, scene);
    const size_t size = INPUT_SIZE, second_size = relation == RELATION_HALVED ? 2 * size : size;
    struct image first = {.pixels = NULL}, second = {.pixels = NULL};
    struct run_text ended = {""};
    *result = (struct relation_result){.drawn = false};
    bool done = draw(&first, programs, step, scene, kind, &(struct variant){.turned = 0}, "256x256",
                     limits, &ended, error) &&
                draw(&second, programs, step, scene, kind, &table[relation].variant,
                     table[relation].size, limits, &ended, error);
    if (done && ended.text[0] != '\0') {
        snprintf(result->text, sizeof result->text, "a new scene is not drawn: %s", ended.text);
    } else if (done && (first.width != size || first.height != size ||
                        second.width != second_size || second.height != second_size)) {
        snprintf(result->text, sizeof result->text, "a new scene is not drawn, or in another size");
    } else if (done) {
        done = compare(result, relation, &first, &second, error);
    }
    image_free(&first);
    image_free(&second);
    return done;
}
