/*
 * For `make MINE=1`: a student's line as line_begin() and line_next(). HER_LINE draws it on a sheet
 * as large as the image; the walk follows its pixels there and takes them away.
 */
static struct image sheet;

static bool take_from_sheet(int x, int y) {
    const bool is_there = x >= 0 && y >= 0 && (size_t)x < sheet.width && (size_t)y < sheet.height &&
                          image_get(&sheet, x, y).r > 0;
    if (is_there) {
        image_set(&sheet, x, y, color_grey(0));
    }
    return is_there;
}

static bool drawn_line_next(struct line_walk *walk) {
    const int step = walk->minor_step;
    const int x = walk->x + !walk->steep, y = walk->y + walk->steep;
    const bool straight = take_from_sheet(x, y);
    if (!straight && !take_from_sheet(x + step * walk->steep, y + step * !walk->steep)) {
        return false;
    }
    *walk = (struct line_walk){.x = x + (straight ? 0 : step * walk->steep),
                               .y = y + (straight ? 0 : step * !walk->steep),
                               .steep = walk->steep,
                               .minor_step = step};
    return true;
}

static bool drawn_line_begin(struct line_walk *walk, struct pixel a, struct pixel b, size_t width,
                             size_t height) {
    struct error error;
    if (sheet.width != width || sheet.height != height) {
        image_free(&sheet);
        if (!image_create(&sheet, width, height, IMAGE_GREY, &error)) {
            return false;
        }
    }
    HER_LINE(&sheet, a, b, color_grey(255));
    const int64_t right = (int64_t)b.x - a.x, up = (int64_t)b.y - a.y;
    const bool steep = llabs(up) > llabs(right);
    if (steep ? up < 0 : right < 0) {
        const struct pixel kept = a;
        a = b;
        b = kept;
    }
    const bool falls = steep ? b.x < a.x : b.y < a.y;
    *walk = (struct line_walk){.steep = steep, .minor_step = falls ? -1 : 1};
    /* The first pixel of the walk, in the part of the sheet around the line. */
    const struct span columns =
        span_overlap((struct span){a.x < b.x ? a.x : b.x, 1 + (a.x > b.x ? a.x : b.x)},
                     (struct span){0, (int)width});
    const struct span rows =
        span_overlap((struct span){a.y < b.y ? a.y : b.y, 1 + (a.y > b.y ? a.y : b.y)},
                     (struct span){0, (int)height});
    const struct span along = steep ? rows : columns, across = steep ? columns : rows;
    for (int u = along.begin; u < along.end; u++) {
        for (int v = across.begin; v < across.end; v++) {
            walk->x = steep ? v : u;
            walk->y = steep ? u : v;
            if (take_from_sheet(walk->x, walk->y)) {
                return true;
            }
        }
    }
    return false;
}
