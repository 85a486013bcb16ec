/* All systems but Windows: see run.h. */
#ifdef __linux__ /* POSIX.1-2008 with nftw(), and RLIMIT_NPROC; other systems have them unasked */
#define _DEFAULT_SOURCE 1
#define _XOPEN_SOURCE   700
#endif

#include "run.h"

#ifndef _WIN32

#include "base/array.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
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

enum {
    MESSAGE_LIMIT = 256 * 1024, /* bytes of standard error that are kept */
    TICK_MS = 5,                /* between two looks at a running program */
    COUNT_MS = 100,             /* between two counts of what it uses */
    OPEN_FILES = 256,           /* in each of its processes */
    SIGNALED = 128              /* and a signal: the status that means it */
};

static const double seconds_to_end = 0.5;      /* between SIGTERM and SIGKILL */
static const double seconds_to_clean_up = 2.0; /* for killed processes to be gone */
static const double patience = 10; /* times the limit, while others keep the processors busy */
static const double seconds_of_patience = 5; /* with a compiler that gets no processor */

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

/* ---- Time ---- */

static void pause_ms(long ms) {
    nanosleep(&(struct timespec){.tv_nsec = ms * 1000000}, NULL);
}

/* ---- What a program uses (Linux) ---- */

/* What all its processes use together. */
struct group {
    size_t processes, bytes;
    double seconds; /* of processor time */
    bool runs;      /* or waits for a processor, and for nothing else */
};

struct process {
    pid_t id, parent, group;
    size_t pages; /* in memory */
    long ticks;   /* of processor time, with the children that it has waited for */
    bool runs, counts;
};

struct process_list {
    struct process *processes;
    size_t count, capacity;
};

/* From /proc/ID/stat, "ID (name) state parent group ...", with four times from the 14th on, and the
 * pages in memory as the 24th; the name may hold anything. */
static bool read_process(const char *id, struct process *process) {
    char path[64], text[512], state;
    long parent, group, times[4], pages;
    snprintf(path, sizeof path, "/proc/%.20s/stat", id);
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        return false;
    }
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    const char *after_name = strrchr(text, ')');
    if (after_name == NULL ||
        sscanf(after_name + 1,
               " %c %ld %ld %*s %*s %*s %*s %*s %*s %*s %*s %ld %ld %ld %ld %*s %*s %*s %*s %*s "
               "%*s %ld",
               &state, &parent, &group, &times[0], &times[1], &times[2], &times[3], &pages) != 8) {
        return false;
    }
    *process = (struct process){.id = (pid_t)strtol(id, NULL, 10),
                                .parent = (pid_t)parent,
                                .group = (pid_t)group,
                                .pages = pages > 0 ? (size_t)pages : 0,
                                .ticks = times[0] + times[1] + times[2] + times[3],
                                .runs = state == 'R'};
    return true;
}

/* List all processes; none where there is no /proc. */
static struct process_list list_processes(void) {
    struct process_list list = {.count = 0};
    DIR *directory = opendir("/proc");
    struct dirent *entry;
    while (directory != NULL && (entry = readdir(directory)) != NULL) {
        struct process process;
        if (!isdigit((unsigned char)entry->d_name[0]) || !read_process(entry->d_name, &process)) {
            continue;
        }
        if (!array_extend(&list.processes, &list.capacity, list.count + 1, sizeof process)) {
            break;
        }
        list.processes[list.count++] = process;
    }
    if (directory != NULL) {
        closedir(directory);
    }
    return list;
}

/* Is it one of the program's: in its group, or started by one that counts? */
static bool belongs(const struct process_list *list, const struct process *process, pid_t leader) {
    bool found = process->group == leader;
    for (size_t i = 0; i < list->count && !found; i++) {
        found = list->processes[i].counts && list->processes[i].id == process->parent;
    }
    return found;
}

/* Add up what the program's processes use, of which `leader` is the first. */
static struct group measure_group(pid_t leader) {
    struct process_list list = list_processes();
    struct group found = {0};
    size_t before, page = (size_t)sysconf(_SC_PAGESIZE);
    double ticks_a_second = (double)sysconf(_SC_CLK_TCK);
    do { /* a parent may come after its child in the list */
        before = found.processes;
        for (size_t i = 0; i < list.count; i++) {
            struct process *process = &list.processes[i];
            if (!process->counts && belongs(&list, process, leader)) {
                process->counts = true;
                found.processes++;
                found.bytes += process->pages * page;
                found.seconds += (double)process->ticks / ticks_a_second;
                found.runs |= process->runs;
            }
        }
    } while (found.processes != before);
    free(list.processes);
    return found;
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
#ifndef __APPLE__ /* there the libraries that all processes share count as well: many GiB */
    if (limits->memory_bytes > 0) {
        lower_limit(RLIMIT_AS, limits->memory_bytes, limits->memory_bytes);
    }
#endif
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
    /* It counts all of the user's threads: leave room for those, and for ours. */
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

/* Stay between the check and the program, which comes back here as a child: a program that ends its
 * parent does not end the check. This process ends as the program does. */
static void stand_between(void) {
    pid_t program = fork();
    int status;
    if (program == 0) {
        return;
    }
    signal(SIGTERM, SIG_IGN); /* the program may take its time after it, up to a limit */
    if (program < 0 || waitpid(program, &status, 0) != program) {
        _exit(127);
    }
    if (WIFSIGNALED(status)) {
        signal(WTERMSIG(status), SIG_DFL);
        raise(WTERMSIG(status));
    }
    _exit(WEXITSTATUS(status));
}

/* A new file, so that nobody's is written into. */
static int open_output(const struct run_command *command) {
    return command->output == NULL ? open("/dev/null", O_WRONLY)
                                   : open(command->output, O_WRONLY | O_CREAT | O_EXCL, 0600);
}

/* `output` is a pipe, or -1 where all goes to the file. */
static void child(const struct run_command *command, int output, int messages, size_t threads) {
    setsid(); /* its own group, and no terminal to write a score to */
    signal(SIGPIPE, SIG_DFL);
    int input = open("/dev/null", O_RDONLY);
    output = output < 0 ? open_output(command) : output;
    if (input < 0 || output < 0 || dup2(input, STDIN_FILENO) < 0 ||
        dup2(output, STDOUT_FILENO) < 0 || dup2(messages, STDERR_FILENO) < 0) {
        _exit(127);
    }
    close(input);
    close(output);
    if (command->locale != NULL) {
        setenv("LC_ALL", command->locale, 1);
    }
    if (command->directory != NULL && chdir(command->directory) != 0) {
        child_fail("enter", command->directory);
    }
    if (command->contained) {
        for (int file = STDERR_FILENO + 1; file < OPEN_FILES; file++) {
            close(file); /* such as the pipe through which make hands out its jobs */
        }
        limit_work(&command->limits, threads);
        setenv("MALLOC_PERTURB_", "90", 0); /* glibc: what malloc() gives is not 0 by luck */
    }
    limit_sizes(&command->limits);
    if (command->contained) {
        stand_between();
    }
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

/* What a program writes, and what of it is kept: the first `size` bytes, or the last. */
struct stream {
    int ends[2]; /* of the pipe: to read, to write; -1 when closed */
    size_t size;
    bool keeps_last;
    struct bytes kept; /* at most 2 * size */
};

enum { MESSAGES, OUTPUT, STREAMS };

static bool open_stream(struct stream *stream) {
    if (pipe(stream->ends) != 0) {
        return false;
    }
    fcntl(stream->ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(stream->ends[1], F_SETFD, FD_CLOEXEC);
    fcntl(stream->ends[0], F_SETFL, O_NONBLOCK);
    return true;
}

static void close_end(int *end) {
    if (*end >= 0) {
        close(*end);
    }
    *end = -1;
}

/* Forget what is older than the last bytes. */
static void keep_last(struct stream *stream, size_t size) {
    if (stream->kept.size > size) {
        memmove(stream->kept.data, stream->kept.data + stream->kept.size - size, size);
        stream->kept.size = size;
    }
}

/* Read what has come, at most one buffer; false when nothing has, or never will. */
static bool read_stream(struct stream *stream) {
    char buffer[65536];
    ssize_t length = read(stream->ends[0], buffer, sizeof buffer);
    if (length <= 0) {
        return false;
    }
    size_t room = stream->keeps_last ? sizeof buffer : stream->size - stream->kept.size;
    bytes_append(&stream->kept, buffer, (size_t)length < room ? (size_t)length : room);
    if (stream->keeps_last && stream->kept.size > 2 * stream->size) {
        keep_last(stream, stream->size);
    }
    return true;
}

/* Wait a tick, or less when the program says something. */
static void wait_a_tick(struct stream streams[STREAMS]) {
    struct pollfd waited[STREAMS];
    nfds_t count = 0;
    for (int i = 0; i < STREAMS; i++) {
        if (streams[i].ends[0] >= 0) {
            waited[count++] = (struct pollfd){.fd = streams[i].ends[0], .events = POLLIN};
        }
    }
    if (count == 0) {
        pause_ms(TICK_MS);
    } else if (poll(waited, count, TICK_MS) > 0) {
        for (int i = 0, k = 0; i < STREAMS; i++) {
            if (streams[i].ends[0] >= 0 && waited[k++].revents != 0 && !read_stream(&streams[i])) {
                close_end(&streams[i].ends[0]);
            }
        }
    }
}

/* Read until nobody is left who could say more: what a container holds ends after the container. */
static void wait_for_silence(struct stream streams[STREAMS]) {
    for (double end = run_now() + seconds_to_clean_up;
         (streams[MESSAGES].ends[0] >= 0 || streams[OUTPUT].ends[0] >= 0) && run_now() < end;) {
        wait_a_tick(streams);
    }
}

/* Write the last bytes of the output into its file; one that cannot be made stays away. */
static void write_output(const struct run_command *command, struct stream *output) {
    int file = open_output(command);
    keep_last(output, output->size);
    for (size_t done = 0; file >= 0 && done < output->kept.size;) {
        ssize_t length = write(file, output->kept.data + done, output->kept.size - done);
        if (length <= 0) {
            break;
        }
        done += (size_t)length;
    }
    close_end(&file);
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
            use->full = use->files > RUN_FILE_COUNT || depth > RUN_FILE_DEPTH;
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
static enum run_end judge_use(const struct run_command *command, const struct group *group) {
    const struct run_limits *limits = &command->limits;
    struct disk_use disk = {.bytes = 0};
    if (limits->disk_bytes > 0) {
        measure_directory(&disk, AT_FDCWD, command->directory, 0);
    }
    bool disk_full = disk.full || disk.bytes > limits->disk_bytes;
    return group->processes > limits->processes + 1 /* the one between */  ? RUN_TOO_MANY
           : limits->group_bytes > 0 && group->bytes > limits->group_bytes ? RUN_TOO_LARGE
           : limits->disk_bytes > 0 && disk_full                           ? RUN_DISK_FULL
                                                                           : RUN_EXITED;
}

/* Has it had its time? A program from which others keep the processors gets more, as does a build
 * as long as it gets anywhere: `idle` are the seconds since it has last used a processor. */
static bool is_out_of_time(const struct run_command *command, const struct group *group,
                           double seconds, double idle) {
    const double limit = command->limits.seconds;
    bool runs = command->contained ? group->runs : idle < seconds_of_patience;
    bool starves = runs && group->seconds < limit;
    return seconds > limit && (!starves || seconds > patience * limit);
}

/* Wait until the program ends or must be stopped. */
static enum run_end watch(const struct run_command *command, pid_t id,
                          struct stream streams[STREAMS]) {
    double start = run_now(), next_count = start + COUNT_MS / 1000.0;
    double used = 0, last_used = start; /* seconds of processors, and when they last grew */
    bool ran = false;                   /* at the last count */
    while (!has_ended(id)) {
        double time = run_now();
        if (run_caught_signal() != 0) {
            return RUN_INTERRUPTED;
        }
        if (time > next_count) {
            struct group group = measure_group(id);
            bool runs = group.runs;
            group.runs = runs || ran; /* it may wait for its file just now */
            ran = runs;
            last_used = group.seconds != used ? time : last_used;
            used = group.seconds;
            enum run_end end = is_out_of_time(command, &group, time - start, time - last_used)
                                   ? RUN_OUT_OF_TIME
                               : command->contained ? judge_use(command, &group)
                                                    : RUN_EXITED;
            next_count = run_now() + COUNT_MS / 1000.0;
            if (end != RUN_EXITED) {
                return end;
            }
        }
        wait_a_tick(streams);
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
        for (double limit = run_now() + seconds_to_end; run_now() < limit && !has_ended(id);) {
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
    const bool keeps_output = command->output != NULL && command->output_bytes > 0;
    struct stream streams[STREAMS] = {
        [MESSAGES] = {.ends = {-1, -1}, .size = MESSAGE_LIMIT},
        [OUTPUT] = {.ends = {-1, -1}, .size = command->output_bytes, .keeps_last = true}};
    bool done =
        (open_stream(&streams[MESSAGES]) && (!keeps_output || open_stream(&streams[OUTPUT]))) ||
        error_set(error, "cannot make a pipe: %s", strerror(errno));
    size_t threads = count_threads();
    fflush(NULL);
    pid_t id = done ? fork() : -1;
    if (id == 0) {
        child(command, streams[OUTPUT].ends[1], streams[MESSAGES].ends[1], threads);
    }
    close_end(&streams[MESSAGES].ends[1]);
    close_end(&streams[OUTPUT].ends[1]);
    if (id > 0) {
        result->end = watch(command, id, streams);
        int status = end_group(id, result->end);
        wait_for_silence(streams);
        result->messages = streams[MESSAGES].kept;
        blank_nuls(&result->messages);
        judge_status(result, status, command->contained);
        done = bytes_append(&result->messages, "", 1) || error_set(error, "out of memory");
    } else if (done) {
        done = error_set(error, "cannot make a process: %s", strerror(errno));
    }
    if (id > 0 && keeps_output) {
        write_output(command, &streams[OUTPUT]);
    }
    bytes_free(&streams[OUTPUT].kept);
    close_end(&streams[MESSAGES].ends[0]);
    close_end(&streams[OUTPUT].ends[0]);
    return done;
}

/* ---- Files and directories ---- */

bool run_lock(const char *path, const char *busy, struct error *error) {
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) {
        return error_set(error, "%.900s: %s", path, strerror(errno));
    }
    if (fcntl(file, F_SETLK, &whole) != 0 && (errno == EAGAIN || errno == EACCES)) {
        fputs(busy, stderr);
        fcntl(file, F_SETLKW, &whole);
    }
    return true; /* also where the file system knows no locks */
}

const char *run_temporary(void) {
    const char *directory = getenv("TMPDIR");
    return directory != NULL && directory[0] == '/' ? directory : "/tmp";
}

bool run_has_room(const char *directory, size_t bytes, struct error *error) {
    struct statvfs disk;
    if (statvfs(directory, &disk) != 0) {
        return true;
    }
    enum { MEGABYTE = 1000 * 1000 };
    const double wanted = (double)bytes, free_bytes = (double)disk.f_bavail * (double)disk.f_frsize;
    if (free_bytes < wanted) {
        return error_set(error, "%.900s: %s (%.1f MB may be needed, %.1f MB are free)", directory,
                         strerror(ENOSPC), wanted / MEGABYTE, free_bytes / MEGABYTE);
    }
    return disk.f_files == 0 || disk.f_favail > 0 || /* some file systems count none */
           error_set(error, "%.900s: %s (for another file)", directory, strerror(ENOSPC));
}

bool run_directory_create(struct run_directory *directory, struct error *error) {
    const char *parent = run_temporary();
    if ((size_t)snprintf(directory->path, sizeof directory->path, "%s/check.XXXXXX", parent) >=
        sizeof directory->path) {
        return error_set(error, "%.900s: name too long", parent);
    }
    return mkdtemp(directory->path) != NULL ||
           error_set(error, "cannot make a directory in %s: %s", parent, strerror(errno));
}

static int remove_entry(const char *path, const struct stat *status, int type, struct FTW *ftw) {
    (void)status, (void)type, (void)ftw;
    return remove(path);
}

void run_directory_remove(const char *path) {
    enum { OPEN_DIRECTORIES = 16, TRIES = 3 }; /* a process that was killed may still be writing */
    for (int i = 0; i < TRIES && access(path, F_OK) == 0; i++) {
        nftw(path, remove_entry, OPEN_DIRECTORIES, FTW_DEPTH | FTW_PHYS);
    }
}

#endif
