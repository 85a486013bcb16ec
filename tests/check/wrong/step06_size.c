/* One picture is too low, the other claims to be huge. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    static struct picture p;
    char path[1000];
    unsigned char header[18];
    picture_draw(&p, 0, 1);
    picture_save(&p, 150, directory, "depth");
    picture_header(header, 65535, 65535);
    snprintf(path, sizeof path, "%s/huge.tga", directory);
    FILE *file = fopen(path, "wb");
    fwrite(header, 1, sizeof header, file);
    return fclose(file);
}
