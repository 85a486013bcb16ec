/* Kinds of files, known by how they begin; see known.h. */
#include "files/known.h"

#include "base/text.h"
#include "files/find.h"
#include "files/image_file.h"

enum kind { MODEL, PICTURE, PAGE, POINTER, GZIP, ZIP, DAMAGED };

static const char *const advices[] = {
    [MODEL] = "Blender, for one, exports it as OBJ",
    [PAGE] = "download the file itself",
    [DAMAGED] = "fetch it again, as bytes and not as text",
    [POINTER] = "`git lfs pull` fetches the file itself",
    [GZIP] = "`gzip -d FILE.gz` unpacks it",
    [ZIP] = "`unzip FILE` unpacks it",
};

/* Letters of the beginning count in either case. Of several that fit, the first one counts. */
static const struct known_file {
    const char *begins;
    size_t at; /* byte, behind blanks */
    const char *what;
    enum kind kind;
} known_files[] = {
    {"version https://git-lfs", 0, "a Git LFS pointer", POINTER},
    {"<!doctype html", 0, "an HTML page", PAGE},
    {"<html", 0, "an HTML page", PAGE},
    {"404: Not Found", 0, "what a server says of a missing file", PAGE},
    {"\x1F\x8B", 0, "a gzip archive", GZIP},
    {"PK\3\4", 0, "a ZIP archive", ZIP},
    {"ply\n", 0, "a PLY file", MODEL},
    {"ply\r", 0, "a PLY file", MODEL},
    {"solid", 0, "an STL file", MODEL},
    {"\n800\nOBJ", 1, "an OBJ file of X-Plane, which is another format", MODEL},
    {"\r\n800\r\nOBJ", 1, "an OBJ file of X-Plane, which is another format", MODEL},
    {"glTF", 0, "a glTF file", MODEL},
    {"{", 0, "JSON, perhaps a glTF file", MODEL},
    {"Kaydara FBX", 0, "an FBX file", MODEL},
    {"; FBX", 0, "an FBX file", MODEL},
    {"BLENDER", 0, "a Blender file", MODEL},
    {"#VRML", 0, "a VRML file", MODEL},
    {"<?xml", 0, "XML, perhaps COLLADA or X3D", MODEL},
    {"<COLLADA", 0, "a COLLADA file", MODEL},
    {"<", 0, "a page of HTML or XML", PAGE},
    {"\x89PNG\r\n\x1A\n", 0, "a PNG file", PICTURE},
    {"\x89PNG", 0, "a PNG file damaged by a transfer as text", DAMAGED},
    {"\xEF\xBF\xBDPNG", 0, "a PNG file damaged by a transfer as text", DAMAGED},
    {"PNG\r\n", 0, "a PNG file damaged by a transfer as text", DAMAGED},
    {"\xFF\xD8\xFF", 0, "a JPEG file", PICTURE},
    {"P1", 0, "a bitmap of Netpbm", PICTURE},
    {"P4", 0, "a bitmap of Netpbm", PICTURE},
    {"P7", 0, "a PAM file", PICTURE},
    {"PF", 0, "a PFM file", PICTURE},
    {"WEBP", 8, "a WebP file", PICTURE},
    {"GIF8", 0, "a GIF file", PICTURE},
    {"BM", 0, "a BMP file", PICTURE},
    {"DDS ", 0, "a DDS file", PICTURE},
    {"8BPS", 0, "a Photoshop file", PICTURE},
    {"II*", 0, "a TIFF file", PICTURE},
    {"\x76\x2F\x31\x01", 0, "an OpenEXR file", PICTURE},
    {"#?RADIANCE", 0, "a Radiance HDR file", PICTURE},
};

/* What converts a picture and, unless its name tells of another kind, all of its kind next to it:
 * find_named() takes them then. */
static void advise_to_convert(struct error *error, const char *what, const char *path) {
    const struct word ending = name_ending(word_of(path));
    const bool all = ending.length > 0 && !image_file_is_readable(ending);
    const char *slash = strrchr(path, '/'), *quote = strchr(path, ' ') == NULL ? "" : "'";
    const int before = all ? slash == NULL ? 0 : (int)(slash + 1 - path) : (int)strlen(path);
    error_set(error,
              "%s, not a PNG, TGA or PPM file: `mogrify -format png %s%.*s%s%s%s` makes PNG files, "
              "which are drawn then",
              what, quote, before, path, quote, all ? "*." : "", all ? ending.start : "");
}

/* Without advice for a model where a picture was wanted, or the other way round. */
static void write_message(struct error *error, const char *what, enum kind kind, const char *path,
                          bool model_wanted) {
    const char *wanted = model_wanted ? "an OBJ or OFF file" : "a PNG, TGA or PPM file";
    bool helps = kind != (model_wanted ? PICTURE : MODEL);
    if (kind == PICTURE && !model_wanted) {
        advise_to_convert(error, what, path);
    } else {
        error_set(error, "%s, not %s%s%s", what, wanted, helps ? ": " : "",
                  helps ? advices[kind] : "");
    }
}

bool known_recognize(const void *data, size_t size, const char *path, bool model_wanted,
                     struct error *error) {
    const uint8_t *start = data;
    size_t blanks = size >= 3 && memcmp(start, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    while (blanks < size && strchr(" \t\r\n", start[blanks]) != NULL && start[blanks] != '\0') {
        blanks++;
    }
    for (size_t i = 0; i < sizeof known_files / sizeof known_files[0]; i++) {
        const struct known_file *known = &known_files[i];
        size_t at = blanks + known->at;
        if (at < size &&
            word_begins((struct word){(const char *)data + at, size - at}, known->begins)) {
            write_message(error, known->what, known->kind, path, model_wanted);
            return true;
        }
    }
    /* 80 bytes of anything, the number of triangles, 50 bytes for each of them */
    if (size >= 84 && 84 + 50 * (uint64_t)load_u32(start + 80) == size) {
        write_message(error, "a binary STL file", MODEL, path, model_wanted);
        return true;
    }
    return false;
}
