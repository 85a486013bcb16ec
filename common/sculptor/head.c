/*
 * The head, neck and shoulders: see head.h.
 *
 * Built as a sculptor does it in clay: first the big masses (cranium, face, jaw, neck, chest), then
 * the parts that sit on them (brow, cheekbones, nose, lids, lips, the cords of the neck), each
 * pressed on with a softer or a sharper seam, and last small hills and hollows.
 *
 * Proportions are those of any drawing manual. The head is 1.15 high (chin at -0.22, crown at
 * 0.93). The eyes lie halfway up. Hairline to brow, brow to the nose's base and from there to the
 * chin are three equal thirds; the mouth lies a third of the way from nose to chin. The head is
 * five eyes wide, with one eye's width between the eyes; the ears reach from brow to the nose's
 * base.
 */
#include "sculptor/head.h"

/* ---- Lines that both the shape and the colours follow ---- */

double head_from_sight(struct vec3 p) {
    /* The eyes meet on something near: both are turned in a little. */
    return sqrt(square(p.x - EYE_CENTER.x + 0.002) + square(p.y - EYE_CENTER.y));
}

double head_eye_opening(struct vec3 p) {
    /* s runs from -1 at the inner corner to 1 at the outer one, which lies a little higher. */
    double s = (p.x - EYE_CENTER.x) / 0.076, y = p.y - EYE_CENTER.y - 0.006 * s;
    double arch = 1 - s * s;
    double upper = 0.0215 * arch * (1 - 0.22 * s), lower = -0.0215 * arch * (1 + 0.25 * s);
    double over = upper - y, under = y - lower;
    return over < under ? over : under;
}

double head_lips(struct vec3 p, double *along) {
    double s = p.x / 0.122;
    *along = s;
    /* The line between the lips dips next to the middle and at the corners. */
    double line =
        0.004 - 0.004 * ridge((s - 0.45) / 0.5) - 0.006 * square(s) + 0.003 * ridge(s / 0.3);
    double fade = s < 1 ? 1 - s * s : 0;
    /* Cupid's bow: the upper border has a notch in the middle between two peaks. */
    double upper = 0.044 * fade + 0.006 * ridge((s - 0.26) / 0.25) - 0.006 * ridge(s / 0.2);
    double lower = 0.050 * fade * (1 - 0.25 * s * s);
    double y = p.y - line;
    return y > 0 ? y / (upper + 0.010) : y / (lower + 0.010);
}

double head_above_hairline(struct vec3 p) {
    /* The edge as seen from the side: y over z. */
    static const double edge[][2] = {{-0.45, -0.06}, {-0.30, 0.01}, {-0.20, 0.12}, {-0.12, 0.20},
                                     {0.06, 0.20},   {0.11, 0.34},  {0.17, 0.53},  {0.25, 0.64},
                                     {0.33, 0.70},   {0.42, 0.745}};
    return p.y - curve(edge, COUNT(edge), p.z) - 0.014 * noise(vec3_scale(p, 17), 12);
}

double head_strands(struct vec3 p, double coarse, double fine, double share) {
    double dx = p.x, dz = p.z + 0.14, r = sqrt(dx * dx + dz * dz) + 0.02;
    double sway = 0.10 * noise(vec3_scale(p, 5), 31) + 0.04 * noise(vec3_scale(p, 13), 33);
    double x = dx / r + sway, z = dz / r - sway, y = p.y * 4;
    return noise(at(x * coarse, y, z * coarse), 32) + share * noise(at(x * fine, y, z * fine), 34);
}

/* ---- The big masses ---- */

static double cranium(struct vec3 p) {
    double d = ellipsoid(p, at(0, 0.525, -0.075), at(0.375, 0.385, 0.455));
    d = join(d, ellipsoid(p, at(0, 0.53, 0.10), at(0.305, 0.30, 0.325)), 0.10);
    /* The nape, where the skull's back goes over into the neck. */
    return join(d, ellipsoid(p, at(0, 0.25, -0.20), at(0.28, 0.30, 0.27)), 0.10);
}

static double face(struct vec3 p) {
    double d = ellipsoid(p, at(0, 0.22, 0.09), at(0.275, 0.30, 0.325));
    d = join(d, ellipsoid(p, at(0.17, 0.09, 0.14), at(0.135, 0.20, 0.20)), 0.08);
    /* The lower jaw, from the angle under the ear to the chin. */
    d = join(d, rod(p, at(0.215, 0.03, 0.00), at(0.07, -0.145, 0.355), 0.060, 0.060), 0.10);
    d = join(d, rod(p, at(0.225, 0.05, 0.00), at(0.260, 0.25, 0.01), 0.060, 0.065), 0.08);
    /* The temple. */
    d = join(d, ellipsoid(p, at(0.19, 0.37, 0.08), at(0.118, 0.20, 0.20)), 0.08);
    /* The floor of the mouth, under the chin. */
    d = join(d, rod(p, at(0, -0.125, 0.30), at(0, -0.165, 0.06), 0.085, 0.105), 0.08);
    /* Next to the nose. */
    d = join(d, ellipsoid(p, at(0.105, 0.19, 0.325), at(0.085, 0.125, 0.095)), 0.08);
    /* The teeth push the mouth forward. */
    return join(d, ellipsoid(p, at(0, 0.035, 0.325), at(0.150, 0.140, 0.150)), 0.08);
}

static double neck_and_chest(struct vec3 p) {
    double d = rod(p, at(0, 0.10, -0.155), at(0, -0.66, -0.20), 0.215, 0.235);
    d = join(d, rod(p, at(0, -0.05, -0.02), at(0, -0.66, -0.06), 0.150, 0.175), 0.12);
    /* Trapezius: the slope from the neck to the shoulder. */
    d = join(d, rod(p, at(0.06, -0.30, -0.25), at(0.60, -0.735, -0.19), 0.15, 0.13), 0.14);
    /* Chest and back, the breast muscle, the round of the shoulder. */
    d = join(d, ellipsoid(p, at(0, -0.98, -0.13), at(0.62, 0.47, 0.34)), 0.10);
    d = join(d, ellipsoid(p, at(0.22, -0.95, 0.04), at(0.28, 0.22, 0.165)), 0.12);
    return join(d, ellipsoid(p, at(0.67, -0.87, -0.15), at(0.215, 0.255, 0.215)), 0.14);
}

/* ---- The parts ---- */

static double add_brow_and_cheek(double d, struct vec3 p) {
    /* The ridge above the eye, the bone next to and below it. */
    d = join(d, rod(p, at(0.045, 0.435, 0.385), at(0.175, 0.462, 0.352), 0.042, 0.038), 0.06);
    d = join(d, rod(p, at(0.175, 0.462, 0.352), at(0.240, 0.400, 0.262), 0.038, 0.032), 0.06);
    d = join(d, rod(p, at(0.240, 0.400, 0.262), at(0.242, 0.255, 0.240), 0.032, 0.034), 0.07);
    d = join(d, ellipsoid(p, at(0.220, 0.225, 0.215), at(0.105, 0.075, 0.115)), 0.09);
    return join(d, rod(p, at(0.25, 0.245, 0.19), at(0.295, 0.275, 0.02), 0.040, 0.036), 0.06);
}

static double add_eye(double d, struct vec3 p) {
    struct vec3 center = EYE_CENTER;
    if (p.z < 0.2 || ball(p, center, 0.16) > 0) {
        return d;
    }
    /* The socket, then the lids as a shell around the eyeball, slit open, then the eyeball. */
    d += 0.030 * hill(p, at(0.145, 0.350, 0.41), at(0.125, 0.085, 0.12));
    d += 0.022 * hill(p, at(0.075, 0.372, 0.40), at(0.050, 0.060, 0.10));
    d = join(d, ball(p, center, EYE_RADIUS + 0.0115), 0.030);
    /* The fold above the upper lid and the one under the lower lid. */
    double opening = head_eye_opening(p);
    double s = clamp((p.x - center.x) / 0.085, -1, 1);
    double fold = p.y - center.y - 0.044 * (1 - s * s) - 0.006;
    d += 0.006 * ridge(fold / 0.010) * (1 - s * s);
    fold = p.y - center.y + 0.050 * (1 - s * s);
    d += 0.003 * ridge(fold / 0.016) * (1 - s * s);
    /* Lids have thick, rounded rims. */
    d -= 0.005 * ridge((opening + 0.007) / 0.010);
    /* Between the lids the eyeball shows, or the bottom of the slit next to it. */
    double bottom = join(d + 0.012, ball(p, center, EYE_RADIUS), 0.004);
    /* As in marble, the pupil is drilled, so that it looks at us unpainted. */
    bottom += 0.016 * fall(0.010, 0.019, head_from_sight(p));
    return mix(d, bottom, ramp(-0.002, 0.003, opening));
}

static double add_nose(double d, struct vec3 p) {
    if (p.z < 0.25 || p.y < 0.02 || p.y > 0.52) {
        return d;
    }
    double n = rod(p, at(0, 0.375, 0.398), at(0, 0.205, 0.512), 0.027, 0.035);
    n = join(n, rod(p, at(0.02, 0.36, 0.365), at(0.045, 0.175, 0.455), 0.030, 0.040), 0.04);
    n = join(n, ellipsoid(p, at(0, 0.178, 0.522), at(0.047, 0.042, 0.045)), 0.035);
    /* The wing of the nostril and the bridge of skin between the nostrils. */
    n = join(n, ellipsoid(p, at(0.063, 0.152, 0.468), at(0.034, 0.037, 0.050)), 0.032);
    n = join(n, rod(p, at(0, 0.160, 0.535), at(0, 0.130, 0.44), 0.020, 0.022), 0.018);
    d = join(d, n, 0.045);
    d += 0.003 * hill(p, at(0.104, 0.165, 0.46), at(0.022, 0.045, 0.06));
    /* The nostril. */
    return carve(d, ellipsoid(p, at(0.036, 0.122, 0.488), at(0.0165, 0.026, 0.036)), 0.010);
}

static double add_mouth(double d, struct vec3 p) {
    if (p.z < 0.25 || p.y < -0.20 || p.y > 0.16 || p.x > 0.22) {
        return d;
    }
    double along, lips = head_lips(p, &along);
    double full = clamp(1.05 - along * along, 0, 1);
    /* Each lip is a roll: out of the line between them, over the round, down to the border. */
    double roll = lips >= 0 ? ridge((lips - 0.55) / 0.75) : ridge((-lips - 0.50) / 0.80);
    d -= (lips >= 0 ? 0.019 : 0.023) * roll * full;
    d += 0.009 * ridge(lips / 0.34) * fall(0.95, 1.25, along);
    /* The corner, pressed in; the groove below the nose; the hollow under the lower lip. */
    d += 0.014 * hill(p, at(0.128, -0.002, 0.42), at(0.030, 0.030, 0.08));
    d += 0.009 * ridge(p.x / 0.022) * ramp(0.035, 0.065, p.y) * fall(0.09, 0.125, p.y);
    d -= 0.005 * ridge((p.x - 0.026) / 0.018) * ramp(0.035, 0.065, p.y) * fall(0.10, 0.125, p.y);
    d += 0.022 * hill(p, at(0, -0.082, 0.45), at(0.095, 0.036, 0.10));
    return d;
}

static double add_chin(double d, struct vec3 p) {
    if (p.y > 0.05 || p.z < 0.1) {
        return d;
    }
    return join(d, ellipsoid(p, at(0, -0.140, 0.400), at(0.085, 0.070, 0.070)), 0.08);
}

static double add_neck_cords(double d, struct vec3 p) {
    if (p.y > 0.25) {
        return d;
    }
    /* Sternocleidomastoid, from behind the ear to the pit of the neck, with its second root on
     * the collarbone; the larynx; the collarbone. */
    d = join(d, rod(p, at(0.240, 0.08, -0.13), at(0.186, -0.22, 0.005), 0.035, 0.043), 0.05);
    d = join(d, rod(p, at(0.186, -0.22, 0.005), at(0.048, -0.60, 0.120), 0.043, 0.027), 0.03);
    d = join(d, rod(p, at(0.180, -0.28, -0.01), at(0.185, -0.60, 0.075), 0.034, 0.024), 0.04);
    d = join(d, ellipsoid(p, at(0, -0.35, 0.085), at(0.045, 0.070, 0.062)), 0.07);
    d = join(d, rod(p, at(0.050, -0.640, 0.095), at(0.28, -0.605, 0.075), 0.032, 0.026), 0.06);
    d = join(d, rod(p, at(0.28, -0.605, 0.075), at(0.58, -0.640, -0.09), 0.026, 0.026), 0.06);
    d += 0.018 * hill(p, at(0, -0.585, 0.11), at(0.06, 0.07, 0.12));
    d += 0.014 * hill(p, at(0.25, -0.53, 0.02), at(0.16, 0.10, 0.16));
    return d;
}

static double add_soft_forms(double d, struct vec3 p) {
    if (p.y < -0.25) {
        return d;
    }
    /* Temple, hollow under the cheekbone, the fold from nose to mouth, and the frontal bumps. */
    d += 0.005 * hill(p, at(0.33, 0.50, 0.16), at(0.14, 0.15, 0.16));
    d += 0.009 * hill(p, at(0.27, 0.10, 0.19), at(0.12, 0.12, 0.16));
    d -= 0.012 * hill(p, at(0.145, 0.215, 0.38), at(0.085, 0.085, 0.12));
    double fold = p.x - 0.088 - 0.42 * (0.14 - p.y);
    d += 0.007 * ridge(fold / 0.045) * ramp(-0.03, 0.03, p.y) * fall(0.13, 0.175, p.y) *
         ramp(0.3, 0.36, p.z);
    d -= 0.010 * hill(p, at(0.11, 0.60, 0.40), at(0.11, 0.09, 0.12));
    return d;
}

static double add_hair(double d, struct vec3 p) {
    if (p.y < -0.1) {
        return d;
    }
    double above = head_above_hairline(p);
    if (above < -0.015) {
        return d;
    }
    /* Thin at the edge, thick on top, and combed into locks from the crown outwards. */
    double front = ramp(-0.05, 0.15, p.z);
    double fringe = front * ramp(0.40, 0.62, p.y);
    double thick =
        mix(0.008, 0.026, fringe) * ramp(-0.015, 0.026, above) + 0.028 * ramp(0, 0.22, above);
    double lock = head_strands(p, 8, 15, 0.5);
    double from_crown = sqrt(p.x * p.x + square(p.z + 0.14));
    return d - thick -
           0.016 * ramp(0, mix(0.12, 0.04, front), above) * ramp(0.04, 0.20, from_crown) * lock;
}

/* Everything above the neck. */
static double add_head(double d, struct vec3 p) {
    double head = join(cranium(p), face(p), 0.09);
    d = p.y > 0.45 ? head : join(head, d, 0.07); /* the neck does not reach so high */
    d = add_chin(d, p);
    d = add_brow_and_cheek(d, p);
    d = add_soft_forms(d, p);
    d = add_eye(d, p);
    d = add_mouth(d, p);
    return add_nose(d, p);
}

double head_distance(struct vec3 p) {
    /* A soft |x|: the two halves melt into each other in the middle instead of forming a crease. */
    p.x = sqrt(p.x * p.x + 1e-4);
    double d = p.y > 0.45 ? 1 : neck_and_chest(p);
    if (p.y > -0.42) { /* the head does not reach so low */
        d = add_head(d, p);
    }
    d = add_neck_cords(d, p);
    return add_hair(d, p);
}

/* ---- The ear ---- */

/* The height of the ear above the side of the head. `a` runs backwards, `b` up, from its middle. */
static double ear_height(double a, double b) {
    double width = b > 0 ? 0.088 : 0.088 - 0.030 * fall(-0.15, 0, b);
    double middle = b > 0 ? 0 : -0.022 * fall(-0.15, 0, b);
    double r = sqrt(square((a - middle) / width) + square(b / 0.160));
    double inside = (1 - r) * 0.088; /* about the distance to the outline */
    if (inside < -0.02) {
        return 0;
    }
    double back = ramp(-0.05, 0.0, a), upper = ramp(-0.02, 0.08, b);
    double rim = back > upper ? back : upper; /* where the helix runs */
    double h = (0.020 + 0.38 * (a + 0.085)) *
               (1 - 0.45 * ramp(0.04, 0.16, b)); /* a plate that sticks out behind */
    h += 0.017 * rim * ridge((inside - 0.010) / 0.016) * ramp(-0.14, -0.08, b); /* helix */
    h -= 0.016 * rim * ridge((inside - 0.028) / 0.014) * ramp(-0.10, -0.05, b); /* groove */
    h += 0.012 * back * ridge((inside - 0.048) / 0.018) * ramp(-0.11, -0.06, b);
    h -= 0.050 * hump(square((a + 0.012) / 0.060) + square((b + 0.018) / 0.070)); /* concha */
    h += 0.024 * hump(square((a + 0.068) / 0.026) + square((b + 0.030) / 0.036)); /* tragus */
    h += 0.014 * hump(square((a + 0.015) / 0.030) + square((b + 0.085) / 0.024));
    h = h > 0.004 ? h : 0.004;
    return h * ramp(-0.008, 0.010, inside);
}

struct vec3 head_grow_ear(struct vec3 p, double *height) {
    *height = 0;
    if (p.x < 0.2 || p.y < 0.0 || p.y > 0.5) {
        return p;
    }
    /* The ear leans back a little: turn (z, y) into its own axes. */
    double dz = p.z + 0.055, dy = p.y - 0.265;
    double a = -0.97 * dz - 0.24 * dy, b = 0.97 * dy - 0.24 * dz;
    double h = ear_height(a, b);
    *height = h;
    /* Out from the head, and back over the hollow behind it. */
    double shear = 0.50 * h;
    return at(p.x + h, p.y - 0.24 * shear, p.z - 0.97 * shear);
}
