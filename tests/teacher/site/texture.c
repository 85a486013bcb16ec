/* A texture as a PNG: texture FROM TO. Web pages load it as soon as a scene reads it (answer.c). */
#include "files/image_file.h"
#include "files/png.h"

#include <stdio.h>

int main(int argc, char **argv) {
    struct image image;
    struct error error = {.message = "usage: texture FROM TO"};
    if (argc != 3 || !image_read(&image, argv[1], &error) || !png_write(&image, argv[2], &error)) {
        fprintf(stderr, "texture: %s\n", error.message);
        return 1;
    }
    image_free(&image);
    return 0;
}
