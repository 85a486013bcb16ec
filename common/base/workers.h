/*
 * Loops shared out among threads that sleep while there is nothing to do.
 *
 * A busy machine is the normal case: a grading job, a laptop in class. So no thread waits awake,
 * and a loop never waits for a thread that the machine has not woken yet: the calling thread does
 * the rest. What a loop computes must not depend on which thread does which part.
 *
 * Each worker begins with its own share, parts next to each other, the same ones in each loop
 * of as many parts: what it has written or read in one is often still in its cache in the next.
 */
#ifndef COMMON_BASE_WORKERS_H
#define COMMON_BASE_WORKERS_H

#include <stddef.h>

struct workers;

/* Does part `index` of the work. `worker` tells apart those that work at the same time: it is below
 * workers_count(), and 0 is the caller. */
typedef void worker_function(void *context, size_t index, size_t worker);

/* Start threads, so that with the one that calls there are `thread_count`; 0 means one for each
 * processor, or as many as the environment variable THREADS says. Where no thread can be started,
 * as on a machine without threads, the caller does all the work. NULL, which is valid everywhere
 * here, when memory runs out or one thread is enough. */
struct workers *workers_create(size_t thread_count);

/* End the threads, none of which may be at work. */
void workers_free(struct workers *workers);

/* How many may work at the same time: 1 for NULL. */
size_t workers_count(const struct workers *workers);

/* Do the parts 0..count-1, each once, and return when all are done. */
void workers_run(struct workers *workers, size_t count, worker_function *work, void *context);

#endif
