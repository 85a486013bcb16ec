/*
 * What is finer than the mesh: see skin.h.
 *
 * Each texel knows its point on the body, so every feature is painted where it is on the body and
 * not where it happens to lie in the texture. First comes the relief, a height above the surface in
 * units of the model (pores, creases, hair); the slope of the relief bends the surface's normal
 * (James Blinn, "Simulation of wrinkled surfaces", SIGGRAPH 1978). Then colour and shine.
 */
#include "sculptor/skin.h"

#include "sculptor/head.h"

#include <stdlib.h>
#include <string.h>

/* What is at a point of the body: how much of each part, 0..1, and of the grain there. */
struct parts {
    double hair, eyebrow, stubble;
    double lip;         /* the red of the lips */
    double eye;         /* the eyeball */
    double iris, pupil; /* on the eyeball */
    double lid_shadow;  /* on the eyeball, under the upper lid */
    double lash;        /* the rim of the upper lid */
    double forehead, nose, nostril, cheek, ear;
    double cavity;      /* how deep the place lies, -1..1 */
    double fine, broad; /* the skin's grain: noise, -1..1 */
    double strands;     /* of hair or eyebrow: noise in stripes, -2..2 */
};

static double hair_at(struct vec3 p) {
    if (p.y < -0.1) {
        return 0;
    }
    double edge = head_above_hairline(p);
    if (edge > -0.05 && edge < 0.06) { /* single strands reach over the edge */
        edge += 0.014 * head_strands(p, 60, 1, 0);
    }
    return ramp(-0.022, 0.004, edge);
}

static double eyebrow_at(struct vec3 p) {
    static const double middle[][2] = {
        {0.035, 0.425}, {0.09, 0.447}, {0.17, 0.466}, {0.255, 0.425}};
    static const double half[][2] = {
        {0.030, 0.004}, {0.05, 0.018}, {0.12, 0.016}, {0.20, 0.011}, {0.262, 0.002}};
    double off = (p.y - curve(middle, COUNT(middle), p.x)) / curve(half, COUNT(half), p.x);
    return ramp(0.025, 0.045, p.x) * fall(0.245, 0.275, p.x) * ramp(0.05, 0.15, p.z) *
           fall(0.5, 1.3, fabs(off));
}

/* The cheeks' lower half, the chin, the whiskers before the ears and the upper lip. */
static double stubble_at(struct vec3 p) {
    double jaw = fall(0.07, 0.16, p.y) * ramp(-0.27, -0.19, p.y) * ramp(0.02, 0.12, p.z);
    double side =
        ramp(0.06, 0.2, p.z) * ramp(0.18, 0.30, p.x) * ramp(-0.2, -0.1, p.y) * fall(0.1, 0.24, p.y);
    double moustache = hill(p, at(0, 0.085, 0.48), at(0.13, 0.055, 0.15));
    return clamp(jaw + side + moustache, 0, 1);
}

static void find_eye(struct parts *parts, struct vec3 p) {
    struct vec3 center = EYE_CENTER;
    double height = ball(p, center, EYE_RADIUS);
    if (height > 0.02 || p.z < center.z) {
        return;
    }
    double opening = head_eye_opening(p);
    double from_sight = head_from_sight(p);
    parts->eye = ramp(-0.001, 0.001, opening) * fall(0.001, 0.003, height);
    parts->iris = fall(IRIS_RADIUS - 0.001, IRIS_RADIUS + 0.002, from_sight);
    parts->pupil = fall(PUPIL_RADIUS - 0.001, PUPIL_RADIUS + 0.001, from_sight);
    parts->lid_shadow = fall(0, 0.012, opening) * ramp(-0.005, 0.010, p.y - center.y);
    parts->lash = fall(0.001, 0.008, fabs(opening + 0.002)) * ramp(-0.015, 0.005, p.y - center.y);
}

static void find_face(struct parts *parts, struct vec3 p) {
    parts->eyebrow = eyebrow_at(p);
    parts->forehead = hill(p, at(0, 0.58, 0.45), at(0.30, 0.16, 0.4));
    parts->nose = hill(p, at(0, 0.20, 0.53), at(0.11, 0.17, 0.15));
    parts->nostril =
        fall(0.003, 0.0105, ellipsoid(p, at(0.036, 0.124, 0.486), at(0.008, 0.016, 0.025)));
    parts->cheek = hill(p, at(0.20, 0.17, 0.34), at(0.15, 0.13, 0.25));
    double along, lips = head_lips(p, &along);
    if (p.z > 0.3) {
        parts->lip = fall(0.92, 1.12, fabs(lips)) * fall(0.9, 1.03, along);
    }
    find_eye(parts, p);
}

/* Turned so that the noise's grid lies askew on the face, where nobody sees its lines. */
static struct vec3 askew(struct vec3 p) {
    return at((2 * p.x - p.y + 2 * p.z) / 3, (2 * p.x + 2 * p.y - p.z) / 3,
              (2 * p.y - p.x + 2 * p.z) / 3);
}

/* `ear` is how far the ear sticks out at p, `cavity` how deep p lies. */
static struct parts find_parts(struct vec3 p, double ear, double cavity) {
    struct parts parts = {.ear = ramp(0.002, 0.012, ear), .cavity = cavity};
    struct vec3 q = {fabs(p.x), p.y, p.z};
    parts.hair = hair_at(q) * (1 - parts.ear);
    if (p.z > 0.1 && p.y > -0.3) {
        find_face(&parts, q);
    }
    parts.stubble = stubble_at(q) * (1 - parts.lip) * (1 - parts.hair);
    if (parts.hair > 0) {
        parts.strands = head_strands(p, 30, 70, 0.6);
    } else if (parts.eyebrow > 0) {
        parts.strands = noise(at((q.x - p.y) * 150, (q.x + p.y) * 40, 0), 25);
    }
    if (parts.hair < 1) {
        struct vec3 r = askew(p);
        parts.fine = 0.7 * noise(vec3_scale(r, 120), 21) + 0.5 * noise(vec3_scale(p, 165), 23);
        parts.broad = noise(vec3_scale(r, 62), 22);
    }
    return parts;
}

/* ---- Relief ---- */

static double creases(struct vec3 p, const struct parts *parts) {
    double x = fabs(p.x), h = 0;
    double wave = 0.010 * noise(at(p.x * 7, p.y * 4, 0.3), 41);
    /* Across the forehead. */
    for (int i = 0; i < 3; i++) {
        double y = 0.555 + 0.045 * i - 0.25 * x * x + wave;
        h -= 0.0022 * ridge((p.y - y) / 0.009) * parts->forehead;
    }
    /* From the outer corner of the eye. */
    for (int i = -1; i <= 1; i++) {
        double out = x - 0.245;
        double y = 0.352 + i * (0.012 + 0.35 * out) + 0.5 * wave;
        h -= 0.0016 * ridge((p.y - y) / 0.006) * ramp(0, 0.015, out) * fall(0.02, 0.07, out) *
             ramp(0.1, 0.15, p.z);
    }
    /* Around the neck. */
    for (int i = 0; i < 2; i++) {
        double y = -0.335 - 0.08 * i - 0.25 * x * x + 1.5 * wave;
        h -= 0.0012 * ridge((p.y - y) / 0.010) * ramp(-0.1, 0.05, p.z);
    }
    return h;
}

static double relief(struct vec3 p, const struct parts *parts) {
    double pits = ramp(0.15, 0.7, parts->fine);
    double skin = 0.0002 * parts->fine + 0.0004 * parts->broad - 0.0006 * pits;
    skin = (skin + creases(p, parts)) * (1 - parts->eye);
    if (parts->lip > 0) {
        double lines = noise(at(p.x * 110, p.y * 14, p.z * 14), 24);
        skin = mix(skin, 0.0012 * lines, parts->lip);
    }
    double h = mix(skin, 0.0045 * parts->strands, parts->hair);
    return h + parts->eyebrow * (0.004 + 0.003 * parts->strands);
}

/* ---- Colour and shine: red, green and blue are x, y and z ---- */

static struct vec3 eye_color(const struct parts *parts) {
    struct vec3 c = at(214, 203, 194);
    c = vec3_mix(c, at(88, 66, 46), parts->iris);
    c = vec3_mix(c, at(16, 14, 14), parts->pupil);
    return vec3_mix(c, at(60, 44, 38), 0.75 * parts->lid_shadow);
}

static struct vec3 skin_color(struct vec3 p, const struct parts *parts) {
    struct vec3 c = at(206, 157, 128);
    double blood = 0.55 * parts->cheek + 0.6 * parts->nose + 0.5 * parts->ear;
    c = vec3_mix(c, at(216, 172, 138), 0.8 * parts->forehead);
    c = vec3_mix(c, at(204, 128, 108), clamp(blood, 0, 0.75));
    double blotch = noise(vec3_scale(p, 9), 51);
    c = vec3_mix(c, at(192, 134, 110), clamp(0.25 + 0.5 * blotch, 0, 0.4));
    c = vec3_mix(c, at(178, 120, 98), clamp(0.3 * parts->broad, 0, 1));
    double dots = clamp(0.34 + 0.5 * parts->fine, 0, 0.8);
    c = vec3_mix(c, at(134, 112, 100), parts->stubble * dots);
    return vec3_mix(c, at(170, 98, 88), 0.75 * parts->lip);
}

static struct vec3 color_of(struct vec3 p, const struct parts *parts) {
    struct vec3 c = parts->hair < 1 ? skin_color(p, parts) : at(0, 0, 0);
    double strand = parts->strands;
    struct vec3 hair = vec3_mix(at(46, 31, 22), at(122, 88, 60), clamp(0.35 + 0.5 * strand, 0, 1));
    c = vec3_mix(c, hair, parts->hair);
    c = vec3_mix(c, at(66, 47, 36), parts->eyebrow * clamp(0.8 + 0.5 * strand, 0, 1));
    c = vec3_mix(c, eye_color(parts), parts->eye);
    c = vec3_mix(c, at(58, 38, 32), 0.85 * parts->lash);
    c = vec3_mix(c, at(40, 20, 16), 0.9 * parts->nostril);
    /* Light hardly reaches the bottom of a fold. */
    return vec3_mix(c, at(60, 34, 28), clamp(1.3 * parts->cavity - 0.05, 0, 0.75));
}

static double shine(const struct parts *parts) {
    double s = 62 + 14 * parts->broad + 16 * parts->fine;
    s += 80 * parts->forehead + 110 * parts->nose;
    s *= 1 - 0.45 * parts->cheek * (1 - parts->nose);
    s *= 1 - 0.4 * parts->stubble;
    s = mix(s, 175, parts->lip);
    s = mix(s, 70, parts->hair);
    s = mix(s, 40, parts->eyebrow);
    s = mix(s, 125, parts->eye);
    return s * (1 - clamp(1.5 * parts->cavity, 0, 0.8)) * (1 - 0.95 * parts->nostril);
}

/* ---- Texels ---- */

struct texel {
    struct vec3 place, normal;
    double height; /* of the relief */
};

/* The normal bent by the relief's slope along u and v. */
static struct vec3 bend(struct vec3 normal, struct vec3 along_u, struct vec3 along_v, double rise_u,
                        double rise_v) {
    double area = vec3_dot(normal, vec3_cross(along_u, along_v));
    if (area < 1e-12) {
        return normal;
    }
    struct vec3 slope = vec3_add(vec3_scale(vec3_cross(along_v, normal), rise_u / area),
                                 vec3_scale(vec3_cross(normal, along_u), rise_v / area));
    double steep = vec3_length(slope);
    if (steep > 1.2) {
        slope = vec3_scale(slope, 1.2 / steep);
    }
    return vec3_normalized(vec3_sub(normal, slope));
}

/* On the eyeball the normal of the ball: the cornea lies smooth over the drilled pupil. */
static struct vec3 smooth_eye(struct vec3 p, struct vec3 normal) {
    struct vec3 q = {fabs(p.x), p.y, p.z};
    if (ball(q, EYE_CENTER, EYE_RADIUS) > 0.004 || q.z < EYE_CENTER.z) {
        return normal;
    }
    struct vec3 round = vec3_normalized(vec3_sub(q, EYE_CENTER));
    round.x = p.x < 0 ? -round.x : round.x;
    double eye = ramp(-0.001, 0.001, head_eye_opening(q));
    return vec3_normalized(vec3_mix(normal, round, eye));
}

/* Red, green and blue of these levels. */
static struct color rgb(double r, double g, double b) {
    return color_rgb(level_from(r), level_from(g), level_from(b));
}

static void paint_colors(struct skin *skin, const struct surface *surface, struct texel *texels) {
    size_t size = skin->diffuse.width;
    for (size_t y = 0; y < size; y++) {
        for (size_t x = 0; x < size; x++) {
            struct surface_point point = surface_at(surface, ((double)x + 0.5) / (double)size,
                                                    ((double)y + 0.5) / (double)size);
            struct vec3 p = point.place;
            struct parts parts = find_parts(p, point.ear, point.cavity);
            texels[y * size + x] =
                (struct texel){p, smooth_eye(p, point.normal), relief(p, &parts)};
            struct vec3 c = color_of(p, &parts);
            image_set(&skin->diffuse, (int)x, (int)y, rgb(c.x, c.y, c.z));
            image_set(&skin->specular, (int)x, (int)y, color_grey(level_from(shine(&parts))));
        }
    }
}

/* The slopes are those between the texels on both sides: the texture goes once around the body. */
static void paint_normals(struct image *image, const struct texel *texels) {
    size_t size = image->width;
    for (size_t y = 0; y < size; y++) {
        const struct texel *row = texels + y * size;
        const struct texel *above = y + 1 < size ? row + size : row;
        const struct texel *below = y > 0 ? row - size : row;
        for (size_t x = 0; x < size; x++) {
            const struct texel *left = &row[x > 0 ? x - 1 : size - 1];
            const struct texel *right = &row[x + 1 < size ? x + 1 : 0];
            struct vec3 n = bend(row[x].normal, vec3_sub(right->place, left->place),
                                 vec3_sub(above[x].place, below[x].place),
                                 right->height - left->height, above[x].height - below[x].height);
            image_set(image, (int)x, (int)y,
                      rgb((n.x + 1) * 127.5, (n.y + 1) * 127.5, (n.z + 1) * 127.5));
        }
    }
}

bool skin_create(struct skin *skin, const struct surface *surface, size_t size,
                 struct error *error) {
    memset(skin, 0, sizeof *skin);
    struct texel *texels = calloc(size * size, sizeof *texels);
    if (texels == NULL) {
        return error_set(error, "out of memory for the skin");
    }
    bool done = image_create(&skin->diffuse, size, size, IMAGE_BGR, error) &&
                image_create(&skin->normals, size, size, IMAGE_BGR, error) &&
                image_create(&skin->specular, size, size, IMAGE_GREY, error);
    if (done) {
        paint_colors(skin, surface, texels);
        paint_normals(&skin->normals, texels);
    } else {
        skin_free(skin);
    }
    free(texels);
    return done;
}

void skin_free(struct skin *skin) {
    image_free(&skin->diffuse);
    image_free(&skin->normals);
    image_free(&skin->specular);
}
