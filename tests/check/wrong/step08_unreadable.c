/* What should be pictures are a text, a picture cut short, a link, a pipe, a directory. */
#include "picture.h"

#include <sys/stat.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    unsigned char header[18];
    if (chdir(directory) != 0) {
        return 9;
    }
    FILE *file = fopen("text.tga", "w");
    fprintf(file, "This is no picture, however long it may be.\n");
    fclose(file);
    picture_header(header, PICTURE_SIZE, PICTURE_SIZE);
    file = fopen("short.tga", "wb");
    fwrite(header, 1, sizeof header, file);
    fclose(file);
    return symlink("/dev/zero", "link.tga") + mkfifo("pipe.tga", 0666) + mkdir("directory.tga", 0);
}
