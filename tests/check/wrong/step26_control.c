/* A message that would paint over the score: control characters of one byte and of two, and marks
 * that turn the direction of writing. */
#include "picture.h"

int main(void) {
    fputs("\x1b[1A\xc2\x9b"
          "1A\xe2\x80\xae"
          "drow\x9bs\xc3\xa9\n",
          stderr);
    return 1;
}
