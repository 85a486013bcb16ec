/* Directories in directories, more than anybody needs. */
#include "picture.h"

#include <sys/stat.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL || chdir(directory) != 0) {
        return 2;
    }
    for (int i = 0; i < 80; i++) {
        if (mkdir("deeper", 0777) != 0 || chdir("deeper") != 0) {
            return 2;
        }
    }
    sleep(8);
}
