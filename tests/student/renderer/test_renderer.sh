#!/bin/sh
# make renderer: one C file from ten main.c. From the solutions it compiles without a warning, draws what
# lesson 10 draws but for roundings, in all looks, and takes broken files; from others it is what they
# are, or says what is missing.
. "$(dirname "$0")/../../unit/script.sh"
said=$work/said
flags='-std=c17 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror'

mkdir "$work/course" && cp -R "$top/common" "$top/Makefile" "$top"/step*/ "$work/course" && mkdir "$work/course/tests" &&
    cp -R "$top/tests/student" "$work/course/tests" && cd "$work/course" || exit 1

# renderer STATUS: with `out` as the file.
renderer() {
    said_by "$1" sh tests/student/renderer/renderer.sh "$build" "$work/out.c" cc
}

# ---- The solutions ----

renderer 0
says 'are from your ten main.c.'
for cc in cc clang; do
    command -v $cc >/dev/null || continue
    # shellcheck disable=SC2086 # several words
    $cc $flags -O2 -c "$work/out.c" -o "$work/out.o" || wrong "$cc has something to say of it"
done
! grep -nE 'to do [0-9]|BEGIN SOLUTION|COURSE_|#include "' "$work/out.c" || wrong "something of the course is left"
lines=$(wc -l <"$work/out.c")
[ "$lines" -le 1700 ] || wrong "it has $lines lines, which is more than 1700"
hers=$(sed -n 's/.* lines \([0-9]*\) are from your ten main[.]c[.]$/\1/p' "$work/out.c")
[ $((3 * hers)) -ge "$lines" ] || wrong "of $lines lines only $hers are hers"
grep -q "^ [*] Of its $lines lines" "$work/out.c" || wrong "it doesn't have as many lines as it says"

# Lesson 10's frame, read by a program that has the renderer in it, which reads its own.
cat >"$work/compare.c" <<'END'
#define main renderer_main
#include "out.c"
#undef main
int main(int argc, char **argv) {
    size_t differ = 0, drawn = 0;
    struct texture_level image;
    int c, height = 0, most = 0, lines = 0;
    char head[200];
    FILE *file = argc > 1 ? fopen(argv[1], "rb") : NULL;
    if (file == NULL || !tga_read(&image, file) || scanf("%*[^\n]") != 0) return 2;
    getchar();
    if (fgets(head, sizeof head, stdin) == NULL) return 2;
    if (sscanf(head, "frame %*d %d %*f %d", &height, &lines) != 2) return 2;
    while (lines > 0) lines -= getchar() == '\n';
    for (size_t i = 0; i < 4 * image.width * image.height && (c = getchar()) != EOF; i++) {
        size_t x = i / 4 % image.width, y = image.height - 1 - i / 4 / image.width;
        int mine = image.texels[y * image.width + x] >> (i % 4 < 3 ? 16 - 8 * (i % 4) : 24) & 255;
        differ += mine != c;
        most = abs(mine - c) > most ? abs(mine - c) : most;
        drawn += c != 0 && i % 4 < 3;
    }
    printf("%zu of %zu by %d\n", differ, drawn, most);
    return differ > 30 || most > 1 || drawn < 100000;
}
END
cc -w -O1 "$work/compare.c" -o "$work/compare" -lm || exit 1
echo '--only turn' | "$build/step10_phong" --live >"$work/frame" && "$work/compare" "$work/turn_000.tga" <"$work/frame" ||
    wrong "it draws another head than lesson 10"

# All looks, near enough to be clipped; a model without textures; files that are none.
cc -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all "$work/out.c" -o "$work/checked" -lm || exit 1
mkdir "$work/drawn" && cd "$work/drawn" || exit 1
for look in phong toon gouraud flat depth wireframe; do
    "$work/checked" "$build/models/bust.obj" --look $look --size 90 --frames 2 --eye 0.3,0.2,0.6 || wrong "$look fails"
    cksum turn_001.tga >>sums
done
[ "$(sort -u sums | wc -l)" -eq 6 ] || wrong "two looks are the same picture"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\nf 9 9 9\nf 1/1/1 2 3\nvn nan 1 x\nf' >odd.obj
"$work/checked" odd.obj --size 20 --frames 1 || wrong "a model without textures"
: >empty.obj
head -c 700 "$build/models/bust_diffuse.tga" >short_diffuse.tga
cp odd.obj short.obj
"$work/checked" short.obj --size 20 --frames 1 || wrong "a texture that ends"
for bad in empty.obj missing.obj /; do
    "$work/checked" $bad --size 20 2>/dev/null
    [ $? -eq 1 ] || wrong "$bad is no error"
done
"$work/checked" odd.obj --look other 2>/dev/null
[ $? -eq 2 ] || wrong "a look that isn't there"
cd "$work/course" || exit 1

# ---- A student's ----

# Without marks, helpers of the same name in two lessons, one of them after a string with a bracket.
for lesson in step*/; do
    awk -v mode=solution -f tests/student/marks.awk "${lesson}main.c" >"$work/main.c" && cp "$work/main.c" "${lesson}main.c" ||
        exit 1
done
renderer 0
cp "$work/out.c" "$work/before.c"
sed -i.old 's|^static double face_intensity(|/* Hers. */\nstatic double helper(double a) { const char *c = "{("; return c[0] == 0x7b ? a : 0; }\n\n&|; s|return vec3_dot(normal, to_light);|return helper(vec3_dot(normal, to_light));|' step04_flat/main.c
sed -i.old 's|^static double corner_intensity(|static double helper(double a) { return a > 0 ? a : 0; }\n\nstatic double cosine(void) { return 0; }\n\n&|; s|return cosine > 0 ? cosine : 0;|return helper(cosine);|' step07_gouraud/main.c
renderer 0
grep -q 'helper_7(cosine)' "$work/out.c" || wrong "two helpers of one name"
! grep -q 'cosine(void)' "$work/out.c" || wrong "a function comes along for a variable of its name"
grep -q 'return helper(vec3_dot' "$work/out.c" || wrong "the first helper has lost its name"

# What is to do is said, or is ours where we have it.
awk -v mode=starter -f "$top/tests/student/marks.awk" "$top/step06_texture/main.c" >"$work/main.c" &&
    cp "$work/main.c" step06_texture/main.c || exit 1
renderer 0
grep -q 'ours: sample_bilinear() of lesson 6' "$said" || wrong "it doesn't say what is ours"
awk -v mode=starter -f "$top/tests/student/marks.awk" "$top/step04_flat/main.c" >"$work/main.c" &&
    cp "$work/main.c" step04_flat/main.c || exit 1
renderer 1
grep -q '^make renderer: step04_flat/main.c: task 4.3 is to do, in face_intensity()' "$said" || wrong "it doesn't say what is to do"
sed -i.old 's/^static struct mat4 lookat(.*) {$/& {/' step08_projection/main.c
renderer 1
grep -q '^make renderer: step08_projection/main.c:[0-9]*: cannot be read' "$said" || wrong "it doesn't say where a bracket is missing"
exit $failed
