/* A command in the background: started, looked at now and then, and ended at any time. */
#ifndef TESTS_STUDENT_LIVE_JOB_H
#define TESTS_STUDENT_LIVE_JOB_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <sys/types.h>

/* All zero: there is none. */
struct job {
    pid_t id; /* of the process that waits for the command */
};

enum job_state { JOB_NONE, JOB_RUNS, JOB_SUCCEEDED, JOB_FAILED };

/* Start a command (its arguments end with NULL) for at most so many seconds. What it writes to
 * standard error goes into the file `said` when it has ended. */
bool job_start(struct job *job, const char *const *arguments, double seconds, const char *said,
               struct error *error);

/* What has become of it. When it has ended, what it said is appended to `said`, then a NUL, and
 * there is no job any more. */
enum job_state job_look(struct job *job, const char *path, struct bytes *said);

/* End it, whatever it does. */
void job_end(struct job *job);

#endif
