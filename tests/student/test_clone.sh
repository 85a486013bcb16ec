#!/bin/sh
# A clone as git makes it on Windows (core.autocrlf), whose scripts nobody may start: a lesson is built
# and checked there, and each command for students and teachers finds its scripts.
. "$(dirname "$0")/../unit/script.sh"

git -C "$top" rev-parse HEAD >/dev/null 2>&1 || skip "this is no checkout of git"
mkdir "$work/course" && git ls-files -z --cached --others --exclude-standard |
    xargs -0 tar -cf "$work/course.tar" && tar -xf "$work/course.tar" -C "$work/course" || exit 1
cd "$work/course" && git init -q . && git add -A &&
    git -c user.name=test -c user.email=test commit -qm course &&
    git -c core.autocrlf=true clone -q "$work/course" "$work/clone" && cd "$work/clone" || exit 1
find . -name '*.sh' -exec chmod -x {} +

# git names what it takes for text, and how that ends in the clone.
git ls-files --eol | grep -v 'w/lf\|w/-text\|w/none' >"$work/said" && said=$work/said &&
    wrong "does not end its lines with LF"
git ls-files --eol -- '*.png' '*.tar' | grep -v 'i/-text *w/-text' >"$work/said" && said=$work/said &&
    wrong "is changed as if it were text"

# course STATUS COMMAND...: of these programs, with which any later make goes on.
course() {
    status=$1
    shift
    said_by "$status" make -s CFLAGS=-O0 MARCH= "$@"
}
course 0 start STEP=01
course 2 check STEP=01
says 'TODO'
course 0 hint STEP=01
says 'hint 1 of 3'
course 0 solution STEP=01
course 0 check STEP=01
says 'PASS'
course 0 open STEP=01
course 0 show STEP=01 SCENE=line KIND=blocks
course 0 handout OUT="$work/out" LESSONS=1
course 2 grade SUBMISSIONS="$work/nowhere"
says 'say whose'
course 2 verify STEP=77
says 'no step'
exit $failed
