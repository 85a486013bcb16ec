#!/bin/sh
# Does `make check SANITIZE=1` say in which line a program stops itself, and not advise what was
# done already? In a small course of one lesson, whose main.c is given one end after the other.

lesson=step01_line
. "$(dirname "$0")/../unit/script.sh"
unset ASAN_OPTIONS UBSAN_OPTIONS

cp -R "$top/Makefile" "$top/common" "$work" && cd "$work" && mkdir -p $lesson tests/reference &&
    cp -R "$top/tests/check" "$top/tests/student" tests && : >$lesson/README.md &&
    cp -R "$top/tests/reference/$lesson" tests/reference || exit 1
grep "^$lesson " "$top/tests/check/scenes.txt" >tests/check/scenes.txt

# Nothing here draws a model.
rm -rf common/sculptor && mkdir common/sculptor && echo 'int main(void) {}' >common/sculptor/sculpt.c

# judges WORDS STATEMENT: so is a program judged that does this.
judges() {
    printf '#include <assert.h>\n#include <stdlib.h>\n%s\n%s\n' \
        'static void stop(int count) { if (count > 1) { abort(); } }' \
        "int main(int count, char **words) { (void)words, (void)count; stop(0); $2; }" >$lesson/main.c
    said_by 1 make -s CFLAGS=-O0 MARCH= check STEP=01 SANITIZE=1
    says "$1"
    silent 'SANITIZE=1'
}

judges 'step01_line/main.c:3: stop() stops the program: abort()' 'stop(count)'
judges 'step01_line/main.c:4: main() stops the program: Assertion ' 'assert(count < 1)'
# shellcheck disable=SC2016 # a variable of the shell that it calls
judges 'SIGKILL' 'assert(system("kill -9 $PPID") < 0)'
exit $failed
