/* Too many processes; only 100, and they end by themselves. */
#include "picture.h"

#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    for (int i = 0; i < 100; i++) {
        pid_t child = fork();
        if (child == 0) {
            sleep(8);
            _exit(0);
        }
        if (child > 0) { /* told by who made it: it may be ended before it says a word */
            witness("%ld\n", (long)child);
        }
    }
    sleep(8);
}
