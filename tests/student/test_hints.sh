#!/bin/sh
# Has every task of every lesson its three hints, and does `make hint` tell them one after another?
. "$(dirname "$0")/../unit/script.sh"

# tasks_of LESSON: of its main.c (with marks) and of its hints, in $work/tasks and $work/hinted.
tasks_of() {
    awk -v mode=tasks -f tests/student/marks.awk "$1/main.c" | cut -f 1 | sort >"$work/tasks"
    awk -f tests/student/hints.awk "$1/hints.txt" >"$work/hints" || return 1
    cut -f 1 "$work/hints" | sort -u >"$work/hinted"
}

# ---- The lessons ----

for lesson in step*; do
    tasks_of "$lesson" || wrong "$lesson/hints.txt cannot be read"
    diff "$work/tasks" "$work/hinted" || wrong "$lesson: < has no hints, > is no task"
done

# ---- make hint ----

mkdir -p "$work/course/tests" "$work/course/step05_zbuffer" "$work/course/step10_phong" &&
    cd "$work/course" && cp "$top/Makefile" . &&
    cp -R "$top/tests/student" tests || exit 1
cat >step05_zbuffer/main.c <<'EOF'
int given; /* to do 5.1: this is no starter's line */
    return 0; // to do 5.2: one thing; to do 5.10: another thing
EOF
cp step05_zbuffer/main.c step10_phong
cat >step05_zbuffer/hints.txt <<'EOF'
# What helps.
task 5.1
hint First of one.
hint Second of one.
hint Third of one.

task 5.2
hint First of two,
     which goes on.
hint Second of two.
hint Third of two.
task 5.10
hint First of ten.
hint Second of ten.
hint	Third of ten.
EOF

# hint STATUS TEXT ARGUMENT...: `make hint` with these ends so, and says this.
hint() {
    status=$1
    text=$2
    shift 2
    said_by "$status" make -s hint "$@"
    says "$text"
}

hint 1 'step05_zbuffer/hints.txt:15: neither' STEP=05
tr '\t' ' ' <step05_zbuffer/hints.txt >spaces && mv spaces step05_zbuffer/hints.txt
hint 0 '1. First of two,' STEP=05
says '       which goes on.'
silent 'Second'
silent '5.1 '
hint 0 'Also to do: 5.10 (make hint STEP=05 TASK=5.10)' STEP=5 TASK=5.2
hint 0 '3. Third of two.' STEP=05
silent '2. Second'
hint 0 '2. Second of two.' STEP=05
hint 0 '1. First of ten.' STEP=05 TASK=5.10
hint 0 '1. First of one.' STEP=step05_zbuffer TASK=5.1
silent 'First of ten'
hint 0 '2. Second of ten.' STEP=05 TASK=5.10
hint 0 '1. First of ten.' STEP=05 TASK=5.10 AGAIN=1
silent 'Third'
sed -i.old 's/to do 5.2: one thing; //' step05_zbuffer/main.c
hint 0 'Third of ten.' STEP=05
sed -i.old 's/to do 5.10//' step05_zbuffer/main.c
hint 0 'Nothing is wrong or left to do' STEP=05
hint 0 'There are: 5.1 5.2 5.10' STEP=05
hint 1 'there is no task "5.20" in this lesson' STEP=05 TASK=5.20
hint 1 'there is no task "5." in this lesson' STEP=05 TASK=5.
hint 1 'step10_phong has no hints.txt' STEP=10
hint 1 'there is no step "7"' STEP=7
hint 1 'say which step' STEP=
make -s clean
hint 1 'no hint for task 5.1 was shown yet' STEP=05 TASK=5.1 AGAIN=1
hint 0 '1. First of one.' STEP=05 TASK=5.1
silent 'Second'
rm step05_zbuffer/main.c
hint 1 'there is no step05_zbuffer/main.c' STEP=05

# ---- Hints that are wrong ----

# refused LINE WORDS TEXT_LINE...: these lines are wrong at that one, and nothing is printed.
refused() {
    where=hints.txt:$1
    words=$2
    shift 2
    printf '%s\n' "$@" >hints.txt
    said_by 1 awk -f tests/student/hints.awk hints.txt
    [ "$(grep -c "^$where: .*$words" "$said") $(wc -l <"$said")" = '1 1' ] ||
        wrong "not $where: $words"
}

refused 1 'task 5.1 has 2 hints, not 3' 'task 5.1' 'hint a' 'hint b'
refused 1 'task 5.1 has 4 hints, not 3' 'task 5.1' 'hint a' 'hint b' 'hint c' 'hint d' 'task 5.2'
refused 5 'task 5.1 is here for the second time' 'task 5.1' 'hint a' 'hint b' 'hint c' \
    'task 5.1'
refused 1 'a hint before' 'hint a'
refused 1 'neither' 'task 5'
refused 3 'neither' 'task 5.1' 'hint a' '    only four blanks'
refused 2 'neither' 'task 5.1' '     goes on'
refused 1 'no hints' '# nothing'

exit $failed
