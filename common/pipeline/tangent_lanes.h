/*
 * Normal maps in tangent space, for pixels: tangent.h includes this. They have a file of their own
 * because lesson 10 names tangent.h before its readers know what the values of a normal map mean.
 */
#ifndef COMMON_PIPELINE_TANGENT_LANES_H
#define COMMON_PIPELINE_TANGENT_LANES_H

#include "lanes.h"

/* From the values 0..255 of such a map and the axes of a pixel: a normal of any length. */
LANES_INLINE struct lanes3 tangent_normal(const lanes *varyings, struct lanes3 value) {
    lanes u = value.x - 127.5f, v = value.y - 127.5f, away = value.z - 127.5f;
    return (struct lanes3){
        u * varyings[0] + v * varyings[3] + away * varyings[6],
        u * varyings[1] + v * varyings[4] + away * varyings[7],
        u * varyings[2] + v * varyings[5] + away * varyings[8],
    };
}

/* As tangent_normal(), of one pixel. */
static inline struct vec3 tangent_normal_at(const double *varyings, struct vec3 value) {
    const double u = value.x - 127.5, v = value.y - 127.5, away = value.z - 127.5;
    return (struct vec3){
        u * varyings[0] + v * varyings[3] + away * varyings[6],
        u * varyings[1] + v * varyings[4] + away * varyings[7],
        u * varyings[2] + v * varyings[5] + away * varyings[8],
    };
}

#endif
