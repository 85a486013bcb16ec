/* The frame that all programs share: options, scenes, files, errors, exit statuses. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/image_file.h"
#include "program.h"
#include "run/live.h"
#include "unit/place.h"
#include "unit/streams.h"

#include <fcntl.h>
#include <time.h>

/* ---- A program to try ---- */

struct probe_state {
    size_t width, height; /* of a frame, as prepare() got them */
};

static int prepare_calls, finish_calls, draw_calls;
static struct drawing last_drawing;

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    struct probe_state *state = drawing->state;
    (void)error;
    prepare_calls++;
    *state = (struct probe_state){width, height};
    return true;
}

static void finish(struct drawing *drawing) {
    (void)drawing;
    finish_calls++;
}

static bool draw_dot(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct probe_state *state = drawing->state;
    CHECK(state->width == image->width && state->height == image->height);
    struct color before = image_get(image, 1, 1); /* cleared, also before it is drawn again */
    CHECK(before.r == 0 && before.g == 0 && before.b == 0);
    image_set(image, 0, 0, color_rgb(9, 0, 0));
    image_set(image, 1, 1, color_rgb(1, 2, (uint8_t)(3 + drawing->frame)));
    drawing_count(drawing, "dots", 1);
    drawing_count(drawing, "dots", 2);
    drawing_count(drawing, "other", 7);
    if (drawing->probed) {
        drawing_note(drawing, "here and");
        drawing_note(drawing, "there");
    }
    draw_calls++;
    last_drawing = *drawing;
    return true;
}

static bool draw_nothing(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)image, (void)error;
    return true;
}

static bool draw_failing(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)image;
    return error_set(error, "cannot draw this");
}

static bool draw_text_scene(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    CHECK(drawing->text != NULL && drawing->text->shape_count == 1);
    image_set(image, (int)drawing->text->shapes[0].x[0], 0, drawing->text->shapes[0].color[0]);
    return true;
}

#define PROBE(scenes_of)                                                                           \
    .name = "probe", .summary = "a program to try", .scenes = (scenes_of),                         \
    .scene_count = sizeof(scenes_of) / sizeof(scenes_of)[0]

static const struct scene scenes[] = {
    {.name = "dot",
     .width = 4,
     .height = 3,
     .draw = draw_dot,
     .eye = {0, 0, 3},
     .up = {0, 1, 0},
     .light = {0, 0, 1}},
    {.name = "film", .width = 5, .height = 4, .frames = 3, .draw = draw_dot, .eye = {0, 0, 3}},
    {.name = "more", .width = 4, .height = 3, .frames = 2, .extra = true, .draw = draw_dot},
};

static const struct program dot_program = {
    PROBE(scenes),       .takes_camera = true,
    .takes_light = true, .state_size = sizeof(struct probe_state),
    .prepare = prepare,  .finish = finish,
};

static const struct scene failing_scenes[] = {
    {.name = "bad", .width = 4, .height = 3, .draw = draw_failing},
};

static const struct program failing_program = {PROBE(failing_scenes)};

static const struct program text_program = {
    PROBE(failing_scenes),
    .text_kind = TEXT_SCENE_LINES,
    .draw_text = draw_text_scene,
    .defaults = {.width = 5, .height = 5},
};

static const struct scene model_scenes[] = {
    {.name = "model", .width = 4, .height = 3, .draw = draw_failing, .needs = NEEDS_MODEL},
};

static const struct program model_program = {PROBE(model_scenes)};
static const struct program several_program = {PROBE(model_scenes), .takes_models = true};

/* A copy of the program, with other scenes. */
static struct program with_scenes(const struct program *program, const struct scene *other,
                                  size_t count) {
    struct program changed = *program;
    changed.scenes = other;
    changed.scene_count = count;
    return changed;
}

/* ---- Running it ---- */

enum { ARGUMENT_LIMIT = 16, OUTPUT_LIMIT = 8192 };

static struct place place;        /* where they all work */
static char output[OUTPUT_LIMIT]; /* standard output and error of the last run */
static size_t output_size;

static void keep_output(int file) {
    ssize_t size = pread(file, output, sizeof output - 1, 0);
    output_size = size > 0 ? (size_t)size : 0;
    output[output_size] = '\0';
    close(file);
}

/* Run in the directory with arguments separated by blanks ('' is empty); fills `output`. */
static int run(const struct program *program, const char *arguments) {
    static char copy[OUTPUT_LIMIT];
    char *argv[ARGUMENT_LIMIT] = {(char *)"probe"};
    int argc = 1;
    snprintf(copy, sizeof copy, "%s", arguments);
    for (char *word = strtok(copy, " "); word != NULL; word = strtok(NULL, " ")) {
        argv[argc++] = strcmp(word, "''") == 0 ? (char *)"" : word;
    }
    int kept_directory = open(".", O_RDONLY);
    CHECK(chdir(place.directory) == 0);
    int file = open("output", O_CREAT | O_TRUNC | O_RDWR, 0600);
    struct streams streams = streams_lead(-1, file, file);
    int status = program_main(program, argc, argv);
    streams_restore(&streams);
    keep_output(file);
    CHECK(fchdir(kept_directory) == 0);
    close(kept_directory);
    return status;
}

static bool exists(const char *name) {
    return file_exists(name_file(&place, name));
}

static void put_file(const char *name, const char *text) {
    CHECK(put_text(name_file(&place, name), text));
}

static struct image picture; /* the last one that was read */

static bool read_image(const char *name, size_t width, size_t height) {
    struct error error;
    image_free(&picture);
    return CHECK(image_read(&picture, name_file(&place, name), &error)) &&
           CHECK(picture.width == width && picture.height == height);
}

/* Run, and compare the status and everything printed. */
#define CHECK_RUN(program, arguments, status, printed)                                             \
    (CHECK(run((program), (arguments)) == (status)), CHECK_TEXT(output, printed))

/* ---- Tests ---- */

static void test_begin(void) {
    place = place_create();
    CHECK(place_count(&place) == 0);
}

static void test_usage(void) {
    static const struct {
        const char *arguments, *message;
    } rows[] = {
        {"--what", "probe: unknown option '--what'; try --help\n"},
        {"-s", "probe: -s wants WxH: each 1 to 16384\n"},
        {"-s 10", "probe: -s wants WxH: each 1 to 16384, not '10'\n"},
        {"-s 0x10", "probe: -s wants WxH: each 1 to 16384, not '0x10'\n"},
        {"-s 10x16385", "probe: -s wants WxH: each 1 to 16384, not '10x16385'\n"},
        {"-s 10x0", "probe: -s wants WxH: each 1 to 16384, not '10x0'\n"},
        {"--only what", "probe: --only wants a scene or all: dot, film, more, not 'what'\n"},
        {"--format gif", "probe: --format wants a format: tga, png or ppm, not 'gif'\n"},
        {"--eye 1,2", "probe: --eye wants three numbers X,Y,Z, not '1,2'\n"},
        {"--light 1,nan,3",
         "probe: --light wants three numbers X,Y,Z that are not all 0, not '1,nan,3'\n"},
        {"--light 0,-0,1e-999",
         "probe: --light wants three numbers X,Y,Z that are not all 0, not '0,-0,1e-999'\n"},
        {"--fit", "probe: unknown option '--fit'; try --help\n"}, /* no scene has a model */
        {"--repeat 0", "probe: --repeat wants a number: 1 to 1000000, not '0'\n"},
        {"--repeat 1000001", "probe: --repeat wants a number: 1 to 1000000, not '1000001'\n"},
        {"''", "probe: an empty name of a file; try --help\n"},
        {"-o ''", "probe: -o wants a directory, not ''\n"},
        {"one.obj", "probe: one argument too many: 'one.obj'; try --help\n"},
        {"--eye 0,0,0", "probe: scene dot: the eye and the center are the same point\n"},
        {"--eye 0.9e-140,0,0",
         "probe: scene dot: the eye and the center are too near to each other\n"},
        {"--eye 1.1e18,0,0",
         "probe: scene dot: the eye and the center are too far from each other\n"},
        {"--eye 1e308,0,0 --center -1e308,0,0",
         "probe: scene dot: the eye and the center are too far from each other\n"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        draw_calls = 0;
        CHECK_ROW(run(&dot_program, rows[i].arguments) == 2, rows[i].arguments);
        CHECK_TEXT(output, rows[i].message);
        CHECK(draw_calls == 0);
    }
    CHECK_RUN(&failing_program, "--eye 1,2,3", 2,
              "probe: unknown option '--eye'; try --help\n"); /* a program without a camera */
    CHECK_RUN(&several_program, "a.obj b.obj c.obj d.obj e.obj", 2,
              "probe: one argument too many: 'e.obj'; try --help\n");
    CHECK(run(&text_program, "--only bad scene.txt") == 2);
}

static void test_help(void) {
    CHECK(run(&dot_program, "--help") == 0);
    CHECK(strstr(output, "probe: a program to try") != NULL);
    CHECK(strstr(output, "usage: probe [options]\n\n") != NULL);
    CHECK(strstr(output, "dot, film, more\n") != NULL);
    CHECK(strstr(output, "--eye") != NULL);
    CHECK(strstr(output, "/out/probe\n") != NULL);
    CHECK(run(&failing_program, "-h") == 0);
    CHECK(strstr(output, "--eye") == NULL && strstr(output, "--light") == NULL);
    CHECK(strstr(output, "standard input") == NULL);
    static const struct scene_value shared[] = {{"power", "of the light", 0, 9, 1, 3},
                                                {.name = NULL}};
    static const struct scene three[] = {
        {.name = "a", .width = 4, .height = 3, .values = shared, .draw = draw_dot},
        {.name = "b", .width = 4, .height = 3, .values = shared, .draw = draw_dot},
        {.name = "c", .width = 4, .height = 3, .draw = draw_dot}};
    struct program sharing = with_scenes(&dot_program, three, 3);
    CHECK(run(&sharing, "-h") == 0); /* a list that two scenes share is printed once */
    const char *found = strstr(output, "power of");
    CHECK(found != NULL && strstr(found + 1, "power of") == NULL);
    CHECK(run(&text_program, "-h") == 0);
    CHECK(strstr(output, "'-' reads standard input.\n") != NULL);
    CHECK(strstr(output, "usage: probe [options] [scene.txt]\n\n") != NULL);
    CHECK(run(&several_program, "-h") == 0);
    CHECK(strstr(output, "usage: probe [options] [model.obj | model.off]...\n\n") != NULL);
    CHECK(strstr(output, "/models/bust.obj\n") != NULL);
    for (char *line = strstr(output, "\n  -") + 1; line[2] == '-'; line = strchr(line, '\n') + 1) {
        CHECK_ROW(line[19] == ' ' && line[20] != ' ', line); /* all texts begin in a column */
    }
}

/* A scene that is no part of the lesson is drawn when it is named. */
static void test_extra(void) {
    CHECK(run(&dot_program, "-o out/deep") == 0);
    CHECK(exists("out/deep/dot.tga") && exists("out/deep/film.tga"));
    CHECK(!exists("out/deep/more.tga"));
    CHECK(run(&dot_program, "-o out/deep --only more") == 0);
    CHECK(exists("out/deep/more.tga"));
}

/* The frames of an animation; 0 in a plain PNG. */
static size_t count_frames(const char *path) {
    struct error error;
    struct bytes file = {0};
    size_t frames = 0;
    CHECK(file_read(name_file(&place, path), &file, &error));
    for (size_t i = 0; i + 4 <= file.size; i++) {
        frames += memcmp(file.data + i, "fcTL", 4) == 0;
    }
    bytes_free(&file);
    return frames;
}

static void test_formats(void) {
    CHECK_RUN(&dot_program, "-o out/deep --only dot", 0, "out/deep/dot.tga\n");
    CHECK(read_image("out/deep/dot.tga", 4, 3));
    CHECK(image_get(&picture, 1, 1).r == 1 && image_get(&picture, 1, 1).b == 3);
    CHECK(run(&dot_program, "-o out --only dot --format png -s 7x9") == 0);
    CHECK(read_image("out/dot.png", 7, 9));
    CHECK(image_get(&picture, 1, 1).r == 1 && image_get(&picture, 1, 1).b == 3);
    CHECK(count_frames("out/dot.png") == 0);
    CHECK(run(&dot_program, "-o out --only dot --format ppm") == 0);
    CHECK(exists("out/dot.ppm"));
    CHECK(!exists("out/dot.tga")); /* only what was asked for */
}

static void test_frames(void) {
    CHECK(run(&dot_program, "-o out --only film") == 0);
    /* Three frames of 2x2 on a sheet of two columns, the first one top left. */
    CHECK(read_image("out/film.tga", 5, 4));
    CHECK(image_get(&picture, 0, 2).r == 9 && image_get(&picture, 1, 3).b == 3 &&
          image_get(&picture, 3, 3).b == 4);
    CHECK(image_get(&picture, 1, 1).b == 5 && image_get(&picture, 3, 1).b == 0);
    CHECK(run(&dot_program, "-o out --only film --format png") == 0);
    CHECK(count_frames("out/film.png") == 3);
    CHECK(read_image("out/film.png", 5, 4)); /* in an animation each frame has the size */
    CHECK_RUN(&dot_program, "-o out --only film -s 1x9", 2,
              "probe: scene film: 3 frames need at least 2x2 pixels\n");
    CHECK_RUN(&dot_program, "-o out --only film -s 9x1", 2,
              "probe: scene film: 3 frames need at least 2x2 pixels\n");
    CHECK(run(&dot_program, "-o out --only film -s 1x1 --format png") == 0); /* no sheet */
}

static void test_stats_and_repeat(void) {
    CHECK_RUN(&dot_program, "-o out --only dot --stats", 0, "dot.dots: 3\ndot.other: 7\n");
    prepare_calls = finish_calls = draw_calls = 0;
    CHECK(run(&dot_program, "-o out --only dot --stats --repeat 5") == 0);
    CHECK(draw_calls == 5 && prepare_calls == 1 && finish_calls == 1);
    CHECK(strstr(output, "dot: ") == output && strstr(output, " ms\n") != NULL);
    CHECK(strstr(output, "dot.dots: 3\n") != NULL); /* of one drawing, not of five */
    CHECK(run(&dot_program, "-o out --only dot --repeat 1") == 0 && strstr(output, " ms\n"));
}

/* Takes at least that long, and every other time, from the first on, eight times as long. */
enum { SLOW_MS = 3 };
static int slow_calls;

static bool draw_slowly(struct drawing *drawing, struct image *image, struct error *error) {
    const struct timespec pause = {.tv_nsec = SLOW_MS * 1000000 * (slow_calls++ % 2 == 0 ? 8 : 1)};
    (void)drawing, (void)image, (void)error;
    nanosleep(&pause, NULL);
    return true;
}

static const struct scene slow_scenes[] = {
    {.name = "slow", .width = 1, .height = 1, .draw = draw_slowly},
};

static const struct program slow_program = {PROBE(slow_scenes)};

/* The median time of `repeat` drawings is at least `least` milliseconds, and at most half of the
 * whole run. */
static void check_time(int repeat, double least) {
    struct timespec begin, end;
    char arguments[32];
    double time = -1;
    slow_calls = 0;
    snprintf(arguments, sizeof arguments, "-o out --repeat %d", repeat);
    clock_gettime(CLOCK_MONOTONIC, &begin);
    CHECK(run(&slow_program, arguments) == 0);
    clock_gettime(CLOCK_MONOTONIC, &end);
    double whole =
        (double)(end.tv_sec - begin.tv_sec) * 1e3 + (double)(end.tv_nsec - begin.tv_nsec) * 1e-6;
    const char *line = strstr(output, "slow: ");
    CHECK(line != NULL && sscanf(line, "slow: %lf ms\n", &time) == 1);
    CHECK(time >= least - 0.001 && time < whole / 2); /* printed with three digits */
}

static void test_repeat_time(void) {
    check_time(3, 8 * SLOW_MS);   /* two are at least as long as the median */
    check_time(2, 4.5 * SLOW_MS); /* the mean of both */
}

static void test_camera(void) {
    CHECK(run(&dot_program, "-o out --only dot -s 16384x2 --frame 1000000") ==
          0); /* as large as they get */
    CHECK(run(&dot_program, "-o out --only dot --eye 0,1.1e-140,0") == 0); /* as near, */
    CHECK(run(&dot_program, "-o out --only dot --eye 0,0,0.9e18") == 0);   /* and as far */
    CHECK(run(&dot_program, "-o out --only dot --no-skip") == 0);
    CHECK(last_drawing.eye.z == 3 && last_drawing.up.y == 1 && !last_drawing.skip);
    CHECK(run(&dot_program, "-o out --only dot --eye 1,-2.5,3e1 --light 0,1,0 --up 2,0,0") == 0);
    CHECK(last_drawing.eye.x == 1 && last_drawing.eye.y == -2.5 && last_drawing.eye.z == 30);
    CHECK(last_drawing.light.y == 1 && last_drawing.light.z == 0 && last_drawing.skip);
    CHECK(last_drawing.up.x == 2 && last_drawing.up.y == 0);
}

static void test_failures(void) {
    CHECK_RUN(&failing_program, "-o nothing --repeat 2", 1, "probe: cannot draw this\n");
    CHECK_RUN(&text_program, "-o nothing --only bad", 1,
              "probe: cannot draw this\n"); /* without a text: its own scenes */
    CHECK(!exists("nothing"));
    CHECK(run(&dot_program, "-o output/dir") == 1); /* `output` is a file */
    CHECK(strstr(output, "probe: output") == output);
    CHECK_RUN(&model_program, "missing.obj", 1, "probe: missing.obj: No such file or directory\n");
    CHECK_RUN(&text_program, "missing.txt", 1, "probe: missing.txt: No such file or directory\n");
    CHECK(run(&dot_program, "-o /proc/nothing/here") == 1);
    CHECK(strstr(output, "probe: /proc/nothing: cannot make the directory: ") == output);
}

static void test_text_scene(void) {
    static const char with_size[] = "size 9 8\nline 3 0 4 0 10 20 30\n";
    static const char without[] = "line 2 0 4 0 10 20 30\n";
    put_file("a.b.txt", with_size);
    put_file("plain", without);
    CHECK_RUN(&text_program, "-o out a.b.txt", 0, "out/a.b.tga\n");
    CHECK(read_image("out/a.b.tga", 9, 8) && image_get(&picture, 3, 0).g == 20);
    CHECK(run(&text_program, "-o out ./plain") == 0);
    CHECK(read_image("out/plain.tga", 5, 5));
    CHECK(run(&text_program, "-o out -s 6x7 a.b.txt") == 0); /* the option wins */
    CHECK(read_image("out/a.b.tga", 6, 7));
}

/* ---- What scenes need ---- */

static const char *const mapped_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";

static bool draw_plain(struct drawing *drawing, struct image *image, struct error *error) {
    (void)image, (void)error;
    CHECK(drawing->model == NULL && drawing->diffuse == NULL && drawing->depth == NULL);
    last_drawing = *drawing;
    return true;
}

static const struct scene needs_scenes[] = {
    {.name = "plain", .light = {0, 0, 7}, .draw = draw_plain},
    {.name = "depth", .needs = NEEDS_MODEL | NEEDS_DEPTH, .draw = draw_nothing},
    {.name = "diffuse", .needs = NEEDS_DIFFUSE, .draw = draw_nothing},
};

static const struct program needs_program = {
    PROBE(needs_scenes),
    .takes_light = true,
    .defaults = {.width = 4, .height = 3, .light = {0, 1, 0}},
};

/* What no chosen scene needs is not read. (What it needs: test_stage.c.) */
static void test_needs(void) {
    CHECK_RUN(&needs_program, "-o out --only plain --stats missing.obj", 0, ""); /* no model */
    CHECK(last_drawing.light.z == 7 && last_drawing.light.y == 0);
    CHECK_RUN(&needs_program, "-o out --only plain --light 1,0,0", 0,
              "out/plain.tga\n"); /* black, but no model belongs into it */
    CHECK(last_drawing.light.x == 1 && last_drawing.light.z == 0);
    put_file("hide.mtl", "newmtl a\nd 0\n");
    put_file("hide.obj", "mtllib hide.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK_RUN(&needs_program, "-o out --only diffuse hide.obj", 0,
              "probe: scene diffuse: nothing was drawn: its materials hide all faces (d 0)\n"
              "out/diffuse.tga\n");
    struct program finishing = needs_program; /* what was never prepared needs no finish */
    finishing.finish = finish;
    finish_calls = 0;
    CHECK(run(&finishing, "-o out --only depth missing.obj") == 1 && finish_calls == 0);
}

/* Run with this text as standard input. */
static int run_with_input(const struct program *program, const char *arguments, const char *input) {
    put_file("input", input);
    int file = open(name_file(&place, "input"), O_RDONLY);
    struct streams streams = streams_lead(file, -1, -1);
    int status = run(program, arguments);
    clearerr(stdin);
    streams_restore(&streams);
    close(file);
    return status;
}

static bool draw_places(struct drawing *drawing, struct image *image, struct error *error) {
    (void)image, (void)error;
    CHECK(drawing->model->uv_count == 3);
    draw_calls++;
    return true;
}

/* A request is one frame, of the animation too. What any scene needs of a model is read for the
 * first. */
static void test_live(void) {
    static const struct scene scenes_of_model[] = {
        {.name = "model", .needs = NEEDS_MODEL, .draw = draw_places},
        {.name = "diffuse", .needs = NEEDS_DIFFUSE, .draw = draw_places},
    };
    struct program program = with_scenes(&needs_program, scenes_of_model, 2);
    char request[6000] = "";
    for (int i = 0; i < 300; i++) { /* more than a request may have */
        string_append(request, sizeof request, "--stats ");
    }
    draw_calls = finish_calls = 0;
    CHECK(run_with_input(&dot_program, "--live", request) == 0);
    CHECK(draw_calls == 1 && finish_calls == 1 && strstr(output, "\nframe 4 3 ") != NULL);
    snprintf(request, sizeof request, "--only film%5000s --frame 6\r\n", ""); /* all around */
    CHECK(run_with_input(&dot_program, "--live", request) == 0);
    CHECK(draw_calls == 2 && last_drawing.frame == 2 && strstr(output, " 2\ndots 3\nother 7\n"));
    CHECK(memcmp(output + output_size - 36, "\1\2\5\377", 4) == 0); /* x = 1, y = 1 */
    CHECK(run_with_input(&dot_program, "--live", "--only more\n") == 0);
    CHECK(draw_calls == 3 && last_drawing.frame == 0);
    put_file("mapped.obj", mapped_obj);
    CHECK(run_with_input(&program, "--live mapped.obj", "--only model\n") == 0);
    CHECK(draw_calls == 4);
    CHECK(run_with_input(&dot_program, "--live", "--probe 1,0\n--only film --probe 0,1\n") == 0);
    CHECK(strstr(output, "\nerror") == NULL && last_drawing.probed && last_drawing.probe.x == 0 &&
          last_drawing.probe.y == 1);
    CHECK(strstr(output, " 4\ndots 3\nother 7\n here and\n there\n") != NULL);
    CHECK(run_with_input(&dot_program, "--live", "--probe 16384,0\n--probe 0,-1\n-s\n") == 0);
    CHECK(strstr(output, "\nerror -s wants WxH: each 1 to 16384\n") != NULL); /* no older word */
    const char *refused = strstr(output, "\nerror --probe wants a pixel X,Y");
    CHECK(refused != NULL && strstr(refused + 1, "\nerror --probe wants") != NULL);
    CHECK(run_with_input(&text_program, "--live", "text\nline 2 0 4 0 10 20 30\nend\n") == 0);
    const char *frame = strstr(output, "\nframe 5 5 ");
    CHECK(frame != NULL && strchr(frame + 1, '\n') + 1 + 100 == output + output_size);
    CHECK(memcmp(output + output_size - 12, "\12\24\36\377", 4) == 0); /* the third from the end */
    CHECK(run_with_input(&text_program, "--live", "text\nends\n\nend\ntext\nlines\nend") == 0);
    refused = strstr(output, "\nerror 'ends' is not known");
    CHECK(refused != NULL && strstr(refused, "\nerror 'lines' is not known") != NULL);
    CHECK(run_with_input(&dot_program, "--live", "text\nend\n") == 0);
    CHECK(strstr(output, "\nerror takes no text scene\n") != NULL);
}

/* What --live says first. */
static void test_description(void) {
    static const struct scene_value values[] = {
        {"a", "the first", 0, 1, 0.5, 1}, {"b", "the other", -2, 2, 1, 0}, {.name = NULL}};
    static const struct scene two_scenes[] = {
        {.name = "dot", .width = 4, .height = 3, .extra = true, .values = values},
        {.name = "model", .needs = NEEDS_MODEL, .light = {0, 0, 1}, .eye = {0, 0, 3}},
    };
    struct program program = with_scenes(&dot_program, two_scenes, 2);
    program.text = "a\nb";
    program.text_values = values + 1;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (CHECK(out != NULL)) {
        live_describe(&program, out);
        fclose(out);
        CHECK_TEXT(text,
                   "{\"program\":\"probe\",\"scenes\":[{\"name\":\"dot\",\"width\":4,\"height\":3,"
                   "\"frames\":1,\"extra\":true,\"values\":[{\"name\":\"a\",\"help\":\"the "
                   "first\",\"least\":0,"
                   "\"most\":1,\"step\":0.5,\"value\":1},{\"name\":\"b\",\"help\":\"the other\","
                   "\"least\":-2,\"most\":2,\"step\":1,\"value\":0}]},{\"name\":\"model\","
                   "\"width\":0,\"height\":0,\"frames\":1,"
                   "\"light\":[0,0,1],\"eye\":[0,0,3],\"center\":[0,0,0],\"up\":[0,0,0]},"
                   "{\"name\":\"your own\",\"frames\":1,\"text\":\"a\\nb\",\"values\":[{"
                   "\"name\":\"b\",\"help\":\"the other\",\"least\":-2,\"most\":2,\"step\":1,"
                   "\"value\":0}]}]}\n");
        free(text);
    }
}

/* The numbers of a scene: theirs, or what --set says. (In --live: test_live.sh.) */
static void test_set(void) {
    static const struct scene_value values[] = {
        {"size", "how large", 1, 9, 1, 5}, {"turn", "how far", -1, 1, 0.1, 0}, {.name = NULL}};
    static const struct scene two_scenes[] = {
        {.name = "one", .width = 4, .height = 3, .values = values + 1, .draw = draw_dot},
        {.name = "dot", .width = 4, .height = 3, .values = values, .draw = draw_dot}};
    struct program program = with_scenes(&dot_program, two_scenes, 2);
    CHECK(run(&program, "-o out") == 0 && !last_drawing.probed);
    CHECK(drawing_value(&last_drawing, "size") == 5 && drawing_value(&last_drawing, "turn") == 0);
    CHECK(run(&program, "-o out --set turn=-1 --set size=9") == 0);
    CHECK(drawing_value(&last_drawing, "size") == 9 && drawing_value(&last_drawing, "turn") == -1);
    CHECK(run(&program, "--set size=0") == 2 && run(&program, "--set size=a") == 2);
    CHECK_RUN(&program, "--set size=9.5", 2,
              "probe: --set wants NAME=N, a scene's number: turn of one, -1 to 1 (0); size of dot, "
              "1 to 9 (5); turn of dot, -1 to 1 (0), not 'size=9.5'\n");
    CHECK(drawing_value(&last_drawing, "siz") == 0);
    program.text_values = values + 1; /* a text scene has its own numbers */
    program.scenes = scenes;
    CHECK(run(&program, "-o out --set turn=1") == 0 && run(&program, "-o out --set size=5") == 2);
}

/* A point is two numbers; what is said about a pixel is lines, as many as there is room for. */
static void test_points_and_notes(void) {
    static const struct scene_value values[] = {
        {"a_x", "", -1, 1, 1, 0}, {"a_y", "", -1, 1, 1, 0}, {.name = NULL}};
    struct drawing drawing = {.values = values, .value = {0.25, -0.5}};
    struct vec2 a = drawing_point(&drawing, "a");
    CHECK(a.x == 0.25 && a.y == -0.5);
    for (int i = 0; i < NOTES_LIMIT; i++) {
        drawing_note(&drawing, "%d", i);
    }
    CHECK(strlen(drawing.notes) == NOTES_LIMIT - 1 && drawing.notes[NOTES_LIMIT - 1] == '\0');
}

static const char *expected_sight;

/* Corner 1 of face 0, its normal, and the first texels of the textures. */
static bool draw_sight(struct drawing *drawing, struct image *image, struct error *error) {
    const struct texture *textures[] = {drawing->diffuse, drawing->normal_map, drawing->specular};
    struct vec3 p = model_position(drawing->model, 0, 1), n = model_normal(drawing->model, 0, 1),
                zero = {0, 0, 0};
    char sight[200];
    (void)error;
    p = vec3_add(p, zero); /* no negative zeros */
    n = vec3_add(n, zero);
    snprintf(sight, sizeof sight, "%g %g %g, %g %g %g,", p.x, p.y, p.z, n.x, n.y, n.z);
    for (int i = 0; i < 3; i++) {
        const struct texture *t = textures[i];
        string_append(sight, sizeof sight, t == NULL ? " none" : " %X%s",
                      t == NULL ? 0 : t->level[0].texels[0],
                      t != NULL && t->tangent_space ? " tangent" : "");
    }
    CHECK_TEXT(sight, expected_sight);
    return image_set(image, 0, 0, color_rgb(0, 0, 1));
}

enum { ALL_TEXTURES = NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR };

#define MISSING  " next to it, nor other usual names; "
#define WHITE    "white instead (--texture)\n"
#define NORMALS  "the mesh's normals instead (--normal-map)\n"
#define SHINE    "the same shine everywhere instead (--specular)\n"
#define MAPPED   "vt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 1 0\nf 1/1/1 2/1/1 3/1/1\n"
#define PICTURES "out/one.tga\nout/two.tga\n"

/* What a model has not is replaced, which is said once; what the command line names must be there,
 * and counts before what is next to the model. */
static void test_replaced(void) {
    static struct scene two_scenes[] = {
        {.name = "one", .needs = ALL_TEXTURES, .width = 4, .height = 3, .draw = draw_sight},
        {.name = "two", .needs = ALL_TEXTURES, .width = 4, .height = 3, .draw = draw_sight},
    };
    const struct program program = {PROBE(two_scenes)};
    uint8_t levels[] = {255, 128, 128, 0, 0, 0};
    const struct image blue = {2, 1, IMAGE_BGR, levels}, grey = {1, 1, IMAGE_GREY, levels};
    const struct image given = {1, 1, IMAGE_BGR, levels};
    struct error error;
    put_file("wild.obj", MAPPED);
    expected_sight = "1 0 0, 0 1 0, FFFFFFFF none FF404040";
    CHECK_RUN(&program, "-o out wild.obj", 0,
              "probe: wild.obj: no wild_diffuse.tga, wild_nm.tga, wild_spec.tga" MISSING
              "white, the mesh's normals, the same shine everywhere instead "
              "(--texture, --normal-map, --specular)\n" PICTURES);
    put_file("wild_nm.JPG", "\xFF\xD8\xFF\xE0");
    CHECK_RUN(
        &program, "-o out --specular none.tga wild.obj", 1,
        "probe: wild.obj: no wild_diffuse.tga" MISSING WHITE
        "probe: wild_nm.JPG: a JPEG file, not a PNG, TGA or PPM file: `mogrify -format png *.JPG` "
        "makes PNG files, which are drawn then; " NORMALS
        "probe: none.tga: No such file or directory\n");
    CHECK(remove(name_file(&place, "wild_nm.JPG")) == 0);
    put_file("bare.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n"); /* no place in a picture */
    expected_sight = "0 0 1, 0 1 0, FFFFFFFF none FF404040";
    CHECK_RUN(&program, "-o out bare.obj", 0, PICTURES);
    CHECK_RUN(&program, "-o out --texture a.png bare.obj", 1,
              "probe: bare.obj: has no texture coordinates, without which a.png cannot be drawn\n");
    CHECK_RUN(&program, "-o out --texture a.png wild.obj", 1,
              "probe: wild.obj: no wild_nm.tga, wild_spec.tga" MISSING
              "the mesh's normals, the same shine everywhere instead (--normal-map, --specular)\n"
              "probe: a.png: No such file or directory\n");
    /* A map in tangent space, and files that cannot be read. */
    put_file("wild_diffuse.png", "\xFF\xD8\xFF\xE0");
    put_file("wild_spec.png", "nothing");
    CHECK(tga_write(&blue, name_file(&place, "wild_nm.tga"), &error));
    expected_sight = "1 0 0, 0 0 1, FFFFFFFF FF8080FF tangent FF404040"; /* the map stays */
    CHECK_RUN(
        &program, "-o out --turn 1,0,0 wild.obj", 0,
        "probe: wild_diffuse.png: a JPEG file, not a PNG, TGA or PPM file: `mogrify -format png "
        "wild_diffuse.png` makes PNG files, which are drawn then; " WHITE
        "probe: wild.obj: the normal map is blue, so it is read as one in "
        "tangent space, as if its name ended in _tangent\n"
        "probe: wild_spec.png: neither a PNG or PPM nor a TGA of a type that is supported; " SHINE
            PICTURES);
    levels[0] = 90;
    CHECK(tga_write(&given, name_file(&place, "given.tga"), &error) &&
          tga_write(&grey, name_file(&place, "wild_nm.tga"), &error));
    two_scenes[0].draw = draw_nothing;
    CHECK_RUN(&program,
              "-o out --only one --stats --texture given.tga --specular given.tga wild.obj", 0,
              "probe: wild_nm.tga: grey values: perhaps heights, but not normals; " NORMALS
              "probe: scene one: nothing was drawn\n"
              "files.textures_present: 3\nfiles.textures_read: 2\n");
    two_scenes[0].draw = draw_sight;
    expected_sight = "1 0 0, 0 1 0, FF80805A FF80805A FF80805A";
    CHECK_RUN(&program,
              "-o out --texture given.tga --normal-map given.tga --specular given.tga wild.obj", 0,
              PICTURES);
    expected_sight = "1 0 0, 0 1 0, FF80805A none FF404040"; /* faces have no material, then */
    put_file("wild4.obj", "mtllib none.mtl\nusemtl a\n" MAPPED);
    CHECK_RUN(&program, "-o out --only one --texture given.tga wild4.obj", 0,
              "probe: wild4.obj:1: 'none.mtl' is a file of materials that is not there: none of "
              "it is drawn\n"
              "probe: wild4.obj: no wild4_nm.tga, wild4_spec.tga" MISSING
              "the mesh's normals, the same shine everywhere instead (--normal-map, --specular)\n"
              "out/one.tga\n");
    /* Without a place in a picture none is looked for. */
    expected_sight = "0 0 1, 0 1 0, FFFFFFFF none FF404040";
    put_file("wild5.obj", "mtllib none.mtl\nusemtl a\nv 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n");
    CHECK_RUN(
        &program, "-o out --only one wild5.obj", 0,
        "probe: wild5.obj:1: 'none.mtl' is a file of materials that is not there: none of it is "
        "drawn\nout/one.tga\n");
    CHECK_RUN(&dot_program, "--texture given.tga", 2,
              "probe: unknown option '--texture'; try --help\n");
}

/* ---- Models out of view ---- */

static double farthest_corner; /* from the origin, of the last face drawn */

/* Sets a pixel, or a depth, for each corner in view. */
static bool draw_corners(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    farthest_corner = 0;
    for (size_t i = 0; i < 3; i++) {
        farthest_corner = fmax(farthest_corner, vec3_length(model_position(drawing->model, 0, i)));
        struct vec2 p = parallel_view(model_position(drawing->model, 0, i), 8, 8);
        if (p.x >= 0 && p.x < 8 && p.y >= 0 && p.y < 8 && drawing->depth == NULL) {
            image_set(image, (int)p.x, (int)p.y, color_grey(9));
        } else if (p.x >= 0 && p.x < 8 && p.y >= 0 && p.y < 8) {
            drawing->depth[(size_t)p.y * 8 + (size_t)p.x] = 0;
        }
    }
    if (drawing->depth != NULL) {
        image_clear(image, color_grey(50)); /* a background */
    }
    return true;
}

static const struct scene view_scenes[] = {
    {.name = "view", .needs = NEEDS_MODEL, .draw = draw_corners},
    {.name = "deep", .needs = NEEDS_MODEL | NEEDS_DEPTH, .draw = draw_corners},
};

static const struct program view_program = {
    PROBE(view_scenes),
    .takes_light = true,
    .defaults = {.width = 8, .height = 8, .eye = {0, 0, 3}, .light = {0, 1, 0}},
};

static const struct scene blank_scenes[] = {
    {.name = "blank", .needs = NEEDS_MODEL, .draw = draw_nothing},
};

static const char far_obj[] = "v 1000 1000 0\nv 1004 1000 0\nv 1000 1002 0\nv 9e9 0 0\nf 1 2 3\n";
static const char out_message[] =
    "probe: far.obj: reaches out of -1..1; --fit brings it into view\n";

#define NO_FRONT                                                                                   \
    "probe: scene blank: nothing was drawn: all faces look away or lie edge-on; what may help: "   \
    "--two-sided --turn\n"

/* What is said of a model; nothing where something is seen, or where nothing was asked. */
static void test_out_of_view(void) {
    struct program camera_program = view_program;
    char expected[400];
    camera_program.takes_camera = true;
    put_file("far.obj", far_obj);
    put_file("near.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK_RUN(&view_program, "-o out near.obj", 0, "out/view.tga\nout/deep.tga\n");
    CHECK_RUN(&view_program, "-o out --fit far.obj", 0, "out/view.tga\nout/deep.tga\n");
    CHECK(farthest_corner > 0.95); /* of a side from -0.95 to 0.95 */
    CHECK_RUN(&camera_program, "-o out --fit far.obj", 0, "out/view.tga\nout/deep.tga\n");
    CHECK(fabs(farthest_corner - 0.875) < 1e-12);
    CHECK(run(&view_program, "-o out far.obj") == 0);
    CHECK(strncmp(output, out_message, strlen(out_message)) == 0);
    snprintf(expected, sizeof expected,
             "%sprobe: scene view: nothing was drawn; what may help: --fit\n"
             "out/view.tga\nout/deep.tga\n",
             out_message);
    CHECK_TEXT(output, expected);
    CHECK_RUN(&camera_program, "-o out --only deep --eye 0,0,2 far.obj", 0,
              "probe: scene deep: nothing was drawn; what may help: --fit --center\n"
              "out/deep.tga\n"); /* placed by hand */
    /* An option that was given is not advised. */
    CHECK_RUN(&camera_program, "-o out --only deep --eye 0,0,2 --center 1,0,0 far.obj", 0,
              "probe: scene deep: nothing was drawn; what may help: --fit\nout/deep.tga\n");
    /* Without an option it is the lesson that is not written yet. */
    camera_program.scenes = blank_scenes;
    camera_program.scene_count = 1;
    CHECK_RUN(&camera_program, "-o out", 0, "out/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --fit near.obj", 0,
              "probe: scene blank: nothing was drawn; what may help: --light\n"
              "out/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --light 0,0,1 --fit", 0,
              "probe: scene blank: nothing was drawn\nout/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --eye 1,0,4 --fit near.obj", 0,
              "probe: scene blank: nothing was drawn; what may help: --center\n"
              "out/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --center 1,0,0 --fit", 0,
              "probe: scene blank: nothing was drawn\nout/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --eye 0,-9,-9 --fit near.obj", 0,
              NO_FRONT "out/blank.tga\n");
    camera_program.takes_camera = camera_program.takes_light = false;
    CHECK_RUN(&camera_program, "-o out --fit near.obj", 0,
              "probe: scene blank: nothing was drawn\nout/blank.tga\n");
    put_file("edge.obj", /* lies, and a face whose corners are in a row */
             "v 0.01 0.02 0.03\nv 0.04 0.05 0.06\nv 0.07 0.08 0.09\nv 1 0 1\nv -1 0 1\nv 1 0 -1\n"
             "f 2 1 3\nf 5 4 6\nf 1 1 2\n");
    put_file("away.obj", "v 0 0 0\nv 0 1 2\nv 1 0 2\nf 1 2 3\n"); /* up, right and away */
    CHECK_RUN(&camera_program, "-o out --fit edge.obj", 0, NO_FRONT "out/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --fit away.obj", 0, NO_FRONT "out/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --fit --two-sided edge.obj", 0,
              "probe: scene blank: nothing was drawn: all faces lie edge-on; what may help: "
              "--turn\nout/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --fit --turn 0,0,1 edge.obj", 0,
              "probe: scene blank: nothing was drawn: all faces look away or lie edge-on; what may "
              "help: --two-sided\nout/blank.tga\n");
    CHECK_RUN(&camera_program, "-o out --fit --turn 0,0,1 --two-sided edge.obj", 0,
              "probe: scene blank: nothing was drawn: all faces lie edge-on\nout/blank.tga\n");
}

/* What is much smaller than the view is drawn, but small; what is wrong with a file is passed over:
 * both are said once. */
static void test_tiny_and_wrong(void) {
    struct program blank = with_scenes(&view_program, blank_scenes, 1);
    put_file("tiny.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
    CHECK_RUN(&view_program, "-o out tiny.obj", 0,
              "probe: tiny.obj: fills little of -1..1; --fit makes it larger\n"
              "out/view.tga\nout/deep.tga\n");
    CHECK_RUN(&view_program, "-o out --fit tiny.obj", 0, "out/view.tga\nout/deep.tga\n");
    CHECK_RUN(&blank, "-o out tiny.obj", 0,
              "probe: tiny.obj: fills little of -1..1; --fit makes it larger\n"
              "probe: scene blank: nothing was drawn; what may help: --fit\nout/blank.tga\n");
    put_file("wild.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 2 3\n");
    CHECK_RUN(&view_program, "-o out wild.obj", 0,
              "probe: wild.obj:4: a face of fewer than 3 corners is not drawn\n"
              "out/view.tga\nout/deep.tga\n");
}

/* A roof of two faces that are wound otherwise, without normals: on the ridge each corner has the
 * mean of both, and not the normal of its own face, which leans by 45 degrees. */
static bool draw_roof(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < 3; i++) {
        double aside = fabs(model_normal(drawing->model, 0, i).x);
        CHECK(i == 1 ? aside > 0.7 : aside < 0.3);
    }
    return image_set(image, 0, 0, color_grey(1));
}

/* --turn: of the model with all that has a direction, before anything else. --two-sided: twice as
 * many faces, and a model that looks away is seen. */
static void test_turn_and_sides(void) {
    struct scene scene = {.name = "turned",
                          .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_NORMAL_MAP | NEEDS_DIFFUSE,
                          .draw = draw_sight};
    struct program program = with_scenes(&view_program, &scene, 1);
    uint8_t levels[] = {100, 60, 230}; /* blue, green, red */
    const struct image normal = {1, 1, IMAGE_BGR, levels};
    struct error error;
    put_file("up.obj", "vt 0 0\nv 0 0 0\nv 0.25 0.5 0.75\nv 0 1 0\nvn 0 1 2\n"
                       "f 1/1/1 2/1/1 3/1/1\n");
    CHECK(tga_write(&normal, name_file(&place, "up_nm.tga"), &error) &&
          tga_write(&normal, name_file(&place, "up_diffuse.tga"), &error));
    expected_sight = "0.25 -0.75 0.5, 0 -2 1, FFE63C64 FFE69B3C none";
    CHECK_RUN(&program, "-o out --turn 1,0,0 up.obj", 0, "out/turned.tga\n");
    CHECK_RUN(&program, "-o out --turn 1000000000001,4,-8 up.obj", 0, "out/turned.tga\n");
    expected_sight = "0.75 0.5 -0.25, 2 1 0, FFE63C64 FF643C19 none";
    CHECK_RUN(&program, "-o out --turn 0,1,0 up.obj", 0, "out/turned.tga\n");
    expected_sight = "-0.5 0.25 0.75, -1 0 2, FFE63C64 FFC3E664 none";
    CHECK_RUN(&program, "-o out --turn 0,0,-3 up.obj", 0, "out/turned.tga\n");
    scene.draw = draw_roof;
    scene.needs = NEEDS_MODEL | NEEDS_NORMALS;
    put_file("roof.obj", "v 0 0 1\nv 1 0 0\nv 0 1 1\nv -1 1 0\nf 1 2 3\nf 1 4 3\n");
    CHECK_RUN(&program, "-o out --smooth 90 --two-sided roof.obj", 0, "out/turned.tga\n");
    CHECK_RUN(&program, "--turn 0.5,0,0", 2,
              "probe: --turn wants three whole numbers X,Y,Z, not '0.5,0,0'\n");
    CHECK_RUN(&program, "--turn 1", 2, "probe: --turn wants three whole numbers X,Y,Z, not '1'\n");
    CHECK_RUN(&program, "--smooth 181", 2, "probe: --smooth wants degrees: 0 to 180, not '181'\n");
    CHECK_RUN(&program, "--smooth -1", 2, "probe: --smooth wants degrees: 0 to 180, not '-1'\n");
    CHECK_RUN(&program, "--smooth x", 2, "probe: --smooth wants degrees: 0 to 180, not 'x'\n");
    program.scenes = view_scenes;
    CHECK_RUN(&program, "-o out --fit --turn 0,3,0 far.obj", 0, "out/view.tga\n");
    CHECK(farthest_corner > 0.95);
    program.scenes = blank_scenes;
    CHECK_RUN(&program, "-o out --two-sided --fit away.obj", 0,
              "probe: scene blank: nothing was drawn; what may help: --light\nout/blank.tga\n");
}

static const struct scene detail_scenes[] = {
    {.name = "view", .needs = NEEDS_MODEL, .draw = draw_corners},
    {.name = "nose", .detail = true, .needs = NEEDS_MODEL, .draw = draw_corners},
    {.name = "ear", .detail = true, .needs = NEEDS_MODEL, .draw = draw_corners},
    {.name = "beard", .detail = true, .extra = true, .needs = NEEDS_MODEL, .draw = draw_corners},
};

/* Scenes that frame a part of the course's model are not drawn of another, unless by name. */
static void test_details(void) {
    const struct program program = with_scenes(&view_program, detail_scenes, 4);
    CHECK_RUN(&program, "-o out", 0, "out/view.tga\nout/nose.tga\nout/ear.tga\n");
    CHECK_RUN(&program, "-o out near.obj", 0, "out/view.tga\n");
    CHECK_RUN(&program, "-o out --only nose near.obj", 0, "out/nose.tga\n");
    CHECK_RUN(&program, "-o out --only all near.obj", 0,
              "out/view.tga\nout/nose.tga\nout/ear.tga\n");
    CHECK_RUN(&program, "-o out missing.obj", 1, "probe: missing.obj: No such file or directory\n");
}

/* One that cannot be drawn does not stop the others; each message once, and the status tells. */
static const struct scene partly_scenes[] = {
    {.name = "bad", .width = 4, .height = 3, .draw = draw_failing},
    {.name = "good", .width = 4, .height = 3, .draw = draw_nothing},
    {.name = "worse", .width = 4, .height = 3, .draw = draw_failing},
    {.name = "read", .width = 4, .height = 3, .needs = NEEDS_MODEL, .draw = draw_nothing},
    {.name = "last", .width = 4, .height = 3, .draw = draw_nothing},
};

static void test_failing_scenes(void) {
    struct program program = with_scenes(&view_program, partly_scenes, 3);
    CHECK_RUN(&program, "-o out", 1, "probe: cannot draw this\nout/good.tga\n");
    program.scene_count = 5;
    CHECK_RUN(&program, "-o out --only read missing.obj", 1,
              "probe: missing.obj: No such file or directory\n");
    CHECK_RUN(&program, "-o out missing.obj", 1,
              "probe: cannot draw this\nprobe: missing.obj: No such file or directory\n"
              "out/good.tga\n"); /* what would come of it cannot be known */
}

/* ---- Seldom ways ---- */

static bool prepare_nothing(struct drawing *drawing, size_t width, size_t height,
                            struct error *error) {
    (void)drawing, (void)width, (void)height;
    prepare_calls++;
    return error_set(error, "cannot prepare this");
}

static bool draw_grey(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    draw_calls++;
    return image_set(image, 0, 0, color_grey(77));
}

static const struct scene grey_scenes[] = {
    {.name = "grey", .width = 4, .height = 3, .format = IMAGE_GREY, .draw = draw_grey},
    {.name = "far", .width = 4, .height = 3, .draw = draw_grey, .eye = {0, 0, 9}},
};

static const struct program grey_program = {PROBE(grey_scenes), .takes_camera = true};

static const struct program unprepared_program = {PROBE(grey_scenes), .prepare = prepare_nothing,
                                                  .finish = finish};

static void test_grey(void) {
    struct error error;
    struct bytes file;
    /* no camera: eye and center are equal */
    CHECK_RUN(&grey_program, "-o out --only grey --format ppm", 0, "out/grey.pgm\n");
    if (CHECK(file_read(name_file(&place, "out/grey.pgm"), &file, &error))) {
        CHECK(file.size > 2 && memcmp(file.data, "P5", 2) == 0);
        bytes_free(&file);
    }
    CHECK(run(&grey_program, "-o out --only grey --center 0,0,9") == 0); /* the eye of the other */
}

/* After "--" nothing is an option. */
static void test_end_of_options(void) {
    CHECK_RUN(&model_program, "-- -x.obj", 1, "probe: -x.obj: No such file or directory\n");
    CHECK_RUN(&model_program, "--fit -- --stats", 1, "probe: --stats: No such file or directory\n");
    CHECK_RUN(&model_program, "-- --", 1, "probe: --: No such file or directory\n");
    CHECK_RUN(&model_program, "-- -a -b", 2, "probe: one argument too many: '-b'; try --help\n");
    CHECK_RUN(&model_program, "-s -- -b", 2, "probe: -s wants WxH: each 1 to 16384, not '--'\n");
    CHECK(run(&dot_program, "-o out --only dot --") == 0);
}

static void test_unprepared(void) {
    prepare_calls = finish_calls = draw_calls = 0;
    CHECK_RUN(&unprepared_program, "-o nothing", 1, "probe: cannot prepare this\n");
    CHECK(prepare_calls == 2 && finish_calls == 2 && draw_calls == 0); /* both scenes */
}

/* Standard output is full: the image is there, but nobody was told. The second time it was full
 * before, and what was lost then is still an error. */
static void test_full_output(void) {
    int full = open("/dev/full", O_WRONLY);
    if (full < 0) { /* not every system has one */
        printf("skipped: there is no /dev/full\n");
        CHECK(true);
        return;
    }
    int errors = open(name_file(&place, "output"), O_CREAT | O_TRUNC | O_RDWR, 0600);
    char *argv[] = {(char *)"probe", (char *)"-o", (char *)name_file(&place, "out"),
                    (char *)"--stats"};
    struct streams streams = streams_lead(-1, full, errors);
    CHECK(program_main(&dot_program, 4, argv) == 1);
    clearerr(stdout);
    printf("lost");
    fflush(stdout);
    int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1);
    CHECK(program_main(&dot_program, 4, argv) == 1);
    clearerr(stdout);
    close(nowhere);
    streams_restore(&streams);
    keep_output(errors);
    CHECK(strstr(output, "probe: cannot write to standard output: ") == output);
    close(full);
}

/* "-" is standard input, its image is called stdin; a hidden file has no extension to drop. */
static void test_text_names(void) {
    static const char text[] = "line 2 0 4 0 10 20 30\n";
    CHECK(run_with_input(&text_program, "-o out -", text) == 0);
    CHECK_TEXT(output, "out/stdin.tga\n");
    put_file(".txt", text);
    CHECK_RUN(&text_program, "-o out .txt", 0, "out/.txt.tga\n");
}

/* Last: remove what the others left. */
static void test_clean_up(void) {
    image_free(&picture);
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", place.directory);
    CHECK(system(command) == 0);
}

/* --live makes standard output line-buffered: it comes last. */
UNIT_MAIN(TEST(test_begin), TEST(test_usage), TEST(test_help), TEST(test_extra), TEST(test_formats),
          TEST(test_frames), TEST(test_stats_and_repeat), TEST(test_repeat_time), TEST(test_camera),
          TEST(test_failures), TEST(test_text_scene), TEST(test_needs), TEST(test_description),
          TEST(test_set), TEST(test_points_and_notes), TEST(test_grey), TEST(test_out_of_view),
          TEST(test_replaced), TEST(test_tiny_and_wrong), TEST(test_turn_and_sides),
          TEST(test_details), TEST(test_failing_scenes), TEST(test_end_of_options),
          TEST(test_unprepared), TEST(test_full_output), TEST(test_text_names), TEST(test_live),
          TEST(test_clean_up))
