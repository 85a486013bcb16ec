#!/bin/sh
# make MINE=1: what later lessons draw with what was written in earlier ones. From the solutions it is all
# hers, the check finds the pictures right, and going to and fro builds nothing again. What is to do, is
# wrong or does not build is ours. What only a later lesson shows is said to be the earlier one's.
. "$(dirname "$0")/../../unit/script.sh"
said=$work/said

# The course with what is built, as far as it is: of common, whose flags name the directory where that
# was, and of the lessons.
mkdir -p "$work/course/tests" "$work/course/build/quick" && cd "$work/course" || exit 1
cp -Rp "$top/common" "$top/Makefile" "$top/README.md" "$top"/step*/ . && ln -s "$top"/tests/* tests || exit 1
(cd "$build" && ls -d flags common tests sculptor models check step*.text quick/common quick/tests \
    quick/libcommon.a quick/numbers quick/step* 2>/dev/null) >"$work/parts"
while read -r part; do
    cp -Rp "$build/$part" "build/$part" || exit 1
done <"$work/parts"

# draws STEP TEXT: make MINE=1 check says the text.
draws() {
    said_by "${3:-0}" make -s BUILT="$build" MINE=1 check STEP="$1"
    says "$2"
}

# change LESSON PATTERN TEXT: in its solution.
change() {
    cp "$top/$1/main.c" "$1/main.c" && sed "s@$2@$3@" "$1/main.c" >"$work/main.c" &&
        ! cmp -s "$work/main.c" "$1/main.c" && cp "$work/main.c" "$1/main.c" || wrong "nothing to change in $1"
}

# ---- The solutions ----

draws 1 'step01_line: nothing here is of earlier lessons'
draws 10 'step10_phong: drawn with your triangle, weights, camera, perspective, pipeline'
silent 'ours:'
says 'SCORE 36/36'
says 'turn PASS' # not exact: it is drawn through part d

# The table of README.md has the functions and tasks that are asked for, and the lessons that draw with them.
said_by 0 sh tests/student/mine/mine.sh say build/mine step*
cat "$said" tests/student/mine.txt README.md | awk '
    function wrong(what) { print "README.md: " what; failed = 1 }
    function number(lesson) { sub(/^step0*/, "", lesson); return lesson + 0 }
    /^step.*: drawn with your / {
        lesson = number($1)
        sub(/.*: drawn with your /, "")
        n = split($0, part, ", ")
        for (i = 1; i <= n; i++) lessons[part[i]] = lessons[part[i]] (lessons[part[i]] ? ", " : "") lesson
    }
    /^(via )?step[0-9]/ && !/: / {
        word = $1 == "via" ? $6 : $5
        tasks[word] = tasks[word] "," ($1 == "via" ? $5 : $4)
        if ($1 != "via") names[word] = names[word] " " $2
    }
    /^\| [a-z]+ \| `/ {
        split($0, part, / *\| */)
        word = part[2]
        told[word] = part[5]
        if (match(told[word], /^[0-9]+ to [0-9]+$/)) {
            split(told[word], range, " to ")
            for (told[word] = i = range[1]; i < range[2]; told[word] = told[word] ", " ++i);
        }
        if (told[word] != lessons[word]) wrong(word " is used in lesson " lessons[word])
        n = split(part[4], task, /[,;] /)
        for (i = 1; i <= n; i++) if (!index(tasks[word] ",", "," task[i] ",")) wrong(word " needs no task " task[i])
        n = split(tasks[word], task, ",")
        for (i = 2; i <= n; i++) if (!index(", " part[4] ",", " " task[i])) wrong(word " needs task " task[i])
        n = split(names[word], name, " ")
        for (i = 1; i <= n; i++) if (!index(part[3], "`" name[i] "()`")) wrong("no " name[i] "()")
    }
    END {
        for (word in lessons) if (!(word in told)) wrong("no row of " word)
        exit failed
    }' || failed=1

# ---- What only a later lesson shows ----

change step03_triangle '[.]y_end = rows.end,' '.y_end = height == 600 ? rows.end - 1 : rows.end,'
draws 5 'step05_zbuffer: drawn with your line, triangle, weights, light' 1
says 'SCORE 24/25' # all but that one are right
silent 'ours:'
says "your triangle_setup() of lesson 3 draws \`side\` otherwise at ("
says "it passes lesson 3's own check"
says 'no task of this lesson is at fault'
said_by 0 make BUILT="$build" check STEP=5
said_by 1 make BUILT="$build" MINE=1 check STEP=5
silent CC

# The lesson's own fault in the same picture is not laid at its door.
change step05_zbuffer 'if (depth > row\[x\]) {' 'if (depth > -INFINITY) {'
draws 5 'step05_zbuffer: drawn with your line, triangle, weights, light' 1
silent 'of lesson 3'
silent 'at fault'
cp "$top/step05_zbuffer/main.c" step05_zbuffer/main.c

# ---- What is ours ----

for lesson in step01_line step02_wireframe; do
    awk -v mode=starter -f tests/student/marks.awk "$top/$lesson/main.c" >"$lesson/main.c" || exit 1
done
change step03_triangle 'y_distance < 0 ||' 'y_distance > 0 \&\&'
echo 'no C' >>step04_flat/main.c
draws 5 'step05_zbuffer: drawn with your weights; ours: line (task 1.2 is not right yet), triangle (task 3b.1 is not right yet), light (its main.c does not build)'
says 'SCORE 25/25 exact'
exit $failed
