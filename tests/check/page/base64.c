/* Bytes as text: see base64.h. */
#include "base64.h"

#include <string.h>

/* One to three bytes become four characters. */
static void encode_group(const unsigned char *data, size_t size, char text[4]) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned bits = (unsigned)data[0] << 16;
    bits |= size > 1 ? (unsigned)data[1] << 8 : 0;
    bits |= size > 2 ? (unsigned)data[2] : 0;
    for (int i = 0; i < 4; i++) {
        text[i] = digits[bits >> (18 - 6 * i) & 63];
    }
    memset(text + 1 + size, '=', 3 - size);
}

bool base64_encode(struct bytes *out, const void *data, size_t size) {
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i += 3) {
        char text[4];
        encode_group(bytes + i, size - i < 3 ? size - i : 3, text);
        if (!bytes_append(out, text, sizeof text)) {
            return false;
        }
    }
    return true;
}
