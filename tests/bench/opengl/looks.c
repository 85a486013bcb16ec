/*
 * The lessons' shading formulas in GLSL, in float.
 *
 * A fragment shader writes whole levels 0..255, rounded as level_from() does. Its alpha says what
 * it stands for: 255 for a pixel, 254 for one at which the formula stands so near to a jump (the
 * border of a texel, of a toon step, of the light) that float may fall on the other side of it.
 * Textures hold whole levels too, and are filtered here: the graphics library's own filter rounds
 * the weights to 8 bits.
 */
#include "looks.h"

static const char *const version = "#version 450 core\n";

static const char *const vertex_shader =
    "layout(location = 0) in vec4 position;\n"
    "layout(location = 1) in vec4 first_in;\n"
    "layout(location = 2) in vec4 second_in;\n"
    "layout(location = 3) in float face_in;\n"
    "uniform mat4 to_clip;\n"
    "out vec4 first, second;\n"
    "flat out float face;\n"
    "#ifdef CHECKER\n"
    "noperspective out vec3 quotients;\n" /* u/w, v/w, 1/w: linear on the screen */
    "#endif\n"
    "void main() {\n"
    "    gl_Position = to_clip * position;\n"
    "    first = first_in;\n"
    "    second = second_in;\n"
    "    face = face_in;\n"
    "#ifdef CHECKER\n"
    "    quotients = vec3(first_in.xy, 1) / gl_Position.w;\n"
    "#endif\n"
    "}\n";

static const char *const fragment_common =
    "in vec4 first, second;\n"
    "flat in float face;\n"
    "uniform usampler2D diffuse_map, normal_map, specular_map;\n"
    "uniform int diffuse_level, normal_level, specular_level, power;\n"
    "uniform vec3 to_light, color, light_color;\n"
    "uniform float ambient, diffuse, specular;\n"
    "layout(location = 0) out uvec4 pixel;\n"
    "layout(location = 1) out float pixel_face;\n"
    "bool at_jump = false;\n"
    "uvec4 rounded(vec3 levels) {\n"
    "    return uvec4(uvec3(clamp(levels, 0.0, 255.0) + 0.5), at_jump ? 254u : 255u);\n"
    "}\n"
    "vec3 texel(usampler2D map, ivec2 at, int level) {\n"
    "    return vec3(texelFetch(map, at, level).rgb);\n"
    "}\n"
    "vec3 bilinear(usampler2D map, vec2 uv, int level) {\n"
    /* Mesa takes the level of one pixel for all in textureSize(map, level). */
    "    ivec2 last = max(textureSize(map, 0) >> level, ivec2(1)) - 1;\n"
    "    vec2 at = clamp(uv * vec2(last + 1) - 0.5, vec2(0), vec2(last));\n"
    "    ivec2 low = ivec2(at), high = min(low + 1, last);\n"
    "    vec2 part = at - vec2(low);\n"
    "    vec3 below = mix(texel(map, low, level), texel(map, ivec2(high.x, low.y), level), "
    "part.x);\n"
    "    vec3 above = mix(texel(map, ivec2(low.x, high.y), level), texel(map, high, level), "
    "part.x);\n"
    "    return mix(below, above, part.y);\n"
    "}\n"
    "vec3 map_normal(vec2 uv) {\n"
    "    return normalize(bilinear(normal_map, uv, normal_level) / 127.5 - 1.0);\n"
    "}\n";

/* Step 10: illuminate(), from the lesson. */
static const char *const phong =
    "float integer_power(float base, int power) {\n"
    "    float result = 1.0;\n"
    "    for (; power > 0; power /= 2) {\n"
    "        if (power % 2 == 1) {\n"
    "            result *= base;\n"
    "        }\n"
    "        base *= base;\n"
    "    }\n"
    "    return result;\n"
    "}\n"
    "vec3 illuminate_with(vec3 rgb, vec3 normal, vec3 to_eye, float weight, int power) {\n"
    "    to_eye = normalize(to_eye);\n"
    "    float facing = dot(normal, to_light), shine = 0.0;\n"
    "    at_jump = at_jump || abs(facing) < 1e-4;\n"
    "    if (facing > 0.0) {\n"
    "        vec3 mirrored = 2.0 * facing * normal - to_light;\n"
    "        shine = integer_power(max(dot(mirrored, to_eye), 0.0), power);\n"
    "    }\n"
    "    float scattered = ambient + diffuse * max(facing, 0.0);\n"
    "    return rgb * scattered + 255.0 * weight * shine;\n"
    "}\n"
    "vec3 illuminate(vec3 rgb, vec3 normal, vec3 to_eye, float weight) {\n"
    "    return illuminate_with(rgb, normal, to_eye, weight, power);\n"
    "}\n";

static const char *const checker =
    "noperspective in vec3 quotients;\n"
    "float mip_level(vec2 right, vec2 up) {\n"
    "    vec2 size = vec2(textureSize(diffuse_map, 0));\n"
    "    float square = max(dot(right * size, right * size), dot(up * size, up * size));\n"
    "    float whole = floor(log2(square));\n"
    "    float level = 0.5 * (whole + square / exp2(whole) - 1.0);\n"
    "    return square > 1.0 ? min(level, float(textureQueryLevels(diffuse_map) - 1)) : 0.0;\n"
    "}\n"
    "void main() {\n"
    "    float w = 1.0 / quotients.z;\n"
    "    vec2 uv = quotients.xy * w;\n"
    "    vec3 right = dFdx(quotients), up = dFdy(quotients);\n"
    "    float level = mip_level((right.xy - uv * right.z) * w, (up.xy - uv * up.z) * w);\n"
    "    int finer = int(level), last = textureQueryLevels(diffuse_map) - 1;\n"
    "    vec3 fine = bilinear(diffuse_map, fract(uv), finer);\n"
    "    vec3 coarse = bilinear(diffuse_map, fract(uv), min(finer + 1, last));\n"
    "    pixel = rounded(mix(fine, coarse, level - float(finer)));\n"
    "    pixel_face = face;\n"
    "}\n";

/* The colour of a pixel in each look; `first` and `second` hold the varyings. */
static const char *const formulas[LOOK_COUNT] = {
    [LOOK_WHITE] = "vec3 levels() { return vec3(255.0 * first.x); }\n",
    [LOOK_LIT_ONLY] = "vec3 levels() {\n"
                      "    if (!(first.x > 0.0)) {\n"
                      "        discard;\n"
                      "    }\n"
                      "    return vec3(255.0 * first.x);\n"
                      "}\n",
    [LOOK_NEAREST] =
        "vec3 levels() {\n"
        "    ivec2 size = textureSize(diffuse_map, 0);\n"
        "    vec2 at = first.xy * vec2(size);\n"
        "    at_jump = any(lessThan(abs(at - round(at)), vec2(1e-3)));\n"
        "    return texel(diffuse_map, clamp(ivec2(floor(at)), ivec2(0), size - 1), 0) * first.z;\n"
        "}\n",
    [LOOK_COLORS] = "vec3 levels() { return 255.0 * first.rgb; }\n",
    [LOOK_LIT] = "vec3 levels() {\n"
                 "    float surface = ambient + diffuse * first.x;\n"
                 "    return surface * color + specular * first.y * light_color;\n"
                 "}\n",
    [LOOK_BILINEAR] = "vec3 levels() {\n"
                      "    return bilinear(diffuse_map, first.xy, diffuse_level) * first.z;\n"
                      "}\n",
    [LOOK_TOON] = "vec3 levels() {\n"
                  "    float at = first.x * 5.0;\n"
                  "    at_jump = abs(at - round(at)) < 1e-5;\n"
                  "    return vec3(255, 155, 0) * min(floor(at), 4.0) / 4.0;\n"
                  "}\n",
    [LOOK_NORMAL_MAP] = "vec3 levels() {\n"
                        "    float intensity = max(dot(map_normal(first.xy), to_light), 0.0);\n"
                        "    return bilinear(diffuse_map, first.xy, diffuse_level) * intensity;\n"
                        "}\n",
    [LOOK_PHONG_PLAIN] = "vec3 levels() {\n"
                         "    vec3 normal = normalize(second.yzw);\n"
                         "    return illuminate(color, normal, first.xyz, specular);\n"
                         "}\n",
    [LOOK_PHONG_MAPPED] = "vec3 levels() {\n"
                          "    vec2 uv = vec2(first.w, second.x);\n"
                          "    return illuminate(color, map_normal(uv), first.xyz, specular);\n"
                          "}\n",
    [LOOK_PHONG_TEXTURED] =
        "vec3 levels() {\n"
        "    vec3 rgb = bilinear(diffuse_map, vec2(first.w, second.x), diffuse_level);\n"
        "    return illuminate(rgb, normalize(second.yzw), first.xyz, specular);\n"
        "}\n",
    [LOOK_PHONG_FULL] = "vec3 levels() {\n"
                        "    vec2 uv = vec2(first.w, second.x);\n"
                        "    vec3 rgb = bilinear(diffuse_map, uv, diffuse_level);\n"
                        "    return illuminate(rgb, map_normal(uv), first.xyz, specular);\n"
                        "}\n",
    [LOOK_PHONG_WEIGHT_MAP] =
        "vec3 levels() {\n"
        "    vec2 uv = vec2(first.w, second.x);\n"
        "    vec3 rgb = bilinear(diffuse_map, uv, diffuse_level);\n"
        "    float weight = bilinear(specular_map, uv, specular_level).r / 255.0;\n"
        "    return illuminate(rgb, map_normal(uv), first.xyz, weight * specular);\n"
        "}\n",
    [LOOK_PHONG_POWER_MAP] =
        "vec3 levels() {\n"
        "    vec2 uv = vec2(first.w, second.x);\n"
        "    vec3 rgb = bilinear(diffuse_map, uv, diffuse_level);\n"
        "    float at = bilinear(specular_map, uv, specular_level).r / 8.0;\n"
        "    at_jump = abs(at - round(at)) < 1e-3;\n"
        "    return illuminate_with(rgb, map_normal(uv), first.xyz, specular, 1 + int(at));\n"
        "}\n",
};

static const char *const main_of_levels = "void main() {\n"
                                          "    vec3 result = levels();\n"
                                          "    pixel = rounded(result);\n"
                                          "    pixel_face = face;\n"
                                          "}\n";

static const char *const layers = "flat in float face;\n"
                                  "layout(location = 0) out vec2 layers;\n"
                                  "void main() { layers = vec2(1, face); }\n";

void look_vertex_shader(enum look look, const char *parts[LOOK_PARTS]) {
    parts[0] = version;
    parts[1] = look == LOOK_CHECKER ? "#define CHECKER\n" : "";
    parts[2] = vertex_shader;
    parts[3] = parts[4] = "";
}

void look_fragment_shader(enum look look, const char *parts[LOOK_PARTS]) {
    parts[0] = version;
    parts[1] = fragment_common;
    parts[2] = look == LOOK_CHECKER ? checker : "";
    parts[2] = look >= LOOK_PHONG_PLAIN ? phong : parts[2];
    parts[3] = look == LOOK_CHECKER ? "" : formulas[look];
    parts[4] = look == LOOK_CHECKER ? "" : main_of_levels;
}

void layer_fragment_shader(const char *parts[LOOK_PARTS]) {
    parts[0] = version;
    parts[1] = layers;
    parts[2] = parts[3] = parts[4] = "";
}
