/*
 * A picture for the tests of the check, drawn and saved without any of the course's code.
 *
 * A large disc, lit from the left, covers most of a smaller one that lies behind it and is drawn
 * last, so that a depth test is what makes the picture right.
 */
#ifndef TESTS_CHECK_PICTURE_H
#define TESTS_CHECK_PICTURE_H

#define _POSIX_C_SOURCE 200809L

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PICTURE_SIZE = 200 };

struct picture {
    unsigned char bgr[PICTURE_SIZE][PICTURE_SIZE][3]; /* [0] is the bottom row */
    int depth[PICTURE_SIZE][PICTURE_SIZE];
};

/* A disc of the centre (x,y); `rule` moves every edge by so many pixels. */
static inline void picture_disc(struct picture *p, int x, int y, int radius, int depth, int rule,
                                int use_depth) {
    for (int j = 0; j < PICTURE_SIZE; j++) {
        for (int i = 0; i < PICTURE_SIZE; i++) {
            int dx = i - x - rule, dy = j - y;
            int inside = dx * dx + dy * dy < radius * radius;
            if (inside && (!use_depth || depth > p->depth[j][i])) {
                p->depth[j][i] = depth;
                p->bgr[j][i][0] = (unsigned char)(depth * 60);
                p->bgr[j][i][1] = (unsigned char)(100 - dx);
                p->bgr[j][i][2] = (unsigned char)(200 - depth * 40);
            }
        }
    }
}

static inline void picture_draw(struct picture *p, int rule, int use_depth) {
    memset(p, 0, sizeof *p);
    picture_disc(p, 100, 100, 80, 2, rule, use_depth);
    picture_disc(p, 60, 60, 30, 1, rule, use_depth);
}

/* The 18 bytes in front of a TGA of 24-bit pixels. */
static inline void picture_header(unsigned char header[18], int width, int height) {
    memset(header, 0, 18);
    header[2] = 2;
    header[12] = (unsigned char)(width & 255);
    header[13] = (unsigned char)(width >> 8);
    header[14] = (unsigned char)(height & 255);
    header[15] = (unsigned char)(height >> 8);
    header[16] = 24;
}

/* Make every value that is drawn lighter by so many levels. */
static inline void picture_add(struct picture *p, int levels) {
    unsigned char *values = p->bgr[0][0];
    for (size_t i = 0; i < sizeof p->bgr; i++) {
        values[i] = (unsigned char)(values[i] > 0 ? values[i] + levels : 0);
    }
}

/* Save the lower `height` rows as DIRECTORY/SCENE.tga. */
static inline void picture_save(const struct picture *p, int height, const char *directory,
                                const char *scene) {
    char path[1000];
    unsigned char header[18];
    snprintf(path, sizeof path, "%s/%s.tga", directory, scene);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(9);
    }
    picture_header(header, PICTURE_SIZE, height);
    fwrite(header, 1, sizeof header, file);
    fwrite(p->bgr, sizeof p->bgr[0], (size_t)height, file);
    fclose(file);
}

/* Add a line to the file that the environment names WITNESS, where a test reads it. */
static inline void witness(const char *format, long number) {
    const char *path = getenv("WITNESS");
    FILE *file = path == NULL ? NULL : fopen(path, "a");
    if (file != NULL) {
        fprintf(file, format, number);
        fclose(file);
    }
}

#endif
