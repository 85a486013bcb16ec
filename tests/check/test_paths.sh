#!/bin/sh
# A path becomes a word of the shell and a string of C. Is one that would be read otherwise there
# refused by name, before anything is built, and one with a blank or a dollar in it not? And does a
# program read and write there where the path looks like a format of printf()?
. "$(dirname "$0")/../unit/script.sh"

# A lesson that prints the path that is compiled into it.
cat >"$work/main.c" <<'EOF'
#include <stdio.h>
int main(void) {
    puts(COURSE_BUILD);
}
EOF

for name in "it's" 'a "b"' 'a\b'; do
    mkdir "$work/$name" && cp "$top/Makefile" "$work/$name" || exit 1
    said_by 1 make -s -C "$work/$name" help
    says 'holds a quote'
done
for name in 'a b' 'a$b' 'é'; do
    mkdir "$work/$name" "$work/$name/step01_line" "$work/$name/common" || exit 1
    cp "$top/Makefile" "$work/$name" && cp "$work/main.c" "$work/$name/step01_line" || exit 1
    : >"$work/$name/step01_line/README.md"
    echo 'extern int nothing;' >"$work/$name/common/nothing.c"
    said_by 0 make -s -C "$work/$name" build/step01_line
    [ "$("$work/$name/build/step01_line")" = "$work/$name/build" ] ||
        wrong "$name is not what the programs have"
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
said_by 0 make -s CFLAGS=-O0 MARCH= build/step01_line
said_by 0 build/step01_line
picture=$work/$name/build/out/step01_line/dot.tga
[ "$(cat "$said")" = "$picture" ] && [ -f "$picture" ] || wrong "in $name it draws elsewhere"
exit $failed
