#!/bin/bash
# Makes up a class to grade: make_class.sh INTO COUNT LAST
#
# INTO/class gets COUNT submissions (at least 40) of lessons 1 to LAST (2 to 9): solutions,
# starters, mistakes, correct programs written otherwise, three copies of one of those, and hostile
# ones, some packed.
# INTO/expected says what each should get, a line each: its name as in class.csv, GRADED or ERROR,
# then a sign and points: `= 66` or `< 66`. CONTAINED=1: programs can be kept from killing others.
cd "$(dirname "$0")/../../.." || exit 1
. tests/teacher/grade/encode.sh
into=$1
count=$2
last=$3
class=$into/class
lessons=$(ls -d step0[1-"$last"]_*)
mkdir -p "$class" "$into/kinds" || exit 1
exec 3>"$into/expected"

# kind NAME MODE: the lessons as marks.awk makes them, to take copies of.
kind() {
    for lesson in $lessons; do
        mkdir -p "$into/kinds/$1/$lesson"
        awk -v mode="$1" -f tests/student/marks.awk "$lesson/main.c" \
            >"$into/kinds/$1/$lesson/main.c" || exit 1
    done
}
kind solution
kind starter
mkdir "$into/list"
# shellcheck disable=SC2086
awk -v directory="$into/list" -f tests/upkeep/verify/replace.awk -f tests/upkeep/verify/parse.awk \
    step0[1-"$last"]*/mistakes.txt tests/lessons/step0[1-"$last"]*/alternatives.txt |
    awk -F '\t' '$6 == "-" && $7 == "-"' >"$into/table" || exit 1
# points LESSONS: what these are worth; a pattern of their numbers.
points() {
    awk -v wanted="^step$1_" '$1 ~ wanted { points += $4 }
        ($1 == "work" || $1 == "same" || $1 == "call") && $2 ~ wanted { points += $5 }
        END { print points }' tests/check/scenes.txt
}
most=$(points "0[1-$last]")
first=$(points 01)

made=0
# expect NAME STATE SIGN POINTS
expect() {
    echo "$(encode "$1") $2" >&3
}

# submission NAME FROM SIGN POINTS [STATE]: a copy of FROM.
submission() {
    cp -R "$into/kinds/$2" "$class/$1" || exit 1
    expect "$1" "${5:-GRADED} $3 $4"
    made=$((made + 1))
}

# entries KIND NUMBER PREFIX SIGN: that many of the table, spread over it, each in a solution.
entries() {
    grep -P "\t$1\t" "$into/table" >"$into/chosen"
    total=$(wc -l <"$into/chosen")
    for ((i = 0; i < $2; i++)); do
        line=$(sed -n "$((i * total / $2 + 1))p" "$into/chosen")
        IFS=$'\t' read -r number lesson _ name _ <<<"$line"
        submission "$3$i-$name" solution "$4" "$most"
        cp "$into/list/$number/main.c" "$class/$3$i-$name/$lesson/main.c" || exit 1
    done
}

# ---- Hostile ones: lesson 1 is the program of standard input, the others are solved ----

# hostile NAME [SIGN POINTS [STATE]]
hostile() {
    submission "hostile-$1" solution "${2:-=}" "${3:-$((most - first))}" "${4:-GRADED}"
    cat >"$class/hostile-$1/step01_line/main.c"
}

# program NAME STATEMENTS: a main() of them; the other functions are the starter's.
program() {
    hostile "$1" <<END
$(awk -v mode=starter -f tests/student/marks.awk step01_line/main.c |
    sed 's/to do [0-9]//; s/^int main(/static inline int given_main(/')
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <net/if.h>
#include <sys/stat.h>
#include <unistd.h>
int kill(int process, int signal);
int symlink(const char *target, const char *path);

int main(int argc, char **argv) {
    (void)argc, (void)argv;
    $2
    return 0;
}
END
}

references=$PWD/tests/reference/step01_line
program loops 'for (volatile int i = 0;; i++) {}'
program forks 'for (;;) fork();'
program fills_the_disk 'char name[40]; static char block[60000000];
    for (int i = 0;; i++) { sprintf(name, "%d", i); FILE *f = fopen(name, "w");
        if (f != NULL) { fwrite(block, 1, sizeof block, f); fclose(f); } }'
program makes_directories 'for (;;) if (mkdir("d", 0700) != 0 || chdir("d") != 0) pause();'
program fills_the_memory 'for (;;) { char *p = malloc(1 << 20);
    if (p != NULL) memset(p, 1, 1 << 20); }'
program crashes '*(volatile int *)8 = 1;'
program speaks_to_the_terminal 'int t = open("/dev/tty", O_WRONLY);
    const char *said = "\033]0;owned\007\033[2J\nSCORE 66/66\n3 passed, 0 failed\n";
    if (t >= 0 && write(t, said, strlen(said)) < 0) return 3;
    fputs(said, stdout); fputs(said, stderr); return 1;'
program ignores_signals 'for (int i = 1; i < 64; i++) signal(i, SIG_IGN); for (;;) pause();'
program leaves_children 'if (fork() == 0) { setsid(); if (fork() == 0) {
    close(0), close(1), close(2); execl("/bin/sleep", "sleep", "98765", (char *)0); } _exit(0); }'
program reads_references "char command[2000];
    snprintf(command, sizeof command, \"cp $references/*.png . && for f in *.png; do \"
        \"mv \$f \${f%%png}tga; done; cat $PWD/step02_wireframe/main.c\", 0);
    return system(command);"
program writes_outside "const char *places[] = {\"$into/written\", \"$PWD/written\",
        \"/var/tmp/written\", \"$PWD/tests/check/scenes.txt\", \"$PWD/build/quick/libcommon.a\"};
    for (int i = 0; i < 5; i++) { int f = open(places[i], O_WRONLY | O_CREAT | O_APPEND, 0666);
        if (f >= 0 && write(f, \"x\", 1) == 1) close(f); }"
# A network has more than the loop to oneself.
program opens_the_network 'struct if_nameindex *i = if_nameindex();
    for (; i != NULL && i->if_index != 0; i++)
        if (strcmp(i->if_name, "lo") != 0) fputs("CONNECTED\n", stderr);
    return 1;'
program reads_solutions "const char *places[] = {\"$PWD/step02_wireframe/main.c\",
        \"$PWD/.git/HEAD\", \"$references/line.png\"};
    for (int i = 0; i < 3; i++) {
        FILE *f = fopen(places[i], \"rb\");
        if (f != NULL && fgetc(f) != EOF) fprintf(stderr, \"READ %s\\n\", places[i]); }
    return 1;"
if [ -n "$CONTAINED" ]; then
    program kills_all 'kill(-1, SIGKILL); kill(getppid(), SIGKILL); for (;;) kill(1, SIGKILL);'
fi
program hides_links "symlink(\"$references/line.png\", \"line.tga\"); symlink(\"/\", \"pixel.tga\");
    mkfifo(\"gradient.tga\", 0666); rename(\".\", \"x\");"

hostile hangs_the_compiler <<'END'
#define A(x) x x x x x x x x x x
#define B(x) A(A(A(A(A(A(A(A(A(x)))))))))
int main(void) { B(B(;)) }
END
hostile reads_without_end <<'END'
#include "/dev/zero"
END
hostile reads_the_solution <<END
__asm__(".incbin \"$PWD/step01_line/main.c\"");
#include "$PWD/step01_line/main.c"
END
hostile brings_its_own_check = "$((most - first))" <<'END'
#include "scenes.h"
int main(void) { return 0; }
END
own=$class/hostile-brings_its_own_check
mkdir -p "$own/tests/check" "$own/common" "$own/build"
printf 'all check %%:\n\ttouch %s/written; echo SCORE 66/66\n' "$into" >"$own/Makefile"
printf '#error own\n' | tee "$own/tests/check/check.c" "$own/common/file.c" "$own/common/file.h" \
    "$own/step01_line/scenes.h" >/dev/null
printf '#!/bin/sh\ntouch %s/written; echo SCORE 66/66\n' "$into" >"$own/build/check"
chmod +x "$own/build/check"
submission "-rf \$(touch written);\`touch written\`'\"*" solution = "$most"
submission $'two\nlines' solution = "$most"
mkdir "$class/hostile-links" && ln -s "$PWD/step01_line" "$class/hostile-links/step01_line" &&
    mkdir "$class/hostile-links/step02_wireframe" &&
    ln -s "$PWD/step02_wireframe/main.c" "$class/hostile-links/step02_wireframe/main.c"
expect hostile-links "ERROR = 0"
echo "no archive" >"$class/hostile-broken.zip"
expect hostile-broken.zip "ERROR = 0"
mkdir "$into/bomb" && head -c 150000000 /dev/zero >"$into/bomb/zeros" &&
    tar czf "$class/hostile-bomb.tar.gz" -C "$into" bomb && rm -r "$into/bomb"
expect hostile-bomb.tar.gz "ERROR = 0"
echo "no archive" >"$class/hostile.rar"
expect hostile.rar "ERROR = 0"
made=$((made + 4))

# ---- Honest ones, in other layouts ----

# layout NAME FORM ENCODING: each lesson's solution as FORM, where L is its name.
layout() {
    for lesson in $lessons; do
        file="$class/layout-$1/${2//L/$lesson}"
        mkdir -p "${file%/*}" && iconv -f UTF-8 -t "$3" "$into/kinds/solution/$lesson/main.c" >"$file" || exit 1
    done
    expect "layout-$1" "GRADED = $most"
    made=$((made + 1))
}
layout flat L.c UTF-8
layout umlaut $'\xdcbung/L/main.c' UTF-8
layout windows 'L\main.c' UTF-16
(cd "$class/layout-umlaut" && zip -qr "../layout-packed.zip" .) && mkdir "$class/layout-moodle" &&
    cp "$class/layout-packed.zip" "$class/layout-moodle" || exit 1
expect layout-packed.zip "GRADED = $most"
expect layout-moodle "GRADED = $most"
made=$((made + 2))

# ---- Everybody else ----

copies=3
rest=$((count - made - copies))
entries accept $((rest / 5)) "other" =
entries mistake $((rest * 2 / 5)) "wrong" '<'
for ((i = 0; i < rest / 8; i++)); do
    submission "starter $i" starter = 0
done
# The copies: their names and comments are changed.
original=$(find "$class" -maxdepth 1 -name 'other0-*')
for copy in one two three; do
    cp -R "$original" "$class/copy $copy"
    sed -i "s/\bimage\b/picture_$copy/g; s|^/\*.*\*/\$|/* by $copy */|; s/    /  /g" \
        "$class/copy $copy/step01_line/main.c"
    sed -i "s/struct picture_$copy/struct image/g; s/drawing->picture_$copy/drawing->image/g" \
        "$class/copy $copy/step01_line/main.c"
    expect "copy $copy" "GRADED = $most"
    made=$((made + 1))
done
# Everything that was handed out, with an older work next to it, and what macOS packs besides.
handout=$into/kinds/handout
mkdir -p "$handout/a/tests/reference" && cp -R "$into"/kinds/solution/* "$handout/a" || exit 1
for lesson in $lessons; do
    mkdir -p "$handout/a/tests/reference/$lesson" || exit 1
    for other in old __MACOSX; do
        mkdir -p "$handout/$other/$lesson" && echo 'no C' >"$handout/$other/$lesson/main.c" || exit 1
    done
done
# Some are packed, with and without a directory of their own.
for ((i = 0; made < count; i++)); do
    name="student $i"
    case $((i % 6)) in
    0) cp -R "$handout" "$class/$name" ;;
    1) name+=.tar.gz && tar czf "$class/$name" -C "$into/kinds" solution ;;
    2) (cd "$into/kinds/solution" && zip -qr "$class/$name.zip" .) && name+=.zip ;;
    3) (cd "$handout" && zip -qr "$class/$name.ZIP" .) && name+=.ZIP ;;
    4) name+=.tar && tar cf "$class/$name" -C "$handout" . ;;
    *) cp -R "$into/kinds/solution" "$class/$name" ;;
    esac
    expect "$name" "GRADED = $most"
    made=$((made + 1))
done
echo "$made submissions in $class, $most points"
