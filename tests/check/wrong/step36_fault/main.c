/* Each scene has a fault that a sanitizer finds; lines are named in expected.txt. */
#include <stdlib.h>
#include <string.h>

static int sum(const int *numbers, int count) {
    int all = 0;
    for (int i = 0; i <= count; i++) {
        all += numbers[i]; /* line 8 */
    }
    return all;
}

/* On one line, since the stack may end at its beginning or at the call. */
/* clang-format off */
static int deeper(volatile int *a) { volatile int b = *a + 1; return deeper(&b) + b; } /* line 15 */
/* clang-format on */

int main(int argc, char **argv) {
    const char *scene = argc >= 5 ? argv[4] : "heap";
    volatile int large = 2147483647, small = 0;
    int *volatile numbers = calloc(8, sizeof *numbers);
    int *volatile nowhere = NULL;
    if (strcmp(scene, "heap") == 0) {
        return sum(numbers, 8);
    }
    if (strcmp(scene, "freed") == 0) {
        free(numbers);
        numbers[0] = 1; /* line 28 */
    } else if (strcmp(scene, "large") == 0) {
        large = large + 1; /* line 30 */
    } else if (strcmp(scene, "null") == 0) {
        *nowhere = 1; /* line 32 */
    } else {
        return deeper(&small);
    }
}
