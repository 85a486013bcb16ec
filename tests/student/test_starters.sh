#!/bin/sh
# Can a student start each lesson, and come back? In a copy of the course, `make start` makes every
# main.c its starter, and `make solution` its solution: both without marks, and the starter builds
# without a warning. (What the check says of them: make verify.) Then, on a small main.c: nothing
# that a student wrote is ever lost, and wrong marks are refused with their line.
. "$(dirname "$0")/../unit/script.sh"

marks() {
    awk -v mode="$1" -f "$top/tests/student/marks.awk" "$2"
}

# ---- The lessons ----

# Sets lessons to those that have marks.
find_lessons() {
    lessons=
    for name in step*; do
        if ! tasks=$(marks tasks "$name/main.c"); then
            wrong "$name/main.c has wrong marks"
        elif [ -n "$tasks" ]; then
            lessons="$lessons $name"
        else
            wrong "$name has no marks"
        fi
    done
}

formatted() {
    ! command -v clang-format >/dev/null || clang-format --dry-run -Werror "$@"
}

# become TARGET: every main.c, by `make start` or `make solution`.
become() {
    for name in $lessons; do
        make -s "$1" STEP="$name" >log 2>&1 || wrong "make $1 STEP=$name: $(cat log)"
        ! grep -En 'BEGIN SOLUTION|STARTER|END SOLUTION' "$name/main.c" ||
            wrong "make $1 left a mark in $name"
        formatted "$name/main.c" || wrong "clang-format would change what make $1 makes of $name"
    done
}

# What gcc warns of depends on how much it optimizes, with clang it does not.
compile() {
    for compiler in $compilers; do
        case $compiler in clang) optimizes=-O0 ;; *) optimizes=-O3 ;; esac
        compile=$(make -s commands CC="$compiler" CFLAGS="$optimizes" WERROR=-Werror | sed 1q)
        for name in $lessons; do
            number=${name%%_*}
            number=${number#step}
            eval "$compile -DCOURSE_LESSON=${number#0} -I$name -c $name/main.c -o starter.o" >log 2>&1 ||
                wrong "$compiler and the starter of $name: $(cat log)"
        done
    done
}

mkdir -p "$work/course/tests" || exit 1
cp -R "$top/Makefile" "$top/.clang-format" "$top/common" "$top"/step* "$work/course" || exit 1
cp -R "$top/tests/check" "$top/tests/reference" "$top/tests/student" \
    "$work/course/tests" &&
    mkdir "$work/course/tests/upkeep" && cp "$top/tests/upkeep/upkeep.mk" "$work/course/tests/upkeep" || exit 1
cd "$work/course" || exit 1
compilers=$(for name in gcc clang; do command -v $name >/dev/null && printf '%s ' $name; done)
compilers=${compilers:-cc }

find_lessons
for name in $lessons; do
    formatted "$name/main.c" || wrong "clang-format would change the marked $name/main.c"
done
if [ -n "$lessons" ]; then
    become start
    compile
    become solution
fi

# ---- What is kept ----

lesson=step05_zbuffer
mkdir -p "$work/small/tests" "$work/small/$lesson" "$work/small/step10_phong" || exit 1
cp "$top/Makefile" "$top/.gitignore" "$work/small" || exit 1
cp -R "$top/tests/student" "$work/small/tests" || exit 1
cd "$work/small" || exit 1

cat >marked <<'EOF'
/* BEGIN SOLUTION 5.1 the first row */
#include <stddef.h>
/* END SOLUTION */

struct canvas;

/* BEGIN SOLUTION 5.2 depth test */
static int helper(void) {
    return 1;
}
/* END SOLUTION */

int nearest(struct canvas *canvas) {
    /* BEGIN SOLUTION 5.1 the first row */
    return canvas != 0;
    /* STARTER
    (void)canvas; // to do 5.1: keep the nearest
    return 0;
    END SOLUTION */
}

void last(void) {
    nearest(0);

    /* BEGIN SOLUTION 5.2 depth test */
    helper();
    /* END SOLUTION */
}
EOF
cat >starter <<'EOF'
struct canvas;

int nearest(struct canvas *canvas) {
    (void)canvas; // to do 5.1: keep the nearest
    return 0;
}

void last(void) {
    nearest(0);
}
EOF
cat >solution <<'EOF'
#include <stddef.h>

struct canvas;

static int helper(void) {
    return 1;
}

int nearest(struct canvas *canvas) {
    return canvas != 0;
}

void last(void) {
    nearest(0);

    helper();
}
EOF
sed 's/first row/row/' marked >marked_later
printf 'mine, without a last line break' >mine
printf 'STARTER\r\n' >also_mine

# holds NAME=FILE...: the lesson's directory holds these files and no others, byte for byte.
holds() {
    for pair in "$@"; do
        cmp "$lesson/${pair%%=*}" "${pair#*=}" || wrong "after $step: not so: $pair"
    done
    [ "$(find $lesson | wc -l)" -eq $(($# + 1)) ] || wrong "after $step: $(find $lesson)"
}

# does WORDS COMMAND...: the command succeeds and says WORDS; fails: it does not, and says them.
does() {
    step=$*
    words=$1
    shift
    "$@" >log 2>&1 || wrong "$step: $(cat log)"
    grep -q "$words" log || wrong "$step said: $(cat log)"
}
fails() {
    step=$*
    words=$1
    shift
    ! "$@" >log 2>&1 || wrong "$step did not fail"
    grep -q "$words" log || wrong "$step said: $(cat log)"
}

cp marked $lesson/main.c
does 'kept in step05_zbuffer/main.c.marked' make -s start STEP=05
holds main.c=starter main.c.marked=marked
does 'is the starter already' make -s start STEP=5
does 'now the solution' make -s solution STEP=step05_zbuffer
holds main.c=solution main.c.marked=marked
does 'now the starter' make -s start STEP=5
holds main.c=starter main.c.marked=marked
cp mine $lesson/main.c
does 'kept in step05_zbuffer/main.c.1' make -s solution STEP=5
holds main.c=solution main.c.marked=marked main.c.1=mine
cp also_mine $lesson/main.c
does 'kept in step05_zbuffer/main.c.2' make -s start STEP=5
holds main.c=starter main.c.marked=marked main.c.1=mine main.c.2=also_mine
cp mine $lesson/main.c
does 'kept in step05_zbuffer/main.c.1' make -s start STEP=05
holds main.c=starter main.c.marked=marked main.c.1=mine main.c.2=also_mine
rm $lesson/main.c $lesson/main.c.[0-9]
does 'now the starter' make -s start STEP=05
holds main.c=starter main.c.marked=marked
cp marked_later $lesson/main.c
does 'has changed.*main.c.1' make -s solution STEP=05
holds main.c=solution main.c.marked=marked_later main.c.1=marked

# What cannot be done changes nothing.
fails 'step10_phong' make -s start
fails 'there is no step "7".*say which' make -s start STEP=7
fails 'there is no step "\*"' make -s start STEP='*'
fails 'no good marks' make -s solution STEP=10
holds main.c=solution main.c.marked=marked_later main.c.1=marked
rm $lesson/main.c.1
cp mine $lesson/main.c
# A disk that is full in the middle of the first, second, ... file that is copied.
mkdir full
cat >full/cp <<EOF
#!/bin/sh
echo >>copies
[ \$(wc -l <copies) -ne \$FULL_AT ] || { head -c 5 "\$1" >"\$2"; exit 1; }
exec $(command -v cp) "\$@"
EOF
chmod +x full/cp
for copy in 1 2 3 4; do
    rm -f copies
    fails 'cannot' env FULL_AT=$copy PATH="$PWD/full:$PATH" sh tests/student/start.sh start 5
    case $copy in
    4) holds main.c=mine main.c.marked=marked_later main.c.1=mine ;;
    *) holds main.c=mine main.c.marked=marked_later ;;
    esac
done
rm $lesson/main.c.* copies
cp marked $lesson/main.c
fails 'cannot write' env FULL_AT=2 PATH="$PWD/full:$PATH" sh tests/student/start.sh start 5
holds main.c=marked
cp mine $lesson/main.c
fails 'no good marks' make -s start STEP=05
cp also_mine $lesson/main.c
fails 'step05_zbuffer/main.c:1: ' make -s start STEP=05
holds main.c=also_mine

if command -v git >/dev/null; then
    cp marked $lesson/main.c
    git init -q .
    git add $lesson .gitignore
    git -c user.name=test -c user.email=test commit -qm marked || wrong "git does not work here"
    cp mine $lesson/main.c
    does 'now the starter' make -s start STEP=05
    holds main.c=starter main.c.marked=marked main.c.1=mine
    git status --porcelain | grep main.c. && wrong "git sees what is kept"
fi

# ---- Wrong marks ----

# refused LINE WORDS TEXT_LINE...: for that line, whatever is asked of the text.
refused() {
    line=$1
    words=$2
    shift 2
    printf '%s\n' "$@" >$lesson/main.c
    for mode in starter solution tasks; do
        if printed=$(marks $mode $lesson/main.c 2>log) || [ -n "$printed" ]; then
            wrong "no error: $words"
        fi
        grep -q "^$lesson/main.c:$line: .*$words" log ||
            wrong "not \"$line: $words\" but $(cat log)"
    done
}

begin='    /* BEGIN SOLUTION 5.1 row */'
end='    /* END SOLUTION */'
refused 2 'task 5.1 has no END' 'int a;' "$begin" 'int b;'
refused 2 'task 5.1 has no END' 'int a;' "$begin" '/* STARTER' 'int b;'
refused 1 'belongs in a solution, but here is what is given' "$end"
refused 1 'belongs in a solution, but here is what is given' '/* STARTER'
refused 1 'belongs in a starter, but here is what is given' 'END SOLUTION */'
refused 2 'belongs in what is given, but here is a solution' "$begin" "$begin" "$end" "$end"
refused 3 'belongs in what is given, but here is a starter' "$begin" '/* STARTER' "$begin"
refused 2 'belongs in a starter, but here is a solution' "$begin" 'END SOLUTION */'
refused 3 'belongs in a solution, but here is a starter' "$begin" '/* STARTER' '/* STARTER'
refused 3 'belongs in a solution, but here is a starter' "$begin" '/* STARTER' "$end"
refused 3 'block comment' "$begin" '/* STARTER' 'int a; /* no' 'END SOLUTION */'
refused 3 'block comment' "$begin" '/* STARTER' 'int a; */' 'END SOLUTION */'
refused 2 'not a mark' 'int a;' '/* BEGIN SOLUTION row */'
refused 1 'not a mark' '/* BEGIN SOLUTION 5.1 */' "$end"
refused 1 'not a mark' '/* BEGIN SOLUTION 5.01 row */' "$end"
refused 1 'not a mark' '// BEGIN SOLUTION 5.1 row' "$end"
refused 1 'not a mark' 'int a; /* BEGIN SOLUTION 5.1 row */' "$end"
refused 1 'not a mark' '/* BEGIN SOLUTION 5.1 row */ int a;' "$end"
refused 2 'not a mark' "$begin" '/* STARTER */' "$end"
refused 2 'not a mark' "$begin" '/* END SOLUTION 5.1 */'
refused 1 'task 4.1 is not one of step 5' '/* BEGIN SOLUTION 4.1 row */' "$end"
refused 3 'task 5.1 is called "rows" here, but "row" before' \
    "$begin" "$end" '/* BEGIN SOLUTION 5.1 rows */' "$end"

exit $failed
