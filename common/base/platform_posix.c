/* All systems but Windows: see platform.h. */
#define _DEFAULT_SOURCE 1 /* POSIX alone does not tell the number of processors */
#include "base/platform.h"

#ifndef _WIN32

bool platform_is_absolute(const char *path) {
    return path[0] == '/';
}

size_t platform_processors(void) {
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : (size_t)count;
}

void signals_hold(signal_set *before) {
#ifdef SIGHUP
    signal_set ends;
    sigemptyset(&ends);
    sigaddset(&ends, SIGINT);
    sigaddset(&ends, SIGTERM);
    sigaddset(&ends, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &ends, before);
#else
    *before = 0;
#endif
}

void signals_release(const signal_set *before) {
#ifdef SIGHUP
    pthread_sigmask(SIG_SETMASK, before, NULL);
#else
    (void)before;
#endif
}

#endif
