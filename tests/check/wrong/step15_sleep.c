/* The second scene takes for ever; asked to end, the program does so in its own way. */
#include "picture.h"

#include <signal.h>
#include <unistd.h>

static volatile sig_atomic_t asked;

static void end(int number) {
    asked = number;
}

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    signal(SIGTERM, end);
    picture(directory, "depth", 0, 1);
    witness("%ld\n", (long)getpid());
    while (!asked) {
        sleep(1); /* a signal cuts it short */
    }
    witness("ended by %ld\n", asked);
    return 0;
}
