/* For `make MINE=1`: lesson 4 has the direction to the light, later lessons that of the light. */
static double face_light(const struct model *model, size_t face, struct vec3 light) {
    return face_intensity(model, face, vec3_scale(light, -1));
}
