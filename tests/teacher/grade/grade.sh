#!/bin/bash
# Grades a class: grade.sh BUILD MAKE SUBMISSIONS OUT [JOBS [LESSONS [SEED [ROSTER [COLUMN]]]]]
#
# Whatever is in SUBMISSIONS is a submission (those are graded that are a directory, .zip or .tar.gz),
# by grade_one.sh, JOBS at a time (as many as there are processors); a failure stops none of the
# others. Stopped and started again, it goes on where it was, and what has changed since is graded
# again. At the end merge.sh makes OUT/class.csv and OUT/index.html, with ROSTER OUT/gradebook.csv, too.
#
# Exit status: 0 each has a result; 1 not; 2 wrong usage.
[ "${BASH_VERSINFO[0]}" -ge 4 ] || {
    echo "make grade: bash $BASH_VERSION is too old, it takes bash 4; on macOS: brew install bash" >&2
    exit 2
}
build=$1
make=$2
submissions=$3
out=$4
jobs=${5:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)}
wanted=$6
seed=$7
roster=$8
column=$9
target=grade
. tests/student/lesson.sh

[ -z "$roster" ] || [ -f "$roster" ] || fail 2 "there is no file ROSTER=$roster"
[ -d "$submissions" ] || fail 2 "say whose: make grade SUBMISSIONS=some/directory [OUT=dir]"
case $jobs in '' | *[!0-9]* | 0) fail 2 "JOBS=$jobs is no number of submissions at a time" ;; esac
(select_lessons) || exit 2
case $seed in *[!0-9]*) fail 2 "SEED=$seed is no number" ;; esac
export LC_ALL=C # names of files are bytes
mkdir -p "$out" || fail 2 "cannot write into $out"
list=()
declare -A is_listed
. tests/teacher/grade/encode.sh
for submission in "$submissions"/*; do
    [ -e "$submission" ] || [ -h "$submission" ] || continue
    list+=("$submission")
    is_listed[$(encode "${submission##*/}")]=yes
done
[ ${#list[@]} -gt 0 ] || fail 2 "there is no directory, .zip or .tar.gz in $submissions"
. tests/teacher/grade/contained.sh

# Sets have_result and others: of the listed submissions how many have a result; the names of results
# that are of none of them.
find_results() {
    local state name
    have_result=0
    others=()
    for state in "$out"/submissions/*/state; do
        [ -f "$state" ] || continue
        name=${state%/state}
        name=${name##*/}
        if [ -n "${is_listed[$name]}" ]; then
            have_result=$((have_result + 1))
        else
            others+=("$name")
        fi
    done
}

# On a terminal one line that says how far it is; otherwise a line each.
show_progress() {
    local count=0 begun=$SECONDS line
    while IFS= read -r line; do
        count=$((count + 1))
        if [ -t 1 ]; then
            printf '\r\033[K%d of %d, %d s: %s' $count ${#list[@]} $((SECONDS - begun)) "$line"
        else
            printf '[%d/%d] %s\n' $count ${#list[@]} "$line"
        fi
    done
    [ ! -t 1 ] || [ $count -eq 0 ] || echo
    find_results
    [ $have_result -le $count ] || echo "$((have_result - count)) results are from before"
}

# xargs stops when a command dies of a signal: no submission may stop the others.
# shellcheck disable=SC2016 # for that shell
printf '%s\0' "${list[@]}" |
    xargs -0 -n 1 -P "$jobs" sh -c 'sh tests/teacher/grade/grade_one.sh "$1" "$2" "$5" "$3" "$4" "$0" || :' \
        "$seed" "$build" "$make" "$out" "$wanted" | show_progress
sh tests/teacher/grade/merge.sh "$build" "$out" "$roster" "$column" || exit 1
find_results
[ ${#others[@]} -eq 0 ] || {
    echo "In $out/submissions, but not in $submissions:"
    printf '    %s\n' "${others[@]}"
}
[ $have_result -ge ${#list[@]} ] || {
    echo "make grade: $((${#list[@]} - have_result)) have no result: try again" >&2
    exit 1
}
