/* The pairs as a table: see listing.h. */
#include "listing.h"

#include <string.h>

/* A field in quotes. A spreadsheet takes one that begins with these signs for a formula (OWASP,
 * "CSV injection"): an apostrophe before it says that it is text. */
static bool put_field(struct bytes *table, const char *text) {
    bool formula = text[0] != '\0' && strchr("=+-@\t\r", text[0]) != NULL;
    bool done = bytes_print(table, "\"%s", formula ? "'" : "");
    for (; *text != '\0' && done; text++) {
        done = bytes_append(table, text, 1) && (*text != '"' || bytes_append(table, text, 1));
    }
    return done && bytes_append(table, "\",", 2);
}

static double share_of(uint32_t shared, uint32_t all) {
    return all > 0 ? (double)shared / all : 0;
}

static bool put_lesson(struct bytes *table, const struct class *class, const struct pair *pair,
                       size_t lesson) {
    struct common common = pairs_compare(class, lesson, pair->a, pair->b);
    return common.shared == 0 ||
           (put_field(table, class->submissions[pair->a].name) &&
            put_field(table, class->submissions[pair->b].name) &&
            bytes_print(table, "%s,%u,%.3f,%.3f\r\n", class->lessons.all[lesson], common.shared,
                        share_of(common.shared, common.of_a),
                        share_of(common.shared, common.of_b)));
}

bool listing_csv(struct bytes *table, const struct class *class, const struct pairs *pairs) {
    bool done = bytes_print(table, "submission a,submission b,lesson,shared fingerprints,"
                                   "share of a,share of b\r\n");
    for (size_t i = 0; i < pairs->count; i++) {
        for (size_t lesson = 0; lesson < class->lessons.count && done; lesson++) {
            done = put_lesson(table, class, &pairs->all[i], lesson);
        }
    }
    return done;
}
