#!/bin/sh
# A path becomes a word of the shell and a string of C. Is one that would be read otherwise there
# refused by name, before anything is built, and one with a blank or a dollar in it not? And does a
# program read and write there where the path looks like a format of printf()?
#
# Exit status 0: all of that is so; 1: something is not.

top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
unset MAKEFLAGS MFLAGS # of the make that runs this test
failed=0

# A lesson that prints the path that is compiled into it.
cat >"$work/main.c" <<'EOF'
#include <stdio.h>
int main(void) {
    puts(COURSE_BUILD);
}
EOF

for name in "it's" 'a "b"' 'a\b'; do
    mkdir "$work/$name" && cp "$top/Makefile" "$work/$name" || exit 1
    if make -s -C "$work/$name" help >"$work/log" 2>&1 || ! grep -q 'holds a quote' "$work/log"; then
        echo "paths: $name is not refused: $(cat "$work/log")"
        failed=1
    fi
done
for name in 'a b' 'a$b' 'é'; do
    mkdir "$work/$name" "$work/$name/step01_line" "$work/$name/common" || exit 1
    cp "$top/Makefile" "$work/$name" && cp "$work/main.c" "$work/$name/step01_line" || exit 1
    : >"$work/$name/step01_line/README.md"
    echo 'extern int nothing;' >"$work/$name/common/nothing.c"
    make -s -C "$work/$name" build/step01_line >"$work/log" 2>&1 || cat "$work/log"
    if [ "$("$work/$name/build/step01_line")" != "$work/$name/build" ]; then
        echo "paths: $name is not what the programs have"
        failed=1
    fi
done
# A lesson that draws a model, which is a triangle here.
name='100%s % n'
mkdir -p "$work/$name/step01_line" "$work/$name/build/models" && cd "$work/$name" || exit 1
cp -R "$top/Makefile" "$top/common" . && rm -r common/sculptor && : >step01_line/README.md || exit 1
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >build/models/bust.obj
cat >step01_line/main.c <<'EOF'
#include "program.h"

static bool draw(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    image_set(image, 0, 0, color_rgb(255, 0, 0));
    return drawing->model->face_count == 1;
}

int main(int argc, char **argv) {
    static const struct scene scenes[] = {{.name = "dot", .needs = NEEDS_MODEL, .draw = draw}};
    static const struct program program = {.name = "step01_line",
                                           .summary = "a dot",
                                           .defaults = {.width = 2, .height = 2},
                                           .scenes = scenes,
                                           .scene_count = 1};
    return program_main(&program, argc, argv);
}
EOF
make -s CFLAGS=-O0 MARCH= build/step01_line >"$work/log" 2>&1 || cat "$work/log"
said=$(build/step01_line 2>&1)
if [ "$said" != "$work/$name/build/out/step01_line/dot.tga" ] || [ ! -f "$said" ]; then
    echo "paths: in $name the program says: $said"
    failed=1
fi
exit $failed
