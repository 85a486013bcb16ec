/*
 * Both shaders. VERTEX hands the numbers of a corner to the pixels. The other one gives a pixel its
 * colour: FORMULA, an expression in float for red, green, blue 0..255 as the lesson has it.
 *
 * Textures hold whole values too, and are filtered here: OpenGL's own filter may round the weights
 * to 8 bits. `at_jump` says that the formula is so near to a jump (the border of a texel, of a toon
 * step, of the light) that float may fall on the other side.
 */
#ifdef VERTEX

layout(location = 0) in vec4 position;
layout(location = 1) in vec4 first_in;
layout(location = 2) in vec4 second_in;
layout(location = 3) in float face_in;
uniform mat4 to_clip;
out vec4 first, second;
noperspective out vec3 quotients; /* u/w, v/w, 1/w: linear on the screen */
flat out float face;

void main() {
    gl_Position = to_clip * position;
    first = first_in;
    second = second_in;
    quotients = vec3(first_in.xy, 1) / gl_Position.w;
    face = face_in;
}

#else

in vec4 first, second; /* the varyings */
noperspective in vec3 quotients;
flat in float face;
layout(binding = 0) uniform usampler2D diffuse_map;
layout(binding = 1) uniform usampler2D normal_map;
layout(binding = 2) uniform usampler2D specular_map;
uniform vec3 levels;  /* mip levels of the three maps */
uniform vec3 weights; /* of ambient, diffuse, specular light */
uniform vec3 to_light, color, light_color;
uniform int power;
layout(location = 0) out uvec4 pixel; /* alpha: 255, and 254 at a jump */
layout(location = 1) out float pixel_face;
layout(location = 2) out vec2 layer; /* added up over all faces, hidden ones too */
bool at_jump = false;

/* ---- Textures ---- */

vec3 texel(usampler2D map, ivec2 at, int level) {
    return vec3(texelFetch(map, at, level).rgb);
}

/* intensity, u, v */
vec3 nearest() {
    ivec2 size = textureSize(diffuse_map, 0);
    vec2 at = first.yz * vec2(size);
    at_jump = any(lessThan(abs(at - round(at)), vec2(1e-3)));
    return texel(diffuse_map, clamp(ivec2(floor(at)), ivec2(0), size - 1), 0) * first.x;
}

vec3 bilinear(usampler2D map, vec2 uv, float number) {
    int level = int(number);
    /* Mesa takes the level of one pixel for all in textureSize(map, level). */
    ivec2 last = max(textureSize(map, 0) >> level, ivec2(1)) - 1;
    vec2 at = clamp(uv * vec2(last + 1) - 0.5, vec2(0), vec2(last));
    ivec2 low = ivec2(at), high = min(low + 1, last);
    vec2 part = at - vec2(low);
    vec3 below = mix(texel(map, low, level), texel(map, ivec2(high.x, low.y), level), part.x);
    vec3 above = mix(texel(map, ivec2(low.x, high.y), level), texel(map, high, level), part.x);
    return mix(below, above, part.y);
}

float mip_level(vec2 right, vec2 up) {
    vec2 size = vec2(textureSize(diffuse_map, 0));
    float square = max(dot(right * size, right * size), dot(up * size, up * size));
    float whole = floor(log2(square));
    float level = 0.5 * (whole + square / exp2(whole) - 1.0);
    return square > 1.0 ? min(level, float(textureQueryLevels(diffuse_map) - 1)) : 0.0;
}

vec3 trilinear() {
    float w = 1.0 / quotients.z;
    vec2 uv = quotients.xy * w;
    vec3 right = dFdx(quotients), up = dFdy(quotients);
    float level = mip_level((right.xy - uv * right.z) * w, (up.xy - uv * up.z) * w);
    int finer = int(level), last = textureQueryLevels(diffuse_map) - 1;
    vec3 fine = bilinear(diffuse_map, fract(uv), float(finer));
    vec3 coarse = bilinear(diffuse_map, fract(uv), float(min(finer + 1, last)));
    return mix(fine, coarse, level - float(finer));
}

/* ---- Light ---- */

vec3 toon() {
    float at = first.x * 5.0;
    at_jump = abs(at - round(at)) < 1e-5;
    return vec3(255, 155, 0) * min(floor(at), 4.0) / 4.0;
}

vec3 map_normal(vec2 uv) {
    return normalize(bilinear(normal_map, uv, levels.y) / 127.5 - 1.0);
}

/* ---- Lesson 10: varyings towards the eye, u, v, normal ---- */

float integer_power(float base, int power) {
    float result = 1.0;
    for (; power > 0; power /= 2) {
        result *= power % 2 == 1 ? base : 1.0;
        base *= base;
    }
    return result;
}

vec3 illuminate(vec3 rgb, vec3 normal, float weight, int power) {
    vec3 to_eye = normalize(first.xyz);
    float facing = dot(normal, to_light), shine = 0.0;
    at_jump = at_jump || abs(facing) < 1e-4;
    if (facing > 0.0) {
        vec3 mirrored = 2.0 * facing * normal - to_light;
        shine = integer_power(max(dot(mirrored, to_eye), 0.0), power);
    }
    return rgb * (weights.x + weights.y * max(facing, 0.0)) + 255.0 * weight * shine;
}

vec2 place() {
    return vec2(first.w, second.x);
}

vec3 mesh_normal() {
    return normalize(second.yzw);
}

vec3 mapped_normal() {
    return map_normal(place());
}

vec3 textured() {
    return bilinear(diffuse_map, place(), levels.x);
}

float specular_value() {
    return bilinear(specular_map, place(), levels.z).r;
}

int power_of_map() {
    float at = specular_value() / 8.0;
    at_jump = abs(at - round(at)) < 1e-3;
    return 1 + int(at);
}

/* Rounded as level_from() rounds. */
void main() {
    vec3 values = clamp(FORMULA, 0.0, 255.0) + 0.5;
    pixel = uvec4(uvec3(values), at_jump ? 254u : 255u);
    pixel_face = face;
    layer = vec2(1, face);
}

#endif
