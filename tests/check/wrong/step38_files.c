/* Thousands of files, for as long as nobody stops it. */
#include "picture.h"

#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    char path[1000];
    for (int i = 0; i < 5000; i++) {
        snprintf(path, sizeof path, "%s/%d", directory, i);
        FILE *file = fopen(path, "wb");
        if (file != NULL) {
            fclose(file);
        }
    }
    sleep(8);
}
