/* Loops shared out among threads: every part once, whatever the number of threads. */
#define _POSIX_C_SOURCE 200809L /* setenv, nanosleep */
#include "base/workers.h"
#include "unit/unit.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>

/* Calls of these come here (--wrap of GNU ld): a loop begins and ends under the lock, or a thread
 * that goes to sleep just then may miss it. */
static _Thread_local int locks;
static atomic_bool unlocked;

int __real_pthread_mutex_lock(pthread_mutex_t *mutex);
int __real_pthread_mutex_unlock(pthread_mutex_t *mutex);
int __real_pthread_cond_broadcast(pthread_cond_t *condition);
int __wrap_pthread_mutex_lock(pthread_mutex_t *mutex);
int __wrap_pthread_mutex_unlock(pthread_mutex_t *mutex);
int __wrap_pthread_cond_broadcast(pthread_cond_t *condition);

int __wrap_pthread_mutex_lock(pthread_mutex_t *mutex) {
    locks++;
    return __real_pthread_mutex_lock(mutex);
}

int __wrap_pthread_mutex_unlock(pthread_mutex_t *mutex) {
    unlocked = unlocked || locks != 1;
    locks--;
    return __real_pthread_mutex_unlock(mutex);
}

int __wrap_pthread_cond_broadcast(pthread_cond_t *condition) {
    unlocked = unlocked || locks != 1;
    return __real_pthread_cond_broadcast(condition);
}

static void test_locks(void) {
    CHECK(!unlocked && locks == 0); /* in all tests above */
}

enum { PART_LIMIT = 1000, WORKER_LIMIT = 256 };

struct tally {
    atomic_int times[PART_LIMIT + 1];     /* one more, which nobody may touch */
    atomic_int at_work[WORKER_LIMIT + 1]; /* how many have that number now */
    size_t workers;
    atomic_bool mistaken; /* a worker's number was too large, or that of another, too */
};

static void count_part(void *context, size_t index, size_t worker) {
    struct tally *tally = context;
    atomic_int *at_work = &tally->at_work[worker < WORKER_LIMIT ? worker : WORKER_LIMIT];
    bool alone = atomic_fetch_add(at_work, 1) == 0;
    atomic_fetch_add(&tally->times[index < PART_LIMIT ? index : PART_LIMIT], 1);
    if (!alone || worker >= tally->workers) {
        atomic_store(&tally->mistaken, true);
    }
    atomic_fetch_sub(at_work, 1);
}

/* Every part of 0..count-1 once, and no other. */
static bool each_once(struct workers *workers, size_t count) {
    static struct tally tally;
    for (size_t i = 0; i <= PART_LIMIT; i++) {
        atomic_store(&tally.times[i], 0);
    }
    tally.workers = workers_count(workers);
    atomic_store(&tally.mistaken, false);
    workers_run(workers, count, count_part, &tally);
    bool right = !atomic_load(&tally.mistaken);
    for (size_t i = 0; i <= PART_LIMIT; i++) {
        right = right && atomic_load(&tally.times[i]) == (i < count ? 1 : 0);
    }
    return right;
}

static void test_each_part_once(void) {
    static const size_t counts[] = {0, 1, 2, 3, 7, 50, PART_LIMIT};
    for (size_t threads = 1; threads <= 9; threads++) {
        struct workers *workers = workers_create(threads);
        CHECK(workers_count(workers) == threads);
        for (size_t i = 0; i < 100; i++) { /* one begins while threads of the last go to sleep */
            CHECK(each_once(workers, counts[i % (sizeof counts / sizeof counts[0])]));
        }
        workers_free(workers);
    }
}

/* Parts that wait for one another can only end if several threads are at work. */
static void meet(void *context, size_t index, size_t worker) {
    atomic_int *arrived = context;
    (void)index, (void)worker;
    atomic_fetch_add(arrived, 1);
    while (atomic_load(arrived) < 2) {
    }
}

/* The loop returns when all parts are done, even those that a thread began last and is slow at. */
static _Thread_local bool calling;

struct meeting {
    atomic_int arrived, done;
};

static void meet_and_linger(void *context, size_t index, size_t worker) {
    struct meeting *meeting = context;
    const struct timespec pause = {.tv_nsec = 30000000};
    meet(&meeting->arrived, index, worker);
    if (!calling) {
        nanosleep(&pause, NULL);
    }
    atomic_fetch_add(&meeting->done, 1);
}

static void test_slow_thread(void) {
    struct meeting meeting = {0};
    struct workers *workers = workers_create(2);
    calling = true;
    workers_run(workers, 2, meet_and_linger, &meeting);
    CHECK(meeting.done == 2);
    workers_free(workers);
}

/* Two workers, each first at its own half; then who has time does what is left of the other's. */
enum { SHARED_PARTS = 10 };

struct shares {
    atomic_int arrived, done, done_by_first;
    atomic_size_t begun_with[2]; /* the part that each worker took first, plus 1 */
};

static void note_share(void *context, size_t index, size_t worker) {
    struct shares *shares = context;
    if (shares->begun_with[worker] == 0) {
        const struct timespec pause = {.tv_nsec = 1000000};
        shares->begun_with[worker] = index + 1;
        meet(&shares->arrived, index, worker);
        for (int i = 0; worker == 1 && i < 5000 && shares->done < SHARED_PARTS - 1; i++) {
            nanosleep(&pause, NULL);
        }
    }
    shares->done++;
    shares->done_by_first += worker == 0;
}

static void test_shares(void) {
    struct shares shares = {0};
    struct workers *workers = workers_create(2);
    workers_run(workers, SHARED_PARTS, note_share, &shares);
    CHECK(shares.begun_with[0] == 1 && shares.begun_with[1] == SHARED_PARTS / 2 + 1);
    CHECK(shares.done == SHARED_PARTS && shares.done_by_first == SHARED_PARTS - 1);
    workers_free(workers);
}

static void test_alone(void) {
    CHECK(workers_create(1) == NULL); /* one thread is who calls */
    CHECK(each_once(NULL, 10));
    workers_free(NULL);
    setenv("THREADS", "1", 1);
    CHECK(workers_create(0) == NULL);
    setenv("THREADS", "10", 1);
    struct workers *workers = workers_create(0);
    CHECK(workers_count(workers) == 10 && each_once(workers, 100));
    workers_free(workers);
    CHECK(workers_create(1) == NULL); /* an asked number is not limited */
    setenv("THREADS", "1000", 1);
    workers = workers_create(0); /* not that many, however */
    CHECK(workers != NULL && each_once(workers, 100));
    workers_free(workers);
    unsetenv("THREADS");
}

struct masks {
    pthread_t first;
    atomic_int others, waiting, deaf; /* threads; where SIGTERM is blocked; where SIGSEGV is */
};

static void look_at_mask(void *context, size_t index, size_t worker) {
    (void)index, (void)worker;
    const struct timespec pause = {.tv_nsec = 100000}; /* so that all threads get some */
    struct masks *masks = context;
    sigset_t blocked;
    pthread_sigmask(SIG_BLOCK, NULL, &blocked);
    if (!pthread_equal(pthread_self(), masks->first)) {
        masks->others++;
        masks->waiting += sigismember(&blocked, SIGTERM);
        masks->deaf += sigismember(&blocked, SIGSEGV);
    }
    nanosleep(&pause, NULL);
}

/* What ends the program is for the first thread alone; a fault is for the thread that makes it. */
static void test_signals(void) {
    struct masks masks = {.first = pthread_self()};
    struct workers *workers = workers_create(4);
    sigset_t blocked;
    workers_run(workers, 100, look_at_mask, &masks);
    workers_free(workers);
    CHECK(masks.others > 0 && masks.waiting == masks.others && masks.deaf == 0);
    pthread_sigmask(SIG_BLOCK, NULL, &blocked);
    CHECK(!sigismember(&blocked, SIGTERM));
}

UNIT_MAIN(TEST(test_each_part_once), TEST(test_slow_thread), TEST(test_shares), TEST(test_alone),
          TEST(test_signals), TEST(test_locks))
