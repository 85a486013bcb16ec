/* The picture's file grows without end; 200 MB, should nobody stop it. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    static char block[1000000];
    char path[1000];
    snprintf(path, sizeof path, "%s/depth.tga", directory);
    FILE *file = fopen(path, "wb");
    for (int i = 0; i < 200; i++) {
        fwrite(block, 1, sizeof block, file);
    }
    fclose(file);
    witness("alive %ld\n", 0);
}
