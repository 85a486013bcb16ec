#!/bin/sh
# The parts of `make MINE=1`, for mine.mk and hers.mk. BUILD is its own build directory, LESSON is
# such as step05_zbuffer:
#
#     mine.sh link HOUSE                  make HOUSE/mine, with what lessons share linked from HOUSE
#     mine.sh hers BUILD LESSON           BUILD/hers/LESSON.names: which of its functions are right, as in
#                                         mine.txt; BUILD/hers/LESSON.c: their source
#     mine.sh names BUILD LESSON EARLIER...   BUILD/hers/LESSON.h: in front of it, their names
#     mine.sh say BUILD LESSON...         with what they are drawn
#     mine.sh whose BUILD REPORT          after a check that wrote this JSON: what of earlier lessons
#                                         makes pictures wrong
#
# A function is known as LESSON_NAME, where NAME is the house's: a pointer, which is the house's again
# where the environment's COURSE_OURS is that name, its word, or `all`. (So mine.sh finds out whose fault it is.)

cd "$(dirname "$0")/../../.." || exit 1
do=$1
build=$2
shift 2
table=tests/student/mine.txt

# table_of LESSON: her name, the house's name, tasks, words, adapter.
table_of() {
    sed 's/^via //' $table | awk -v lesson="$1" '$1 == lesson { print $2, $3, $4, $5, $6 }'
}

number_of() {
    echo "$1" | sed 's/^step0*\([0-9]*\).*/\1/'
}

link() {
    house=$build
    mkdir -p "$house/mine/quick" "$house/common" "$house/tests" "$house/quick/common" "$house/quick/tests" || exit 1
    for file in common tests models flags sculptor libcommon.a check show live compare_page; do
        ln -sfn "../$file" "$house/mine/$file" || exit 1
    done
    for file in common tests libcommon.a; do
        ln -sfn "../../quick/$file" "$house/mine/quick/$file" || exit 1
    done
}

# right_tasks LESSON: those that have all their points.
right_tasks() {
    sed -n 's/.*"task": "\([^"]*\)".*"points": \([0-9]*\), "most": \2}.*/\1/p' "$build/hers/$1.json"
}

hers() {
    lesson=$1
    right=$(right_tasks "$lesson" | tr '\n' ' ')
    table_of "$lesson" | awk -v right=" $right" '{
        n = split($3, tasks, ",")
        for (i = 1; i <= n && index(right, " " tasks[i] " "); i++);
        if (i > n) print }' >"$build/hers/$lesson.names"
    write_source >"$build/hers/$lesson.c"
}

# Nothing of what is not right is compiled.
write_source() {
    if [ ! -s "$build/hers/$lesson.names" ]; then
        echo 'typedef int nothing;'
        return
    fi
    echo "#line 1 \"$lesson/main.c\""
    sed '/^[[:blank:]]*#[[:blank:]]*include[[:blank:]]*"scenes.h"/,$d' "$lesson/main.c"
    echo "#line 1 \"$table\""
    echo '#include <stdlib.h>'
    echo '#include <string.h>'
    case $lesson in step01_*) echo '#define HER_LINE line' ;; *) echo '#define HER_LINE line_inside' ;; esac
    awk '$5 != "" && !seen[$5]++ { print "#include \"tests/student/mine/" $5 ".inc\"" }
        { print "__typeof__(" $2 ") *'"$lesson"'_" $2 " = " $1 ";" }
        { choice = choice "    if (ours != NULL && strstr(\" all " $2 " " $4 " \", ours) != NULL) {\n" }
        { choice = choice "        '"$lesson"'_" $2 " = " $2 ";\n    }\n" }
        END {
            print "__attribute__((constructor)) static void choose(void) {"
            print "    const char *ours = getenv(\"COURSE_OURS\");\n" choice "}"
        }' "$build/hers/$lesson.names"
}

# uses NAME: does the lesson's text have it? (Its cameras come from camera_call().)
uses() {
    case $1 in
    mat4_*) cat "$lesson"/*.[ch] | grep -q pipeline_call ;;
    pipeline_finish) cat "$lesson"/*.[ch] | grep -q 'pipeline_end' ;;
    *) cat "$lesson"/*.[ch] | grep -qw "$1" ;;
    esac
}

names() {
    lesson=$1
    shift
    for earlier; do
        while read -r _ name _; do
            ! uses "$name" || echo "$name ${earlier}_$name"
        done <"$build/hers/$earlier.names"
    done | awk '
        { header = "raster.h"; of[$1] = $2 }
        /^(texture|model|pipeline)_/ { header = $1 ".h"; sub(/_[^.]*/, "", header) }
        { print "#include \"" header "\"\nextern __typeof__(" $1 ") *" $2 ";" }
        END { for (name in of) print "#define " name " " of[name] }' >"$build/hers/$lesson.h"
}

# missing LESSON TASKS: the first of them that hasn't all its points, or `build`.
missing() {
    ! grep -q '"state": "BUILD"' "$build/hers/$1.json" || { echo build && return; }
    right=$(right_tasks "$1" | tr '\n' ' ')
    for task in $(echo "$2" | tr , ' '); do
        case " $right" in *" $task "*) ;; *) echo "$task" && return ;; esac
    done
    echo build
}

# find_words [EXCEPT]: sets mine and ours to words of the table, for what the lesson draws with: ours as
# WORD:TASK or WORD:build, which is why.
find_words() {
    mine=
    ours=
    while read -r from _ name tasks word _; do
        if [ ! -f "$build/hers/$from.names" ] || ! is_before "$from" "$lesson" || ! uses "$name" ||
            [ "${name%_*}" = "${1:-none}" ]; then
            continue
        elif grep -q " $name " "$build/hers/$from.names"; then
            mine="$mine $word"
        else
            ours="$ours $word:$(missing "$from" "$tasks")"
        fi
    done <"$build/hers/table"
}

# The same through part d of lesson 9, which draws with the lesson's own fragment functions.
find_all_words() {
    find_words
    case " $mine " in *' pipeline '*)
        through=$mine
        kept=$lesson
        lesson=$(ls -d step09_*)
        find_words texture
        lesson=$kept
        mine="$mine $through"
        ;;
    esac
}

is_before() {
    [ "$(number_of "$1")" -lt "$(number_of "$2")" ]
}

# list_of WORDS EXCEPT: each once, with commas, and with what it lacks.
list_of() {
    echo "$1" | tr ' ' '\n' | awk -F : -v except=" $2 " '
        $0 != "" && !index(except, " " $1 " ") && !seen[$1]++ {
            printf "%s%s%s", (n++ ? ", " : ""), $1,
                $2 == "" ? "" : $2 == "build" ? " (its main.c does not build)" : " (task " $2 " is not right yet)"
        }'
}

say() {
    grep -v '^#' $table | sed 's/^via //' >"$build/hers/table"
    for lesson; do
        find_all_words
        yours=$(list_of "$mine")
        others=$(list_of "$ours" "$mine")
        case $yours:$others in
        :) echo "$lesson: nothing here is of earlier lessons" ;;
        :*) echo "$lesson: drawn with our $others" ;;
        *) echo "$lesson: drawn with your $yours${others:+; ours: $others}" ;;
        esac
    done
}

# is_right_with OURS: is the scene right with these words ours?
is_right_with() {
    COURSE_OURS=" $1 " CHECK_TIMEOUT=3 "$build/check" --programs "$build/quick" --differences "$build/hers/differences" \
        --make true --only "$scene" "$lesson" </dev/null >/dev/null 2>&1
}

# lesson_of WORD: from which lesson it is, the last one before this that has it right.
lesson_of() {
    while read -r one _ name _ its_word _; do
        if [ "$its_word" = "$1" ] && is_before "$one" "$lesson" && grep -q " $name " "$build/hers/$one.names"; then
            echo "$one"
        fi
    done <"$build/hers/table" | tail -n 1
}

# The function of $from to which the word's fault can be laid, or the word for several.
function_of() {
    case $from in
    step01_*) echo 'line()' && return ;;
    step02_*) echo 'line_inside()' && return ;;
    step04_*) echo 'face_intensity()' && return ;;
    esac
    awk -v lesson="$from" -v word="$word" '$1 == lesson && $5 == word { print $2, $3 }' $table |
        while read -r her name; do
            if is_right_with "$name"; then
                echo "$her()"
                break
            fi
        done | grep . || echo "$word"
}

# Is the scene wrong because of a word, and right where that is ours? Each word is named once; a scene that
# is wrong with all of them ours is the lesson's own fault.
blame() {
    for word in $blamed; do
        ! is_right_with "$word" || return
    done
    is_right_with all || { found=own && return; }
    found=${found:-earlier}
    case $state in
    FAIL) does="draws \`$scene\` otherwise${where:+ at $where}" ;;
    CRASH) does="crashes in \`$scene\`" ;;
    *) does="does not come to an end in \`$scene\`" ;;
    esac
    for word in $(echo "$mine" | tr ' ' '\n' | sort -u); do
        if is_right_with "$word"; then
            blamed="$blamed $word"
            from=$(lesson_of "$word")
            number=$(number_of "$from")
            echo "  your $(function_of) of lesson $number $does; it passes lesson $number's own check"
            return
        fi
    done
    echo "  what you wrote in earlier lessons $does"
}

whose() {
    found=
    known=
    awk -F '"' '/^ *"step": / { step = $4 }
        /{"scene": / && $8 ~ /FAIL|CRASH|TIME/ {
            where = match($0, /\([0-9]+,[0-9]+\)/) ? substr($0, RSTART, RLENGTH) : ""
            if (!seen[step, $4]++) print step, $4, $8, where }' "$1" |
        {
            while read -r lesson scene state where; do
                [ "$lesson" = "$known" ] || find_all_words
                known=$lesson
                blame
            done
            [ "$found" != earlier ] || echo "  With ours there, all of these are right: no task of this lesson is at fault."
        }
}

"$do" "$@"
