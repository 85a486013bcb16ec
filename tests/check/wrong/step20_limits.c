/* Says what it finds around itself, and fails, so that the check shows it. */
#include "picture.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    struct rlimit cpu, size, core;
    char here[1000];
    int files = 0, open_files = 0;
    DIR *around = opendir(".");
    while (readdir(around) != NULL) {
        files++;
    }
    closedir(around);
    for (int i = 3; i < 256; i++) {
        open_files += dup2(i, 255) == 255;
    }
    getrlimit(RLIMIT_CPU, &cpu);
    getrlimit(RLIMIT_FSIZE, &size);
    getrlimit(RLIMIT_CORE, &core);
    int terminal = open("/dev/tty", O_WRONLY);
    int here_is_directory = strcmp(getcwd(here, sizeof here), directory) == 0;
    fprintf(stderr,
            "here %d files %d open %d group %d cpu %d size %ld core %ld input %d make %d "
            "terminal %d\n",
            here_is_directory, files - 2, open_files, getpgrp() == getpid(), cpu.rlim_cur < 10000,
            (long)size.rlim_cur, (long)core.rlim_cur, getchar(), getenv("MAKEFLAGS") != NULL,
            terminal >= 0);
    return 3;
}
