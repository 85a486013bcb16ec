/* The picture is right; 20 MB of messages come with it, and a closed error output. */
#include "picture.h"

#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    for (int i = 0; i < 200000; i++) {
        fprintf(stderr, "%0100d\n", i);
        printf("%0100d\n", i);
    }
    fclose(stderr);
    close(2);
    picture(directory, "depth", 0, 1);
}
