/* Textures and their mip levels; see texture.h. */
#include "texture.h"

#include "base/large_pages.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* The texels that one texel of the next level covers along one axis. The weights are whole numbers:
 * lengths in a unit that divides them all. */
struct cover {
    size_t first;       /* the first texel */
    size_t count;       /* 1 to 3 texels */
    uint32_t weight[3]; /* how much of each is covered */
};

/* What lies between a row and the next: the first texel again, and nothing. */
static void fill_gap(const struct texture_level *level, size_t row) {
    uint32_t *texels = level->texels + row * level->pitch, *gap = texels + level->width;
    memset(gap, 0, (level->pitch - level->width) * sizeof *gap);
    gap[0] = texels[0];
}

/* Above the last row, the first one again. */
static void repeat_first_row(const struct texture_level *level) {
    memcpy(level->texels + level->height * level->pitch, level->texels,
           level->pitch * sizeof *level->texels);
}

static size_t half_size(size_t size) {
    return size > 1 ? size / 2 : 1;
}

/* Texel `i` of half_size(size). Even: two whole texels. Odd, size = 2m + 1: texel i covers from
 * i (2 + 1/m) to (i + 1)(2 + 1/m), which in units of 1/m is m - i, m and i + 1 of three texels. */
static struct cover cover_of(size_t i, size_t size) {
    uint32_t m = (uint32_t)(size / 2), at = (uint32_t)i;
    if (size == 1) {
        return (struct cover){0, 1, {1, 0, 0}};
    }
    if (size % 2 == 0) {
        return (struct cover){2 * i, 2, {1, 1, 0}};
    }
    return (struct cover){2 * i, 3, {m - at, m, at + 1}};
}

/* The mean of the covered texels, each channel rounded to the nearest level, halves up. Sums stay
 * below 65535^2 * 255 < 2^41: everything is exact. */
static uint32_t mean_texel(const struct texture_level *from, const struct cover *across,
                           const struct cover *up) {
    uint64_t sum[4] = {0, 0, 0, 0}, total = 0;
    for (size_t y = 0; y < up->count; y++) {
        const uint32_t *row = from->texels + (up->first + y) * from->pitch + across->first;
        for (size_t x = 0; x < across->count; x++) {
            uint64_t weight = (uint64_t)up->weight[y] * across->weight[x];
            uint32_t texel = row[x];
            total += weight;
            for (int channel = 0; channel < 4; channel++) {
                sum[channel] += weight * (texel >> 8 * channel & 0xFF);
            }
        }
    }
    assert(total > 0); /* a texel covers something */
    uint32_t mean = 0;
    for (int channel = 0; channel < 4; channel++) {
        mean |= (uint32_t)((2 * sum[channel] + total) / (2 * total)) << 8 * channel;
    }
    return mean;
}

/* The mean of four texels, rounded. Two channels are added at a time, in 16 bits each: four levels
 * and 2 for rounding stay below 2^10. */
static uint32_t mean_of_four(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    const uint32_t two_channels = 0x00FF00FF;
    uint32_t low = (a & two_channels) + (b & two_channels) + (c & two_channels) +
                   (d & two_channels) + 0x00020002;
    uint32_t high = (a >> 8 & two_channels) + (b >> 8 & two_channels) + (c >> 8 & two_channels) +
                    (d >> 8 & two_channels) + 0x00020002;
    return (low >> 2 & two_channels) | (high >> 2 & two_channels) << 8;
}

/* A level of even width and height, as nearly all are: without weights and divisions. */
static void shrink_even_level(const struct texture_level *from, struct texture_level *to) {
    for (size_t y = 0; y < to->height; y++) {
        const uint32_t *lower = from->texels + 2 * y * from->pitch, *upper = lower + from->pitch;
        uint32_t *row = to->texels + y * to->pitch;
        for (size_t x = 0; x < to->width; x++) {
            row[x] = mean_of_four(lower[2 * x], lower[2 * x + 1], upper[2 * x], upper[2 * x + 1]);
        }
        fill_gap(to, y);
    }
}

static void shrink_level(const struct texture_level *from, struct texture_level *to) {
    if (from->width % 2 == 0 && from->height % 2 == 0) {
        shrink_even_level(from, to);
        return;
    }
    for (size_t y = 0; y < to->height; y++) {
        struct cover up = cover_of(y, from->height);
        for (size_t x = 0; x < to->width; x++) {
            struct cover across = cover_of(x, from->width);
            to->texels[y * to->pitch + x] = mean_texel(from, &across, &up);
        }
        fill_gap(to, y);
    }
}

/* A loop for each format, so that the compiler knows how many bytes a pixel has. */
static void unpack_row(const uint8_t *p, enum image_format format, size_t width,
                       uint32_t *restrict texels) {
    switch (format) {
    case IMAGE_GREY:
        for (size_t i = 0; i < width; i++) {
            texels[i] = p[i] * UINT32_C(0x010101) | UINT32_C(0xFF000000);
        }
        break;
    case IMAGE_BGR:
        for (size_t i = 0; i < width; i++, p += 3) {
            texels[i] = p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | UINT32_C(0xFF000000);
        }
        break;
    case IMAGE_BGRA:
        for (size_t i = 0; i < width; i++, p += 4) {
            texels[i] = p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
        }
        break;
    }
}

static void unpack_image(const struct image *image, const struct texture_level *to) {
    const uint8_t *row = image->pixels;
    for (size_t y = 0; y < to->height; y++) {
        unpack_row(row, image->format, to->width, to->texels + y * to->pitch);
        fill_gap(to, y);
        row += image->width * image->format;
    }
}

/* Set the sizes of the levels. Returns how many texels they have, which lie one after the other,
 * with the row above the last one. */
static uint64_t lay_out(struct texture *texture, size_t width, size_t height, size_t limit) {
    uint64_t count = 0;
    for (;;) {
        size_t pitch = texture_pitch(width);
        texture->level[texture->level_count++] = (struct texture_level){
            .width = width,
            .height = height,
            .pitch = pitch,
        };
        count += (uint64_t)pitch * (height + 1);
        if ((width == 1 && height == 1) || texture->level_count == limit) {
            return count;
        }
        width = half_size(width);
        height = half_size(height);
    }
}

bool texture_create(struct texture *texture, const struct image *image, struct error *error) {
    return texture_create_levels(texture, image, 0, error);
}

bool texture_create_levels(struct texture *texture, const struct image *image, size_t limit,
                           struct error *error) {
    *texture = (struct texture){0};
    if (image->width < 1 || image->height < 1 || image->width > IMAGE_SIZE_LIMIT ||
        image->height > IMAGE_SIZE_LIMIT) {
        return error_set(error, "a texture of %zux%zu pixels", image->width, image->height);
    }
    if ((uint64_t)texture_pitch(image->width) * image->height > TEXTURE_TEXEL_LIMIT) {
        return error_set(error, "a texture of %zux%zu pixels, more than %d texels", image->width,
                         image->height, TEXTURE_TEXEL_LIMIT);
    }
    uint64_t count = lay_out(texture, image->width, image->height, limit);
    /* Another row: a place that is rounded up to the first texel behind the last one has
     * neighbours, too, which count for nothing. */
    uint64_t room = count + texture->level[0].pitch;
    if (room <= SIZE_MAX / sizeof *texture->texels) {
        texture->texels = malloc((size_t)room * sizeof *texture->texels);
    }
    if (texture->texels == NULL) {
        *texture = (struct texture){0};
        return error_out_of_memory(error);
    }
    ask_for_large_pages(texture->texels, (size_t)room * sizeof *texture->texels);
    memset(texture->texels + count, 0, (size_t)(room - count) * sizeof *texture->texels);
    uint32_t *next = texture->texels;
    for (size_t i = 0; i < texture->level_count; i++) {
        texture->level[i].texels = next;
        next += texture->level[i].pitch * (texture->level[i].height + 1);
    }
    texture_set_clamp(texture, false);
    unpack_image(image, &texture->level[0]);
    repeat_first_row(&texture->level[0]);
    for (size_t i = 1; i < texture->level_count; i++) {
        shrink_level(&texture->level[i - 1], &texture->level[i]);
        repeat_first_row(&texture->level[i]);
    }
    return true;
}

void texture_set_clamp(struct texture *texture, bool clamp) {
    texture->clamp = clamp;
    for (size_t i = 0; i < texture->level_count; i++) {
        struct texture_level *level = &texture->level[i];
        level->columns = (float)level->width;
        level->rows = (float)level->height;
        level->recip_columns = clamp ? 0 : 1 / level->columns;
        level->recip_rows = clamp ? 0 : 1 / level->rows;
        level->most_columns = clamp ? level->columns - 1 : level->columns;
        level->most_rows = clamp ? level->rows - 1 : level->rows;
        level->kind =
            1 | (uint64_t)clamp << 1 | (uint64_t)level->width << 2 | (uint64_t)level->height << 32;
    }
}

void texture_free(struct texture *texture) {
    free(texture->texels);
    *texture = (struct texture){0};
}

size_t texture_wrapped_level(const struct texture *texture, double pixels) {
    size_t level = 0;
    if (texture != NULL) {
        double texels = (double)texture->level[0].width / 2;
        while (texels > 1.5 * pixels && level + 1 < texture->level_count) {
            texels /= 2;
            level++;
        }
    }
    return level;
}
