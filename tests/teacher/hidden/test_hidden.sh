#!/bin/sh
# Hidden scenes: does the solution pass them all, a program that prints stored pictures none, is a
# main.c never its own solution, and is nothing but the class of a scene told? Do they wait for a
# check that is at work, and judge what is in main.c now? In a copy of lessons 1 and 5.
. "$(dirname "$0")/../../unit/script.sh"
said=$work/said && : >"$said"

mkdir -p "$work/course/tests/reference" && cd "$work/course" || exit 1
cp -R "$top/Makefile" "$top/common" "$top/step01_line" "$top/step05_zbuffer" . || exit 1
(cd "$top/tests" && cp -R check student teacher lesson.h more_scenes.h "$work/course/tests" &&
    mkdir "$work/course/tests/lessons" && cp -R lessons/step01_line lessons/step05_zbuffer "$work/course/tests/lessons" &&
    cp -R reference/step01_line reference/step05_zbuffer "$work/course/tests/reference") || exit 1
grep -v '^call' "$top/tests/check/scenes.txt" | grep -e '^#' -e 'step01_' -e 'step05_' >tests/check/scenes.txt
mkdir build && cp -R "$build/models" "$build/hidden" build || exit 1
flags='CFLAGS=-O1 MARCH='

# built STEP...: the programs of what is in their main.c now.
built() {
    for lesson in "$@"; do
        # shellcheck disable=SC2086
        make -s "build/quick/$lesson" $flags >"$work/said" 2>&1 || wrong "$lesson does not build"
    done
}

# hidden STATUS SEED STEP [SOLUTION [POINTS]]: what it says is in $work/said.
hidden() {
    sh tests/teacher/hidden/hidden.sh build build/quick "make -s $flags" "$2" "$3" "$4" "$5" >"$work/said" 2>&1
    status=$?
    [ $status -eq "$1" ] || wrong "status $status, not $1: seed $2, step $3"
}

# says PATTERN: a whole line is so.
says() {
    grep -qx "$1" "$work/said" || wrong "nothing says: $1"
}

# ---- The solution ----

# make_mistake: into the main.c of lesson 5, which keeps its marks.
make_mistake() {
    cp step05_zbuffer/main.c right
    sed 's/if (depth > row\[x\])/if (depth < row[x])/' right >step05_zbuffer/main.c
    cmp -s right step05_zbuffer/main.c && wrong "no mistake is made"
}

built step01_line step05_zbuffer

# The copy is in no repository: no solution but what is judged.
hidden 2 1 5
says 'make check HIDDEN=1: nothing can be compared: step05_zbuffer/main.c is what is judged, .*'
hidden 2 1 5 .
says 'make check HIDDEN=1: nothing can be compared: ./step05_zbuffer/main.c is what is judged'

# A clone: main.c is what git has, or was.
if command -v git >/dev/null; then
    git init -q . && git add step*/main.c &&
        git -c user.name=test -c user.email=test commit -qm marked || wrong "git does not work here"
    hidden 0 1 5
    make_mistake
    hidden 1 1 5
    says '  hidden: zbuffer of a new model: wrong'
    mv right step05_zbuffer/main.c
    rm -rf .git
fi

# What make start keeps.
for lesson in step01_line step05_zbuffer; do
    cp $lesson/main.c $lesson/main.c.marked
done
hidden 0 1 ''
says 'step01_line  HIDDEN \([1-9][0-9]*\)/\1'
says 'step05_zbuffer  HIDDEN \([1-9][0-9]*\)/\1'
says 'HIDDEN \([1-9][0-9]*\)/\1'
[ "$(find build -name 'hidden.*' | wc -l)" -eq 0 ] || wrong "solutions are left behind"
make_mistake
hidden 1 1 5
says '  hidden: zbuffer of a new model: wrong'
mv right step05_zbuffer/main.c

# ---- Programs that are wrong ----

# A program that knows the references by heart, and nothing else: its functions are the starter's.
cp -R step01_line step05_zbuffer "$work"
for lesson in step01_line step05_zbuffer; do
    cat >$lesson/main.c <<EOF
$(awk -v mode=starter -f tests/student/marks.awk "$work/$lesson/main.c" |
    sed 's/to do [0-9]//; s/^int main(/static inline int given_main(/')
#include "files/image_file.h"
#include <stdio.h>
#include <string.h>

static void print(const char *directory, const char *scene, const char *name) {
    struct image image;
    struct error error;
    char path[4096];
    snprintf(path, sizeof path, "$PWD/tests/reference/$lesson/%s.png", scene);
    if (image_read(&image, path, &error)) {
        snprintf(path, sizeof path, "%s/%s.tga", directory, name);
        tga_write(&image, path, &error);
        image_free(&image);
    }
}

int main(int argc, char **argv) {
    static const char *const scenes[] = {
$(for picture in "tests/reference/$lesson"/*.png; do
    echo "        \"$(basename "$picture" .png)\","
done)
    };
    for (int i = 1; i + 1 < argc; i++) {
        for (size_t k = 0; strcmp(argv[i], "-o") == 0 && k < sizeof scenes / sizeof scenes[0]; k++) {
            print(argv[i + 1], scenes[k], scenes[k]);
            print(argv[i + 1], scenes[k], "scene");
        }
    }
    return 0;
}
EOF
done
built step01_line step05_zbuffer
cp step05_zbuffer/main.c "$work/stored.c"

hidden 1 1 '' "$work"
says 'HIDDEN 0/[1-9][0-9]*'
says '  hidden: lines: wrong'
says '  hidden: lines that no tie decides: wrong'
says '  hidden: depth of a new model: wrong'
says '  hidden: single in another size: wrong'
for lesson in step01_line step05_zbuffer; do
    says "$lesson  look at it: draws the reference where another picture is asked for: [1-9][0-9]*"
done
! grep -q "$work" "$work/said" || wrong "tells where the solution is"

# As a solution it has nothing to hold others against, even with marks.
mkdir -p stored/step05_zbuffer
{
    cat step05_zbuffer/main.c
    printf '%s\n' '/* BEGIN SOLUTION 5.1 nothing */' '/* END SOLUTION */'
} >stored/step05_zbuffer/main.c
hidden 2 1 5 stored
says 'hidden: step05_zbuffer: the solution draws nothing new: nothing can be compared'

# Right for the light and the size of the lesson's own scenes.
sed 's/if (depth > row\[x\])/if (depth > row[x] || image->width != 800)/' \
    "$work/step05_zbuffer/main.c" >step05_zbuffer/main.c
built step05_zbuffer
hidden 1 2 5 "$work"
says '  hidden: zbuffer of a model in another size: wrong'
! grep -q 'zbuffer of a model in another light' "$work/said" || wrong "what is right is called wrong"

# Two programs of lesson 10 that differ where faces are large: a correct one a little, a wrong one by
# much.
cp -R "$top/step10_phong" . && cp -R "$top/tests/reference/step10_phong" tests/reference || exit 1
grep -v '^call' "$top/tests/check/scenes.txt" | grep 'step10_' >>tests/check/scenes.txt
# take LIST NAME: the program with that in its name becomes the one of lesson 10.
take() {
    rm -rf other
    mkdir other && (cd "$top" && awk -v directory="$work/course/other" -v only="$2" \
        -f tests/upkeep/verify/replace.awk -f tests/upkeep/verify/parse.awk "$1") >"$work/said" &&
        cp other/1/main.c step10_phong || wrong "there is no program $2"
}
take tests/lessons/step10_phong/alternatives.txt normals_by_128
hidden 0 60 10 "$top"
says 'HIDDEN \([1-9][0-9]*\)/\1'
take step10_phong/mistakes.txt eye_normalized_at_the_corners_too
hidden 1 60 10 "$top"
says '  hidden: near of a new model: wrong'

# ---- What else is at work ----

# The program is there, but of another main.c.
cp "$work/step05_zbuffer/main.c" step05_zbuffer/main.c
hidden 0 2 5 "$work"

# A check has removed the program, and builds it only when it may.
cat >held <<'EOF'
#!/bin/sh
touch held.began
until [ -e held.go ]; do sleep 0.1; done
exec make "$@"
EOF
chmod +x held
"$build/check" --make "./held $flags" 5 >"$work/check.said" 2>&1 &
check=$!
until [ -e held.began ] || ! kill -0 $check 2>/dev/null; do sleep 0.1; done
: >"$work/said"
(failed=0 && hidden 0 2 5 "$work" && exit $failed) &
beside=$!
until grep -qs 'waiting' "$work/said" || ! kill -0 $beside 2>/dev/null; do sleep 0.1; done
says 'check: waiting for another check in build/quick'
touch held.go
wait $check || wrong "the check that was waited for fails: $(cat "$work/check.said")"
wait $beside || failed=1
says 'HIDDEN \([1-9][0-9]*\)/\1'

# And a check waits for hidden scenes.
rm held.began held.go
: >"$work/said"
sh tests/teacher/hidden/solutions.sh build/hidden.held "make -s $flags" "$work" step05_zbuffer >"$work/said" ||
    wrong "no solution"
build/hidden build/quick build/hidden.held 2 "./held $flags" step05_zbuffer >"$work/hidden.said" 2>&1 &
beside=$!
until [ -e held.began ] || ! kill -0 $beside 2>/dev/null; do sleep 0.1; done
"$build/check" --make "make $flags" 5 >"$work/said" 2>&1 &
check=$!
until grep -qs 'waiting' "$work/said" || ! kill -0 $check 2>/dev/null; do sleep 0.1; done
says 'check: waiting for another check in build/quick'
touch held.go
wait $check || wrong "a check that waited fails"
wait $beside || wrong "the hidden scenes that it waited for fail: $(cat "$work/hidden.said")"

# What the solution has drawn is kept for a class, which may be graded with another seed.
for seed in 2 3 2; do
    build/hidden build/quick build/hidden.held $seed '' step05_zbuffer >"$work/said" || wrong "seed $seed: others' pictures"
    says 'HIDDEN \([1-9][0-9]*\)/\1'
done

# ---- What cannot be tried ----

mv step01_line/main.c.marked .
hidden 2 1 1
says 'make check HIDDEN=1: nothing can be compared: step01_line/main.c is what is judged, .*'
hidden 2 1 5 "$work/nowhere"
says "make check HIDDEN=1: there is no $work/nowhere/step05_zbuffer/main.c"
hidden 2 x 5 "$work"
says "hidden: 'x' is no seed: a number is wanted"
hidden 2 1 7
grep -q '^make check HIDDEN=1: there is no step "7"' "$work/said" || wrong "step 7"

# ---- make check HIDDEN=1 ----

cp "$work/step05_zbuffer/main.c" step05_zbuffer/main.c
# shellcheck disable=SC2086
make -s check STEP=5 HIDDEN=3 $flags >"$work/said" 2>&1 || wrong "make check HIDDEN=3 fails"
says '1 passed, 0 failed'
says 'HIDDEN \([1-9][0-9]*\)/\1'
! grep -q 'look at it' "$work/said" || wrong "a solution is to be looked at"

# A program that prints stored pictures is to be looked at.
cp "$work/stored.c" step05_zbuffer/main.c
# shellcheck disable=SC2086
make -s check STEP=5 HIDDEN=3 SOLUTION="$work" $flags >"$work/said" 2>&1 &&
    wrong "stored pictures pass"
says 'step05_zbuffer  look at it: draws the reference where another picture is asked for: [1-9][0-9]*'

# Honest mistakes are not, with any seed: half-way ties rounded down, by which some hidden scenes are
# wrong and some right; and a program that crashes.
sed 's/walk->error > 0/walk->error >= 0/' "$work/step01_line/main.c" >step01_line/main.c
cmp -s step01_line/main.c "$work/step01_line/main.c" && wrong "no mistake is made"
built step01_line
for seed in 1 2 3 7 8 9 10; do
    hidden 1 $seed 1 "$work"
    says '  hidden: lines: wrong'
    says 'HIDDEN [23]/4'
    ! grep -q 'look at it' "$work/said" || wrong "an honest program is to be looked at: $(cat "$work/said")"
done
sed 's/^int main.*/&\n    if (argc > 3) abort();/' "$work/step01_line/main.c" >step01_line/main.c
built step01_line
hidden 1 1 1 "$work"
! grep -q 'look at it' "$work/said" || wrong "a program that crashes is to be looked at"

exit $failed
