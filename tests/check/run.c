#define _POSIX_C_SOURCE 200809L

#include "run.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

enum {
    MESSAGE_LIMIT = 256 * 1024, /* bytes of standard error that are kept */
    TICK_MS = 5,                /* between two looks at a running program */
    COUNT_MS = 100,             /* between two counts of what it uses */
    OPEN_FILES = 256,           /* in each of its processes */
    FILE_COUNT = 4096,          /* in its directory */
    FILE_DEPTH = 64,            /* directories in one another */
    SIGNALED = 128              /* and a signal: the status that tells of it */
};

static const double seconds_to_end = 0.5;      /* between SIGTERM and SIGKILL */
static const double seconds_to_clean_up = 2.0; /* for killed processes to be gone */

/* ---- Standard files ---- */

bool run_open_standard_files(void) {
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++) {
        /* The lowest number that is free is this one. */
        if (fcntl(file, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != file) {
            return false;
        }
    }
    return true;
}

/* ---- Being asked to end ---- */

/* The only changing global: a signal handler has no other way to tell. */
static volatile sig_atomic_t caught_signal;

static const int caught_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

static void catch_signal(int number) {
    caught_signal = number;
}

void run_catch_signals(void) {
    for (size_t i = 0; i < sizeof caught_signals / sizeof caught_signals[0]; i++) {
        struct sigaction action;
        if (sigaction(caught_signals[i], NULL, &action) == 0 && action.sa_handler != SIG_IGN) {
            memset(&action, 0, sizeof action);
            action.sa_handler = catch_signal;
            sigaction(caught_signals[i], &action, NULL);
        }
    }
}

int run_caught_signal(void) {
    return caught_signal;
}

void run_die_of_signal(void) {
    signal(caught_signal, SIG_DFL);
    raise(caught_signal);
}

struct signal_name run_signal_name(int number) {
    static const struct {
        int number;
        const char *name;
    } known[] = {
        {SIGSEGV, "SIGSEGV"}, {SIGABRT, "SIGABRT"}, {SIGFPE, "SIGFPE"},   {SIGILL, "SIGILL"},
        {SIGBUS, "SIGBUS"},   {SIGTRAP, "SIGTRAP"}, {SIGSYS, "SIGSYS"},   {SIGPIPE, "SIGPIPE"},
        {SIGKILL, "SIGKILL"}, {SIGTERM, "SIGTERM"}, {SIGXFSZ, "SIGXFSZ"}, {SIGXCPU, "SIGXCPU"},
        {SIGINT, "SIGINT"},   {SIGQUIT, "SIGQUIT"}, {SIGHUP, "SIGHUP"},   {SIGALRM, "SIGALRM"},
    };
    struct signal_name name;
    snprintf(name.text, sizeof name.text, "signal %d", number);
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (known[i].number == number) {
            snprintf(name.text, sizeof name.text, "%s", known[i].name);
        }
    }
    return name;
}

/* ---- Limits ---- */

enum { MEGABYTE = 1000 * 1000 };

struct run_limits run_program_limits(double seconds) {
    return (struct run_limits){.seconds = seconds,
                               .file_bytes = (size_t)64 * MEGABYTE,
                               .disk_bytes = (size_t)256 * MEGABYTE,
                               .group_bytes = (size_t)2000 * MEGABYTE,
                               .processes = 64};
}

struct run_text run_stopped_by(const struct run_result *result, const struct run_limits *limits) {
    struct run_text text = {""};
    if (result->end == RUN_OUT_OF_TIME) {
        snprintf(text.text, sizeof text.text, "stopped after %g s", limits->seconds);
    } else if (result->end == RUN_TOO_MANY) {
        snprintf(text.text, sizeof text.text, "stopped at more than %u processes",
                 limits->processes);
    } else if (result->end == RUN_TOO_LARGE) {
        snprintf(text.text, sizeof text.text, "stopped at more than %zu MB of memory",
                 limits->group_bytes / MEGABYTE);
    } else if (result->end == RUN_DISK_FULL) {
        snprintf(text.text, sizeof text.text,
                 "stopped at more than %zu MB of files, %d of them, or %d levels deep",
                 limits->disk_bytes / MEGABYTE, FILE_COUNT, FILE_DEPTH);
    } else if (result->end == RUN_KILLED && result->number == SIGXFSZ) {
        snprintf(text.text, sizeof text.text, "SIGXFSZ, file larger than %zu MB",
                 limits->file_bytes / MEGABYTE);
    }
    return text;
}

/* ---- Time ---- */

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec / 1e9;
}

static void pause_ms(long ms) {
    nanosleep(&(struct timespec){.tv_nsec = ms * 1000000}, NULL);
}

/* ---- The processes that descend from this one (Linux) ---- */

struct process {
    pid_t id, parent;
    size_t pages; /* in memory */
    bool descends;
};

/* What the descendants use together. */
struct group {
    size_t processes, bytes;
};

struct process_list {
    struct process *processes;
    size_t count;
};

#ifdef __linux__

/* From /proc/ID/stat, "ID (name) state parent ...", of which the 24th is the pages in memory; the
 * name may hold anything. */
static bool read_process(const char *id, struct process *process) {
    char path[64], text[512];
    snprintf(path, sizeof path, "/proc/%.20s/stat", id);
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return false;
    }
    ssize_t length = read(file, text, sizeof text - 1);
    close(file);
    if (length <= 0) {
        return false;
    }
    text[length] = '\0';
    const char *after_name = strrchr(text, ')');
    char state;
    long parent, pages;
    if (after_name == NULL ||
        sscanf(after_name + 1,
               " %c %ld %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s "
               "%*s %ld",
               &state, &parent, &pages) != 3) {
        return false;
    }
    process->parent = (pid_t)parent;
    process->pages = pages > 0 ? (size_t)pages : 0;
    return true;
}

static void list_all(struct process_list *list) {
    DIR *directory = opendir("/proc");
    if (directory == NULL) {
        return;
    }
    size_t capacity = 0;
    struct dirent *entry;
    while ((entry = readdir(directory)) != NULL) {
        struct process process = {.id = (pid_t)strtol(entry->d_name, NULL, 10)};
        if (process.id <= 0 || !read_process(entry->d_name, &process)) {
            continue;
        }
        if (list->count == capacity) {
            capacity = capacity == 0 ? 256 : 2 * capacity;
            struct process *larger = realloc(list->processes, capacity * sizeof *larger);
            if (larger == NULL) {
                break;
            }
            list->processes = larger;
        }
        list->processes[list->count++] = process;
    }
    closedir(directory);
}

static bool is_descendant(const struct process_list *list, pid_t id) {
    for (size_t i = 0; i < list->count; i++) {
        if (list->processes[i].id == id) {
            return list->processes[i].descends;
        }
    }
    return false;
}

/* Mark all descendants of this process and return what they use; with a signal, send it. */
static struct group find_descendants(int signal_to_send) {
    struct process_list list = {.processes = NULL};
    list_all(&list);
    struct group found = {0};
    size_t before, page = (size_t)sysconf(_SC_PAGESIZE);
    do { /* a parent may stand behind its child in the list */
        before = found.processes;
        for (size_t i = 0; i < list.count; i++) {
            struct process *p = &list.processes[i];
            if (!p->descends && (p->parent == getpid() || is_descendant(&list, p->parent))) {
                p->descends = true;
                found.processes++;
                found.bytes += p->pages * page;
                if (signal_to_send != 0) {
                    kill(p->id, signal_to_send);
                }
            }
        }
    } while (found.processes != before);
    free(list.processes);
    return found;
}

/* With this, a process whose parent has died becomes our child, wherever it has hidden. */
static void adopt_orphans(bool adopt) {
    prctl(PR_SET_CHILD_SUBREAPER, adopt ? 1UL : 0UL, 0UL, 0UL, 0UL);
}

/* Threads on the whole machine, which are at least those of this user; 0 when unknown. */
static size_t count_threads(void) {
    FILE *file = fopen("/proc/loadavg", "r");
    size_t threads = 0;
    if (file != NULL) {
        if (fscanf(file, "%*s %*s %*s %*u/%zu", &threads) != 1) {
            threads = 0;
        }
        fclose(file);
    }
    return threads;
}

#else

static struct group find_descendants(int signal_to_send) {
    (void)signal_to_send;
    return (struct group){0};
}

static void adopt_orphans(bool adopt) {
    (void)adopt;
}

static size_t count_threads(void) {
    return 0;
}

#endif

/* Kill and reap what is left. */
static void clean_up_processes(void) {
    double end = now() + seconds_to_clean_up;
    pid_t reaped;
    while ((reaped = waitpid(-1, NULL, WNOHANG)) >= 0 && now() < end) {
        if (reaped == 0) {
            find_descendants(SIGKILL);
            pause_ms(1);
        }
    }
}

/* ---- The child's side ---- */

static void lower_limit(int resource, rlim_t soft, rlim_t hard) {
    struct rlimit limit;
    if (getrlimit(resource, &limit) != 0) {
        return;
    }
    limit.rlim_max = limit.rlim_max < hard ? limit.rlim_max : hard;
    limit.rlim_cur = soft < limit.rlim_max ? soft : limit.rlim_max;
    setrlimit(resource, &limit);
}

static void limit_sizes(const struct run_limits *limits) {
    if (limits->file_bytes > 0) {
        lower_limit(RLIMIT_FSIZE, limits->file_bytes, limits->file_bytes);
    }
    if (limits->memory_bytes > 0) {
        lower_limit(RLIMIT_AS, limits->memory_bytes, limits->memory_bytes);
    }
}

static void limit_work(const struct run_limits *limits, size_t threads) {
    long cores = 1;
#ifdef _SC_NPROCESSORS_ONLN
    cores = sysconf(_SC_NPROCESSORS_ONLN) > 1 ? sysconf(_SC_NPROCESSORS_ONLN) : 1;
#endif
    rlim_t seconds = (rlim_t)(limits->seconds * (double)cores) + 1;
    lower_limit(RLIMIT_CPU, seconds, seconds + 1);
    lower_limit(RLIMIT_CORE, 0, 0);
    lower_limit(RLIMIT_NOFILE, OPEN_FILES, OPEN_FILES);
#ifdef RLIMIT_NPROC
    /* It counts the threads of all that the user runs: leave room for those, and for ours. */
    rlim_t processes = (threads > 0 ? threads : 2048) + limits->processes + 1024;
    lower_limit(RLIMIT_NPROC, processes, processes);
#else
    (void)threads;
#endif
}

static void child_fail(const char *what, const char *name) {
    char text[512];
    int length = snprintf(text, sizeof text, "cannot %s %s: %s\n", what, name, strerror(errno));
    if (length > 0 && write(STDERR_FILENO, text, strlen(text)) < 0) {
        _exit(126);
    }
    _exit(127);
}

/* The command that runs the programs, or NULL. */
static const char *runner(void) {
    const char *command = getenv("CHECK_RUNNER");
    return command != NULL && command[0] != '\0' ? command : NULL;
}

static void execute(const struct run_command *command) {
    enum { ARGUMENT_LIMIT = 64 };
    const char *const *arguments = command->arguments;
    const char *run_by[ARGUMENT_LIMIT + 2] = {runner()};
    if (command->contained && run_by[0] != NULL) {
        for (size_t i = 0; i < ARGUMENT_LIMIT && arguments[i] != NULL; i++) {
            run_by[i + 1] = arguments[i];
        }
        arguments = run_by;
    }
    /* execvp() takes pointers to characters that it does not change. */
    execvp(arguments[0], (char *const *)(uintptr_t)arguments);
    child_fail("start", arguments[0]);
}

enum { DIRECTORY_FLAGS = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC };

/* Make it the current directory. A link is not followed: a program may have put it there. */
static bool enter(const char *directory) {
    int file = open(directory, DIRECTORY_FLAGS);
    bool entered = file >= 0 && fchdir(file) == 0;
    if (file >= 0) {
        close(file);
    }
    return entered;
}

static void child(const struct run_command *command, int messages, size_t threads) {
    if (command->contained) {
        setsid(); /* a group of its own, and no terminal to write a score to */
    } else {
        setpgid(0, 0);
    }
    signal(SIGPIPE, SIG_DFL);
    int input = open("/dev/null", O_RDONLY);
    int output = command->output == NULL ? open("/dev/null", O_WRONLY)
                                         : open(command->output, O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (input < 0 || output < 0 || dup2(input, STDIN_FILENO) < 0 ||
        dup2(output, STDOUT_FILENO) < 0 || dup2(messages, STDERR_FILENO) < 0) {
        _exit(127);
    }
    close(input);
    close(output);
    if (command->locale != NULL) {
        setenv("LC_ALL", command->locale, 1);
    }
    if (command->directory != NULL && !enter(command->directory)) {
        child_fail("enter", command->directory);
    }
    if (command->contained) {
        for (int file = STDERR_FILENO + 1; file < 256; file++) {
            close(file); /* such as the pipe through which make hands out its jobs */
        }
        unsetenv("MAKEFLAGS");
        unsetenv("MFLAGS");
        limit_work(&command->limits, threads);
    }
    limit_sizes(&command->limits);
    execute(command);
}

/* ---- The parent's side ---- */

/* Has the process ended? It stays a zombie, so that its number, and with it the number of its
 * group, is not given to anyone else before the group is killed. */
static bool has_ended(pid_t id) {
    siginfo_t info;
    memset(&info, 0, sizeof info);
    return waitid(P_PID, (id_t)id, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == id;
}

/* Read what is there, at most one buffer; false when there is nothing, or never will be. */
static bool read_messages(int pipe_end, struct bytes *messages) {
    char buffer[65536];
    ssize_t length = read(pipe_end, buffer, sizeof buffer);
    if (length <= 0) {
        return false;
    }
    size_t room = MESSAGE_LIMIT - messages->size;
    bytes_append(messages, buffer, (size_t)length < room ? (size_t)length : room);
    return true;
}

/* Wait a tick, or less when the program says something. */
static void wait_a_tick(int *pipe_end, struct bytes *messages) {
    struct pollfd waited = {.fd = *pipe_end, .events = POLLIN};
    if (*pipe_end < 0) {
        pause_ms(TICK_MS);
    } else if (poll(&waited, 1, TICK_MS) > 0 && !read_messages(*pipe_end, messages)) {
        close(*pipe_end);
        *pipe_end = -1;
    }
}

/* What a directory holds; more than is allowed of depth or count is `full`. */
struct disk_use {
    size_t bytes, files;
    bool full;
};

static void measure_directory(struct disk_use *use, int parent, const char *name, int depth) {
    int file = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *directory = file < 0 ? NULL : fdopendir(file);
    struct dirent *entry;
    struct stat status;
    while (directory != NULL && !use->full && (entry = readdir(directory)) != NULL) {
        bool counts = strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
        if (counts && fstatat(file, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) == 0) {
            use->files++;
            use->bytes += (size_t)status.st_blocks * 512;
            use->full = use->files > FILE_COUNT || depth > FILE_DEPTH;
            if (S_ISDIR(status.st_mode) && !use->full) {
                measure_directory(use, file, entry->d_name, depth + 1);
            }
        }
    }
    if (directory != NULL) {
        closedir(directory);
    } else if (file >= 0) {
        close(file);
    }
}

/* Does it use more than it may? RUN_EXITED: it does not. */
static enum run_end judge_use(const struct run_command *command) {
    const struct run_limits *limits = &command->limits;
    struct group group = find_descendants(0);
    struct disk_use disk = {.bytes = 0};
    if (limits->disk_bytes > 0) {
        measure_directory(&disk, AT_FDCWD, command->directory, 0);
    }
    bool disk_full = disk.full || disk.bytes > limits->disk_bytes;
    return group.processes > limits->processes                            ? RUN_TOO_MANY
           : limits->group_bytes > 0 && group.bytes > limits->group_bytes ? RUN_TOO_LARGE
           : limits->disk_bytes > 0 && disk_full                          ? RUN_DISK_FULL
                                                                          : RUN_EXITED;
}

/* Wait until the program ends or must be stopped. */
static enum run_end watch(const struct run_command *command, pid_t id, int *pipe_end,
                          struct bytes *messages) {
    double start = now(), next_count = start + COUNT_MS / 1000.0;
    while (!has_ended(id)) {
        double time = now();
        if (run_caught_signal() != 0) {
            return RUN_INTERRUPTED;
        }
        if (time - start > command->limits.seconds) {
            return RUN_OUT_OF_TIME;
        }
        if (command->contained && time > next_count) {
            enum run_end end = judge_use(command);
            next_count = now() + COUNT_MS / 1000.0;
            if (end != RUN_EXITED) {
                return end;
            }
        }
        wait_a_tick(pipe_end, messages);
    }
    return RUN_EXITED;
}

/* The group may not be there yet: then there is only its leader. */
static void signal_group(pid_t id, int number) {
    if (kill(-id, number) != 0) {
        kill(id, number);
    }
}

/* End the whole group, and reap its leader. Returns the leader's wait status. */
static int end_group(pid_t id, enum run_end end) {
    if (end == RUN_OUT_OF_TIME || end == RUN_INTERRUPTED) {
        signal_group(id, SIGTERM);
        for (double limit = now() + seconds_to_end; now() < limit && !has_ended(id);) {
            pause_ms(TICK_MS);
        }
    }
    signal_group(id, SIGKILL);
    int status = 0;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

static void judge_status(struct run_result *result, int status, bool contained) {
    if (result->end != RUN_EXITED) {
        return;
    }
    bool told =
        contained && runner() != NULL && WIFEXITED(status) && WEXITSTATUS(status) > SIGNALED;
    if (WIFSIGNALED(status) || told) {
        result->number = told ? WEXITSTATUS(status) - SIGNALED : WTERMSIG(status);
        result->end = result->number == SIGXCPU ? RUN_OUT_OF_TIME : RUN_KILLED;
    } else {
        result->number = WEXITSTATUS(status);
    }
}

/* A text ends at its first NUL: those in it become blanks. */
static void blank_nuls(struct bytes *messages) {
    for (size_t i = 0; i < messages->size; i++) {
        messages->data[i] = messages->data[i] == '\0' ? ' ' : messages->data[i];
    }
}

bool run(const struct run_command *command, struct run_result *result, struct error *error) {
    *result = (struct run_result){.end = RUN_EXITED};
    int ends[2];
    if (pipe(ends) != 0) {
        return error_set(error, "cannot make a pipe: %s", strerror(errno));
    }
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    size_t threads = count_threads();
    adopt_orphans(command->contained);
    fflush(NULL);
    pid_t id = fork();
    if (id == 0) {
        child(command, ends[1], threads);
    }
    close(ends[1]);
    bool done = id > 0;
    if (done) {
        if (!command->contained) {
            setpgid(id, id); /* the child does it too: whoever comes first */
        }
        result->end = watch(command, id, &ends[0], &result->messages);
        int status = end_group(id, result->end);
        if (command->contained) {
            clean_up_processes();
        }
        while (ends[0] >= 0 && result->messages.size < MESSAGE_LIMIT &&
               read_messages(ends[0], &result->messages)) {
        }
        blank_nuls(&result->messages);
        judge_status(result, status, command->contained);
        done = bytes_append(&result->messages, "", 1) || error_set(error, "out of memory");
    } else {
        error_set(error, "cannot make a process: %s", strerror(errno));
    }
    if (ends[0] >= 0) {
        close(ends[0]);
    }
    adopt_orphans(false);
    return done;
}

/* ---- Directories ---- */

const char *run_temporary(void) {
    const char *directory = getenv("TMPDIR");
    return directory != NULL && directory[0] == '/' ? directory : "/tmp";
}

bool run_has_room(const char *directory, size_t bytes, struct error *error) {
    struct statvfs disk;
    if (statvfs(directory, &disk) != 0) {
        return true;
    }
    const double wanted = (double)bytes, free_bytes = (double)disk.f_bavail * (double)disk.f_frsize;
    if (free_bytes < wanted) {
        return error_set(error, "%.900s: %s (%.1f MB may be needed, %.1f MB are free)", directory,
                         strerror(ENOSPC), wanted / MEGABYTE, free_bytes / MEGABYTE);
    }
    return disk.f_files == 0 || disk.f_favail > 0 || /* some file systems count none */
           error_set(error, "%.900s: %s (for another file)", directory, strerror(ENOSPC));
}

/* One that cannot be opened is not left there. */
static bool open_directory(struct run_directory *directory, struct error *error) {
    directory->file = open(directory->path, DIRECTORY_FLAGS);
    if (directory->file < 0) {
        error_set(error, "%.900s: %s", directory->path, strerror(errno));
        rmdir(directory->path);
    }
    return directory->file >= 0;
}

bool run_directory_make(struct run_directory *directory, const char *path, struct error *error) {
    directory->file = -1;
    if ((size_t)snprintf(directory->path, sizeof directory->path, "%s", path) >=
        sizeof directory->path) {
        return error_set(error, "%.900s: name too long", path);
    }
    if (mkdir(path, 0777) != 0) {
        return error_set(error, "%.900s: cannot make the directory: %s", path, strerror(errno));
    }
    return open_directory(directory, error);
}

bool run_directory_create(struct run_directory *directory, struct error *error) {
    const char *parent = run_temporary();
    directory->file = -1;
    if ((size_t)snprintf(directory->path, sizeof directory->path, "%s/check.XXXXXX", parent) >=
        sizeof directory->path) {
        return error_set(error, "%.900s: name too long", parent);
    }
    if (mkdtemp(directory->path) == NULL) {
        return error_set(error, "cannot make a directory in %s: %s", parent, strerror(errno));
    }
    return open_directory(directory, error);
}

/* Links are removed, not followed. */
static bool remove_entry(int parent, const char *name) {
    return unlinkat(parent, name, 0) == 0 || unlinkat(parent, name, AT_REMOVEDIR) == 0;
}

static bool is_dots(const char *name) {
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

static int open_inside(int parent, const char *name) {
    int file = openat(parent, name, DIRECTORY_FLAGS);
    if (file < 0 && errno == EACCES && fchmodat(parent, name, 0700, 0) == 0) {
        file = openat(parent, name, DIRECTORY_FLAGS);
    }
    return file;
}

/* Move an entry of a directory into `top`, under the next name that is free there. */
static bool lift_entry(int directory, const char *name, int top, unsigned long *number) {
    char lifted[40];
    bool done;
    fchmodat(directory, name, 0700, 0); /* its ".." changes */
    do {
        snprintf(lifted, sizeof lifted, "lifted.%lu", (*number)++);
        done = renameat(directory, name, top, lifted) == 0;
    } while (!done && (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR));
    return done;
}

/* Remove what is in the directory `name` of `top`, and lift directories that are not empty into
 * `top`, under new names. Returns how many entries are no longer there. */
static size_t lift_contents(int top, const char *name, unsigned long *number) {
    size_t gone = 0;
    int file = open_inside(top, name);
    DIR *directory = file < 0 ? NULL : fdopendir(file);
    if (directory == NULL) {
        return 0;
    }
    fchmod(file, 0700);
    struct dirent *entry;
    while ((entry = readdir(directory)) != NULL) {
        if (is_dots(entry->d_name)) {
            continue;
        }
        gone += remove_entry(file, entry->d_name) || lift_entry(file, entry->d_name, top, number);
    }
    closedir(directory);
    return gone;
}

/* Remove what can be removed at once. Returns whether anything was. */
static bool remove_uppermost(int top, unsigned long *number) {
    size_t gone = 0;
    int file = openat(top, ".", DIRECTORY_FLAGS);
    DIR *directory = file < 0 ? NULL : fdopendir(file);
    if (directory == NULL) {
        return false;
    }
    struct dirent *entry;
    while ((entry = readdir(directory)) != NULL) {
        if (!is_dots(entry->d_name) && !remove_entry(top, entry->d_name)) {
            gone += lift_contents(top, entry->d_name, number);
            gone += remove_entry(top, entry->d_name);
        } else {
            gone += !is_dots(entry->d_name);
        }
    }
    closedir(directory);
    return gone > 0;
}

/* Remove everything in an open directory, and close it. A program may have nested directories
 * deeper than files can be open: so whatever the depth, two are. */
static void remove_contents(int file) {
    unsigned long number = 0;
    fchmod(file, 0700);
    while (remove_uppermost(file, &number)) {
    }
    close(file);
}

/* Remove everything in the directory `name` of `parent`, then the directory. */
static void remove_tree(int parent, const char *name) {
    int file = open_inside(parent, name);
    if (file >= 0) {
        remove_contents(file);
    }
    unlinkat(parent, name, AT_REMOVEDIR);
}

/* The name that an open directory has now. Only Linux tells it, where there is a /proc. */
static bool name_of(int file, char *path, size_t size) {
    char link[40];
    struct stat open_one, named;
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    ssize_t length = readlink(link, path, size - 1);
    if (length < 0) {
        return false;
    }
    path[length] = '\0';
    return fstat(file, &open_one) == 0 && lstat(path, &named) == 0 &&
           open_one.st_dev == named.st_dev && open_one.st_ino == named.st_ino;
}

/* A program may have given its directory another name, anywhere on the disk: what is in it goes in
 * any case. Where the new name cannot be found, an empty directory stays. */
static void remove_moved(int moved) {
    char path[4096];
    bool removed = false;
    fchmod(moved, 0700);
    for (int i = 0; i < 3 && !removed; i++) {
        int file = openat(moved, ".", DIRECTORY_FLAGS);
        if (file >= 0) {
            remove_contents(file);
        }
        removed = !name_of(moved, path, sizeof path) || rmdir(path) == 0;
    }
}

void run_directory_remove(const struct run_directory *directory) {
    /* More than once, because entries may be passed over while others are removed. A program may
     * have put something else in the directory's place, such as a link. */
    for (int i = 0; i < 3 && unlink(directory->path) != 0 && errno != ENOENT; i++) {
        remove_tree(AT_FDCWD, directory->path);
    }
    if (directory->file >= 0) {
        remove_moved(directory->file);
        close(directory->file);
    }
}
