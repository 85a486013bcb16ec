#!/bin/sh
# Does build/similar list copies, and nothing else? With the lessons' own solutions, and two
# programs that somebody else wrote: renamed, reordered and commented copies are listed with their
# lines; what the course gives, and independent solutions, are not. Nothing that a submission holds
# or is called stops it, gets into the page as HTML, or into a spreadsheet as a formula.
#
# Exit status 0: all of that is so; 1: something is not.

top=$(cd "$(dirname "$0")/../../.." && pwd) || exit 1
build=$(cd "$top" && cd "${CHECK_PROGRAMS:-build}" && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
failed=0

wrong() {
    echo "similar: $*"
    failed=1
}

# compare ARGUMENT...: sets status; what it says is in out and errors.
compare() {
    rm -f page.html table.csv
    timeout 60 "$build/similar" --starters starters --html page.html --csv table.csv "$@" \
        >out 2>errors
    status=$?
    [ $status -eq 0 ] || wrong "status $status: $*: $(cat errors)"
}

# pairs COUNT: so many were listed.
pairs() {
    grep -q "^similar: $1 of " out || wrong "$2: not $1 pairs but $(cat out)"
}

# holds FILE TEXT, lacks FILE TEXT
holds() {
    grep -qF -e "$2" "$1" || wrong "$1 lacks $2"
}
lacks() {
    ! grep -qF -e "$2" "$1" || wrong "$1 holds $2"
}

# ---- The submissions ----

cd "$top" || exit 1
for lesson in step[0-9]*_*/main.c; do
    lesson=${lesson%/main.c}
    mkdir -p "$work/starters/$lesson" "$work/solution/$lesson" || exit 1
    for mode in starter solution; do
        directory=$work/$mode
        [ $mode = solution ] || directory=$work/starters
        awk -v mode=$mode -f tests/student/marks.awk "$lesson/main.c" >"$directory/$lesson/main.c" ||
            exit 1
    done
    cp "$lesson/scenes.h" "$lesson/attempts.h" "$work/starters/$lesson" || exit 1
done
cp -R common "$work/starters" || exit 1
for program in tests/teacher/similar/other/*.txt; do
    lesson=$(basename "$program" .txt)
    mkdir -p "$work/other/$lesson" && cp "$program" "$work/other/$lesson/main.c" || exit 1
done
cd "$work" || exit 1

# change NAME COMMAND...: a copy of the solution, each main.c as the command changes it.
change() {
    name=$1
    shift
    for main in solution/*/main.c; do
        lesson=${main#*/}
        mkdir -p "$name/${lesson%/*}" && "$@" <"$main" >"$name/$lesson" || exit 1
    done
}

# Every name gets another; keywords stay.
rename_all() {
    awk 'BEGIN {
            split("if else for while return struct enum static const int double float bool void " \
                  "unsigned char sizeof switch case break continue default true false", words, " ")
            for (i in words) keyword[words[i]] = 1
        }
        {
            line = ""
            rest = $0
            while (match(rest, /[A-Za-z_][A-Za-z_0-9]*/)) {
                word = substr(rest, RSTART, RLENGTH)
                line = line substr(rest, 1, RSTART - 1) (word in keyword ? word : "my_" word)
                rest = substr(rest, RSTART + RLENGTH)
            }
            print line rest
        }'
}

# The last function first; other comments, other white space.
reorder() {
    awk '{ text = text $0 "\n" }
        /^}/ || /^};/ { part[++count] = text; text = "" }
        END {
            for (i = count; i > 0; i--) printf "%s", part[i]
            printf "%s", text
        }' | sed 's|/\*.*\*/|/* mine */|; s/^    /\t\t/; s/ {$/\
{/; s/ = /=/'
}

change renamed rename_all
change reordered reorder

# ---- What is listed ----

compare solution other starters
pairs 0 'independent solutions and the starters'
compare starters also=starters solution
pairs 0 'the starters twice'
holds page.html 'judges nobody'

compare solution other renamed starters
pairs 1 'a renamed copy'
holds out '100 %  solution  renamed'
holds table.csv '"solution","renamed",step02_wireframe,'
lacks table.csv other
holds page.html '<mark>'
holds page.html 'my_'
[ "$(grep -c '^<details>' page.html)" -eq "$(grep -c '"solution","renamed"' table.csv)" ] ||
    wrong 'not all lessons of the table are in the page'

compare solution other reordered
pairs 1 'a reordered copy'

# One lesson of somebody's own work is a copy.
mkdir mixed && cp -R other/step02_wireframe solution/step01_line mixed || exit 1
compare solution other mixed
holds out '  solution  mixed  (100 % of step01_line)'
holds out '  other  mixed  (100 % of step02_wireframe)'
pairs 2 'two sources'

# What is copied into a file of its own is seen, with its name.
mkdir -p split/step01_line && cp other/step01_line/main.c split/step01_line/helper.h &&
    cp starters/step01_line/main.c split/step01_line/main.c || exit 1
compare other split
pairs 1 'a copy in a header'
holds page.html 'helper.h:'

# ---- Names ----

evil=$(printf 'a\033[31m<b>&"\nc')
mkdir -p names && cp -R solution "names/$evil" && cp -R solution 'names/=1+1' &&
    cp -R solution 'names/x=y' || exit 1
sed 's|;$|; // <script>|' solution/step01_line/main.c >"names/$evil/step01_line/main.c"
compare "names/$evil" 'names/=1+1/' 'anna=names/x=y' "missing$evil"
pairs 3 'odd names'
holds table.csv "\"'=1+1\",\"anna\",step01_line,"
holds page.html 'a?[31m&lt;b&gt;&amp;&quot;?c'
holds page.html '// &lt;script&gt;'
lacks page.html '<b>'
lacks page.html '<script'
for file in out errors page.html; do
    lacks $file "$(printf '\033')"
done
[ "$(wc -l <errors)" -eq 1 ] || wrong "not one note: $(cat errors)"

# ---- Hostile files ----

# many BYTES TEXT: the text again and again.
many() {
    yes "$2" | tr -d '\n' | head -c "$1"
}
submit() {
    mkdir -p "hostile/$1/step05_zbuffer" && cat >"hostile/$1/step05_zbuffer/main.c"
}
many 262144 '0,' | submit zeros
many 262144 '0,' | submit zeros_again
many 262144 '/*' | submit comments
many 262144 '"\' | submit quotes
many 262144 'x' | submit name
head -c 262144 /dev/zero | submit nul
head -c 200000 "$build/similar" | submit binary
many 262145 'x;' | submit large
printf '' | submit empty
mkdir -p hostile/pipe/step05_zbuffer hostile/link/step05_zbuffer hostile/linked \
    hostile/directory/step05_zbuffer/main.c hostile/nothing &&
    mkfifo hostile/pipe/step05_zbuffer/main.c &&
    ln -s "$work/solution/step05_zbuffer/main.c" hostile/link/step05_zbuffer/main.c &&
    ln -s "$work/solution/step05_zbuffer" hostile/linked/step05_zbuffer || exit 1
[ "$(find hostile/* -prune | wc -l)" -eq 14 ] || wrong "hostile: $(ls hostile)"
compare solution hostile/* hostile/missing renamed
holds out '100 %  solution  renamed'
pairs 1 'hostile files'
for note in 'large: hostile/large/step05_zbuffer: more than 256 files or 256 KiB' \
    'pipe: hostile/pipe/step05_zbuffer: main.c is not a plain file' \
    'link: hostile/link/step05_zbuffer: main.c is not a plain file' \
    'directory: hostile/directory/step05_zbuffer: main.c is not a plain file' \
    'linked: hostile/linked/step05_zbuffer: is not a plain directory' \
    'nothing: has no lesson' 'missing: has no lesson'; do
    holds errors "$note"
    holds page.html "<li>$note"
done
[ "$(wc -c <page.html)" -lt 4000000 ] || wrong 'the page is too large'

# ---- Wrong usage, and what cannot be done ----

# refuses STATUS WORDS ARGUMENT...
refuses() {
    wanted=$1
    words=$2
    shift 2
    "$build/similar" "$@" >out 2>errors
    status=$?
    [ $status -eq "$wanted" ] || wrong "status $status and not $wanted: $*"
    holds errors "$words"
}
refuses 2 'say what everybody got' solution other
refuses 2 "unknown option '--judge'" --judge yes
refuses 2 '--starters needs a value' --starters
refuses 2 "--all is '101'" --starters starters --all 101 solution
refuses 2 "--lesson is 'half'" --starters starters --lesson half solution
refuses 1 'missing: No such file' --starters missing solution
refuses 1 'has no lesson, like' --starters hostile solution
refuses 1 'nowhere/page.html' --starters starters --html nowhere/page.html solution renamed
compare
pairs 0 'no submission'

[ $failed -eq 0 ] && echo "similar: copies are listed, and nothing else"
exit $failed
