/* The options of the command line: see options.h. */
#include "run/options.h"

#include "base/text.h"

#include <stdio.h>
#include <string.h>

enum { REPEAT_LIMIT = 1000000, HELP_COLUMN = 17 };

/* Reads the value (NULL for an option without one) into the option's field. */
typedef bool parse_function(const char *value, void *field);

/* ---- What an option means ---- */

static bool parse_switch(const char *value, void *field) {
    (void)value;
    *(bool *)field = true;
    return true;
}

static bool parse_path(const char *value, void *field) {
    *(const char **)field = value;
    return value[0] != '\0';
}

static bool parse_format(const char *value, void *field) {
    const struct image_file_format *format = image_file_format_find(value);
    *(const struct image_file_format **)field = format;
    return format != NULL;
}

static bool parse_scene(const char *value, void *field) {
    struct options *options = field;
    options->all = strcmp(value, "all") == 0;
    if (options->all) {
        options->only = NULL;
        return true;
    }
    for (size_t i = 0; i < options->program->scene_count; i++) {
        if (strcmp(options->program->scenes[i].name, value) == 0) {
            options->only = &options->program->scenes[i];
            return true;
        }
    }
    return false;
}

static bool parse_count(const char *text, size_t length, int64_t limit, size_t *count) {
    int64_t value;
    if (!word_to_integer((struct word){text, length}, &value) || value < 1 || value > limit) {
        return false;
    }
    *count = (size_t)value;
    return true;
}

static bool parse_repeat(const char *value, void *field) {
    return parse_count(value, strlen(value), REPEAT_LIMIT, field);
}

static bool parse_size(const char *value, void *field) {
    struct size_option *size = field;
    size_t before = strcspn(value, "x");
    return value[before] == 'x' && parse_count(value, before, DRAW_LIMIT, &size->width) &&
           parse_count(value + before + 1, strlen(value + before + 1), DRAW_LIMIT, &size->height);
}

/* Three finite numbers with commas between them. */
static bool parse_vec3(const char *value, void *field) {
    double number[3];
    for (int i = 0; i < 3; i++) {
        size_t length = strcspn(value, ",");
        if (!word_to_double((struct word){value, length}, &number[i]) || !isfinite(number[i]) ||
            (value[length] == ',') != (i < 2)) {
            return false;
        }
        value += length + (i < 2);
    }
    *(struct vec3_option *)field = (struct vec3_option){true, {number[0], number[1], number[2]}};
    return true;
}

/* A pixel of an image, which may be smaller. */
static bool parse_pixel(const char *value, void *field) {
    struct pixel_option *pixel = field;
    struct vec3_option three;
    char text[64];
    snprintf(text, sizeof text, "%s,0", value);
    bool done = parse_vec3(text, &three) && three.value.x >= 0 && three.value.y >= 0 &&
                three.value.x < DRAW_LIMIT && three.value.y < DRAW_LIMIT;
    if (done) {
        *pixel = (struct pixel_option){true, {(int)three.value.x, (int)three.value.y}};
    }
    return done;
}

const struct scene_value *find_value(const struct scene_value *values,
                                     const struct chosen_value *chosen) {
    const struct scene_value *value = values;
    while (value != NULL && value->name != NULL &&
           (strlen(value->name) != chosen->length ||
            memcmp(value->name, chosen->name, chosen->length) != 0)) {
        value++;
    }
    return value != NULL && value->name != NULL ? value : NULL;
}

static bool is_within(const struct scene_value *known, double value) {
    return known != NULL && value >= known->least && value <= known->most;
}

/* Three whole numbers of quarter turns; four make none. */
static bool parse_turns(const char *value, void *field) {
    struct vec3_option turns;
    if (!parse_vec3(value, &turns)) {
        return false;
    }
    const double quarters[3] = {turns.value.x, turns.value.y, turns.value.z};
    bool whole = true;
    for (int i = 0; i < 3; i++) {
        whole = whole && floor(quarters[i]) == quarters[i];
        ((int *)field)[i] = (int)(quarters[i] - 4 * floor(quarters[i] / 4));
    }
    return whole;
}

/* NAME=VALUE: a number of a scene, within its range. */
static bool parse_set(const char *text, void *field) {
    struct options *options = field;
    const struct program *program = options->program;
    struct chosen_value chosen = {.name = text, .length = strcspn(text, "=")};
    const char *number = text + chosen.length + (text[chosen.length] == '=');
    if (options->set_count == VALUE_LIMIT ||
        !word_to_double((struct word){number, strlen(number)}, &chosen.value)) {
        return false;
    }
    options->set[options->set_count++] = chosen;
    bool known = is_within(find_value(program->text_values, &chosen), chosen.value);
    for (size_t i = 0; i < program->scene_count; i++) {
        known |= is_within(find_value(program->scenes[i].values, &chosen), chosen.value);
    }
    return known;
}

static bool parse_angle(const char *value, void *field) {
    struct angle_option *angle = field;
    angle->given = word_to_double((struct word){value, strlen(value)}, &angle->degrees) &&
                   angle->degrees >= 0 && angle->degrees <= 180;
    return angle->given;
}

/* Light without a direction makes every picture black. */
static bool parse_light(const char *value, void *field) {
    struct vec3_option *light = field;
    return parse_vec3(value, field) &&
           (light->value.x != 0 || light->value.y != 0 || light->value.z != 0);
}

/* ---- The table ---- */

#define SIZES ": each 1 to 16384"
_Static_assert(DRAW_LIMIT == 16384, "the largest of SIZES");
#define REPEATS ": 1 to 1000000"
_Static_assert(REPEAT_LIMIT == 1000000, "the largest of REPEATS");
#define FORMATS ": " IMAGE_FILE_NAMES
#define ANGLES  ": 0 to 180"
#define POINT   "three numbers X,Y,Z"

/* What a program must have for an option to make sense: scenes that need it, or these. */
enum condition {
    ALWAYS = 1 << 16, /* above all that a scene may need */
    WITH_MODEL = 1 << 17,
    WITH_CAMERA = 1 << 18,
    WITH_LIGHT = 1 << 19,
    WITH_VALUES = 1 << 20
};

#define FIELD(name) offsetof(struct options, name)

static const struct option {
    const char *name;
    const char *value; /* as --help shows it; empty for an option without one */
    const char *wants; /* for messages */
    const char *help;
    size_t field; /* offset in struct options; 0: all of them */
    parse_function *parse;
    unsigned condition; /* of enum condition or enum need */
} options_known[] = {
    {"-o", "DIR", "a directory", "where the images go", FIELD(directory), parse_path, ALWAYS},
    {"-s", "WxH", "WxH" SIZES, "image size" SIZES, FIELD(size), parse_size, ALWAYS},
    {"--only", "SCENE", "a scene or all", "draw just this scene; all: those besides, too", 0,
     parse_scene, ALWAYS},
    {"--format", "F", "a format" FORMATS, "of the images" FORMATS, FIELD(format), parse_format,
     ALWAYS},
    {"--turn", "X,Y,Z", "three whole numbers X,Y,Z",
     "first turn the model: quarter turns around x, then y, then z", FIELD(turns), parse_turns,
     WITH_MODEL},
    {"--two-sided", "", "", "draw the faces of the model from both sides", FIELD(two_sided),
     parse_switch, WITH_MODEL},
    {"--fit", "", "", "move and scale the model into view", FIELD(fit), parse_switch, WITH_MODEL},
    {"--smooth", "A", "degrees" ANGLES,
     "without normals in the file, edges sharper than A degrees are hard" ANGLES
     ", by default 60 or as the file says",
     FIELD(smooth), parse_angle, NEEDS_NORMALS | NEEDS_COLORS},
    {"--texture", "FILE", "a file", "the colours, instead of those next to the model",
     FIELD(textures[MODEL_DIFFUSE]), parse_path, NEEDS_DIFFUSE},
    {"--normal-map", "FILE", "a file", "the normals, too", FIELD(textures[MODEL_NORMAL_MAP]),
     parse_path, NEEDS_NORMAL_MAP},
    {"--specular", "FILE", "a file", "the shine, too", FIELD(textures[MODEL_SPECULAR]), parse_path,
     NEEDS_SPECULAR},
    {"--eye", "X,Y,Z", POINT, "where the camera is", FIELD(eye), parse_vec3, WITH_CAMERA},
    {"--center", "X,Y,Z", POINT, "the point that it looks at", FIELD(center), parse_vec3,
     WITH_CAMERA},
    {"--up", "X,Y,Z", POINT, "the direction that appears upwards", FIELD(up), parse_vec3,
     WITH_CAMERA},
    {"--light", "X,Y,Z", POINT " that are not all 0",
     "where the light goes, comes from or is: see the lesson", FIELD(light), parse_light,
     WITH_LIGHT},
    {"--set", "NAME=N", "NAME=N, a scene's number", "change a number of a scene", 0, parse_set,
     WITH_VALUES},
    {"--repeat", "N", "a number" REPEATS,
     "draw N times; print the median milliseconds of one frame" REPEATS, FIELD(repeat),
     parse_repeat, ALWAYS},
    {"--stats", "", "", "print what was done and what was skipped", FIELD(stats), parse_switch,
     ALWAYS},
    {"--no-skip", "", "", "do everything; the image must not change", FIELD(no_skip), parse_switch,
     ALWAYS},
    {"--frame", "N", "a number" REPEATS, "with --live: this frame of an animation" REPEATS,
     FIELD(frame), parse_repeat, ALWAYS},
    {"--probe", "X,Y", "a pixel X,Y", "with --live: what there is to say about this pixel",
     FIELD(probe), parse_pixel, ALWAYS},
    {"--live", "", "", "answer lines of options with frames: see common/run/live.h", FIELD(live),
     parse_switch, ALWAYS},
    {"--help", "", "", "this text; so does -h", FIELD(help), parse_switch, ALWAYS},
};

enum { OPTIONS_KNOWN = sizeof options_known / sizeof options_known[0] };

struct details {
    char text[1024]; /* cut where they are too many */
};

/* The numbers of a list: their scene, range and default. */
static void add_values(struct details *details, const struct scene_value *value,
                       const char *scene) {
    for (; value != NULL && value->name != NULL; value++) {
        string_append(details->text, sizeof details->text, "%s %s of %s, %g to %g (%g)",
                      details->text[0] == '\0' ? ":" : ";", value->name, scene, value->least,
                      value->most, value->value);
    }
}

/* What follows the option's texts: the names of the scenes, or of their numbers. */
static struct details details_of(const struct option *option, const struct program *program) {
    struct details details = {{0}};
    for (size_t i = 0; i < program->scene_count; i++) {
        const struct scene *scene = &program->scenes[i];
        if (option->parse == parse_scene) {
            string_append(details.text, sizeof details.text, "%s %s", i == 0 ? ":" : ",",
                          scene->name);
        } else if (option->parse == parse_set && (i == 0 || scene->values != scene[-1].values)) {
            add_values(&details, scene->values, scene->name);
        }
    }
    if (option->parse == parse_set) {
        add_values(&details, program->text_values, "a text scene");
    }
    return details;
}

unsigned program_needs(const struct program *program) {
    unsigned needs = 0;
    for (size_t i = 0; i < program->scene_count; i++) {
        needs |= program->scenes[i].needs;
    }
    return needs;
}

/* Does it draw a model, which the command line may then name? */
static bool takes_model(const struct program *program) {
    return program->draw_text == NULL && (program_needs(program) & ~(unsigned)NEEDS_DEPTH) != 0;
}

static bool takes_values(const struct program *program) {
    bool takes = program->text_values != NULL;
    for (size_t i = 0; i < program->scene_count; i++) {
        takes |= program->scenes[i].values != NULL;
    }
    return takes;
}

static bool takes_option(const struct program *program, const struct option *option) {
    unsigned has = ALWAYS | program_needs(program) | (takes_model(program) ? WITH_MODEL : 0) |
                   (program->takes_camera ? WITH_CAMERA : 0) |
                   (program->takes_light ? WITH_LIGHT : 0) |
                   (takes_values(program) ? WITH_VALUES : 0);
    return (has & option->condition) != 0;
}

static const struct option *find_option(const struct program *program, const char *name) {
    name = strcmp(name, "-h") == 0 ? "--help" : name;
    for (size_t i = 0; i < OPTIONS_KNOWN; i++) {
        if (strcmp(options_known[i].name, name) == 0 && takes_option(program, &options_known[i])) {
            return &options_known[i];
        }
    }
    return NULL;
}

/* ---- The command line ---- */

static bool parse_input(struct options *options, const char *input, struct error *error) {
    const struct program *program = options->program;
    bool takes_input = program->draw_text != NULL || takes_model(program);
    if (input[0] == '\0') {
        return error_set(error, "an empty name of a file; try --help");
    }
    if (!takes_input || options->input_count == (program->takes_models ? MODELS_LIMIT : 1)) {
        return error_set(error, "one argument too many: '%s'; try --help", input);
    }
    options->input[options->input_count++] = input;
    return true;
}

/* An option and its value, which is NULL at the end of the command line. Sets `count` to how many
 * arguments these are. */
static bool parse_option(struct options *options, const char *name, const char *value, int *count,
                         struct error *error) {
    const struct program *program = options->program;
    const struct option *option = find_option(program, name);
    if (option == NULL) {
        return error_set(error, "unknown option '%s'; try --help", name);
    }
    bool takes_value = option->value[0] != '\0';
    *count = takes_value ? 2 : 1;
    if (takes_value && value == NULL) {
        return error_set(error, "%s wants %s%s", name, option->wants,
                         details_of(option, program).text);
    }
    return option->parse(value, (char *)options + option->field) ||
           error_set(error, "%s wants %s%s, not '%s'", name, option->wants,
                     details_of(option, program).text, value);
}

bool options_parse(struct options *options, const struct program *program, int argc, char **argv,
                   struct error *error) {
    *options = (struct options){.program = program, .format = &image_file_formats[0]};
    int count = 1;
    bool ended = false; /* by "--": what follows is no option, whatever it begins with */
    for (int i = 1; i < argc; i += count) {
        bool is_input = ended || argv[i][0] != '-' || strcmp(argv[i], "-") == 0;
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        count = 1;
        if (!ended && strcmp(argv[i], "--") == 0) {
            ended = true;
            continue;
        }
        if (is_input ? !parse_input(options, argv[i], error)
                     : !parse_option(options, argv[i], value, &count, error)) {
            return false;
        }
    }
    if (options->only != NULL && program->draw_text != NULL && options->input_count > 0) {
        return error_set(error, "--only and a text scene do not go together");
    }
    return true;
}

/* ---- Help ---- */

void options_print_help(const struct program *program) {
    const char *input = program->draw_text != NULL ? " [scene.txt]"
                        : takes_model(program)     ? " [model.obj | model.off]"
                                                   : "";
    printf("%s: %s\n\n", program->name, program->summary);
    printf("usage: %s [options]%s%s\n\n", program->name, input, program->takes_models ? "..." : "");
    for (size_t i = 0; i < OPTIONS_KNOWN; i++) {
        const struct option *option = &options_known[i];
        if (takes_option(program, option)) {
            int width = HELP_COLUMN - (int)strlen(option->name);
            printf("  %s %-*s%s%s\n", option->name, width, option->value, option->help,
                   details_of(option, program).text);
        }
    }
    printf("\nWithout -o the images go to %s/%s\n", OUTPUT_DIRECTORY, program->name);
    if (program->draw_text != NULL) {
        printf("A text scene draws what its lines say; '-' reads standard input.\n");
    } else if (takes_model(program)) {
        printf("Without a model: %s/%s\n", MODELS_DIRECTORY, DEFAULT_MODEL);
    }
    printf("Version %s of the course\n", COURSE_VERSION);
}
