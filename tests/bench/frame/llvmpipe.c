/* llvmpipe's side: see llvmpipe.h. */
#define _POSIX_C_SOURCE 200809L /* setenv */
#include "llvmpipe.h"

#include "bench/memory.h"
#include "vertices.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <stdio.h>
#include <stdlib.h>

/* ---- OpenGL without a window, whatever graphics hardware there is: EGL, surfaceless ---- */

struct gl_context {
    EGLDisplay display;
    EGLContext context;
    char name[256]; /* "llvmpipe (...), version" */
};

static void choose_llvmpipe(void) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    /* Otherwise the four pixels of a square share one mip level, even for texelFetch(); and a cache
     * might hold shaders that were compiled so. */
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

static bool gl_context_open(struct gl_context *c, struct error *error) {
    static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        5,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    choose_llvmpipe();
    *c = (struct gl_context){
        .display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL),
        .context = EGL_NO_CONTEXT,
    };
    if (c->display == EGL_NO_DISPLAY || !eglInitialize(c->display, NULL, NULL)) {
        return error_set(error,
                         "EGL has no display without a window (Mesa's surfaceless platform)");
    }
    if (eglBindAPI(EGL_OPENGL_API)) {
        c->context = eglCreateContext(c->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    }
    if (c->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, c->context)) {
        return error_set(error, "EGL cannot make a context of OpenGL 4.5");
    }
    snprintf(c->name, sizeof c->name, "%s, OpenGL %s", (const char *)glGetString(GL_RENDERER),
             (const char *)glGetString(GL_VERSION));
    return true;
}

static void gl_context_close(struct gl_context *c) {
    if (c->context != EGL_NO_CONTEXT) {
        eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(c->display, c->context);
    }
    if (c->display != EGL_NO_DISPLAY) {
        eglTerminate(c->display);
    }
    *c = (struct gl_context){.display = EGL_NO_DISPLAY, .context = EGL_NO_CONTEXT};
}

/* ---- Shaders ---- */

#define TEXT_OF_VALUE(value) #value
#define TEXT_OF(macro)       TEXT_OF_VALUE(macro)

static const char *const head = "#version 450 core\n"
                                "#define AMBIENT " TEXT_OF(AMBIENT) "\n";

/* 0, with a message, for a shader that does not compile. */
static GLuint compile(GLenum kind, const char *text, struct error *error) {
    const char *const parts[] = {head, text};
    GLuint shader = glCreateShader(kind);
    GLint compiled = GL_FALSE;
    glShaderSource(shader, 2, parts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        char log[512];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        error_set(error, "a shader does not compile: %s", log);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

/* Compile and link two shaders. 0, with a message, where that fails. */
static GLuint gl_make_program(const char *vertex_text, const char *fragment_text,
                              struct error *error) {
    GLuint vertex = compile(GL_VERTEX_SHADER, vertex_text, error);
    GLuint fragment = vertex != 0 ? compile(GL_FRAGMENT_SHADER, fragment_text, error) : 0;
    GLuint program = glCreateProgram();
    GLint linked = GL_FALSE;
    if (fragment != 0) {
        char log[512];
        glAttachShader(program, vertex);
        glAttachShader(program, fragment);
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        error_set(error, "shaders cannot be linked: %s", log);
    }
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return linked != GL_FALSE ? program : 0;
}

/* ---- Conventions ---- */

/* With matrices of gl_set_matrix(), pixels on an edge go to the triangle that the top-left rule
 * names; front faces and depth are those of the course. */
static void gl_use_conventions(void) {
    /* Mesa gives a pixel centre on a horizontal edge to the triangle above it when the origin is
     * below, and to the one below it, as the top-left rule has it, when the origin is above. So the
     * origin is above and gl_set_matrix() mirrors y: twice mirrored, the picture stays upright. */
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glFrontFace(GL_CW);
    glDepthFunc(GL_GREATER);
}

/* In perspective the course's z/w grows with 1/w, so 1/w may replace it: NEAR_W / w is 0..1 and
 * keeps a float's precision at all distances. Here NEAR_W is where the course cuts. */
#define NEAR_W (1.0 / 128)

static struct mat4 perspective_clip(struct mat4 to_clip) {
    for (int column = 0; column < 4; column++) {
        to_clip.m[2][column] = column == 3 ? NEAR_W : 0;
    }
    return to_clip;
}

static void gl_set_vec3(GLuint program, const char *name, struct vec3 v) {
    glUniform3f(glGetUniformLocation(program, name), (float)v.x, (float)v.y, (float)v.z);
}

/* With y mirrored: see gl_use_conventions(). */
static void gl_set_matrix(GLuint program, const char *name, const struct mat4 *matrix) {
    float elements[16];
    for (int i = 0; i < 16; i++) {
        float element = (float)matrix->m[i / 4][i % 4];
        elements[i] = i / 4 == 1 ? -element : element;
    }
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_TRUE, elements);
}

/* ---- Shaders: the formulas of scene.h, each in the form that llvmpipe draws fastest ---- */

static const char *const vertex_shaders[FRAME_LOOKS] = {
    [FRAME_FLAT] = "layout(location = 0) in vec3 position;\n"
                   "layout(location = 1) in vec3 normal;\n"
                   "uniform mat4 to_clip;\n"
                   "uniform vec3 to_light;\n"
                   "flat out float light;\n"
                   "void main() {\n"
                   "    gl_Position = to_clip * vec4(position, 1);\n"
                   "    light = max(dot(normal, to_light), 0.0);\n"
                   "}\n",
    [FRAME_GOURAUD] = "layout(location = 0) in vec3 position;\n"
                      "layout(location = 1) in vec3 normal;\n"
                      "layout(location = 2) in vec2 uv_in;\n"
                      "uniform mat4 to_clip;\n"
                      "uniform vec3 to_light;\n"
                      "out float light;\n"
                      "out vec2 uv;\n"
                      "void main() {\n"
                      "    gl_Position = to_clip * vec4(position, 1);\n"
                      "    light = max(dot(normal, to_light), 0.0);\n"
                      "    uv = uv_in;\n"
                      "}\n",
    [FRAME_PHONG] = "layout(location = 0) in vec3 position_in;\n"
                    "layout(location = 2) in vec2 uv_in;\n"
                    "uniform mat4 to_clip;\n"
                    "out vec3 position;\n"
                    "out vec2 uv;\n"
                    "void main() {\n"
                    "    gl_Position = to_clip * vec4(position_in, 1);\n"
                    "    position = position_in;\n"
                    "    uv = uv_in;\n"
                    "}\n",
};

static const char *const fragment_shaders[FRAME_LOOKS] = {
    [FRAME_FLAT] = "flat in float light;\n"
                   "out vec4 color;\n"
                   "void main() {\n"
                   "    color = vec4(vec3(light), 1);\n"
                   "}\n",
    [FRAME_GOURAUD] = "in float light;\n"
                      "in vec2 uv;\n"
                      "uniform sampler2D diffuse_map;\n"
                      "out vec4 color;\n"
                      "void main() {\n"
                      "    color = vec4(texture(diffuse_map, uv).rgb * light, 1);\n"
                      "}\n",
    [FRAME_PHONG] =
        "in vec3 position;\n"
        "in vec2 uv;\n"
        "uniform sampler2D diffuse_map, normal_map, specular_map;\n"
        "uniform vec3 to_light, eye;\n"
        "out vec4 color;\n"
        "void main() {\n"
        "    vec3 normal = normalize(texture(normal_map, uv).rgb * 2.0 - 1.0);\n"
        "    float light = max(dot(normal, to_light), 0.0);\n"
        "    vec3 mirrored = 2.0 * light * normal - to_light;\n"
        "    float near = max(dot(mirrored, normalize(eye - position)), 0.0);\n"
        "    float square = near * near, fourth = square * square;\n"
        "    float shine = light > 0.0 ? fourth * fourth * square : 0.0;\n"
        "    shine *= texture(specular_map, uv).r;\n"
        "    color = vec4(texture(diffuse_map, uv).rgb * (AMBIENT + light) + shine, 1);\n"
        "}\n",
};

static const char *const sampler_names[MODEL_TEXTURE_KINDS] = {
    [MODEL_DIFFUSE] = "diffuse_map",
    [MODEL_NORMAL_MAP] = "normal_map",
    [MODEL_SPECULAR] = "specular_map",
};

/* ---- The renderer ---- */

struct llvmpipe {
    struct gl_context context;
    GLuint programs[FRAME_LOOKS];
    /* The scene that is loaded. */
    GLuint color, depth, frame; /* texture, renderbuffer, framebuffer */
    GLuint textures[MODEL_TEXTURE_KINDS];
    GLuint vertex_array, buffers[2]; /* vertices, indices */
    GLsizei index_count, width, height;
};

static void close_llvmpipe(struct llvmpipe *l) {
    gl_context_close(&l->context); /* and everything that it holds */
    free(l);
}

static struct llvmpipe *open_llvmpipe(int threads, struct error *error) {
    char number[16];
    struct llvmpipe *l = bench_memory(1, sizeof *l);
    snprintf(number, sizeof number, "%d", threads > 1 ? threads : 0); /* 0: the one that calls */
    setenv("LP_NUM_THREADS", number, 1);
    bool done = gl_context_open(&l->context, error);
    for (int look = 0; done && look < FRAME_LOOKS; look++) {
        l->programs[look] = gl_make_program(vertex_shaders[look], fragment_shaders[look], error);
        done = l->programs[look] != 0;
    }
    if (!done) {
        close_llvmpipe(l);
        return NULL;
    }
    return l;
}

static const char *name_llvmpipe(const struct llvmpipe *l) {
    return l->context.name;
}

/* ---- Loading ---- */

static void unload(struct llvmpipe *l) {
    glDeleteFramebuffers(1, &l->frame);
    glDeleteTextures(1, &l->color);
    glDeleteRenderbuffers(1, &l->depth);
    glDeleteTextures(MODEL_TEXTURE_KINDS, l->textures);
    glDeleteVertexArrays(1, &l->vertex_array);
    glDeleteBuffers(2, l->buffers);
}

/* Colour as the course has it, blue first; depth in as many bits as a float. */
static bool make_frame(struct llvmpipe *l, const struct frame_scene *scene, struct error *error) {
    l->width = (GLsizei)scene->width;
    l->height = (GLsizei)scene->height;
    glGenTextures(1, &l->color);
    glBindTexture(GL_TEXTURE_2D, l->color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, l->width, l->height, 0, GL_BGRA,
                 GL_UNSIGNED_INT_8_8_8_8_REV, NULL);
    glGenRenderbuffers(1, &l->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, l->depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, l->width, l->height);
    glGenFramebuffers(1, &l->frame);
    glBindFramebuffer(GL_FRAMEBUFFER, l->frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, l->color, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, l->depth);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE ||
           error_set(error, "Mesa cannot draw off the screen in this format");
}

static void load_texture(struct llvmpipe *l, GLuint program, enum model_texture_kind kind,
                         struct frame_texture from) {
    glActiveTexture(GL_TEXTURE0 + (GLenum)kind);
    glGenTextures(1, &l->textures[kind]);
    glBindTexture(GL_TEXTURE_2D, l->textures[kind]);
    if (from.texture != NULL) {
        const struct texture_level *level = &from.texture->level[from.level];
        glPixelStorei(GL_UNPACK_ROW_LENGTH, (GLint)level->pitch);
        glTexImage2D(GL_TEXTURE_2D, 0, kind == MODEL_SPECULAR ? GL_R8 : GL_RGBA8,
                     (GLsizei)level->width, (GLsizei)level->height, 0, GL_BGRA,
                     GL_UNSIGNED_INT_8_8_8_8_REV, level->texels);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glUniform1i(glGetUniformLocation(program, sampler_names[kind]), (GLint)kind);
}

static void describe_attribute(GLuint index, GLint floats, size_t offset) {
    glVertexAttribFormat(index, floats, GL_FLOAT, GL_FALSE, (GLuint)offset);
    glVertexAttribBinding(index, 0);
    glEnableVertexAttribArray(index);
}

static void load_mesh(struct llvmpipe *l, const struct frame_scene *scene) {
    struct vertices v = {0};
    (scene->look == FRAME_FLAT ? vertices_flat : vertices_smooth)(&v, scene->head);
    glGenVertexArrays(1, &l->vertex_array);
    glBindVertexArray(l->vertex_array);
    glGenBuffers(2, l->buffers);
    glBindBuffer(GL_ARRAY_BUFFER, l->buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(v.vertex_count * sizeof *v.vertices), v.vertices,
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, l->buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(v.index_count * sizeof *v.indices),
                 v.indices, GL_STATIC_DRAW);
    l->index_count = (GLsizei)v.index_count;
    glBindVertexBuffer(0, l->buffers[0], 0, sizeof(struct vertex));
    describe_attribute(0, 3, offsetof(struct vertex, position));
    if (scene->look != FRAME_PHONG) {
        describe_attribute(1, 3, offsetof(struct vertex, normal));
    }
    if (scene->look != FRAME_FLAT) {
        describe_attribute(2, 2, offsetof(struct vertex, uv));
    }
    vertices_free(&v);
}

/* All that stays the same from frame to frame. */
static void set_state(const struct llvmpipe *l, const struct frame_scene *scene) {
    const struct rectangle *r = &scene->call.viewport;
    const struct mat4 to_clip = perspective_clip(scene->call.to_clip);
    GLuint program = l->programs[scene->look];
    gl_use_conventions();
    gl_set_matrix(program, "to_clip", &to_clip);
    gl_set_vec3(program, "to_light", scene->to_light);
    gl_set_vec3(program, "eye", scene->eye);
    glViewport(r->x, r->y, r->width, r->height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    glClearColor(0, 0, 0, 0);
    glClearDepth(0);
}

static bool load(struct llvmpipe *l, const struct frame_scene *scene, struct error *error) {
    GLuint program = l->programs[scene->look];
    unload(l);
    glUseProgram(program);
    if (!make_frame(l, scene, error)) {
        return false;
    }
    load_mesh(l, scene);
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        load_texture(l, program, (enum model_texture_kind)kind, scene->textures[kind]);
    }
    set_state(l, scene);
    GLenum problem = glGetError();
    return problem == GL_NO_ERROR || error_set(error, "OpenGL reports error 0x%x", problem);
}

/* ---- Frames ---- */

static void draw(struct llvmpipe *l) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, l->index_count, GL_UNSIGNED_INT, NULL);
    glFinish();
}

static bool read_pixels(struct llvmpipe *l, uint8_t *pixels, struct error *error) {
    glReadPixels(0, 0, l->width, l->height, GL_BGRA, GL_UNSIGNED_BYTE, pixels);
    GLenum problem = glGetError();
    return problem == GL_NO_ERROR || error_set(error, "OpenGL reports error 0x%x", problem);
}

static const struct llvmpipe_functions functions = {
    .open = open_llvmpipe,
    .close = close_llvmpipe,
    .name = name_llvmpipe,
    .load = load,
    .draw = draw,
    .read = read_pixels,
};

const struct llvmpipe_functions *const llvmpipe = &functions;
