#!/bin/sh
# Does the check say what the exercises of MORE.md say that it says? Makes each change of these paragraphs,
# which are written as in alternatives.txt, has the lesson checked, and looks for the rows after `says`, with |
# between them, both in what the check says and, as `code`, on the lesson's page.
. "$(dirname "$0")/../../unit/script.sh"

mkdir -p "$work/step04_flat" "$work/step05_zbuffer" "$work/step06_texture" || exit 1
root_of() {
    cat <<END

accept root_with_$1_steps
says $2
-     struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(w1, w0), vec3_sub(w2, w0)));
+     struct vec3 cross = vec3_cross(vec3_sub(w1, w0), vec3_sub(w2, w0));
+     float square = (float)vec3_dot(cross, cross), root;
+     uint32_t bits;
+     memcpy(&bits, &square, sizeof bits);
+     bits = 0x5f3759df - bits / 2;
+     memcpy(&root, &bits, sizeof bits);
+     for (int i = 0; i < $1; i++) root = root * (1.5f - 0.5f * square * root * root);
+     struct vec3 normal = vec3_scale(cross, (double)root);
END
}
{
    root_of 0 'flat FAIL 4/6: 43.7 % of drawn pixels wrong'
    root_of 1 'flat PASS 6/6: 16.8 % differ (46,174 pixels)'
    root_of 2 'flat PASS 6/6: 0.6 % differ (1,670 pixels)'
} >"$work/step04_flat/alternatives.txt"
rounded_to() {
    cat <<END

accept depth_of_$1_bits
says $2
-             double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
+             double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
+             depth = ldexp(floor(ldexp(depth, $1 - 1)), 1 - $1);
END
}
{
    rounded_to 22 'PASS 24/24'
    rounded_to 21 'cards FAIL 0/1: 1,680 of 160,000 drawn pixels differ'
} >"$work/step05_zbuffer/alternatives.txt"
divided_every() {
    cat <<END

accept divided_every_$1_columns
says $2
-     struct vec3 over_w = vec3_interpolate(edges_weights(&plane->edges, x, y), c[0], c[1], c[2]);
-     *w = 1 / over_w.z;
-     return vec2_scale((struct vec2){over_w.x, over_w.y}, *w);
+     struct vec3 here = vec3_interpolate(edges_weights(&plane->edges, x, y), c[0], c[1], c[2]);
+     struct vec3 from = vec3_interpolate(edges_weights(&plane->edges, x - x % $1, y), c[0], c[1], c[2]);
+     struct vec3 to = vec3_interpolate(edges_weights(&plane->edges, x - x % $1 + $1, y), c[0], c[1], c[2]);
+     double part = (double)(x % $1) / $1, u = from.x / from.z, v = from.y / from.z;
+     *w = 1 / here.z;
+     return (struct vec2){u + (to.x / to.z - u) * part, v + (to.y / to.z - v) * part};
END
}
{
    divided_every 16 'room FAIL 2/3: 0.5 % of drawn pixels with another colour|mipmapped FAIL 3/3: 3.4 % of drawn pixels wrong'
    divided_every 8 'room FAIL 2/3: 0.12 % of drawn pixels with another colour|mipmapped FAIL 3/3: 0.5 % of drawn pixels wrong'
    divided_every 4 'room PASS 3/3: 0.03 % differ (75 pixels)|mipmapped PASS 3/3: 6.9 % differ (18,209 pixels)'
    cat <<'END'

accept logarithm_of_the_library
says mipmapped PASS 3/3: 16.2 % differ (43,020 pixels)
-     int exponent;
-     double fraction = frexp(square, &exponent); /* square = fraction * 2^exponent, 0.5..1 */
-     return texture_clamp(0.5 * ((exponent - 1) + (2 * fraction - 1)), last);
+     return texture_clamp(0.5 * log2(square), last);
END
} >"$work/step06_texture/alternatives.txt"
awk -v directory="$work" -f tests/upkeep/verify/replace.awk -f tests/upkeep/verify/parse.awk \
    "$work"/step*/alternatives.txt >"$work/table" || exit 1

# The course with what is built of it.
mkdir -p "$work/course/build/quick" && cp -Rp Makefile common tests step0[456]_* "$work/course" && (
    cd "$build" && for part in flags common sculptor models check quick/common quick/libcommon.a; do
        [ ! -e "$part" ] || cp -Rp "$part" "$work/course/build/$part" || exit 1
    done
) && cd "$work/course" || exit 1
while IFS="$(printf '\t')" read -r number lesson _ _ _ _ _ _ rows _; do
    { echo '#include <string.h>' && cat "$work/$number/main.c"; } >"$lesson/main.c" || exit 1
    make -s check STEP="$lesson" VERBOSE=1 >"$work/said" 2>&1
    said=$work/said
    echo "$rows" | tr '|' '\n' >"$work/rows"
    while read -r row; do
        says "$row"
        grep -qF "\`$row\`" "$top/$lesson/MORE.md" || wrong "$lesson/MORE.md doesn't say: $row"
    done <"$work/rows"
    cp "$top/$lesson/main.c" "$lesson/main.c"
done <"$work/table"
# And no row of these pages is left out.
grep -ohE '`([a-z_]+ )?(PASS|FAIL) [0-9]+/[0-9]+: [^`]*`' step0[456]_*/MORE.md | tr -d '`' | sort -u >"$work/quoted"
cut -f 9 "$work/table" | tr '|' '\n' | sort -u | comm -13 - "$work/quoted" >"$work/left"
[ ! -s "$work/left" ] || { said=$work/left && wrong "rows that no change here makes"; }
exit $failed
