#!/bin/sh
# Whatever students hand in gets the same points by `make grade`, on Gradescope and by Moodle's VPL: each
# layout of the one list below goes through all of their scripts, each in a locale of bytes, of UTF-8 or of
# Latin-1, in turn. Building and drawing take seconds, so here a check that only reads main.c stands for the
# real one, which try_templates.sh and test_grade.sh let work.
#
# (On GitHub and GitLab nothing is searched: what a student pushes is the hand-out, with main.c in its place.)
# shellcheck disable=SC2086,SC2231,SC2317 # one digit is one word; a way is called by its name
. "$(dirname "$0")/../../unit/script.sh"
for tool in zip unzip bash; do
    command -v $tool >/dev/null || skip "there is no $tool"
done
templates=$top/tests/teacher/templates

# ---- Two courses, of lesson 1 and of lessons 1 and 2 ----

mkdir -p "$work/course1/build" "$work/submissions" && cd "$work" || exit 1
(cd "$top" && tar cf - tests/student/lesson.sh tests/check/report.awk step01_line/*.[ch]) | tar xf - -C course1 || exit 1
echo 'build/check models:' >course1/Makefile
echo starter >course1/step01_line/main.c
# A lesson has its points, 10 or 7, when main.c is right, and has the header next to it that it includes.
cat >course1/build/check <<'CHECK' && chmod +x course1/build/check
#!/bin/sh
lessons=
sources=.
while [ $# -gt 0 ]; do
    case $1 in
    --sources) sources=$2 && shift ;;
    --json) report=$2 && shift ;;
    --note) echo "$2" && shift ;;
    --*) shift ;;
    *) lessons="$lessons $1" ;;
    esac
    shift
done
for lesson in ${lessons:-step*}; do
    case $lesson in *01*) most=10 ;; *) most=7 ;; esac
    main=$sources/$lesson/main.c
    case $(cat "$main" 2>/dev/null) in
    right*mine.h*) state=$([ -f "$sources/$lesson/mine.h" ] && echo PASS || echo FAIL) ;;
    right*) state=PASS ;;
    *) state=FAIL ;;
    esac
    echo "$lesson $state $most"
done | awk '
    $2 == "PASS" { sum += $3 }
    { most += $3; steps = steps (NR > 1 ? "," : "") "\n    {\n      \"step\": \"" $1 "\",\n      \"items\": [\n" \
        "        {\"scene\": \"all\", \"state\": \"" $2 "\", \"points\": " ($2 == "PASS" ? $3 : 0) ", \"most\": " $3 \
        ", \"tasks\": []}\n      ]\n    }" }
    END { printf "{\n  \"points\": %d,\n  \"most\": %d,\n  \"steps\": [%s\n  ]\n}\n", sum, most, steps }' >"$report"
CHECK
cp -R course1 course2 && mkdir course2/step02_wireframe && cp course1/step01_line/main.c course2/step02_wireframe || exit 1
for number in 1 2; do
    mkdir -p gradescope$number/results gradescope$number/source kept && cp -R course$number kept/course &&
        tar czf course$number.tar.gz -C kept course && mv kept/course gradescope$number/source &&
        cp "$templates/gradescope"/* "$templates/take.sh" gradescope$number/source &&
        cp "$templates/gradescope/run_autograder" gradescope$number &&
        mkdir course$number/tests/teacher && cp "$build/limited" course$number/build &&
        cp -R "$top/tests/teacher/grade" "$templates" course$number/tests/teacher || exit 1
done
mkdir locales
localedef -i de_DE -f ISO-8859-1 "$work/locales/de_DE" 2>/dev/null || echo "layouts: without Latin-1, for there is no localedef"
export LOCPATH="$work/locales"

# ---- The ways ----

# by_WAY LESSONS NAME: sets points to `10/17` and why to what is said of the submission.
by_grade() {
    graded=$(CONTAIN_BY=nothing sh course$1/tests/teacher/grade/grade_one.sh build make "$work/submissions/$2" "$work/out" 2>&1)
    result=$(ls -d out/submissions/*) # one at a time
    why=$(cat "$result/state" "$result/log" 2>/dev/null)
    case $graded in
    *' ERROR '*) points=0 ;;
    *) points=${graded##* GRADED } points=${points%%/*} ;;
    esac
    rm -rf taken && mv "$result/sources" taken 2>/dev/null
    rm -rf out
}
# hand_in NAME INTO: a service unpacks nothing.
hand_in() {
    mkdir -p "$2" && if [ -d "submissions/$1" ]; then cp -RP "submissions/$1/." "$2"; else cp -RP "submissions/$1" "$2"; fi
}
by_gradescope() {
    rm -rf gradescope$1/submission gradescope$1/source/course/step*/mine.h
    for lesson in gradescope$1/source/course/step*; do
        cp course1/step01_line/main.c "$lesson" || exit 1
    done
    hand_in "$2" gradescope$1/submission || exit 1
    (AUTOGRADER=$work/gradescope$1 && export AUTOGRADER && gradescope$1/run_autograder) >printed 2>&1
    points=$(awk '{ while (match($0, /"score": [0-9]+/)) {
            sum += substr($0, RSTART + 9, RLENGTH - 9)
            $0 = substr($0, RSTART + RLENGTH)
        } } END { print sum + 0 }' gradescope$1/results/results.json 2>>printed)
    why=$(cat printed gradescope$1/results/results.json)
    rm -f gradescope$1/results/results.json
}
by_vpl() {
    rm -rf vpl && mkdir vpl && cp "$templates/moodle_vpl"/* "$templates/take.sh" vpl && cp course$1.tar.gz vpl/course.tar.gz &&
        hand_in "$2" vpl && echo "export VPL_GRADEMIN=0 VPL_GRADEMAX=$([ "$1" = 1 ] && echo 10 || echo 17)" >vpl/common_script.sh ||
        exit 1
    why=$(cd vpl && bash ./vpl_evaluate.sh 2>&1 && ./vpl_execution)
    points=$(echo "$why" | sed -n 's/^Grade :=>> *\([0-9]*\)\.00$/\1/p')
}

made=0
tried=0
# has FILE...: a new submission of these files. Each is right; after `old`, wrong; after `empty`, empty.
has() {
    name=layout$((made = made + 1))
    text=right
    mkdir "submissions/$name" && for file; do
        case $file in
        old | right) text=$file && continue ;;
        esac
        mkdir -p "submissions/$name/$(dirname "$file")" && echo "$text" >"submissions/$name/$file" || exit 1
    done
}
# packed SUFFIX [COMMAND...]: the last one, in an archive of that suffix, or as the command makes it.
packed() {
    old=$name
    name=layout$((made = made + 1)).$1
    shift
    (cd "submissions/$old" && "$@" "$work/submissions/$name" .) >/dev/null || exit 1
}
# inside DIRECTORY: the last one, a file, in a new submission.
inside() {
    old=$name
    name=layout$((made = made + 1))
    mkdir -p "submissions/$name/$1" && cp "submissions/$old" "submissions/$name/$1" || exit 1
}
# gives LESSONS POINTS [WORDS]: by all ways, and where WORDS are wanted, says them.
export LC_ALL=C
locales='C C.UTF-8 de_DE'
gives() {
    tried=$((tried + 1))
    for way in grade gradescope vpl; do
        LC_ALL=${locales%% *}
        locales="${locales#* } $LC_ALL"
        by_$way "$1" "$name"
        [ "$points" = "$2" ] || wrong "$way in $LC_ALL: $points, not $2: $why: $(find "submissions/$name")"
        case $why in *"${3:-}"*) ;; *) wrong "$way in $LC_ALL does not say $3: $why" ;; esac
    done
    LC_ALL=${locales%% *} # another first way for the next
    locales="${locales#* } $LC_ALL"
    LC_ALL=C
}

# ---- The layouts ----

umlaut=$(printf '\334bung')
for path in step01_line/main.c step01_line.c step01/main.c Step01_Line/Main.C STEP01_LINE.C hw1/step01_line/main.c \
    a/b/c/d/step01_line/main.c lesson1/main.c 1/main.c line/main.c lesson_1.c 'Lesson 1.c' ann_12_34_step01_line.c \
    'step01_line (1)/main.c' 'step01_line\main.c' "$umlaut/step01_line/main.c" Übung/step01_line/main.c \
    'a b/step01_line/main.c' "it's/\$(x)/step01_line/main.c" ./-rf/step01_line/main.c; do
    has "$path" other/thing.c
    gives 2 10
done
for path in main.c hw2/main.c ann_12_34_main.c 'main (1).c' solution.c "$umlaut.c"; do
    has "$path"
    gives 1 10
done
has step01_line/main.c step02_wireframe/main.c
gives 2 17
has step02/main.c step01.c
gives 2 17
has step02_wireframe/main.c
gives 2 7
has deep/step01_line/main.c old step01/main.c step01_line.c main.c # the surest name, wherever it is
gives 2 10
has step01_line/main.c old old/step01_line/main.c __MACOSX/step01_line/main.c # the nearest to the top
gives 2 10
has step01_line/main.c old tests/student/starters/step01_line.c common/file.c common/run/main.c # the hand-out
gives 2 10
has step01_line/main.c step01_line/mine.h step01_line/scenes.h "step01_line/\$(x).h" common/file.c
echo 'right: #include "mine.h"' >submissions/$name/step01_line/main.c
gives 2 10
[ "$(cd taken && find . -type f | sort | tr '\n' ' ')" = "./step01_line/main.c ./step01_line/mine.h " ] ||
    wrong "takes more than it may: $(find taken)"
for encoding in UTF-16LE UTF-16BE; do
    has step01_line/main.c
    printf '\357\273\277right: Übung\n' | iconv -f UTF-8 -t $encoding >submissions/$name/step01_line/main.c || exit 1
    gives 2 10 "$([ $encoding = UTF-16BE ] || echo 'step01_line/main.c was UTF-16, and is taken as UTF-8.')"
done

has "$umlaut/step01_line/main.c"
plain=$name
packed zip zip -qr && gives 2 10
inside moodle && gives 2 10
(cd "submissions/$name" && zip -qr ../twice.zip .) && name=twice.zip && gives 2 10
name=$plain && packed ZIP zip -qr && gives 2 10
name=$plain && packed tar tar cf && gives 2 10
name=$plain && packed tar.gz tar czf && gives 2 10
inside 'Ann_12_assignsubmission_file' && gives 2 10
name=$plain && packed tgz tar czf && gives 2 10
has main.c && packed zip zip -qr && gives 1 10
echo right >submissions/ann_main.c && name=ann_main.c && gives 1 10
name=ann_step02.c && echo right >submissions/$name && gives 2 7

# Nothing that could be meant: no points, and the reason.
mkdir submissions/empty && name=empty && gives 2 0 'holds no main.c of a lesson'
# shellcheck disable=SC2016 # as it is said
{
    has a.c b/c.c && gives 2 0 'found `a.c`, `b/c.c`; hand in step01_line/main.c'
    has a.c b/c.c && gives 1 0 'found `a.c`, `b/c.c`; hand in step01_line/main.c'
    has main.c && gives 2 0 'found `main.c`; hand in step01_line/main.c'
    has step01_line/main.cpp && gives 2 0 'found `step01_line/main.cpp`; hand in step01_line/main.c'
    has step01_line/main.c.txt && gives 1 0 'found `step01_line/main.c.txt`; hand in'
    has work.rar && gives 1 0 'found `work.rar`; hand in'
    has "$umlaut/b.c" c.c && gives 1 0 'found `?bung/b.c`, `c.c`; hand in'
}
has step01_line/main.c
head -c 1048577 /dev/zero | tr '\0' ' ' >submissions/$name/step01_line/main.c
gives 2 0 "step01_line/main.c is no file of 1 MiB at most"
has step01_line/main.c
ln -sf /etc/passwd submissions/$name/step01_line/main.c
gives 2 0 "step01_line/main.c is a link"
mkdir -p dots && echo right >main.c && (cd dots && tar cPf ../submissions/dots.tar ../main.c) && name=dots.tar
gives 1 0 "\`../'"
echo "no archive" >submissions/broken.zip && name=broken.zip
gives 2 0 'cannot be unpacked: End-of-central-directory signature not found'
ln -s layout1 submissions/link
by_grade 2 link
case $points$why in 0*"a link"*) ;; *) wrong "a link is followed: $points $why" ;; esac
[ -z "$(find . -name '*.packed.*' -o -name 'sources.*')" ] || wrong "archives are left unpacked"
echo "layouts: $tried, each by three ways"
exit $failed
