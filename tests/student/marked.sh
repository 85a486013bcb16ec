# For scripts that take a lesson's marked source apart, which read this with `.` after lesson.sh.
# `main` is the lesson's main.c, `work` a directory of the script's own.

# text MODE FILE [NAME]: what marks.awk makes of a file, which messages call NAME.
text() {
    awk -v mode="$1" -v name="${3:-$2}" -f tests/student/marks.awk "$2"
}

# has_marks FILE [NAME]: sets tasks; says what is wrong where there are marks, but not good ones.
has_marks() {
    [ -f "$1" ] && tasks=$(text tasks "$@") && [ -n "$tasks" ]
}

# Has git a marked source? It becomes $work/marked.
find_marked_in_git() {
    git show "HEAD:./$main" >"$work/marked" 2>"$work/git" && has_marks "$work/marked" "$main"
}

# The marked source becomes $work/marked. A student may have written anything into main.c, so wrong
# marks there end nothing where the source is found elsewhere.
find_marked() {
    if has_marks "$main"; then
        cp "$main" "$work/marked" || fail 1 "cannot copy $main"
    elif [ -f "$main.marked" ]; then
        has_marks "$main.marked" ||
            fail 1 "$main.marked is no longer the lesson's source; without it, git's is taken"
        cp "$main.marked" "$work/marked" || fail 1 "cannot copy $main.marked"
    elif ! find_marked_in_git; then
        fail 1 "$main has no good marks that tell solution and starter apart," \
            "there is no $main.marked, and git has none; bring back the main.c of the course"
    fi
}

# Find the marked source elsewhere, where main.c is what is judged: a solution made of main.c would be
# held against itself.
find_marked_elsewhere() {
    if find_marked_in_git; then
        return
    elif [ ! -f "$main.marked" ]; then
        why=$(sed 1q "$work/git")
        fail 1 "nothing can be compared: $main is what is judged, and there is no other solution:" \
            "git has none with marks${why:+ ($why)}, and there is no $main.marked;" \
            "SOLUTION=dir names one"
    fi
    has_marks "$main.marked" || fail 1 "$main.marked is no longer the lesson's source"
    cp "$main.marked" "$work/marked" || fail 1 "cannot copy $main.marked"
}
