/*
 * How the solid becomes a surface: see surface.h.
 *
 * A stick is inside the bust, from the base to the crown. From points along the stick rays go
 * out all around; each ray ends where it leaves the clay. Low rays look up at the shoulders and at
 * the neck, those of the jaw look down, those of the skull fan out to the zenith: so each part is
 * seen from inside as squarely as possible and the rays never cross. The number of the ray is the
 * texture coordinate. Rays are closest where the face is.
 */
#include "sculptor/surface.h"

#include "sculptor/head.h"

#include <stdlib.h>

/* Over v: where on the stick the ray starts, and its angle above the horizon in degrees. */
static const double stick_y[][2] = {{0.00, -0.95}, {0.07, -0.94}, {0.14, -0.90}, {0.20, -0.82},
                                    {0.25, -0.66}, {0.29, -0.38}, {0.33, -0.14}, {0.36, 0.04},
                                    {0.39, 0.14},  {0.42, 0.19},  {0.52, 0.21},  {0.59, 0.28},
                                    {0.80, 0.30},  {1.00, 0.42}};
static const double stick_z[][2] = {{0.0, -0.15}, {0.35, -0.13}, {0.6, -0.10}, {1.0, -0.07}};
static const double ray_angle[][2] = {
    {0.00, 0},    {0.07, 8},   {0.14, 23},  {0.20, 30},  {0.25, 24},  {0.29, 3},
    {0.33, -19},  {0.36, -32}, {0.39, -36}, {0.42, -35}, {0.52, -20}, {0.59, -16},
    {0.64, -9.5}, {0.71, 1},   {0.78, 11},  {0.82, 18},  {0.89, 43},  {1.00, 90}};

/* The ray of column share s (0 front .. 1 back) and height share t (0 base's rim .. 1 crown). */
static void choose_ray(double s, double t, struct vec3 *start, struct vec3 *direction) {
    struct vec2 turn = turn_direction(0.5 * (0.62 * s + 0.38 * s * s * s)); /* closer in front */
    struct vec2 tilt = turn_direction(curve(ray_angle, COUNT(ray_angle), t) / 360);
    /* Rows should run level over the face, which is nearer to the stick at its sides: rays to the
     * side climb and fall as steeply as it takes on an ellipse. */
    double ellipse = 0.72 / sqrt(square(0.72 * turn.x) + square(turn.y));
    double level = tilt.x * mix(1, ellipse, ramp(0.28, 0.38, t));
    *start = (struct vec3){0, curve(stick_y, COUNT(stick_y), t), curve(stick_z, COUNT(stick_z), t)};
    *direction = vec3_normalized((struct vec3){level * turn.y, tilt.y, level * turn.x});
}

/* Walk along the ray from inside until the clay ends, then halve the last step again and again. */
static struct vec3 leave_clay(struct vec3 start, struct vec3 direction) {
    double inside = 0, outside = 0;
    for (int step = 0; step < 400; step++) {
        double d = head_distance(vec3_add(start, vec3_scale(direction, outside)));
        if (d >= 0) {
            break;
        }
        inside = outside;
        outside += -0.7 * d > 0.0015 ? -0.7 * d : 0.0015;
    }
    for (int step = 0; step < 16; step++) {
        double middle = (inside + outside) / 2;
        if (head_distance(vec3_add(start, vec3_scale(direction, middle))) < 0) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    return vec3_add(start, vec3_scale(direction, (inside + outside) / 2));
}

static struct surface_point *point_at(const struct surface *surface, int column, int row) {
    return &surface->points[surface_index(surface, column, row)];
}

static void cast_rays(struct surface *surface) {
    for (int row = SURFACE_BASE_ROWS; row <= surface->rows; row++) {
        double t = (double)(row - SURFACE_BASE_ROWS) / (surface->rows - SURFACE_BASE_ROWS);
        for (int column = 0; column <= surface->columns; column++) {
            struct vec3 start, direction;
            choose_ray((double)column / surface->columns, t, &start, &direction);
            if (column == 0 || column == surface->columns || row == surface->rows) {
                direction.x = 0; /* the middle lies exactly in the mirror */
            }
            struct surface_point *point = point_at(surface, column, row);
            point->place = head_grow_ear(leave_clay(start, direction), &point->ear);
        }
    }
    /* One crown, the same from every side. */
    struct surface_point *last_row = point_at(surface, 0, surface->rows);
    for (int column = 1; column <= surface->columns; column++) {
        last_row[column].place = last_row[0].place;
    }
}

/* The base: the rim drawn together to a point. */
static void close_base(struct surface *surface) {
    const struct vec3 middle = {0, BASE_Y, -0.15};
    const struct surface_point *rim = point_at(surface, 0, SURFACE_BASE_ROWS);
    for (int row = 0; row < SURFACE_BASE_ROWS; row++) {
        for (int column = 0; column <= surface->columns; column++) {
            point_at(surface, column, row)->place =
                vec3_mix(middle, rim[column].place, (double)row / SURFACE_BASE_ROWS);
        }
    }
}

/* The point at a column that may lie one beyond the half: there is its mirror image. */
static struct vec3 mirrored(const struct surface *surface, int column, int row) {
    int last = surface->columns;
    int inside = column < 0 ? -column : column > last ? 2 * last - column : column;
    struct vec3 p = point_at(surface, inside, row)->place;
    p.x = inside == column ? p.x : -p.x;
    return p;
}

static void find_normals(struct surface *surface) {
    for (int row = 0; row <= surface->rows; row++) {
        for (int column = 0; column <= surface->columns; column++) {
            int below = row > 0 ? row - 1 : row, above = row < surface->rows ? row + 1 : row;
            if (row == SURFACE_BASE_ROWS) {
                below = row; /* the rim belongs to the side, not to the base */
            }
            struct vec3 along_u =
                vec3_sub(mirrored(surface, column + 1, row), mirrored(surface, column - 1, row));
            struct vec3 along_v =
                vec3_sub(mirrored(surface, column, above), mirrored(surface, column, below));
            struct vec3 n = vec3_normalized(vec3_cross(along_u, along_v));
            if (row < SURFACE_BASE_ROWS) {
                n = (struct vec3){0, -1, 0};
            } else if (row == surface->rows) {
                n = (struct vec3){0, 1, 0};
            }
            if (column == 0 || column == surface->columns) {
                n.x = 0;
                n = vec3_normalized(n);
            }
            point_at(surface, column, row)->normal = n;
        }
    }
}

/* How far the points `reach` steps away lie above this one, over their distance from it. */
static double cavity_at(const struct surface *surface, int column, int row, int reach) {
    const struct surface_point *point = point_at(surface, column, row);
    double rise = 0, way = 0;
    for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
            int y = row + dy * reach;
            y = y < SURFACE_BASE_ROWS ? SURFACE_BASE_ROWS : y > surface->rows ? surface->rows : y;
            struct vec3 d = vec3_sub(mirrored(surface, column + dx * reach, y), point->place);
            rise += vec3_dot(d, point->normal);
            way += vec3_length(d);
        }
    }
    return way > 0 ? rise / way : 0;
}

static void find_cavities(struct surface *surface) {
    for (int row = SURFACE_BASE_ROWS; row <= surface->rows; row++) {
        for (int column = 0; column <= surface->columns; column++) {
            double fine = cavity_at(surface, column, row, 3);
            double broad = cavity_at(surface, column, row, 9);
            point_at(surface, column, row)->cavity = (fine + broad) / 2;
        }
    }
}

bool surface_create(struct surface *surface, int columns, int rows) {
    size_t count = ((size_t)columns + 1) * ((size_t)rows + 1);
    *surface = (struct surface){.columns = columns, .rows = rows};
    surface->points = calloc(count, sizeof *surface->points);
    if (surface->points == NULL) {
        return false;
    }
    cast_rays(surface);
    close_base(surface);
    find_normals(surface);
    find_cavities(surface);
    return true;
}

void surface_free(struct surface *surface) {
    free(surface->points);
    *surface = (struct surface){0};
}

static struct surface_point point_mix(const struct surface_point *a, const struct surface_point *b,
                                      double t) {
    return (struct surface_point){
        .place = vec3_mix(a->place, b->place, t),
        .normal = vec3_mix(a->normal, b->normal, t),
        .ear = mix(a->ear, b->ear, t),
        .cavity = mix(a->cavity, b->cavity, t),
    };
}

struct surface_point surface_at(const struct surface *surface, double u, double v) {
    double x = fabs(2 * u - 1) * surface->columns, y = v * surface->rows;
    int i = (int)clamp(floor(x), 0, surface->columns - 1);
    int j = (int)clamp(floor(y), 0, surface->rows - 1);
    const struct surface_point *low = point_at(surface, i, j);
    const struct surface_point *high = point_at(surface, i, j + 1);
    struct surface_point below = point_mix(&low[0], &low[1], x - i);
    struct surface_point above = point_mix(&high[0], &high[1], x - i);
    struct surface_point p = point_mix(&below, &above, y - j);
    if (u < 0.5) { /* the mirror image */
        p.place.x = -p.place.x;
        p.normal.x = -p.normal.x;
    }
    p.normal = vec3_normalized(p.normal);
    return p;
}
