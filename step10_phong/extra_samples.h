/*
 * Beyond lesson 10: supersampling and gamma. Drawn by `build/step10_phong --only samples`.
 *
 * The head is drawn larger, and each pixel of the picture is the mean of a square of pixels: its
 * samples. (Franklin Crow, "The Aliasing Problem in Computer-Generated Shaded Images", CACM 20(11),
 * 1977.) But what is to be averaged is light, and the values of a picture are not light: a screen
 * shows the value v with (v / 255)^2.2 of its light.
 */

enum averaging { MEAN_OF_VALUES, MEAN_OF_LIGHT };

/* What each value counts in the mean. */
static void make_weights(enum averaging averaging, double weight[256]) {
    for (int value = 0; value < 256; value++) {
        weight[value] = averaging == MEAN_OF_LIGHT ? pow(value / 255.0, 2.2) : value;
    }
}

/* And back: the value that counts as much as the mean. */
static uint8_t value_of(double mean, enum averaging averaging) {
    return level_from(averaging == MEAN_OF_LIGHT ? 255 * pow(mean, 1 / 2.2) : mean);
}

/* The mean of side * side samples, in each channel; `corner` is the first byte of the lowest left
 * one. */
static struct color average(const struct image *samples, const uint8_t *corner, int side,
                            enum averaging averaging, const double weight[256]) {
    double sum[3] = {0, 0, 0}, count = side * side;
    for (int y = 0; y < side; y++) {
        const uint8_t *row = corner + (size_t)y * samples->width * samples->format;
        for (int x = 0; x < side; x++) {
            const uint8_t *sample = row + (size_t)x * samples->format;
            for (int channel = 0; channel < 3; channel++) {
                sum[channel] += weight[sample[channel]];
            }
        }
    }
    return color_rgb(value_of(sum[2] / count, averaging), value_of(sum[1] / count, averaging),
                     value_of(sum[0] / count, averaging));
}

/* Fill a part of the image from one that is `side` times as wide and as high as this part. */
static void average_into(struct image *image, struct rectangle place, const struct image *samples,
                         int side, enum averaging averaging) {
    double weight[256];
    make_weights(averaging, weight);
    for (int y = 0; y < place.height; y++) {
        for (int x = 0; x < place.width; x++) {
            size_t first = (size_t)(y * side) * samples->width + (size_t)(x * side);
            const uint8_t *corner = samples->pixels + first * samples->format;
            image_set(image, place.x + x, place.y + y,
                      average(samples, corner, side, averaging, weight));
        }
    }
}

/* The head of the scene `turn` in all of an image, whose alpha says afterwards where it is. */
static bool draw_head(const struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline pipeline = {0};
    struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0);
    struct draw_call call = pipeline_call(drawing, whole, 0.85, CULL_BACK);
    struct uniforms u = make_uniforms(drawing, 0.85 * whole.width, textured_material);
    bool done =
        pipeline_create(&pipeline, image->width, image->height, error) &&
        pipeline_draw(&pipeline, &call, drawn_by(drawing, &weight_mapped), &u, sizeof u, error) &&
        pipeline_finish(&pipeline, image, error);
    pipeline_free(&pipeline);
    return done;
}

/* Draw the head into a part of an image, with side * side samples for each pixel. */
static bool draw_sampled(const struct drawing *drawing, struct image *image, struct rectangle place,
                         int side, enum averaging averaging, struct error *error) {
    struct image samples = {0};
    if (place.width == 0 || place.height == 0) {
        return true;
    }
    bool done = image_create(&samples, (size_t)(place.width * side), (size_t)(place.height * side),
                             IMAGE_BGRA, error) &&
                draw_head(drawing, &samples, error);
    if (done) {
        average_into(image, place, &samples, side, averaging);
    }
    image_free(&samples);
    return done;
}

/* Above: 1 and 4 samples. Below: 16, their light averaged, and their values. */
static bool draw_samples(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct {
        int side;
        enum averaging averaging;
    } cells[4] = {{1, MEAN_OF_LIGHT}, {2, MEAN_OF_LIGHT}, {4, MEAN_OF_LIGHT}, {4, MEAN_OF_VALUES}};
    bool done = true;
    for (int i = 0; done && i < 4; i++) {
        struct rectangle place = grid_cell(image->width, image->height, 2, 2, i);
        done = draw_sampled(drawing, image, place, cells[i].side, cells[i].averaging, error);
    }
    return done;
}
