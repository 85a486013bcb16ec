/* SIGTERM is ignored, and a child's child writes the picture when the time is over. */
#include "picture.h"

#include <signal.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    signal(SIGTERM, SIG_IGN);
    if (fork() == 0) {
        if (fork() == 0) {
            witness("%ld\n", (long)getpid());
            sleep(3);
            witness("alive %ld\n", (long)getpid());
            picture(directory, "depth", 0, 1);
        }
        pause();
    }
    witness("%ld\n", (long)getpid());
    for (;;) {
        pause();
    }
}
