/* Mesa without a window: see mesa.h. */
#include "mesa.h"

#include "context.h"
#include "looks.h"

#include <stdlib.h>

enum { TEXTURE_LIMIT = 4, UNIFORM_TEXTURES = 3 };

struct mesa {
    struct gl_context context;
    GLuint programs[LOOK_COUNT], layer_program;
    /* The picture that is loaded. */
    GLuint vertex_array;
    GLuint *buffers; /* two a batch: whole and snapped */
    size_t buffer_count;
    GLuint colors, faces, depths, layers; /* renderbuffers */
    GLuint frame, layer_frame;            /* framebuffers */
    GLuint textures[TEXTURE_LIMIT];
    const struct texture *sources[TEXTURE_LIMIT];
    size_t texture_count;
};

/* ---- Shaders ---- */

/* 0, with a message, when the program cannot be made. */
static GLuint make_program(enum look look, bool layers, struct error *error) {
    const char *vertex_parts[LOOK_PARTS], *fragment_parts[LOOK_PARTS];
    look_vertex_shader(look, vertex_parts);
    if (layers) {
        layer_fragment_shader(fragment_parts);
    } else {
        look_fragment_shader(look, fragment_parts);
    }
    return gl_make_program(vertex_parts, fragment_parts, LOOK_PARTS, error);
}

struct mesa *mesa_open(struct error *error) {
    struct mesa *mesa = calloc(1, sizeof *mesa);
    if (mesa == NULL) {
        error_set(error, "out of memory");
        return NULL;
    }
    if (!gl_context_open(&mesa->context, error)) {
        goto fail;
    }
    for (int look = 0; look < LOOK_COUNT; look++) {
        mesa->programs[look] = make_program((enum look)look, false, error);
        if (mesa->programs[look] == 0) {
            goto fail;
        }
    }
    mesa->layer_program = make_program(LOOK_WHITE, true, error);
    if (mesa->layer_program == 0) {
        goto fail;
    }
    return mesa;
fail:
    mesa_close(mesa);
    return NULL;
}

void mesa_close(struct mesa *mesa) {
    if (mesa == NULL) {
        return;
    }
    if (mesa->context.context != EGL_NO_CONTEXT) {
        mesa_unload(mesa);
        for (int look = 0; look < LOOK_COUNT; look++) {
            glDeleteProgram(mesa->programs[look]);
        }
        glDeleteProgram(mesa->layer_program);
    }
    gl_context_close(&mesa->context);
    free(mesa);
}

const char *mesa_name(const struct mesa *mesa) {
    return mesa->context.name;
}

/* ---- A picture ---- */

static GLuint make_renderbuffer(GLenum format, const struct picture *picture) {
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, (GLsizei)picture->width,
                          (GLsizei)picture->height);
    return buffer;
}

static void attach(GLenum place, GLuint renderbuffer) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, renderbuffer);
}

static bool make_targets(struct mesa *mesa, const struct picture *picture) {
    mesa->colors = make_renderbuffer(GL_RGBA8UI, picture);
    mesa->faces = make_renderbuffer(GL_R32F, picture);
    mesa->depths = make_renderbuffer(GL_DEPTH_COMPONENT32F, picture);
    mesa->layers = make_renderbuffer(GL_RG32F, picture);
    glGenFramebuffers(1, &mesa->frame);
    glBindFramebuffer(GL_FRAMEBUFFER, mesa->frame);
    attach(GL_COLOR_ATTACHMENT0, mesa->colors);
    attach(GL_COLOR_ATTACHMENT1, mesa->faces);
    attach(GL_DEPTH_ATTACHMENT, mesa->depths);
    bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glGenFramebuffers(1, &mesa->layer_frame);
    glBindFramebuffer(GL_FRAMEBUFFER, mesa->layer_frame);
    attach(GL_COLOR_ATTACHMENT0, mesa->layers);
    return complete && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/* Upload a texture with its mip levels, unless it has been; NULL is nothing to do. */
static bool load_texture(struct mesa *mesa, const struct texture *texture) {
    for (size_t i = 0; i < mesa->texture_count; i++) {
        if (mesa->sources[i] == texture) {
            return true;
        }
    }
    if (texture == NULL) {
        return true;
    }
    if (mesa->texture_count == TEXTURE_LIMIT) {
        return false;
    }
    glGenTextures(1, &mesa->textures[mesa->texture_count]);
    glBindTexture(GL_TEXTURE_2D, mesa->textures[mesa->texture_count]);
    mesa->sources[mesa->texture_count++] = texture;
    for (size_t i = 0; i < texture->level_count; i++) {
        const struct texture_level *level = &texture->level[i];
        glPixelStorei(GL_UNPACK_ROW_LENGTH, (GLint)level->pitch);
        glTexImage2D(GL_TEXTURE_2D, (GLint)i, GL_RGBA8UI, (GLsizei)level->width,
                     (GLsizei)level->height, 0, GL_BGRA_INTEGER, GL_UNSIGNED_INT_8_8_8_8_REV,
                     level->texels);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, (GLint)texture->level_count - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return true;
}

static bool load_textures(struct mesa *mesa, const struct picture *picture) {
    for (size_t i = 0; i < picture->batch_count; i++) {
        const struct look_values *values = &picture->batches[i].values;
        if (!load_texture(mesa, values->diffuse_map) || !load_texture(mesa, values->normal_map) ||
            !load_texture(mesa, values->specular_map)) {
            return false;
        }
    }
    return true;
}

static void load_corners(GLuint buffer, const struct gl_corner *corners, size_t count) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *corners), corners, GL_STATIC_DRAW);
}

bool mesa_load(struct mesa *mesa, const struct picture *picture, struct error *error) {
    mesa_unload(mesa);
    mesa->buffer_count = 2 * picture->batch_count;
    mesa->buffers = calloc(mesa->buffer_count + 1, sizeof *mesa->buffers);
    if (mesa->buffers == NULL) {
        mesa->buffer_count = 0;
        return error_set(error, "out of memory");
    }
    glGenVertexArrays(1, &mesa->vertex_array);
    glGenBuffers((GLsizei)mesa->buffer_count, mesa->buffers);
    for (size_t i = 0; i < picture->batch_count; i++) {
        const struct batch *batch = &picture->batches[i];
        load_corners(mesa->buffers[2 * i], batch->whole, batch->whole_count);
        load_corners(mesa->buffers[2 * i + 1], batch->snapped, batch->snapped_count);
    }
    if (!make_targets(mesa, picture) || !load_textures(mesa, picture)) {
        return error_set(error, "Mesa cannot draw off the screen in this format");
    }
    return true;
}

void mesa_unload(struct mesa *mesa) {
    const GLuint renderbuffers[4] = {mesa->colors, mesa->faces, mesa->depths, mesa->layers};
    const GLuint framebuffers[2] = {mesa->frame, mesa->layer_frame};
    glDeleteRenderbuffers(4, renderbuffers);
    glDeleteFramebuffers(2, framebuffers);
    glDeleteTextures((GLsizei)mesa->texture_count, mesa->textures);
    if (mesa->buffers != NULL) {
        glDeleteBuffers((GLsizei)mesa->buffer_count, mesa->buffers);
    }
    glDeleteVertexArrays(1, &mesa->vertex_array);
    free(mesa->buffers);
    mesa->buffers = NULL;
    mesa->buffer_count = mesa->texture_count = 0;
    mesa->colors = mesa->faces = mesa->depths = mesa->layers = 0;
    mesa->frame = mesa->layer_frame = mesa->vertex_array = 0;
}

/* ---- Drawing ---- */

static void set_float(GLuint program, const char *name, double value) {
    glUniform1f(glGetUniformLocation(program, name), (float)value);
}

static void set_int(GLuint program, const char *name, int value) {
    glUniform1i(glGetUniformLocation(program, name), value);
}

/* Bind a texture to a unit and tell the shader. */
static void set_texture(const struct mesa *mesa, GLuint program, const char *name, int unit,
                        const struct texture *texture) {
    set_int(program, name, unit);
    for (size_t i = 0; i < mesa->texture_count; i++) {
        if (mesa->sources[i] == texture) {
            glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
            glBindTexture(GL_TEXTURE_2D, mesa->textures[i]);
        }
    }
}

static void set_values(const struct mesa *mesa, GLuint program, const struct look_values *v) {
    set_texture(mesa, program, "diffuse_map", 0, v->diffuse_map);
    set_texture(mesa, program, "normal_map", 1, v->normal_map);
    set_texture(mesa, program, "specular_map", 2, v->specular_map);
    set_int(program, "diffuse_level", (int)v->diffuse_level);
    set_int(program, "normal_level", (int)v->normal_level);
    set_int(program, "specular_level", (int)v->specular_level);
    set_int(program, "power", v->power);
    gl_set_vec3(program, "to_light", v->to_light);
    gl_set_vec3(program, "color", v->color);
    gl_set_vec3(program, "light_color", v->light_color);
    set_float(program, "ambient", v->ambient);
    set_float(program, "diffuse", v->diffuse);
    set_float(program, "specular", v->specular);
}

static void set_view(GLuint program, const struct picture *picture, const struct batch *batch,
                     enum positions positions) {
    const struct rectangle *r = &batch->viewport;
    const struct mat4 identity = mat4_identity();
    glScissor(r->x, r->y, r->width, r->height);
    if (positions == POSITIONS_WHOLE) {
        glViewport(r->x, r->y, r->width, r->height);
        gl_set_matrix(program, "to_clip", &batch->to_clip);
    } else {
        glViewport((GLint)(picture->width / 2) - SNAPPED_VIEWPORT / 2,
                   (GLint)(picture->height / 2) - SNAPPED_VIEWPORT / 2, SNAPPED_VIEWPORT,
                   SNAPPED_VIEWPORT);
        gl_set_matrix(program, "to_clip", &identity);
    }
}

static void set_tests(const struct batch *batch, bool layers) {
    (batch->depth_test && !layers ? glEnable : glDisable)(GL_DEPTH_TEST);
    (layers ? glEnable : glDisable)(GL_BLEND);
    (batch->cull != CULL_NONE ? glEnable : glDisable)(GL_CULL_FACE);
    glCullFace(batch->cull == CULL_FRONT ? GL_FRONT : GL_BACK);
}

/* Where the vertex shader finds its inputs in a struct gl_corner. */
static void describe_corners(GLuint buffer) {
    const GLuint varyings = offsetof(struct gl_corner, varyings);
    const GLuint half = VARYINGS / 2 * sizeof(float);
    glVertexAttribFormat(0, 4, GL_FLOAT, GL_FALSE, offsetof(struct gl_corner, position));
    glVertexAttribFormat(1, VARYINGS / 2, GL_FLOAT, GL_FALSE, varyings);
    glVertexAttribFormat(2, VARYINGS / 2, GL_FLOAT, GL_FALSE, varyings + half);
    glVertexAttribFormat(3, 1, GL_FLOAT, GL_FALSE, offsetof(struct gl_corner, face));
    glBindVertexBuffer(0, buffer, 0, sizeof(struct gl_corner));
    for (GLuint i = 0; i < 4; i++) {
        glVertexAttribBinding(i, 0);
        glEnableVertexAttribArray(i);
    }
}

static void draw_batches(const struct mesa *mesa, const struct picture *picture,
                         enum positions positions, bool layers) {
    glEnable(GL_SCISSOR_TEST);
    gl_use_conventions();
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(mesa->vertex_array);
    for (size_t i = 0; i < picture->batch_count; i++) {
        const struct batch *batch = &picture->batches[i];
        bool whole = positions == POSITIONS_WHOLE;
        size_t count = whole ? batch->whole_count : batch->snapped_count;
        GLuint program = layers ? mesa->layer_program : mesa->programs[batch->look];
        glUseProgram(program);
        set_view(program, picture, batch, positions);
        set_tests(batch, layers);
        if (!layers) {
            set_values(mesa, program, &batch->values);
        }
        describe_corners(mesa->buffers[2 * i + !whole]);
        glDrawArrays(GL_TRIANGLES, 0, (GLsizei)count);
    }
}

static void draw(struct mesa *mesa, const struct picture *picture, enum positions positions,
                 bool faces) {
    static const GLenum targets[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    static const GLuint no_color[4] = {0, 0, 0, 0};
    static const GLfloat zero[4] = {0, 0, 0, 0};
    glBindFramebuffer(GL_FRAMEBUFFER, mesa->frame);
    glDrawBuffers(faces ? 2 : 1, targets);
    glDisable(GL_SCISSOR_TEST);
    glClearBufferuiv(GL_COLOR, 0, no_color);
    if (faces) {
        glClearBufferfv(GL_COLOR, 1, zero);
    }
    glClearBufferfv(GL_DEPTH, 0, zero);
    draw_batches(mesa, picture, positions, false);
    glFinish();
}

void mesa_draw(struct mesa *mesa, const struct picture *picture, enum positions positions) {
    draw(mesa, picture, positions, false);
}

static void draw_layers(struct mesa *mesa, const struct picture *picture,
                        enum positions positions) {
    static const GLfloat zero[4] = {0, 0, 0, 0};
    glBindFramebuffer(GL_FRAMEBUFFER, mesa->layer_frame);
    glDisable(GL_SCISSOR_TEST);
    glClearBufferfv(GL_COLOR, 0, zero);
    draw_batches(mesa, picture, positions, true);
    glFinish();
}

/* ---- Reading back ---- */

static void read_pixels(const struct picture *picture, GLenum format, GLenum type, void *to) {
    glReadPixels(0, 0, (GLsizei)picture->width, (GLsizei)picture->height, format, type, to);
}

void mesa_read_depths(struct mesa *mesa, const struct picture *picture, float *depths) {
    glBindFramebuffer(GL_FRAMEBUFFER, mesa->frame);
    read_pixels(picture, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
}

bool mesa_draw_and_read(struct mesa *mesa, const struct picture *picture, enum positions positions,
                        struct mesa_result *result, struct error *error) {
    size_t pixel_count = picture->width * picture->height;
    *result = (struct mesa_result){
        .pixels = malloc(pixel_count * 4),
        .faces = malloc(pixel_count * sizeof *result->faces),
        .depths = malloc(pixel_count * sizeof *result->depths),
        .layers = malloc(pixel_count * sizeof *result->layers),
    };
    if (result->pixels == NULL || result->faces == NULL || result->depths == NULL ||
        result->layers == NULL) {
        mesa_result_free(result);
        return error_set(error, "out of memory");
    }
    draw(mesa, picture, positions, true);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    read_pixels(picture, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, result->pixels);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    read_pixels(picture, GL_RED, GL_FLOAT, result->faces);
    mesa_read_depths(mesa, picture, result->depths);
    draw_layers(mesa, picture, positions);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    read_pixels(picture, GL_RG, GL_FLOAT, result->layers);
    GLenum problem = glGetError();
    if (problem != GL_NO_ERROR) {
        mesa_result_free(result);
        return error_set(error, "OpenGL reports error 0x%x", (unsigned)problem);
    }
    return true;
}

void mesa_result_free(struct mesa_result *result) {
    free(result->pixels);
    free(result->faces);
    free(result->depths);
    free(result->layers);
    *result = (struct mesa_result){0};
}
