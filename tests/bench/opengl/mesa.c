/* Mesa draws a picture: see mesa.h. */
#include "mesa.h"

#include "base/file.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Begin and end ---- */

bool seen_create(struct seen *seen, size_t pixel_count, struct error *error) {
    *seen = (struct seen){
        .pixels = calloc(pixel_count, sizeof *seen->pixels),
        .faces = calloc(pixel_count, sizeof *seen->faces),
        .layers = calloc(pixel_count, sizeof *seen->layers),
        .depths = calloc(pixel_count, sizeof *seen->depths),
    };
    return (seen->pixels != NULL && seen->faces != NULL && seen->layers != NULL &&
            seen->depths != NULL) ||
           error_out_of_memory(error);
}

void seen_free(struct seen *seen) {
    free(seen->pixels);
    free(seen->faces);
    free(seen->layers);
    free(seen->depths);
    *seen = (struct seen){0};
}

/* The colour, the face that is seen, the layers, and the depth of a pixel. */
static bool make_targets(void) {
    static const GLenum formats[] = {GL_RGBA8UI, GL_R32F, GL_RG32F, GL_DEPTH_COMPONENT32F};
    static const GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                    GL_COLOR_ATTACHMENT2, GL_DEPTH_ATTACHMENT};
    GLuint frame, targets[4];
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glGenRenderbuffers(4, targets);
    for (int i = 0; i < 4; i++) {
        glBindRenderbuffer(GL_RENDERBUFFER, targets[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, formats[i], SIDE_LIMIT, SIDE_LIMIT);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, targets[i]);
    }
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/* Where the vertex shader finds its inputs in a struct gl_corner. */
static void describe_corners(void) {
    const GLuint varyings = offsetof(struct gl_corner, varyings), half = 4 * sizeof(float);
    GLuint array, buffer;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindVertexBuffer(0, buffer, 0, sizeof(struct gl_corner));
    glVertexAttribFormat(1, 4, GL_FLOAT, GL_FALSE, varyings);
    glVertexAttribFormat(2, 4, GL_FLOAT, GL_FALSE, varyings + half);
    glVertexAttribFormat(3, 1, GL_FLOAT, GL_FALSE, offsetof(struct gl_corner, face));
    for (GLuint i = 0; i < 4; i++) {
        glVertexAttribBinding(i, 0);
        glEnableVertexAttribArray(i);
    }
}

bool mesa_open(struct mesa *mesa, struct error *error) {
    *mesa = (struct mesa){.picture = NULL};
    if (!gl_context_open(&mesa->context, error) ||
        !file_read("tests/bench/opengl/scene.glsl", &mesa->shaders, error)) {
        return false;
    }
    describe_corners();
    return bytes_append(&mesa->shaders, "", 1)
               ? make_targets() ||
                     error_set(error, "Mesa cannot draw off the screen in this format")
               : error_out_of_memory(error);
}

/* With the context OpenGL frees all that it holds. */
void mesa_close(struct mesa *mesa) {
    gl_context_close(&mesa->context);
    bytes_free(&mesa->shaders);
}

/* ---- Loading ---- */

/* The program with that formula; 0, with a message, when it can't be made. */
static GLuint program_with(struct mesa *mesa, const char *formula) {
    const char *text = (const char *)mesa->shaders.data;
    char head[300];
    for (size_t i = 0; i < mesa->program_count; i++) {
        if (strcmp(mesa->formulas[i], formula) == 0) {
            return mesa->programs[i];
        }
    }
    assert(mesa->program_count < PROGRAM_LIMIT);
    snprintf(head, sizeof head, "#version 450 core\n#define FORMULA %s\n", formula);
    mesa->formulas[mesa->program_count] = formula;
    return mesa->programs[mesa->program_count++] =
               gl_make_program((const char *[]){head, "#define VERTEX\n", text},
                               (const char *[]){head, "", text}, 3, mesa->picture->error);
}

/* Upload a texture with its mip levels. */
static void upload_texture(GLuint name, const struct texture *texture) {
    glBindTexture(GL_TEXTURE_2D, name);
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
}

/* The name that OpenGL has for a texture, which is uploaded when it is new; 0 for NULL. */
static GLuint texture_name(struct mesa *mesa, const struct texture *texture) {
    for (size_t i = 0; i < mesa->texture_count; i++) {
        if (mesa->textures[i] == texture) {
            return mesa->names[i];
        }
    }
    if (texture == NULL) {
        return 0;
    }
    assert(mesa->texture_count < TEXTURE_LIMIT);
    GLuint *name = &mesa->names[mesa->texture_count];
    glGenTextures(1, name);
    upload_texture(*name, texture);
    mesa->textures[mesa->texture_count++] = texture;
    return *name;
}

bool mesa_load(struct mesa *mesa, struct picture *picture) {
    assert(picture->width <= SIDE_LIMIT && picture->height <= SIDE_LIMIT);
    glDeleteTextures((GLsizei)mesa->texture_count, mesa->names);
    mesa->texture_count = 0;
    mesa->picture = picture;
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(picture->corner_count * sizeof *picture->corners),
                 picture->corners, GL_STATIC_DRAW);
    for (size_t i = 0; i < picture->part_count; i++) {
        struct gl_part *part = &picture->parts[i];
        part->program = program_with(mesa, part->formula);
        if (part->program == 0) {
            return false;
        }
        for (int map = 0; map < MAPS; map++) {
            texture_name(mesa, part->maps[map]);
        }
    }
    return true;
}

/* ---- Drawing ---- */

/* All that the shaders read. */
static void set_uniforms(struct mesa *mesa, const struct gl_part *part,
                         const struct mat4 *to_clip) {
    glUseProgram(part->program);
    for (int i = 0; i < MAPS; i++) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, texture_name(mesa, part->maps[i]));
    }
    gl_set_matrix(part->program, "to_clip", to_clip);
    gl_set_vec3(part->program, "levels", part->levels);
    gl_set_vec3(part->program, "weights", part->weights);
    gl_set_vec3(part->program, "to_light", part->to_light);
    gl_set_vec3(part->program, "color", part->color);
    gl_set_vec3(part->program, "light_color", part->light_color);
    glUniform1i(glGetUniformLocation(part->program, "power"), part->power);
}

static void enable(GLenum what, bool on) {
    (on ? glEnable : glDisable)(what);
}

static void draw_part(struct mesa *mesa, const struct gl_part *part, bool snapped) {
    const struct rectangle *r = &part->viewport;
    const struct mat4 identity = mat4_identity();
    const GLint side = SNAPPED_VIEWPORT;
    const GLint left = (GLint)mesa->picture->width / 2 - side / 2;
    const GLint below = (GLint)mesa->picture->height / 2 - side / 2;
    set_uniforms(mesa, part, snapped ? &identity : &part->to_clip);
    glScissor(r->x, r->y, r->width, r->height);
    if (snapped) {
        glVertexAttribFormat(0, 4, GL_FLOAT, GL_FALSE, offsetof(struct gl_corner, snapped));
        glViewport(left, below, side, side);
    } else {
        glVertexAttribFormat(0, 4, GL_FLOAT, GL_FALSE, offsetof(struct gl_corner, plain));
        glViewport(r->x, r->y, r->width, r->height);
    }
    enable(GL_CULL_FACE, part->cull != CULL_NONE);
    glCullFace(part->cull == CULL_FRONT ? GL_FRONT : GL_BACK);
    glDrawArrays(GL_TRIANGLES, (GLint)part->first, (GLsizei)part->count);
}

/* Clear and draw. `outputs` says where the three outputs of the fragment shader go. */
static void draw(struct mesa *mesa, bool snapped, bool hidden, const GLenum outputs[3]) {
    const struct picture *picture = mesa->picture;
    static const GLuint no_color[4] = {0, 0, 0, 0};
    static const GLfloat zero[4] = {0, 0, 0, 0};
    glDrawBuffers(3, outputs);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, (GLsizei)picture->width, (GLsizei)picture->height);
    glClearBufferuiv(GL_COLOR, 0, no_color);
    glClearBufferfv(GL_COLOR, 1, zero);
    glClearBufferfv(GL_COLOR, 2, zero);
    glClearBufferfv(GL_DEPTH, 0, zero);
    gl_use_conventions();
    glEnablei(GL_BLEND, 2); /* the layers are added up */
    glBlendFunc(GL_ONE, GL_ONE);
    for (size_t i = 0; i < picture->part_count; i++) {
        enable(GL_DEPTH_TEST, !hidden && !picture->parts[i].no_depth_test);
        draw_part(mesa, &picture->parts[i], snapped);
    }
    glFinish();
}

void mesa_draw(struct mesa *mesa, bool snapped) {
    draw(mesa, snapped, false, (const GLenum[]){GL_COLOR_ATTACHMENT0, GL_NONE, GL_NONE});
}

/* ---- Reading back ---- */

static void read_target(const struct mesa *mesa, GLenum target, GLenum format, GLenum type,
                        void *to) {
    glReadBuffer(target);
    glReadPixels(0, 0, (GLsizei)mesa->picture->width, (GLsizei)mesa->picture->height, format, type,
                 to);
}

void mesa_read_depths(const struct mesa *mesa, struct seen *seen) {
    read_target(mesa, GL_COLOR_ATTACHMENT0, GL_DEPTH_COMPONENT, GL_FLOAT, seen->faces);
    for (size_t i = 0; i < mesa->picture->width * mesa->picture->height; i++) {
        seen->depths[i] = (double)seen->faces[i];
    }
}

bool mesa_draw_all(struct mesa *mesa, bool snapped, struct seen *seen) {
    draw(mesa, snapped, false,
         (const GLenum[]){GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_NONE});
    mesa_read_depths(mesa, seen);
    read_target(mesa, GL_COLOR_ATTACHMENT0, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, seen->pixels);
    read_target(mesa, GL_COLOR_ATTACHMENT1, GL_RED, GL_FLOAT, seen->faces);
    draw(mesa, snapped, true, (const GLenum[]){GL_NONE, GL_NONE, GL_COLOR_ATTACHMENT2});
    read_target(mesa, GL_COLOR_ATTACHMENT2, GL_RG, GL_FLOAT, seen->layers);
    GLenum problem = glGetError();
    return problem == GL_NO_ERROR ||
           error_set(mesa->picture->error, "OpenGL reports error 0x%x", (unsigned)problem);
}
