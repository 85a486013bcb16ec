/*
 * POSIX as the course needs it, where a system has it in another form.
 *
 * platform_windows.c is for Windows, where paths are UTF-8 in our code, with / between directories,
 * and files are bytes; platform_posix.c for all other systems, of which WebAssembly (WASI) has no
 * signals. Include this after the file's own _POSIX_C_SOURCE.
 */
#ifndef COMMON_BASE_PLATFORM_H
#define COMMON_BASE_PLATFORM_H

#include <errno.h>
#include <fcntl.h>
#ifndef __wasi__
#include <signal.h>
#endif
#include <stdbool.h>
#include <stddef.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef _WIN32
/* First in main(): the arguments become UTF-8, and standard input and output bytes. */
void windows_begin(int *argc, char ***argv);

/* As the functions of POSIX, by whose names file.c calls them. */
int windows_open(const char *path, int flags, ...);
ssize_t windows_read(int file, void *data, size_t size);
ssize_t windows_write(int file, const void *data, size_t size);
int windows_stat(const char *path, struct stat *status);
int windows_rename(const char *from, const char *to);
int windows_unlink(const char *path);
int windows_mkdir(const char *path);

/* A path for Windows' own functions; "" for one that is too long. */
enum { WINDOWS_PATH = 4096 };
struct windows_wide {
    wchar_t path[WINDOWS_PATH];
};
struct windows_wide windows_widen(const char *path);
#endif

#ifdef SIG_BLOCK
typedef sigset_t signal_set;
#else
typedef int signal_set;
#endif

/* Does the path begin at the root, or at a drive? */
bool platform_is_absolute(const char *path);

/* How many processors the machine has; at least 1. */
size_t platform_processors(void);

/* SIGINT, SIGTERM and SIGHUP wait from here, in the thread that calls, until the old set is back.
 * On Windows Ctrl-C has no effect in between. */
void signals_hold(signal_set *before);
void signals_release(const signal_set *before);

#endif
