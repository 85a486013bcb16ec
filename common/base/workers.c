/* Loops shared out among threads: see workers.h. POSIX threads, where there are any. */
#define _POSIX_C_SOURCE 200809L
#include "base/workers.h"

#include "base/platform.h"

#include <stdlib.h>

#if defined(_POSIX_THREADS) && _POSIX_THREADS > 0 && !defined(__wasi__)

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

enum { THREAD_LIMIT = 256 };

/* A worker's share of a loop: parts that lie side by side, done in turn, by whoever comes. */
struct share {
    atomic_size_t next; /* the first part that nobody has taken */
    size_t end;
    char apart[112]; /* from the next one: no cache line is of two */
};

struct workers {
    pthread_mutex_t mutex;
    pthread_cond_t loop_begins, last_leaves;
    pthread_t threads[THREAD_LIMIT];
    size_t thread_count;   /* without the one that calls */
    size_t threads_awoken; /* that know their own number */
    bool ending;

    /* The loop that is being done. The first three change only while nobody is at work. */
    worker_function *work;
    void *context;
    struct share share[THREAD_LIMIT]; /* of each worker */
    unsigned long loop;     /* its number, which tells a thread whether it knows it already */
    bool open;              /* threads may still join */
    size_t threads_at_work; /* without the one that calls */
};

/* First its own share, then what the others have not begun. So in every loop, and in every frame, a
 * worker does much the same parts: what it reads is often in its own cache, and to fetch a line
 * from that of another processor can take longer than from memory. */
static void do_parts(struct workers *workers, size_t worker) {
    size_t count = workers->thread_count + 1;
    for (size_t i = 0; i < count; i++) {
        struct share *share = &workers->share[(worker + i) % count];
        size_t index;
        while ((index = atomic_fetch_add(&share->next, 1)) < share->end) {
            workers->work(workers->context, index, worker);
        }
    }
}

/* A thread's life: sleep until a loop begins, help, sleep. */
static void *thread_main(void *argument) {
    struct workers *workers = argument;
    unsigned long known = 0;
    pthread_mutex_lock(&workers->mutex);
    size_t worker = ++workers->threads_awoken;
    while (!workers->ending) {
        if (!workers->open || workers->loop == known) {
            pthread_cond_wait(&workers->loop_begins, &workers->mutex);
            continue;
        }
        known = workers->loop;
        workers->threads_at_work++;
        pthread_mutex_unlock(&workers->mutex);
        do_parts(workers, worker);
        pthread_mutex_lock(&workers->mutex);
        workers->threads_at_work--;
        if (workers->threads_at_work == 0) {
            pthread_cond_signal(&workers->last_leaves);
        }
    }
    pthread_mutex_unlock(&workers->mutex);
    return NULL;
}

static size_t wanted_threads(size_t thread_count) {
    const char *text = getenv("THREADS");
    long count = (long)thread_count;
    if (count == 0 && text != NULL) {
        count = strtol(text, NULL, 10);
    }
    size_t wanted = count < 1 ? platform_processors() : (size_t)count;
    return wanted < THREAD_LIMIT ? wanted : THREAD_LIMIT;
}

struct workers *workers_create(size_t thread_count) {
    size_t wanted = wanted_threads(thread_count);
    struct workers *workers = wanted > 1 ? calloc(1, sizeof *workers) : NULL;
    if (workers == NULL) {
        return NULL;
    }
    pthread_mutex_init(&workers->mutex, NULL);
    pthread_cond_init(&workers->loop_begins, NULL);
    pthread_cond_init(&workers->last_leaves, NULL);
    /* What ends the program is for the first thread, which may have to wait (file.c). Faults stay
     * with the thread whose they are: a sanitizer tells where. */
    signal_set before;
    signals_hold(&before);
    while (workers->thread_count + 1 < wanted &&
           pthread_create(&workers->threads[workers->thread_count], NULL, thread_main, workers) ==
               0) {
        workers->thread_count++;
    }
    signals_release(&before);
    return workers;
}

void workers_free(struct workers *workers) {
    if (workers == NULL) {
        return;
    }
    pthread_mutex_lock(&workers->mutex);
    workers->ending = true;
    pthread_cond_broadcast(&workers->loop_begins);
    pthread_mutex_unlock(&workers->mutex);
    for (size_t i = 0; i < workers->thread_count; i++) {
        pthread_join(workers->threads[i], NULL);
    }
    pthread_cond_destroy(&workers->last_leaves);
    pthread_cond_destroy(&workers->loop_begins);
    pthread_mutex_destroy(&workers->mutex);
    free(workers);
}

static void run_shared(struct workers *workers, size_t count, worker_function *work,
                       void *context) {
    pthread_mutex_lock(&workers->mutex);
    workers->work = work;
    workers->context = context;
    size_t shares = workers->thread_count + 1;
    for (size_t i = 0; i < shares; i++) {
        atomic_store(&workers->share[i].next, count * i / shares);
        workers->share[i].end = count * (i + 1) / shares;
    }
    workers->loop++;
    workers->open = true;
    pthread_cond_broadcast(&workers->loop_begins);
    pthread_mutex_unlock(&workers->mutex);
    do_parts(workers, 0);
    pthread_mutex_lock(&workers->mutex);
    workers->open = false; /* a thread that wakes only now is late */
    while (workers->threads_at_work > 0) {
        pthread_cond_wait(&workers->last_leaves, &workers->mutex);
    }
    pthread_mutex_unlock(&workers->mutex);
}

#else

struct workers {
    size_t thread_count;
};

struct workers *workers_create(size_t thread_count) {
    (void)thread_count;
    return NULL;
}

void workers_free(struct workers *workers) {
    (void)workers;
}

static void run_shared(struct workers *workers, size_t count, worker_function *work,
                       void *context) {
    (void)workers, (void)count, (void)work, (void)context;
}

#endif

size_t workers_count(const struct workers *workers) {
    return workers == NULL ? 1 : workers->thread_count + 1;
}

void workers_run(struct workers *workers, size_t count, worker_function *work, void *context) {
    if (workers != NULL && count > 1) {
        run_shared(workers, count, work, context);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        work(context, i, 0);
    }
}
