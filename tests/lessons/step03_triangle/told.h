/* Lesson 3: which pixels a triangle must draw, the answer of task 3b.1. */

/* The centre is inside, and a hair to its right and below as well. */
static bool told_wanted(const struct fixed2 corner[3], int x, int y, bool newly_drawn) {
    const int64_t px = (int64_t)x * SUBPIXELS + SUBPIXELS / 2;
    const int64_t py = (int64_t)y * SUBPIXELS + SUBPIXELS / 2;
    int left = 0, right = 0; /* edges that have the centre there */
    (void)newly_drawn;
    for (int i = 0; i < 3; i++) {
        const struct fixed2 a = corner[i], b = corner[(i + 1) % 3];
        const int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y;
        int64_t side = dx * (py - a.y) - dy * (px - a.x);
        side = side != 0 ? side : dy != 0 ? -dy : -dx;
        left += side > 0;
        right += side < 0;
    }
    return left == 3 || right == 3;
}
