/* A command in the background: see job.h. A process of ours runs it, as the check runs programs. */
#define _POSIX_C_SOURCE 200809L
#include "job.h"

#include "base/file.h"
#include "check/run.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Does not return: the status tells whether the command has succeeded. */
static void run_and_exit(const struct run_command *command, const char *said) {
    struct run_result result = {.end = RUN_EXITED};
    struct error error;
    bool done = run(command, &result, &error);
    const char *text = done ? (const char *)result.messages.data : error.message;
    if (done && result.end == RUN_INTERRUPTED) {
        _exit(1);
    }
    done = done && result.end == RUN_EXITED && result.number == 0;
    _exit(file_write(said, text, strlen(text), &error) && done ? 0 : 1);
}

bool job_start(struct job *job, const char *const *arguments, double seconds, const char *said,
               struct error *error) {
    const struct run_command command = {
        .arguments = arguments, .locale = "C", .limits = {.seconds = seconds}};
    job_end(job);
    unlink(said);
    job->id = fork();
    if (job->id == 0) {
        run_and_exit(&command, said);
    }
    if (job->id < 0) {
        job->id = 0;
        return error_set(error, "cannot start %.100s: %s", arguments[0], strerror(errno));
    }
    return true;
}

enum job_state job_look(struct job *job, const char *path, struct bytes *said) {
    int status = 0;
    struct error error;
    if (job->id == 0) {
        return JOB_NONE;
    }
    if (waitpid(job->id, &status, WNOHANG) == 0) {
        return JOB_RUNS;
    }
    job->id = 0;
    if (file_exists(path)) {
        file_read(path, said, &error);
    }
    bytes_append(said, "", 1);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? JOB_SUCCEEDED : JOB_FAILED;
}

void job_end(struct job *job) {
    if (job->id > 0) {
        kill(job->id, SIGTERM);
        waitpid(job->id, NULL, 0);
        job->id = 0;
    }
}
