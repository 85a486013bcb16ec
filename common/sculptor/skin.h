/* The bust's three textures. */
#ifndef COMMON_SCULPTOR_SKIN_H
#define COMMON_SCULPTOR_SKIN_H

#include "base/error.h"
#include "sculptor/surface.h"
#include "tgaimage.h"

#include <stdbool.h>

struct skin {
    struct image diffuse;  /* colour, BGR */
    struct image normals;  /* object-space normals, red x, green y, blue z: (n + 1) * 127.5 */
    struct image specular; /* how brightly it shines, grey */
};

/* Paint textures of size x size texels. On an error `skin` is empty. */
bool skin_create(struct skin *skin, const struct surface *surface, size_t size,
                 struct error *error);
void skin_free(struct skin *skin);

#endif
