#!/bin/sh
# `make grade` in small: what becomes of the names of submissions, hidden scenes against stored pictures,
# and a class that is merged. In what layouts they come is tried by tests/teacher/templates/test_layouts.sh,
# what hostile programs do by tests/teacher/grade/try_class.sh.
. "$(dirname "$0")/../../unit/script.sh"

# ---- Names ----

. "$top/tests/teacher/grade/encode.sh"
for pair in 'ann=ann' 'a b=a%20b' '-rf=%2Drf' '.x=%2Ex' '=1+1=%3D1%2B1' 'a%b=a%25b' 'ü=%C3%BC' \
    "it's=it%27s"; do
    wanted=${pair##*=}
    name=${pair%="$wanted"}
    [ "$(encode "$name")" = "$wanted" ] || wrong "$name becomes $(encode "$name"), not $wanted"
done

# ---- A class of four, of lesson 1 ----

mkdir -p "$work/course/tests/reference" && cd "$work/course" || exit 1
cp -R "$top/Makefile" "$top/common" "$top/step01_line" . &&
    (cd "$top/tests" && cp -R check student teacher "$work/course/tests" &&
        cp lesson.h numbers.h more_scenes.h "$work/course/tests" && mkdir "$work/course/tests/lessons" && cp -R lessons/step01_line "$work/course/tests/lessons" &&
        cp -R reference/step01_line "$work/course/tests/reference") || exit 1
grep -e '^#' -e 'step01_' "$top/tests/check/scenes.txt" >tests/check/scenes.txt
mkdir build && cp -R "$build/models" build || exit 1
for kind in solution starter; do
    mkdir -p "../class/$kind/step01_line" &&
        awk -v mode=$kind -f tests/student/marks.awk step01_line/main.c \
            >"../class/$kind/step01_line/main.c" || exit 1
done
chmod 600 ../class/solution/step01_line/main.c # where root grades, the compiler runs as another user
mkdir -p "../class/a b/step01_line" ../class/stored/step01_line
sed 's/52, 41/41, 52/' ../class/solution/step01_line/main.c >"../class/a b/step01_line/main.c"
# given: the starter's functions, without its main(): trials.c calls them.
given() {
    sed 's/to do [0-9]//; s/^int main(/static inline int given_main(/' ../class/starter/step01_line/main.c
}
# It has all of the references within itself.
{
    given
    echo '#include <stdio.h>'
    echo '#include <string.h>'
    for picture in tests/reference/step01_line/*.png; do
        scene=$(basename "$picture" .png)
        "$build/quick/step01_line" -o "$work" --only "$scene" >/dev/null 2>&1
        echo "static const unsigned char stored_${scene}[] = {"
        od -An -v -tu1 "$work/$scene.tga" | sed 's/  */,/g; s/^,//; s/$/,/'
        echo '};'
    done
    echo 'static void put(const char *name, const void *data, size_t size) {'
    echo '    FILE *file = fopen(name, "wb"); fwrite(data, 1, size, file); fclose(file); }'
    echo 'int main(int argc, char **argv) {'
    for picture in tests/reference/step01_line/*.png; do
        scene=$(basename "$picture" .png)
        echo "    put(\"$scene.tga\", stored_$scene, sizeof stored_$scene);"
    done
    echo 'return 0; }'
} >../class/stored/step01_line/main.c
flags='CFLAGS=-O1 MARCH='
# shellcheck disable=SC2086
make -s grade $flags SUBMISSIONS=../class OUT=../out LESSONS=1 SEED=3 JOBS=2 >"$work/said" 2>&1 ||
    wrong "make grade fails: $(cat "$work/said")"
most=$(awk -F, 'NR == 2 { print $4 }' ../out/class.csv)
# row NAME PATTERN: its line in the CSV.
row() {
    grep -qx "$1,$2" ../out/class.csv || wrong "$1 is not $2: $(grep "^$1," ../out/class.csv)"
}
row solution "GRADED,$most,$most,4,4,.*"
row starter "GRADED,0,$most,0,4,.*"
row 'a%20b' "GRADED,$((most - 2)),$most,4,4,0,.*"
row stored "GRADED,[1-9].*,$most,0,4,.*,\"look at step01_line: draws no picture of anything that is new\""
grep -q '<td>GRADED: look at step01_line: draws no' ../out/index.html || wrong "the page names nobody to look at"
for file in report.html report.xml report.json log hidden sources; do
    [ -e "../out/submissions/a%20b/$file" ] || wrong "a b has no $file"
done
grep -q 'looks like &quot;x and y exchanged' ../out/index.html || wrong "the page has no diagnosis"
grep -q 'href="submissions/a%2520b/report.html"><bdi>a b</bdi><' ../out/index.html || wrong "no link to a b"
left=$(find build -maxdepth 1 -name 'grade.*'; find ../out -name '.[gm]*')
[ -z "$left" ] || wrong "left behind: $left"

# ---- The table of a platform ----

cat >../moodle.csv <<'END'
Identifier,Full name,Email address,Grade,Maximum Grade,Feedback
Participant 7,"Sol, ""A""",solution@x.org,,100.00,"two
lines, with a comma"
Participant 8,Nobody,stor@x.org,12,100.00,
Participant 9,starter,one@x.org,,100.00,
Participant 10,starter,two@x.org,,100.00,
END
# shellcheck disable=SC2086
make -s grade-merge $flags OUT=../out ROSTER=../moodle.csv >"$work/said" 2>&1 || wrong "with a roster: $(cat "$work/said")"
printf '%s\n' 'Identifier,Full name,Email address,Grade,Maximum Grade,Feedback' \
    'Participant 7,"Sol, ""A""",solution@x.org,100,100.00,"two' 'lines, with a comma"' \
    'Participant 8,Nobody,stor@x.org,12,100.00,' 'Participant 9,starter,one@x.org,,100.00,' \
    'Participant 10,starter,two@x.org,,100.00,' | diff - ../out/gradebook.csv || wrong "Moodle's table"
for name in a%20b starter stored; do
    grep -qx "    $name" "$work/said" || wrong "does not say that $name is nobody's"
done

# ---- What is alike ----

# Without sim_c the page says what to install.
mkdir "$work/bin" && ln -s /usr/bin/* /bin/* "$work/bin" 2>/dev/null
rm -f "$work/bin/sim_c"
PATH=$work/bin sh tests/teacher/grade/merge.sh build ../out >"$work/said" || wrong "grade fails without sim_c"
grep -q 'apt-get install similarity-tester' ../out/index.html || wrong "does not say what to install"

# A copy has other names and comments, its functions in another order, some new lines, and a
# header; other programs and two starters are none. Nobody can stop the comparison.
mkdir ../alike && cp -R ../out/submissions ../alike || exit 1
# sources NAME: main.c is standard input.
sources() {
    mkdir -p "../alike/submissions/$1/sources/step01_line" &&
        echo GRADED >"../alike/submissions/$1/state" && echo 1 >"../alike/submissions/$1/seconds" &&
        cat >"../alike/submissions/$1/sources/step01_line/main.c" || exit 1
}
copy=../alike/submissions/copy/sources/step01_line
awk '{ text = text $0 "\n" }
    /;$/ && /^ / && ++lines % 5 == 0 { text = text "    counted++;\n" }
    /^}/ { part[++count] = text; text = "" }
    END { for (i = count; i > 0; i--) printf "%s", part[i] }' ../class/solution/step01_line/main.c |
    sed 's|/\*.*\*/|// mine|; s/line/row/g; s/walk/way/g; s/image/picture/g' |
    sources copy
sed -n '1,50p' $copy/main.c >$copy/mine.h && sed -n '51,$p' $copy/main.c | sources copy
sources starter_again <../class/starter/step01_line/main.c
yes '0,' | tr -d '\n' | head -c 30000 | sources zeros
yes 'x' | head -c 40000 | tr '\n' '(' | sources long
# Such a file keeps sim_c busy for a second on some machines; here it never ends with it.
if command -v sim_c >/dev/null; then
    mkdir "$work/slow" && cat >"$work/slow/sim_c" <<END && chmod +x "$work/slow/sim_c"
#!/bin/sh
for file; do
    [ ! -f "\$file" ] || ! grep -q '0,0,0,0' "\$file" || while :; do :; done
done
exec $(command -v sim_c) "\$@"
END
    PATH=$work/slow:$PATH
fi
sh tests/teacher/grade/merge.sh build ../alike >"$work/said" || wrong "merge: $(cat "$work/said")"
if command -v sim_c >/dev/null; then
    listed=$(sed -E 's/^([89][0-9]|100),//' ../alike/similar.csv | LC_ALL=C sort | tr '\n' ' ')
    [ "$listed" = "percent,lesson,submission,submission step01_line,a%20b,copy \
step01_line,a%20b,solution step01_line,copy,solution " ] || wrong "alike: $(cat ../alike/similar.csv)"
    grep -qE '>step01_line</td><td[^>]*>3</td><td[^>]*>[89][0-9] %</td><td>.*>a b</bdi></a>, .*>copy</bdi></a>, .*>solution</bdi></a><' \
        ../alike/index.html || wrong "the page does not list the copy"
    for reason in 'zeros, step01_line keeps sim_c from its work' \
        'long, step01_line is longer than 32768 bytes'; do
        grep -q "Not compared: $reason" ../alike/index.html || wrong "the page lacks: $reason"
    done
else
    echo "grade: without sim_c, copies are not looked for"
fi

# ---- Again ----

# What is there is not done again; what is taken away is, by itself.
cp ../out/class.csv "$work/before"
touch "$work/mark"
rm -r ../out/submissions/starter
# shellcheck disable=SC2086
make -s grade-one $flags SUBMISSION=../class/starter OUT=../out LESSONS=1 SEED=3 \
    >"$work/said" 2>&1 ||
    wrong "make grade-one fails: $(cat "$work/said")"
# shellcheck disable=SC2086
make -s grade-merge $flags OUT=../out >"$work/said" 2>&1 || wrong "make grade-merge fails"
cmp "$work/before" ../out/class.csv || wrong "graded by itself it is another"
[ -z "$(find ../out/submissions/solution -newer "$work/mark")" ] || wrong "graded twice"

# Twice ended with nobody asking for it.
printf 'begun\nbegun\n' >../out/.begun/starter
rm -r ../out/submissions/starter
# shellcheck disable=SC2086
make -s grade-one $flags SUBMISSION=../class/starter OUT=../out LESSONS=1 >"$work/said" 2>&1
grep -qx 'ERROR killed the grading twice' ../out/submissions/starter/state ||
    wrong "who kills the grading is graded"

# Not shut in, a program can kill the check: somebody outlives that. What cannot be kept from it is
# said in the report of everybody.
mkdir -p ../class/kills/step01_line
{
    given
    cat <<'END'
#include <signal.h>
#include <stdio.h>
#include <unistd.h>
int kill(int process, int signal);
int main(int argc, char **argv) {
    char path[64];
    int check = 0;
    snprintf(path, sizeof path, "/proc/%d/stat", (int)getppid()); /* the one between */
    FILE *file = fopen(path, "r");
    return file == NULL || fscanf(file, "%*d %*s %*c %d", &check) != 1 || kill(check, SIGKILL);
}
END
} >../class/kills/step01_line/main.c
rm -rf ../out
for name in kills solution; do
    # shellcheck disable=SC2086
    CONTAIN_BY=nothing make -s grade-one $flags SUBMISSION=../class/$name OUT=../out LESSONS=1 \
        >"$work/said" 2>&1
done
grep -qx 'ERROR killed by the submission' ../out/submissions/kills/state ||
    wrong "kills: $(cat ../out/submissions/kills/state)"
grep -qx GRADED ../out/submissions/solution/state || wrong "who comes after it is not graded"
grep -q '"note": "Graded without bwrap and unshare' ../out/submissions/solution/report.json ||
    wrong "what is not prevented is not said"
exit $failed
