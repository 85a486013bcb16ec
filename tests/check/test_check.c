/*
 * Tests of the check itself: for each way to fail, a small program in tests/check/wrong that fails
 * in that way, and the line that the check must print for it.
 *
 * Run it from the course's root directory. It needs the check, built: in the directory that
 * CHECK_PROGRAMS names in the environment, or where the Makefile puts it. All it writes goes to a
 * temporary directory.
 */
#define _POSIX_C_SOURCE 200809L

#include "check/wrong/picture.h"

#include "base/bytes.h"
#include "base/error.h"
#include "base/file.h"
#include "fault.h"
#include "files/image_file.h"
#include "files/png.h"
#include "unit/unit.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { ARGUMENT_LIMIT = 24, PATH_LIMIT = 1024 };

/* Made once, before the tests, which only read it. */
static struct fixture {
    char directory[64]; /* of all that is written */
    char here[512];     /* the course's root */
    char programs[600]; /* with check in it */
    int status;         /* of a check of all the wrong programs; the file `all` is what it said */
    const char *build_timeout;
    int closed;           /* a standard file that the check is called without, or -1 */
    struct bytes witness; /* what those programs have told: process numbers, NUL at its end */
} fixture;

struct path {
    char text[PATH_LIMIT];
};

/* A name in the temporary directory. */
static struct path inside(const char *name) {
    struct path path;
    snprintf(path.text, sizeof path.text, "%s/%s", fixture.directory, name);
    return path;
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec / 1e9;
}

static void sleep_ms(long ms) {
    nanosleep(&(struct timespec){.tv_sec = ms / 1000, .tv_nsec = ms % 1000 * 1000000}, NULL);
}

/* The file's contents with a NUL at the end; empty when it cannot be read. */
static struct bytes read_text(const char *path) {
    struct bytes text = {.data = NULL};
    struct error error;
    file_read(path, &text, &error);
    bytes_append(&text, "", 1);
    return text;
}

static bool contains(const struct bytes *text, const char *part) {
    return strstr((const char *)text->data, part) != NULL;
}

/* ---- Running the programs under test ---- */

/* Start a program with its output and errors going to files; `timeout` is CHECK_TIMEOUT. */
static pid_t start(const char *name, const char *timeout, const char *const *arguments) {
    fflush(NULL);
    pid_t id = fork();
    if (id != 0) {
        return id;
    }
    char program[PATH_LIMIT];
    snprintf(program, sizeof program, "%s/%s", fixture.programs, name);
    int output = open(inside("output").text, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    int errors = open(inside("errors").text, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(output, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    if (fixture.closed >= 0) {
        close(output);
        close(errors);
        close(fixture.closed);
    }
    signal(SIGINT, SIG_DFL); /* a shell ignores it for what it runs in the background */
    setenv("TMPDIR", inside("tmp").text, 1);
    setenv("WITNESS", inside("witness").text, 1);
    setenv("CHECK_TIMEOUT", timeout, 1);
    setenv("CHECK_BUILD_TIMEOUT", fixture.build_timeout, 1);
    setenv("MAKEFLAGS", "s", 1); /* not those of the make that runs this test */
    const char *all[ARGUMENT_LIMIT] = {program};
    for (size_t i = 0; arguments[i] != NULL && i + 2 < ARGUMENT_LIMIT; i++) {
        all[i + 1] = arguments[i];
    }
    execv(program, (char *const *)(uintptr_t)all);
    perror(program);
    _exit(99);
}

/* The exit status, or 1000 plus the signal. */
static int finish(pid_t id) {
    int status;
    while (waitpid(id, &status, 0) < 0) {
        if (errno != EINTR) {
            return -1;
        }
    }
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
}

/* Start the check for the wrong programs; steps are separated by blanks, "" means all. */
static pid_t start_check(const char *timeout, const char *steps) {
    static char make[2 * PATH_LIMIT], references[PATH_LIMIT], build[PATH_LIMIT],
        differences[PATH_LIMIT];
    static char words[PATH_LIMIT];
    snprintf(make, sizeof make, "make BUILD=%s", inside("build").text);
    snprintf(references, sizeof references, "%s", inside("reference").text);
    snprintf(build, sizeof build, "%s", inside("build").text);
    snprintf(differences, sizeof differences, "%s", inside("differences").text);
    snprintf(words, sizeof words, "%s", steps);
    const char *arguments[ARGUMENT_LIMIT] = {
        "--root",        "tests/check/wrong", "--scenes",   "scenes.txt",
        "--references",  references,          "--programs", build,
        "--differences", differences,         "--make",     make};
    size_t count = 12;
    for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " ")) {
        arguments[count++] = word;
    }
    return start("check", timeout, arguments);
}

static int run_check(const char *steps, struct bytes *output) {
    int status = finish(start_check("1", steps));
    *output = read_text(inside("output").text);
    return status;
}

/* ---- The fixture ---- */

static bool write_reference(const char *step, const char *scene, bool blank) {
    static struct picture p;
    struct image image;
    struct error error;
    struct path path = inside("reference/");
    strcat(path.text, step);
    mkdir(path.text, 0777);
    strcat(strcat(strcat(path.text, "/"), scene), ".png");
    picture_draw(&p, 0, 1);
    if (!image_create(&image, PICTURE_SIZE, PICTURE_SIZE, IMAGE_BGR, &error)) {
        return false;
    }
    if (!blank) {
        memcpy(image.pixels, p.bgr, sizeof p.bgr);
    }
    bool done = png_write(&image, path.text, &error);
    image_free(&image);
    return done;
}

static bool write_references(void) {
    FILE *table = fopen("tests/check/wrong/scenes.txt", "r");
    if (table == NULL) {
        return false;
    }
    char line[256], step[64], scene[64];
    bool done = true;
    while (fgets(line, sizeof line, table) != NULL) {
        if (sscanf(line, "%63s %63s", step, scene) == 2 && step[0] != '#' &&
            strcmp(scene, "nowhere") != 0) {
            done &= write_reference(step, scene, strcmp(step, "step24_blankreference") == 0);
        }
    }
    fclose(table);
    return done;
}

static bool set_up(void) {
    const char *programs = getenv("CHECK_PROGRAMS");
    snprintf(fixture.directory, sizeof fixture.directory, "/tmp/test_check.XXXXXX");
    if (getcwd(fixture.here, sizeof fixture.here) == NULL || mkdtemp(fixture.directory) == NULL) {
        return false;
    }
    snprintf(fixture.programs, sizeof fixture.programs, "%s",
             programs != NULL ? programs : COURSE_BUILD "/tests");
    struct path check = {""};
    snprintf(check.text, sizeof check.text, "%s/check", fixture.programs);
    if (access(check.text, X_OK) != 0) {
        fprintf(stderr, "%s: %s\n", check.text, strerror(errno));
        return false;
    }
    setenv("CHECK_EXACT", "0", 1); /* .ci/run sets it */
    fixture.build_timeout = "4.5";
    fixture.closed = -1;
    mkdir(inside("tmp").text, 0777);
    mkdir(inside("reference").text, 0777);
    if (!write_references()) {
        return false;
    }
    fixture.status = finish(start_check("1", ""));
    rename(inside("output").text, inside("all").text);
    fixture.witness = read_text(inside("witness").text);
    return true;
}

static void tear_down(void) {
    char command[PATH_LIMIT];
    snprintf(command, sizeof command, "rm -rf '%s'", fixture.directory);
    if (fixture.directory[0] != '\0' && system(command) != 0) {
        fprintf(stderr, "cannot remove %s\n", fixture.directory);
    }
    bytes_free(&fixture.witness);
}

/* ---- Tests of one check of everything ---- */

/* Cut "STEP  " from a line that begins with it; NULL for another line. */
static const char *after_step(const char *line, const char *step) {
    size_t length = strlen(step);
    bool same = strncmp(line, step, length) == 0 && strncmp(line + length, "  ", 2) == 0;
    return same ? line + length + 2 : NULL;
}

/* What the output says of a step: what follows "STEP  ", then with "; " between them the lines
 * below it, without the two blanks in front. */
static struct path line_of(const struct bytes *output, const char *step) {
    struct path line = {""};
    bool inside_step = false;
    for (const char *text = (const char *)output->data; *text != '\0';) {
        size_t length = strcspn(text, "\n"), used = strlen(line.text);
        const char *begin = after_step(text, step);
        inside_step = begin != NULL || (inside_step && strncmp(text, "  ", 2) == 0);
        if (inside_step) {
            begin = begin != NULL ? begin : text + 2;
            snprintf(line.text + used, sizeof line.text - used, "%s%.*s", used > 0 ? "; " : "",
                     (int)(length - (size_t)(begin - text)), begin);
        }
        text += length + (text[length] == '\n');
    }
    return line;
}

/* Does the text match the pattern, in which a * stands for anything? */
static bool matches(const char *text, const char *pattern) {
    while (*pattern != '*' && *pattern != '\0' && *pattern == *text) {
        pattern++;
        text++;
    }
    if (*pattern != '*') {
        return *pattern == *text;
    }
    while (*text != '\0' && !matches(text, pattern + 1)) {
        text++;
    }
    return matches(text, pattern + 1);
}

/* Cut the line from a text that begins with it. Returns the text behind it. */
static char *cut_line(char *text) {
    char *end = strchr(text, '\n');
    if (end == NULL) {
        return text + strlen(text);
    }
    *end = '\0';
    return end + 1;
}

/* All that the check prints, line by line. */
static void test_output(void) {
    struct bytes expected = read_text("tests/check/wrong/expected.txt");
    struct bytes output = read_text(inside("all").text);
    char *line = (char *)output.data, *pattern = (char *)expected.data, *next, *next_pattern;
    for (; *pattern != '\0'; pattern = next_pattern) {
        next_pattern = cut_line(pattern);
        if (pattern[0] != '#') {
            next = cut_line(line);
            if (!CHECK_ROW(matches(line, pattern), pattern)) {
                fprintf(stderr, "    got:    %s\n", line);
            }
            line = next;
        }
    }
    CHECK_TEXT(line, "");
    CHECK(fixture.status == 2); /* a reference is missing */
    bytes_free(&expected);
    bytes_free(&output);
}

/* Each scene that failed has its picture, with the reference on its left, and yours in the middle;
 * it is named at the end of the output, which test_output() has read. */
static void test_difference_images(void) {
    static const char *const kept[] = {"step02_shifted/depth", "step06_size/huge",
                                       "step08_unreadable/pipe"};
    for (size_t i = 0; i < sizeof kept / sizeof kept[0]; i++) {
        char name[200];
        struct image picture;
        struct error error;
        snprintf(name, sizeof name, "differences/%s.png", kept[i]);
        CHECK_ROW(image_read(&picture, inside(name).text, &error), kept[i]);
        CHECK_ROW(picture.width == 2 * (3 * PICTURE_SIZE + 16) && picture.height > 2 * PICTURE_SIZE,
                  kept[i]);
        image_free(&picture);
    }
}

/* No process that told its number is alive, and none went on after its time. */
static void test_nothing_survives(void) {
    const char *text = (const char *)fixture.witness.data;
    size_t processes = 0;
    CHECK(!contains(&fixture.witness, "alive"));
    CHECK(contains(&fixture.witness, "ended by")); /* SIGTERM came first */
    const char *first_try = strstr(text, "try");   /* to build what takes too long */
    CHECK(first_try != NULL && strstr(first_try + 3, "try") == NULL);
    double end = now() + 2; /* for init to reap what is dead already */
    for (; *text != '\0'; text += strcspn(text, "\n") + 1) {
        pid_t id = (pid_t)strtol(text, NULL, 10);
        if (id <= 1) {
            continue; /* a line of words */
        }
        processes++;
        while (kill(id, 0) == 0 && now() < end) {
            sleep_ms(10);
        }
        CHECK(kill(id, 0) != 0);
    }
    CHECK(processes >= 1 + 2 + 64 + 1); /* sleep, stubborn, crowd, slow */
}

static bool is_empty_directory(const char *path) {
    DIR *directory = opendir(path);
    size_t entries = 0;
    if (directory == NULL) {
        return false;
    }
    while (readdir(directory) != NULL) {
        entries++;
    }
    closedir(directory);
    return entries == 2;
}

static void test_temporary_directories_are_removed(void) {
    CHECK(is_empty_directory(inside("tmp").text));
}

/* ---- Tests of checks of their own ---- */

static void test_status_of_passed_and_failed(void) {
    struct bytes output;
    struct path old = inside("differences/step01_exact/depth.png");
    struct error error;
    mkdir(inside("differences").text, 0777);
    mkdir(inside("differences/step01_exact").text, 0777);
    CHECK(file_write(old.text, "old", 3, &error));
    CHECK(run_check("01 2", &output) == 0);
    CHECK(access(old.text, F_OK) != 0);
    CHECK_TEXT(line_of(&output, "step01_exact").text, "PASS 2/2 SCORE 2/2 exact");
    CHECK(contains(&output, "\n2 passed, 0 failed\n"));
    CHECK(!contains(&output, "/step01_exact/") && contains(&output, "/step02_shifted/"));
    CHECK(!contains(&output, "step03"));
    bytes_free(&output);
    CHECK(run_check("1 step07_missing", &output) == 1);
    CHECK(contains(&output, "\n1 passed, 1 failed\n"));
    bytes_free(&output);
    CHECK(run_check("10", &output) == 1);
    CHECK(contains(&output, "\n0 passed, 1 failed\n"));
    bytes_free(&output);
}

/* One scene is drawn and judged, and a step that has none of that name is wrong usage. */
static void test_one_scene(void) {
    struct bytes output;
    CHECK(run_check("--only depth2 -- 01", &output) == 0);
    CHECK_TEXT(line_of(&output, "step01_exact").text, "PASS 1/1 SCORE 1/1 exact");
    bytes_free(&output);
    output = read_text(inside("witness").text); /* the program was told */
    CHECK(contains(&output, "one scene of 2\n"));
    bytes_free(&output);
    CHECK(run_check("--only depth3 01", &output) == 2);
    CHECK(output.size == 1);
    bytes_free(&output);
    output = read_text(inside("errors").text);
    CHECK(contains(&output, "step01_exact has no scene 'depth3'"));
    bytes_free(&output);
}

/* A score that nobody gets is no score. */
static void test_full_output(void) {
    struct bytes output;
    unlink(inside("output").text);
    if (access("/dev/full", W_OK) == 0 && CHECK(symlink("/dev/full", inside("output").text) == 0)) {
        CHECK(finish(start_check("1", "01")) == 2);
        output = read_text(inside("errors").text);
        CHECK(contains(&output, "check: the score could not be written"));
        bytes_free(&output);
        unlink(inside("output").text);
    }
}

/* Nor is one that went into a file which the check has opened for itself. */
static void test_closed_output(void) {
    struct path lock = inside("build/check.lock");
    struct error error;
    CHECK(file_write(lock.text, "", 0, &error));
    for (int closed = STDIN_FILENO; closed <= STDERR_FILENO; closed++) {
        fixture.closed = closed;
        int status = finish(start_check("1", "01"));
        fixture.closed = -1;
        CHECK(status == (closed == STDOUT_FILENO ? 2 : 0));
        CHECK(file_size(lock.text) == 0);
        struct bytes output = read_text(inside("output").text);
        CHECK(contains(&output, "SCORE 2/2 exact") == (closed != STDOUT_FILENO));
        bytes_free(&output);
    }
}

/* Where every picture must be exact, one that is right within its limit fails. */
static void test_exact_is_demanded(void) {
    struct bytes output;
    setenv("CHECK_EXACT", "1", 1);
    CHECK(run_check("01 02", &output) == 1);
    setenv("CHECK_EXACT", "0", 1);
    CHECK_TEXT(line_of(&output, "step01_exact").text, "PASS 2/2 SCORE 2/2 exact");
    CHECK(strncmp(line_of(&output, "step02_shifted").text, "FAIL 0/1 ", 9) == 0);
    CHECK(contains(&output, "(must be exact)"));
    bytes_free(&output);
    setenv("CHECK_EXACT", "yes", 1);
    CHECK(run_check("01", &output) == 2);
    setenv("CHECK_EXACT", "0", 1);
    bytes_free(&output);
}

/* A program of an earlier build must not be checked instead of one that does not build, or whose
 * source has gone; nor when it is newer than its source. */
static void test_old_program_is_not_used(void) {
    static const char *const steps[] = {"step10_build", "step12_absent"};
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        char command[3 * PATH_LIMIT], line[80];
        struct bytes output;
        snprintf(command, sizeof command, "cp '%s' '%s/%s'", inside("build/step01_exact").text,
                 inside("build").text, steps[i]);
        snprintf(line, sizeof line, "%s  BUILD ", steps[i]);
        CHECK_ROW(system(command) == 0, steps[i]);
        CHECK_ROW(run_check(steps[i], &output) == 1, steps[i]);
        CHECK_ROW(contains(&output, line), steps[i]);
        bytes_free(&output);
    }
}

/* The check reads the references and never changes one, whatever fails. */
static void test_references_are_not_changed(void) {
    struct path path = inside("reference/step05_blank/depth.png");
    struct stat before, after;
    struct bytes old = read_text(path.text), output;
    CHECK(stat(path.text, &before) == 0);
    CHECK(run_check("5", &output) == 1);
    struct bytes new = read_text(path.text);
    CHECK(stat(path.text, &after) == 0 && before.st_ino == after.st_ino);
    CHECK(old.size == new.size &&memcmp(old.data, new.data, old.size) == 0);
    CHECK(access(inside("reference/step23_noreference/nowhere.png").text, F_OK) != 0);
    bytes_free(&old);
    bytes_free(&new);
    bytes_free(&output);
}

static void test_wrong_usage(void) {
    static const struct {
        const char *arguments[4];
        const char *timeout, *message;
    } cases[] = {
        {{"--nonsense"}, "1", "unknown option '--nonsense'"},
        {{"-"}, "1", "unknown option '-'"},
        {{"--root"}, "1", "--root needs a value"},
        {{"--", "--root"}, "1", "there is no step '--root'"},
        {{"--", "--", "1"}, "1", "there is no step '--'"},
        {{"--root", "/nowhere"}, "1", "/nowhere: No such file"},
        {{"--scenes", "/nowhere"}, "1", "/nowhere"},
        {{"77"}, "1", "there is no step '77'; the steps are step01_line"},
        {{"step05"}, "1", "there is no step 'step05'"},
        {{"5x"}, "1", "there is no step '5x'"},
        {{"01"}, "soon", "CHECK_TIMEOUT"},
        {{"01"}, "-1", "CHECK_TIMEOUT"},
        {{"01"}, "nan", "CHECK_TIMEOUT"},
        {{"--make", "no_such_make", "01"}, "1", "cannot run no_such_make"},
        {{"--programs", "/dev/null/x", "01"}, "1", "/dev/null: cannot make the directory"},
        {{"--programs", "/proc", "01"}, "1", "check: /proc"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int status = finish(start("check", cases[i].timeout, cases[i].arguments));
        struct bytes errors = read_text(inside("errors").text);
        CHECK_ROW(status == 2, cases[i].message);
        CHECK_ROW(contains(&errors, cases[i].message), cases[i].message);
        bytes_free(&errors);
    }
}

/* What the lessons are given cannot be made, an old program or what the compiler leaves beside it
 * not be removed: no score, but why. */
static void test_own_failures_are_not_scored(void) {
    static const struct {
        const char *first, *step, *where, *message;
    } cases[] = {
        {"broken", "01", "errors", "check: cannot build broken: sculpt: no clay\n"},
        {"nowhere", "01", "errors", "check: cannot build nowhere: make"},
        {"", "12", "output", "step12_absent  ERROR 0/1 SCORE 0/1: cannot remove "},
        {"", "01", "output", "step01_exact  ERROR 0/2 SCORE 0/2: cannot remove "},
        {"", "09", "output", "step09_status  ERROR 0/1 SCORE 0/1: cannot remove "},
        {"", "05", "output", "step05_blank  ERROR 0/1 SCORE 0/1: cannot remove "},
    };
    char make[2 * PATH_LIMIT];
    struct path build = inside("build"), references = inside("reference");
    snprintf(make, sizeof make, "make BUILD=%s", build.text);
    mkdir(inside("build/step12_absent").text, 0777);
    mkdir(inside("build/step01_exact.o").text, 0777);
    mkdir(inside("build/step09_status.d").text, 0777);
    mkdir(inside("build/step05_blank.said").text, 0777);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *arguments[] = {
            "--root",        "tests/check/wrong", "--scenes",    "scenes.txt", "--references",
            references.text, "--programs",        build.text,    "--make",     make,
            "--first",       cases[i].first,      cases[i].step, NULL};
        CHECK_ROW(finish(start("check", "1", arguments)) == 2, cases[i].message);
        struct bytes said = read_text(inside(cases[i].where).text);
        CHECK_ROW(contains(&said, cases[i].message), cases[i].message);
        CHECK_ROW(!contains(&said, "PASS") && !contains(&said, "FAIL"), cases[i].message);
        bytes_free(&said);
    }
    rmdir(inside("build/step12_absent").text);
    rmdir(inside("build/step01_exact.o").text);
    rmdir(inside("build/step09_status.d").text);
    rmdir(inside("build/step05_blank.said").text);
}

static void test_wrong_build_timeout(void) {
    const char *arguments[] = {"01", NULL}, *right = fixture.build_timeout;
    fixture.build_timeout = "0";
    CHECK(finish(start("check", "1", arguments)) == 2);
    fixture.build_timeout = right;
    struct bytes errors = read_text(inside("errors").text);
    CHECK(contains(&errors, "CHECK_BUILD_TIMEOUT is '0'"));
    bytes_free(&errors);
}

/* Wait up to ten seconds for words in what the check says. */
static bool is_said(const char *words) {
    bool said = false;
    for (double end = now() + 10; !said && now() < end; sleep_ms(10)) {
        struct bytes errors = read_text(inside("errors").text);
        said = contains(&errors, words);
        bytes_free(&errors);
    }
    return said;
}

/* Two checks in one build directory would remove each other's programs: the second waits, until the
 * first has ended or it is told to end itself. */
static void test_checks_wait_for_each_other(void) {
    static const struct { int signal, status; } cases[] = {{SIGINT, 1000 + SIGINT}, {0, 0}};
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    int file = open(inside("build/check.lock").text, O_RDWR);
    CHECK(file >= 0 && fcntl(file, F_SETLK, &whole) == 0); /* nobody has it now */
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        unlink(inside("errors").text);
        pid_t check = start_check("1", "01");
        CHECK(is_said("check: waiting for another check in "));
        sleep_ms(300);
        struct bytes output = read_text(inside("output").text);
        CHECK(!contains(&output, "step01"));
        bytes_free(&output);
        if (cases[i].signal != 0) {
            kill(check, cases[i].signal);
        } else {
            close(file); /* lets the lock go */
        }
        CHECK(finish(check) == cases[i].status);
        output = read_text(inside("output").text);
        CHECK(contains(&output, "PASS 2/2 SCORE 2/2 exact") == (cases[i].status == 0));
        bytes_free(&output);
    }
}

static void test_scene_tables(void) {
    static const struct {
        const char *table, *message;
    } cases[] = {
        {"", "there is no scene in it"},
        {"nonsense a\n", ":1: 'nonsense' is not the name of a step"},
        {"step1_a\n", ":1: '' is not the name of a scene"},
        {"step1_a ../b\n", ":1: '../b' is not the name of a scene"},
        {"step1_a b\n", ":1: '' are no tasks, like 5.2 or 5.1,5.2"},
        {"step1_a b 1.1,\n", ":1: '1.1,' are no tasks"},
        {"step1_a b 1.1,1.1\n", ":1: '1.1,1.1' are no tasks"},
        {"step1_a b 1B.1\n", ":1: '1B.1' are no tasks"},
        {"step1_a b 1.01\n", ":1: '1.01' are no tasks"},
        {"step1_a b 1b.1.1\n", ":1: '1b.1.1' are no tasks"},
        {"step1_a b 1234567890.1\n", ":1: '1234567890.1' are no tasks"},
        {"step1_a b 1b\n", ":1: '1b' are no tasks"},
        {"step1_a b 1.1+1\n", ":1: '1.1+1' are no tasks"},
        {"step1_a b 1.1+1b.1,1.1\n", ":1: '1.1+1b.1,1.1' are no tasks"},
        {"step1_a b 1.1+1b+1c\n", ":1: '1.1+1b+1c' are no tasks"},
        {"step1_a b 1.1+\n", ":1: '1.1+' are no tasks"},
        {"step1_a b 1.1,1.2,1.3,1.4,1.5,1.6,1.7,1.8,1.9,2.1,2.2,2.3,2.4,2.5,2.6,2.7,2.8\n",
         "are no tasks"},
        {"step1_a b 1.1\n", ":1: '' is not a number of points"},
        {"step1_a b 1.1 0\n", ":1: '0' is not a number of points"},
        {"step1_a b 1.1 1.5\n", ":1: '1.5' is not a number of points"},
        {"step1_a b 1.1 nan\n", ":1: 'nan' is not a number of points"},
        {"step1_a b 1.1 1001\n", ":1: '1001' is not a number of points"},
        {"step1_a b 1.1,1b.2 3\n", ":1: 3 points cannot be shared out evenly to 2 tasks"},
        {"step1_a b 1.1 1\n", ":1: '' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 100.1 1\n", ":1: '100.1' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 1 nan\n", ":1: 'nan' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 1 2\n", ":1: '' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 1 2 x\n", ":1: 'x' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 1 2 3 x\n", ":1: 'x' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 1 2 3 4 5\n", ":1: unexpected '5'"},
        {"step1_a b 1.1 1 -1\n", ":1: '-1' is neither 'exact' nor a percentage"},
        {"step1_a b 1.1 1 exact c\n", ":1: unexpected 'c'"},
        {"work step1_a b 1.1 1 c 1\n", ":1: work of 'step1_a' must stand behind its scenes"},
        {"step1_a b 1.1 1 exact\nwork step2_a b\n", ":2: work of 'step2_a' must stand behind"},
        {"step1_a b 1.1 1 exact\nwork step1_a c\n", ":2: step1_a has no scene 'c'"},
        {"step1_a b 1.1 1 exact\nwork step1_a b 1\n", ":2: '1' are no tasks"},
        {"step1_a b 1.1 1 exact\nwork step1_a b 1.1 1\n", ":2: '' is not the name of a counter"},
        {"step1_a b 1.1 1 exact\nwork step1_a b 1.1 1 c -1\n", ":2: '-1' is not what a counter"},
        {"step1_a b 1.1 1 exact\nwork step1_a b 1.1 1 c 1.5\n", ":2: '1.5' is not what a counter"},
        {"step1_a b 1.1 1 exact\nwork step1_a b 1.1 1 c 1 x\n", ":2: 'x' is not what a counter"},
        {"step1_a b 1.1 1 exact\nwork step1_a b 1.1 1 c 1 2 3\n", ":2: unexpected '3'"},
        {"same step1_a b 1.1 1 moved 1\n", ":1: relations of 'step1_a' must stand behind"},
        {"step1_a b 1.1 1 exact\nsame step1_a b 1.1 1 1\n", ":2: '1' are no relations"},
        {"step1_a b 1.1 1 exact\nsame step1_a b 1.1 1 moved,\n", ":2: 'moved,' are no relations"},
        {"step1_a b 1.1 1 exact\nsame step1_a b 1.1 1 moved,moved 1\n", ":2: 'moved,moved' are no"},
        {"step1_a b 1.1 1 exact\nsame step1_a b 1.1 1 moved\n", ":2: '' is neither 'exact' nor a"},
        {"step1_a b 1.1 1 exact\nsame step1_a b 1.1 1 moved 1 2\n", ":2: unexpected '2'"},
        {"step1_a b 1.1 1 exact\nstep1_a b 1.1 1 exact\n", ":2: b stands here twice"},
        {"step1_a b 1.1 1 exact\nstep2_a b 2.1 1 1 1 1\n\nstep1_a c 1.1 1 exact\n",
         ":4: the scenes of step1_a must stand together"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct path path = inside("table.txt");
        struct error error;
        CHECK(file_write(path.text, cases[i].table, strlen(cases[i].table), &error));
        const char *arguments[] = {"--scenes", path.text, NULL};
        int status = finish(start("check", "1", arguments));
        struct bytes errors = read_text(inside("errors").text);
        CHECK_ROW(status == 2, cases[i].message);
        CHECK_ROW(contains(&errors, cases[i].message), cases[i].message);
        bytes_free(&errors);
    }
}

/* A check that is told to end takes its program and its directory with it. */
static void test_interrupt(void) {
    static const int signals[] = {SIGINT, SIGTERM};
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        unlink(inside("witness").text);
        pid_t check = start_check("30", "15");
        struct bytes told = read_text(inside("witness").text);
        for (double end = now() + 10; !contains(&told, "\n") && now() < end;) {
            sleep_ms(10);
            bytes_free(&told);
            told = read_text(inside("witness").text);
        }
        pid_t program = (pid_t)strtol((const char *)told.data, NULL, 10);
        bytes_free(&told);
        CHECK(program > 1 && kill(program, 0) == 0);
        CHECK(!is_empty_directory(inside("tmp").text));
        double asked = now();
        kill(check, signals[i]);
        CHECK(finish(check) == 1000 + signals[i]);
        CHECK(now() - asked < 2);
        CHECK(program > 1 && kill(program, 0) != 0);
        CHECK(is_empty_directory(inside("tmp").text));
    }
}

/* A program that ends who has started it, by whatever signal, is judged, and has not passed. */
static void test_ends_its_parent(void) {
    static const char table[] = "step17_killer depth 17.1 1 exact\n";
    static const int signals[] = {SIGKILL, SIGTERM, SIGINT, SIGSEGV, SIGUSR1};
    struct path scenes = inside("killer.txt");
    struct error error;
    char arguments[2 * PATH_LIMIT], number[8];
    CHECK(file_write(scenes.text, table, strlen(table), &error));
    CHECK(rename(inside("reference/step16_stubborn").text,
                 inside("reference/step17_killer").text) == 0);
    snprintf(arguments, sizeof arguments, "--scenes %s 17", scenes.text);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        struct bytes output;
        snprintf(number, sizeof number, "%d", signals[i]);
        setenv("KILLS_WITH", number, 1);
        CHECK_ROW(run_check(arguments, &output) == 1, number);
        CHECK_ROW(contains(&output, "step17_killer") && contains(&output, "SCORE 0/1\n"), number);
        bytes_free(&output);
    }
    CHECK(rename(inside("reference/step17_killer").text,
                 inside("reference/step16_stubborn").text) == 0);
}

/* A program that is run by another one: its status tells of a signal. */
static void test_runner(void) {
    struct bytes output;
    char runner[2 * PATH_LIMIT];
    snprintf(runner, sizeof runner, "%s/tests/check/wrong/runner.sh", fixture.here);
    setenv("CHECK_RUNNER", runner, 1);
    CHECK(run_check("1 9 14", &output) == 1);
    CHECK_TEXT(line_of(&output, "step01_exact").text, "PASS 2/2 SCORE 2/2 exact");
    CHECK(contains(&output, "exit status 1: step09_status: bust.obj:17"));
    CHECK(contains(&output, "step14_abort  CRASH 0/1 SCORE 0/1\n  depth CRASH 0/1: SIGABRT, ended "
                            "by abort() or a failed assert(): "));
    bytes_free(&output);
    setenv("CHECK_RUNNER", "/nowhere/runner", 1);
    CHECK(run_check("1", &output) == 1);
    CHECK(contains(&output, "cannot start /nowhere/runner"));
    bytes_free(&output);
    unsetenv("CHECK_RUNNER");
}

/* What a program counts, and which of its pictures are black or missing, tells a mistake. */
static void test_known_counters(void) {
    static const struct {
        const char *step, *list;      /* all that is known of the step's mistakes */
        const char *options, *wanted; /* "": it looks like nothing */
    } cases[] = {
        {"step41_counted", "41.2 0 depth:-:pixels=5,rows=7 five\n", "",
         "depth pixels FAIL 0/1: 5 pixels, but 9 are right;   looks like \"five\"; make hint "
         "STEP=41 TASK=41.2; depth2 pixels FAIL 0/1: 5 pixels, but 9 are right; depth2 rows"},
        {"step41_counted", "41.2 4 depth:-:pixels=5,rows=7 five\n", "--only depth",
         "looks like \"five\": see step41_counted/WRONG.md, figure 4; make hint STEP=41 "
         "TASK=41.2"},
        {"step41_counted", "41.2 0 depth:-:pixels=5,rows=7 five\n", "--only depth2", ""},
        {"step41_counted", "41.2 0 depth:-:pixels=5 not all of it\n", "", ""},
        {"step41_counted", "41.2 0 depth2:-:pixels=5,rows=8 five\n", "",
         "depth2 pixels FAIL 0/1: 5 pixels, but 9 are right;   looks like \"five\"; make hint "
         "STEP=41 TASK=41.2; depth2 rows FAIL 0/1: 8 rows, but 9 are right;   looks like "
         "the same"},
        {"step42_black", "42.2 0 depth2:rbb:pixels=5;depth3:rbb:pixels=0 black\n", "",
         "may be \"black\"; make hint STEP=42 TASK=42.2; depth3 FAIL 0/1: "},
        {"step42_black", "42.2 0 depth2:rbb:pixels=5;depth3:rbb:pixels=0 black\n", "",
         "may be the same"},
        {"step42_black", "42.2 0 depth2:rbb:pixels=5;depth3:rbb:pixels=1 black\n", "", ""},
        {"step42_black", "42.2 0 depth2:rbb:pixels=5 black\n", "--only depth2", ""},
        {"step43_divided", "43.2 0 depth2:rd:- by 0\n", "",
         "depth2 CRASH 0/1: SIGFPE, a whole number divided by 0;   may be \"by 0\"; make hint "
         "STEP=43 TASK=43.2"},
        {"step43_divided", "43.2 0 depth2:rd:pixels=5 counted\n", "", ""},
        {"step13_crash", "13.1 0 depth2:rd:- another crash\n", "", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char arguments[2 * PATH_LIMIT];
        struct bytes output;
        struct error error;
        struct path path = inside("looks/");
        strcat(path.text, cases[i].step);
        strcat(path.text, "/looks");
        CHECK(directory_create(path.text, &error));
        strcat(path.text, "/signs.txt");
        CHECK(file_write(path.text, cases[i].list, strlen(cases[i].list), &error));
        snprintf(arguments, sizeof arguments, "--looks %s %s %s", inside("looks").text,
                 cases[i].options, cases[i].step);
        CHECK(run_check(arguments, &output) == 1);
        struct path line = line_of(&output, cases[i].step);
        bool looks = strstr(line.text, "looks like") != NULL || strstr(line.text, "may be") != NULL;
        CHECK_ROW(looks == (cases[i].wanted[0] != '\0') &&
                      strstr(line.text, cases[i].wanted) != NULL,
                  cases[i].list);
        bytes_free(&output);
    }
}

/* Where undefined behaviour is: in the step's own file, though a header's function was called. */
static void test_place_of_fault(void) {
    static const struct {
        const char *messages, *said;
    } cases[] = {
        {"/a/step02_b/main.c:12:5: runtime error: index 9 out of bounds\n",
         "step02_b/main.c:12: index 9 out of bounds"},
        {"common/raster.h:138:26: runtime error: division by zero\n"
         "    #0 0x5581 in floor_divide common/raster.h:138\n"
         "    #1 0x5582 in line step02_b/main.c:126\n"
         "    #2 0x5583 in draw step02_b/scenes.h:67\n",
         "step02_b/main.c:126: division by zero"},
        {"x: step02_b/main.c:4: f: Assertion `n > 1' failed.\n"
         "==9==ERROR: AddressSanitizer: ABRT on unknown address 0x03 (pc 0x04 T0)\n"
         "    #0 0x05 in __GI_abort stdlib/abort.c:79\n"
         "    #1 0x06 in f step02_b/main.c:4\n",
         "step02_b/main.c:4: f() stops the program: Assertion `n > 1' failed."},
        {"==9==ERROR: AddressSanitizer: ABRT on unknown address 0x03 (pc 0x04 T0)\n"
         "    #0 0x05 in __GI_abort stdlib/abort.c:79\n"
         "    #1 0x06 in main step02_b/main.c:5:58\n",
         "step02_b/main.c:5: main() stops the program: abort()"},
        {"common/raster.h:138:26: runtime error: division by zero\n",
         "common/raster.h:138: division by zero"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct result_text text = {""};
        CHECK_ROW(fault_describe(&text, "step02_b", cases[i].messages), cases[i].said);
        CHECK_TEXT(text.text, cases[i].said);
    }
}

/* Who has the program built with sanitizers is not told to do that. */
static void test_sanitized_is_not_advised(void) {
    struct bytes output;
    CHECK(run_check("--sanitized 33", &output) == 1);
    CHECK_TEXT(line_of(&output, "step33_first").text,
               "CRASH 1/2 SCORE 3/4; depth CRASH 0/1: SIGABRT, ended by abort() or a failed "
               "assert(); depth2 PASS 3/3; tasks: 33.1 CRASH "
               "0/1, 33.2 3/3");
    bytes_free(&output);
}

static const struct unit_test tests[] = {
    TEST(test_output),
    TEST(test_difference_images),
    TEST(test_nothing_survives),
    TEST(test_temporary_directories_are_removed),
    TEST(test_status_of_passed_and_failed),
    TEST(test_one_scene),
    TEST(test_full_output),
    TEST(test_closed_output),
    TEST(test_exact_is_demanded),
    TEST(test_old_program_is_not_used),
    TEST(test_references_are_not_changed),
    TEST(test_wrong_usage),
    TEST(test_own_failures_are_not_scored),
    TEST(test_wrong_build_timeout),
    TEST(test_checks_wait_for_each_other),
    TEST(test_scene_tables),
    TEST(test_interrupt),
    TEST(test_ends_its_parent),
    TEST(test_runner),
    TEST(test_known_counters),
    TEST(test_place_of_fault),
    TEST(test_sanitized_is_not_advised),
};

int main(void) {
    int status = 1;
    if (set_up()) {
        status = unit_run(tests, sizeof tests / sizeof tests[0]);
    } else {
        fprintf(stderr, "test_check: cannot begin: build the check, and run this from the course's "
                        "root directory\n");
    }
    tear_down();
    return status;
}
