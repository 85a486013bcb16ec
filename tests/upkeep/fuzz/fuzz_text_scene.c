/*
 * Text scenes of any bytes, read as lines and as triangles. What can be read keeps the limits of
 * text_scene.h (make stress draws what these allow). Every word that is a number is the number that
 * the C library reads.
 */
#include "base/text.h"
#include "fuzz.h"
#include "run/text_scene.h"

#include <math.h>

enum { SCENE_GROWTH = 24 };  /* bytes of a shape (60) for 19 of text, in an array that doubles */
enum { NUMBER_LENGTH = 99 }; /* longer words are not compared */

/* ---- Numbers ---- */

static void require_number(struct word word) {
    char copy[NUMBER_LENGTH + 1];
    double as_double;
    if (word.length > NUMBER_LENGTH || !word_to_double(word, &as_double)) {
        return;
    }
    memcpy(copy, word.start, word.length);
    copy[word.length] = '\0';
    char *end;
    double expected = strtod(copy, &end);
    REQUIRE(*end == '\0');
    REQUIRE(memcmp(&expected, &as_double, sizeof expected) == 0);
}

/* A word is a run of characters inside the file, and lines are counted from 1. */
static void require_words(const uint8_t *data, size_t size) {
    struct error error = no_error();
    struct text text;
    size_t line = 0;
    if (!text_begin(&text, data, size, (size & 1) != 0, &error)) {
        require_message(&error);
        return;
    }
    while (text_next_line(&text)) {
        REQUIRE(text.line > line);
        line = text.line;
        for (;;) {
            struct word word = text_next_word(&text);
            if (word.length == 0) {
                break;
            }
            const char *begin = (const char *)data, *end = begin + size;
            REQUIRE(word.start >= begin && word.start + word.length <= end);
            REQUIRE(strlen(word_show(word).text) <= word.length);
            require_number(word);
        }
    }
}

/* ---- Scenes ---- */

static void require_limits(const struct text_scene *scene, size_t corners) {
    const double limit = TEXT_SCENE_COORDINATE_LIMIT;
    REQUIRE(scene->width <= TEXT_SCENE_SIZE_LIMIT && scene->height <= TEXT_SCENE_SIZE_LIMIT);
    REQUIRE((scene->width == 0) == (scene->height == 0));
    for (size_t i = 0; i < scene->shape_count; i++) {
        const struct text_scene_shape *shape = &scene->shapes[i];
        for (size_t j = 0; j < corners; j++) {
            REQUIRE(shape->x[j] >= -limit && shape->x[j] <= limit);
            REQUIRE(shape->y[j] >= -limit && shape->y[j] <= limit);
            REQUIRE(corners == 3 ||
                    (floor(shape->x[j]) == shape->x[j] && floor(shape->y[j]) == shape->y[j]));
            REQUIRE(shape->color[j].a == 255);
        }
    }
}

static void require_scene(const uint8_t *data, size_t size, enum text_scene_kind kind) {
    size_t corners = kind == TEXT_SCENE_LINES ? 2 : 3;
    struct error error = no_error();
    struct text_scene scene;
    memory_begin();
    bool done = text_scene_decode(&scene, data, size, kind, &error);
    require_memory(size, SCENE_GROWTH);
    if (!done) {
        REQUIRE(scene.shapes == NULL && scene.shape_count == 0);
        require_message(&error);
        return;
    }
    require_limits(&scene, corners);
    text_scene_free(&scene);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    require_words(data, size);
    require_scene(data, size, TEXT_SCENE_LINES);
    require_scene(data, size, TEXT_SCENE_TRIANGLES);
    return 0;
}
