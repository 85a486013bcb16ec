#!/bin/sh
# Does make mutants find what a test misses, and nothing else? A small course has one function and a
# test that forgets one of its limits. All changes of the function are made; what must survive them
# is known. (With <= for < it is the same function, which the compiler knows.)
here=$(cd "$(dirname "$0")" && pwd) && work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
cd "$work" && mkdir -p common tests/unit build || exit 1

cat >common/clamp.h <<'C'
int clamp(int value, int least, int most); /* 1 + 1 in a comment */
C
cat >common/clamp.c <<'C'
#include "clamp.h"

#include <assert.h>
#if 0 + 1 < 2
int clamp_calls = 3; /* outside of functions */
#endif

int clamp(int value, int least, int most) {
    assert(least <= most);
    const char *text = "1 + 1";
    if (value < least) {
        value = least;
    }
    clamp_calls++;
    return value > most && text[0] == '1' ? most : value;
}
C
cat >tests/unit/test_clamp.c <<'C'
#include "clamp.h"

int main(void) {
    return clamp(1, 2, 4) == 2 && clamp(3, 2, 4) == 3 ? 0 : 1; /* none is above 4 */
}
C
cat >expected <<'C'
common/clamp.c:14: arithmetic survives
    - clamp_calls++;
    + clamp_calls--;
common/clamp.c:14: deleted survives
    - clamp_calls++;
    + ;
common/clamp.c:15: constant survives
    - return value > most && text[0] == '1' ? most : value;
    + return value > most && text[1] == '1' ? most : value;
common/clamp.c:15: branch survives
    - return value > most && text[0] == '1' ? most : value;
    + return value > most && text[0] == '1' && 0 ? most : value;
common/clamp.c:15: comparison survives
    - return value > most && text[0] == '1' ? most : value;
    + return value > most && text[0] != '1' ? most : value;
C
echo '6 of 11 changes killed (seed 1)' >>expected
MUTANTS_CC='cc -O1 -w -Icommon' MUTANTS_SANITIZED='' MUTANTS_STRESS='' \
    "$here/mutants.sh" build 1000 1 >found 2>&1
if [ $? -ne 1 ] || ! LC_ALL=C sort found >sorted || ! LC_ALL=C sort expected | diff - sorted; then
    cat found
    exit 1
fi
# Nothing is left behind.
[ -z "$(ls build)" ] || { ls build && exit 1; }
