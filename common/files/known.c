/* Kinds of files, known by how they begin; see known.h. */
#include "files/known.h"

#include <stdint.h>
#include <string.h>

#define CONVERT  "`magick FILE NEW.png` converts it"
#define EXPORT   "Blender, for one, exports it as OBJ"
#define DOWNLOAD "download the file itself"

/* Letters of the beginning count in either case. */
static const struct known_file {
    const char *begins;
    size_t at; /* byte */
    const char *what, *advice;
} known_files[] = {
    {"version https://git-lfs", 0, "a Git LFS pointer", "`git lfs pull` fetches the file itself"},
    {"<!doctype html", 0, "an HTML page", DOWNLOAD},
    {"<html", 0, "an HTML page", DOWNLOAD},
    {"\x1F\x8B", 0, "a gzip archive", "`gzip -d FILE.gz` unpacks it"},
    {"PK\3\4", 0, "a ZIP archive", "`unzip FILE` unpacks it"},
    /* Models. */
    {"ply\n", 0, "a PLY file", EXPORT},
    {"ply\r", 0, "a PLY file", EXPORT},
    {"solid", 0, "an STL file", EXPORT},
    {"glTF", 0, "a glTF file", EXPORT},
    {"{", 0, "JSON, perhaps a glTF file", EXPORT},
    {"Kaydara FBX", 0, "an FBX file", EXPORT},
    {"; FBX", 0, "an FBX file", EXPORT},
    {"BLENDER", 0, "a Blender file", EXPORT},
    {"#VRML", 0, "a VRML file", EXPORT},
    {"<?xml", 0, "XML, perhaps COLLADA or X3D", EXPORT},
    {"<COLLADA", 0, "a COLLADA file", EXPORT},
    /* Pictures. */
    {"\xFF\xD8\xFF", 0, "a JPEG file", CONVERT},
    {"WEBP", 8, "a WebP file", CONVERT},
    {"GIF8", 0, "a GIF file", CONVERT},
    {"BM", 0, "a BMP file", CONVERT},
    {"DDS ", 0, "a DDS file", CONVERT},
    {"8BPS", 0, "a Photoshop file", CONVERT},
    {"II*", 0, "a TIFF file", CONVERT},
    {"\x76\x2F\x31\x01", 0, "an OpenEXR file", CONVERT},
    {"#?RADIANCE", 0, "a Radiance HDR file", CONVERT},
};

static int to_small(int c) {
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
}

static bool begins_as(const struct known_file *known, const uint8_t *data, size_t size) {
    size_t length = strlen(known->begins), same = 0;
    while (same < length && known->at + same < size &&
           to_small(data[known->at + same]) == to_small((uint8_t)known->begins[same])) {
        same++;
    }
    return same == length;
}

/* 80 bytes of anything, the number of triangles, 50 bytes for each of them. */
static bool is_binary_stl(const uint8_t *data, size_t size) {
    if (size < 84) {
        return false;
    }
    uint64_t count =
        data[80] | (uint64_t)data[81] << 8 | (uint64_t)data[82] << 16 | (uint64_t)data[83] << 24;
    return 84 + 50 * count == size;
}

bool error_known_file(struct error *error, const void *data, size_t size, const char *wanted) {
    for (size_t i = 0; i < sizeof known_files / sizeof known_files[0]; i++) {
        const struct known_file *known = &known_files[i];
        if (begins_as(known, data, size)) {
            error_set(error, "%s, not %s: %s", known->what, wanted, known->advice);
            return true;
        }
    }
    if (is_binary_stl(data, size)) {
        error_set(error, "a binary STL file, not %s: " EXPORT, wanted);
        return true;
    }
    return false;
}
