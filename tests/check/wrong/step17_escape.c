/* The work is left to a process that leaves the group, while the program ends at once. */
#include "picture.h"

#include <signal.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    int ready[2];
    char byte;
    if (pipe(ready) != 0) {
        return 9;
    }
    if (fork() == 0) {
        setsid();
        signal(SIGTERM, SIG_IGN);
        if (fork() == 0) {
            setsid();
            witness("%ld\n", (long)getpid());
            if (write(ready[1], "", 1) == 1) {
                sleep(30);
            }
        }
        _exit(0);
    }
    return read(ready[0], &byte, 1) != 1;
}
