/*
 * Tests of common/base/file.c: messages, blocks of bytes, whole files in and out, and what happens
 * when the disk, the directory or the file does not play along.
 */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "base/bytes.h"
#include "base/error.h"
#include "unit/place.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>

/* Run in a child process; true when it returns true. */
static bool in_child(bool (*run)(const char *), const char *argument) {
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        _exit(run(argument) ? 0 : 1);
    }
    int status = 1;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

/* Become somebody who owns nothing; in a child process only. */
static bool drop_privileges(void) {
    return getuid() != 0 || (setgid(65534) == 0 && setuid(65534) == 0);
}

/* Is it the path, and behind it the reason? */
static bool tells(const struct error *error, const char *path, const char *reason) {
    size_t length = strlen(path);
    return strncmp(error->message, path, length) == 0 &&
           strcmp(error->message + length, reason) == 0;
}

/* ---- Messages ---- */

/* What a terminal would obey is replaced, byte by byte; what it shows stays. */
static void test_printable_texts(void) {
    static const struct {
        const char *text, *shown;
    } cases[] = {
        {"", ""},
        {"\x1f\x20\x7e\x7f", "? ~?"},
        {"\xc2\x80 \xc2\x9f \xc2\xa0", "?? ?? \xc2\xa0"}, /* C1: U+0080 to U+009F */
        {"\xd8\x9c \xd8\x9d", "?? \xd8\x9d"},
        {"\xe2\x80\x8d\xe2\x80\x8e\xe2\x80\x8f\xe2\x80\x90", "\xe2\x80\x8d??????\xe2\x80\x90"},
        {"\xe2\x80\xa7\xe2\x80\xa8\xe2\x80\xae\xe2\x80\xaf", "\xe2\x80\xa7??????\xe2\x80\xaf"},
        {"\xe2\x81\xa5\xe2\x81\xa6\xe2\x81\xa9\xe2\x81\xaa", "\xe2\x81\xa5??????\xe2\x81\xaa"},
        {"\xc3\xa9 \xe4\xb8\xad \xf0\x9f\x99\x82", "\xc3\xa9 \xe4\xb8\xad \xf0\x9f\x99\x82"},
        {"a\x9b \x80 \xbf", "a? ? ?"},                   /* no first byte */
        {"\xc3 \xe4\xb8 \xf0\x9f\x99", "? ?? ???"},      /* cut off */
        {"\xc0\xaf \xc1\xbf \xe0\x9f\xbf", "?? ?? ???"}, /* longer than need be */
        {"\xf0\x8f\xbf\xbf \xf4\x90\x80\x80", "???? ????"},
        {"\xed\x9f\xbf \xed\xa0\x80 \xed\xbf\xbf \xee\x80\x80",
         "\xed\x9f\xbf ??? ??? \xee\x80\x80"},
        {"\xef\xbf\xbd \xef\xbf\xbe \xef\xbf\xbf", "\xef\xbf\xbd ??? ???"}, /* not in XML */
        {"\xf4\x8f\xbf\xbf \xf8\x88\x80\x80\x80 \xff", "\xf4\x8f\xbf\xbf ????? ?"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[40];
        strcpy(text, cases[i].text);
        text_make_printable(text, '?');
        CHECK_TEXT(text, cases[i].shown);
    }
    struct error error;
    CHECK(!error_set(&error, "%s", "two\nlines\x1b[31m\x7f"));
    CHECK_TEXT(error.message, "two?lines?[31m?");
}

static void test_names_of_files(void) {
    static const struct {
        bool (*name)(struct error *error, const char *path);
        const char *path;
        size_t line;
        const char *message;
    } rows[] = {
        {error_name_file, "a/b.obj", 0, "a/b.obj: 12 faces"}, /* no line, for all its number */
        {error_name_file, "a", 17, "a:17: 12 faces"},
        {error_name_file, "-", 0, "-: 12 faces"}, /* a file that is written may have this name */
        {error_name_input, "-", 0, "standard input: 12 faces"},
        {error_name_input, "--", 5, "--:5: 12 faces"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct error error;
        error_set(&error, "12 faces");
        error.line = rows[i].line;
        CHECK(!rows[i].name(&error, rows[i].path) && error.line == 0);
        CHECK_TEXT(error.message, rows[i].message);
    }
    struct error error;
    CHECK(!error_out_of_memory(&error) && error_is_out_of_memory(&error));
    CHECK(!error_name_file(&error, "a") && error_is_out_of_memory(&error));
    CHECK(!error_set(&error, "memory") && !error_is_out_of_memory(&error));
}

/* Of a long message the beginning is kept, of a long name the end. */
static void test_long_messages(void) {
    enum { LONG = 5000, KEPT = 512 };
    struct error error;
    char text[LONG + 1], expected[KEPT + 40];
    memset(text, 'x', LONG - KEPT);
    memset(text + LONG - KEPT, 'y', KEPT);
    text[LONG] = '\0';
    CHECK(!error_set(&error, "%s", text));
    CHECK(strlen(error.message) == sizeof error.message - 1);
    error.line = 7;
    CHECK(!error_set(&error, "wrong") && error.line == 0); /* the line was that of the old one */
    error.line = SIZE_MAX;
    CHECK(!error_name_file(&error, text));
    snprintf(expected, sizeof expected, "...%s:%zu: wrong", text + LONG - KEPT, SIZE_MAX);
    CHECK_TEXT(error.message, expected);
    error_set(&error, "wrong");
    CHECK(!error_name_file(&error, text + LONG - KEPT));
    CHECK(error.message[0] == 'y' && strlen(error.message) == KEPT + 7); /* just not too long */
}

/* ---- Bytes ---- */

static void test_bytes(void) {
    struct bytes bytes = {0};
    bytes_free(&bytes);
    CHECK(bytes_append(&bytes, NULL, 0) && bytes.data == NULL);
    for (size_t i = 0; i < 1000; i++) {
        unsigned char byte = (unsigned char)(i % 251);
        CHECK(bytes_append(&bytes, &byte, 1));
    }
    bool same = bytes.size == 1000 && bytes.capacity >= 1000;
    for (size_t i = 0; i < 1000; i++) {
        same = same && bytes.data[i] == i % 251;
    }
    CHECK(same);
    CHECK(bytes_print(&bytes, "%s", "") && bytes.size == 1000); /* nothing is no failure */
    CHECK(bytes_reserve(&bytes, 5000) && bytes.size == 1000 && bytes.capacity >= 6000);
    CHECK(!bytes_reserve(&bytes, SIZE_MAX) && bytes.size == 1000 && bytes.data[7] == 7);
    CHECK(!bytes_reserve(&bytes, SIZE_MAX - 999));
    bytes_free(&bytes);
    CHECK(bytes.data == NULL && bytes.size == 0 && bytes.capacity == 0);
    CHECK(bytes_reserve(&bytes, 1000) && bytes.capacity == 1000); /* no more than asked for */
    bytes_free(&bytes);
    struct bytes full = {.size = SIZE_MAX - 3, .capacity = SIZE_MAX - 3};
    CHECK(!bytes_print(&full, "%d", 12345) && full.size == SIZE_MAX - 3);
}

/* ---- Reading ---- */

static void test_read(void) {
    struct place place = place_create();
    struct bytes bytes;
    struct error error;
    const char *path = name_file(&place, "a");
    CHECK(file_write(path, "hello from a file", 17, &error));
    CHECK(file_read(path, &bytes, &error) && bytes.size == 17);
    CHECK(bytes.data != NULL && memcmp(bytes.data, "hello from a file", 17) == 0);
    bytes_free(&bytes);
    CHECK(file_write(path, NULL, 0, &error));
    CHECK(file_read(path, &bytes, &error) && bytes.size == 0);
    bytes_free(&bytes);
    CHECK(file_read("/dev/null", &bytes, &error) && bytes.size == 0);
    bytes_free(&bytes);
    place_remove(&place, "a");
}

static void check_not_read(const char *path, const char *reason) {
    struct bytes bytes = {.size = 99};
    struct error error;
    CHECK_ROW(!file_read(path, &bytes, &error), path);
    CHECK(bytes.data == NULL && bytes.size == 0);
    CHECK_ROW(tells(&error, path, reason), error.message);
}

static void test_read_errors(void) {
    struct place place = place_create();
    check_not_read(place.directory, ": is a directory");
    check_not_read(name_file(&place, "none"), ": No such file or directory");
    check_not_read("", ": No such file or directory");
    const char *path = name_file(&place, "huge");
    int file = open(path, O_WRONLY | O_CREAT, 0600);
    CHECK(file >= 0 && ftruncate(file, ((off_t)1 << 30) + 1) == 0); /* a hole: takes no room */
    close(file);
    check_not_read(path, ": is larger than 1 GiB");
    place_remove(&place, "huge");
}

/* Standard input is a pipe that is filled in small pieces, longer than any buffer. */
static bool read_pipe(const char *unused) {
    enum { SIZE = 200000 };
    (void)unused;
    int ends[2];
    if (pipe(ends) != 0) {
        return false;
    }
    if (fork() == 0) {
        for (int i = 0; i < SIZE; i += 1000) {
            char piece[1000];
            memset(piece, 'a' + i / 1000 % 26, sizeof piece);
            if (write(ends[1], piece, sizeof piece) != (ssize_t)sizeof piece) {
                _exit(1);
            }
        }
        _exit(0);
    }
    close(ends[1]);
    dup2(ends[0], STDIN_FILENO);
    struct bytes bytes;
    struct error error;
    bool same = file_read("-", &bytes, &error) && bytes.size == SIZE;
    for (size_t i = 0; same && i < SIZE; i++) {
        same = bytes.data[i] == 'a' + i / 1000 % 26;
    }
    bytes_free(&bytes);
    return same;
}

static bool read_closed_input(const char *unused) {
    struct bytes bytes;
    struct error error;
    (void)unused;
    close(STDIN_FILENO);
    return !file_read("-", &bytes, &error) && bytes.data == NULL &&
           tells(&error, "standard input", ": Bad file descriptor");
}

static void test_standard_input(void) {
    CHECK(in_child(read_pipe, ""));
    CHECK(in_child(read_closed_input, ""));
}

/* ---- Writing ---- */

static void test_write(void) {
    struct place place = place_create();
    struct error error;
    struct stat status;
    const char *path = name_file(&place, "a");
    mode_t mask = umask(0022);
    CHECK(file_write(path, "first", 5, &error) && file_is(path, "first"));
    umask(mask);
    CHECK(stat(path, &status) == 0 && (status.st_mode & 0777) == 0644);
    CHECK(file_write(path, "1", 1, &error) && chmod(path, 0604) == 0);
    CHECK(file_write(path, "second", 6, &error) && file_is(path, "second"));
    CHECK(stat(path, &status) == 0 && (status.st_mode & 0777) == 0604);
    CHECK(place_count(&place) == 1);
    place_remove(&place, "a");
}

/* A program may be run without standard input: the next file is number 0 then. */
static bool write_without_input(const char *path) {
    struct error error;
    close(STDIN_FILENO);
    struct bytes bytes;
    bool done = file_read(path, &bytes, &error) && open(path, O_RDONLY) == STDIN_FILENO;
    close(STDIN_FILENO);
    bytes_free(&bytes);
    return done && file_write(path, "second", 6, &error) && drop_privileges() &&
           file_write("/dev/null", "new", 3, &error); /* a device is opened as it is */
}

static void test_write_without_input(void) {
    struct place place = place_create();
    struct error error;
    const char *path = name_file(&place, "a");
    CHECK(file_write(path, "first", 5, &error));
    CHECK(in_child(write_without_input, path) && file_is(path, "second"));
    place_remove(&place, "a");
}

static void check_not_written(const char *path, const char *reason) {
    struct error error;
    CHECK_ROW(!file_write(path, "new", 3, &error), path);
    CHECK_ROW(tells(&error, path, reason), error.message);
}

static void test_write_errors(void) {
    struct place place = place_create();
    check_not_written(place.directory, ": is a directory");
    check_not_written(name_file(&place, "none/a"), ": No such file or directory");
    check_not_written("", ": No such file or directory");
    CHECK(place_count(&place) == 0);
    place_remove(&place, NULL);
}

/* As somebody who may not write there: the superuser may always. */
static bool write_without_permission(const char *path) {
    struct error error;
    return drop_privileges() && !file_write(path, "new", 3, &error) &&
           tells(&error, path, ": Permission denied");
}

static bool make_directory_without_permission(const char *path) {
    struct error error;
    return drop_privileges() && !directory_create(path, &error) &&
           tells(&error, path, ": cannot make the directory: Permission denied");
}

static void test_write_protection(void) {
    struct place place = place_create();
    struct error error;
    const char *path = name_file(&place, "a");
    CHECK(file_write(path, "old", 3, &error));
    CHECK(chmod(path, 0444) == 0 && chmod(place.directory, 0777) == 0);
    CHECK(in_child(write_without_permission, path)); /* a protected file */
    CHECK(unlink(path) == 0 && chmod(place.directory, 0555) == 0);
    CHECK(in_child(write_without_permission, path)); /* a protected directory */
    CHECK(in_child(make_directory_without_permission, path));
    CHECK(chmod(place.directory, 0777) == 0 && place_count(&place) == 0);
    place_remove(&place, NULL);
}

/* Where nobody may write, whoever it is. */
static bool write_from_elsewhere(const char *path) {
    struct error error;
    return chdir("/proc") == 0 && file_write(path, "new", 3, &error);
}

/* The new file is made next to the old one: the caller's directory does not matter. */
static void test_write_from_elsewhere(void) {
    struct place place = place_create();
    if (access("/proc", F_OK) == 0) { /* on Linux */
        CHECK(in_child(write_from_elsewhere, name_file(&place, "a")));
        CHECK(file_is(name_file(&place, "a"), "new") && unlink(place.path) == 0);
    }
    place_remove(&place, NULL);
}

static void check_no_directory(const char *path, const char *reason) {
    struct error error;
    char message[100];
    snprintf(message, sizeof message, ": cannot make the directory: %s", reason);
    CHECK(!directory_create(path, &error));
    CHECK_ROW(tells(&error, path, message), error.message);
}

static bool is_link(const char *path) {
    struct stat status;
    return lstat(path, &status) == 0 && S_ISLNK(status.st_mode);
}

static void test_directory(void) {
    struct place place = place_create();
    struct error error;
    const char *path = name_file(&place, "%s%d");
    CHECK(directory_create(path, &error) && directory_create(path, &error) && rmdir(path) == 0);
    place_remove(&place, NULL);
}

/* A link to a file that is not there yet stays too, and leads to the new file; one that leads into
 * a directory that is not there is an error. */
static void test_dangling_link(void) {
    struct place place = place_create(), other = place;
    struct error error;
    const char *link = name_file(&place, "link"), *a = name_file(&other, "a");
    CHECK(symlink("a", link) == 0);
    CHECK(file_write(link, "new", 3, &error));
    CHECK(is_link(link) && place_count(&place) == 2 && access(link, X_OK) != 0);
    CHECK(file_write(link, "newer", 5, &error) && is_link(link) && place_count(&place) == 2);
    CHECK(file_is(a, "newer"));
    CHECK(unlink(link) == 0 && symlink("b/c", link) == 0);
    check_not_written(link, ": No such file or directory");
    CHECK(place_count(&place) == 2);
    check_no_directory(link, "No such file or directory");
    check_no_directory(a, "Not a directory");
    CHECK(unlink(link) == 0 && symlink("link", link) == 0);
    check_no_directory(link, "Too many levels of symbolic links");
    place_remove(&place, "link,a");
}

static bool write_much(const char *path) {
    static const char much[1 << 22];
    struct error error;
    return file_write(path, much, sizeof much, &error);
}

/* Whenever it is ended, a program leaves the whole file or none. */
static void test_ended_while_writing(void) {
    struct place place = place_create();
    for (int i = 0; i < 60; i++) {
        const struct timespec pause = {.tv_nsec = i * 50000};
        int status;
        fflush(NULL);
        pid_t child = fork();
        if (child == 0) {
            _exit(write_much(name_file(&place, "a")) ? 0 : 1);
        }
        nanosleep(&pause, NULL);
        CHECK(child > 0 && kill(child, SIGTERM) == 0 && waitpid(child, &status, 0) == child);
        CHECK(place_count(&place) <= 1);
        CHECK(!file_exists(name_file(&place, "a")) || file_size(place.path) == 1 << 22);
        unlink(place.path);
    }
    place_remove(&place, NULL);
}

/* Files may have 1000 bytes. */
static bool write_past_limit(const char *path) {
    const struct rlimit limit = {1000, 1000};
    struct sigaction action;
    struct error error;
    char many[5000] = "";
    return setrlimit(RLIMIT_FSIZE, &limit) == 0 && !file_write(path, many, sizeof many, &error) &&
           tells(&error, path, ": File too large") && sigaction(SIGXFSZ, NULL, &action) == 0 &&
           action.sa_handler == SIG_DFL;
}

/* A file that grows too large, as on a full disk, is an error, and no signal: the old one, if there
 * is any, and nothing else is left. */
static void test_size(void) {
    struct place place = place_create();
    CHECK(file_size(name_file(&place, "none")) == 0 && !file_exists(place.path));
    CHECK(put_text(place.path, "") && file_size(place.path) == 0 && file_exists(place.path));
    CHECK(put_text(place.path, "seven..") && file_size(place.path) == 7);
    place_remove(&place, "none");
}

/* A file in other letters, which the path gets then, also where two directories differ in letters
 * alone; none where two fit. */
static void test_find(void) {
    static const struct {
        const char *path, *found; /* NULL: none */
    } rows[] = {
        {"NOTE.TXT", "Note.txt"},
        {"Note.txt", "Note.txt"},
        {"note.tx", NULL},
        {"note.txtt", NULL},
        {"TWO", NULL},
        {"two", NULL},
        {"tWO", "tWO"},
        {"n\xC3\x84", NULL},
        {"note.txt/x", NULL},
        {"none/note.txt", NULL},
        {"//Two", "//Two"},
        {"N\xC3\xA4", "n\xC3\xA4"},
        {"DIR/ONE", "Dir/one"},
        {"dir/One", "Dir/one"},
        {"DIR/both", NULL},
        {"dir/BOTH", "dir/both"},
        {"DIR/two", "dir/two"},
        {"DIR//one", "Dir//one"},
        {"DIR/none", NULL},
        {"./DIR/ONE", "./Dir/one"},
    };
    struct place place = place_create();
    CHECK(put_text(name_file(&place, "Note.txt"), "") && put_text(name_file(&place, "Two"), "") &&
          put_text(name_file(&place, "tWO"), "") && put_text(name_file(&place, "n\xC3\xA4"), ""));
    struct error error;
    CHECK(
        directory_create(name_file(&place, "Dir"), &error) &&
        directory_create(name_file(&place, "dir"), &error) &&
        put_text(name_file(&place, "Dir/one"), "") && put_text(name_file(&place, "Dir/both"), "") &&
        put_text(name_file(&place, "dir/two"), "") && put_text(name_file(&place, "dir/both"), ""));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char path[200];
        snprintf(path, sizeof path, "%s", name_file(&place, rows[i].path));
        CHECK_ROW(file_find(path) == (rows[i].found != NULL), rows[i].path);
        CHECK_ROW(rows[i].found == NULL || strcmp(path, name_file(&place, rows[i].found)) == 0,
                  rows[i].path);
    }
    static const char *const files[] = {"Dir/one", "Dir/both", "dir/two", "dir/both"};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        CHECK(unlink(name_file(&place, files[i])) == 0);
    }
    CHECK(rmdir(name_file(&place, "Dir")) == 0 && rmdir(name_file(&place, "dir")) == 0);
    place_remove(&place, "Note.txt,Two,tWO,n\xC3\xA4");
}

static void test_limit_of_file_size(void) {
    struct place place = place_create();
    CHECK(in_child(write_past_limit, name_file(&place, "a")));
    CHECK(place_count(&place) == 0);
    CHECK(put_text(place.path, "old"));
    CHECK(in_child(write_past_limit, place.path));
    CHECK(file_is(place.path, "old") && place_count(&place) == 1);
    place_remove(&place, "a");
}

/* A device or a pipe is written to, and stays what it is. The devices of the system are only
 * touched without the right to replace them: a wrong program under test must not do harm. */
static bool write_to_null(const char *path) {
    struct error error;
    return drop_privileges() && file_write(path, "gone", 4, &error);
}

static bool write_to_full(const char *path) {
    struct error error;
    return drop_privileges() && !file_write(path, "gone", 4, &error) &&
           tells(&error, path, ": No space left on device");
}

static bool write_to_pipe(const char *path) {
    struct error error;
    return file_write(path, "through", 7, &error);
}

static void test_devices(void) {
    struct place place = place_create();
    struct stat status;
    char got[16] = "";
    CHECK(in_child(write_to_null, "/dev/null"));
    if (stat("/dev/full", &status) == 0) { /* not every system has it */
        CHECK(in_child(write_to_full, "/dev/full"));
    }
    const char *path = name_file(&place, "pipe");
    CHECK(mkfifo(path, 0600) == 0);
    int reader = open(path, O_RDONLY | O_NONBLOCK);
    CHECK(in_child(write_to_pipe, path));
    CHECK(read(reader, got, sizeof got - 1) == 7);
    CHECK_TEXT(got, "through");
    close(reader);
    CHECK(stat(path, &status) == 0 && S_ISFIFO(status.st_mode) && place_count(&place) == 1);
    place_remove(&place, "pipe");
}

UNIT_MAIN(TEST(test_printable_texts), TEST(test_names_of_files), TEST(test_long_messages),
          TEST(test_bytes), TEST(test_read), TEST(test_read_errors), TEST(test_standard_input),
          TEST(test_write), TEST(test_write_without_input), TEST(test_write_errors),
          TEST(test_write_protection), TEST(test_write_from_elsewhere), TEST(test_directory),
          TEST(test_dangling_link), TEST(test_size), TEST(test_find), TEST(test_limit_of_file_size),
          TEST(test_ended_while_writing), TEST(test_devices))
