# Reads a lesson's hints.txt, which has a paragraph for each task of the lesson:
#
#     # A comment.
#     task 5.2
#     hint A first nudge: a question, or what to look at. A long hint goes on in lines
#          that are indented by five blanks.
#     hint More: the formula or the quantity, in words.
#     hint Nearly the code: the line or two that matter.
#
# A task has exactly three hints. Prints "5.2<TAB>1<TAB>first line of text" for each, with <TAB> and
# no number before the lines that follow.
#
#     awk -f hints.awk step05_zbuffer/hints.txt
#
# Exit status 1: something is wrong. It is named on standard error as FILE:LINE; nothing is printed.

function wrong(line, message) {
    printf "%s:%d: %s\n", FILENAME, line, message | "cat >&2"
    failed = 1
    exit 1
}

function finish_task() {
    if (task != "" && hints != 3) wrong(task_line, "task " task " has " hints + 0 " hints, not 3")
}

function print_later(line) { printed = printed line "\n" }

{ sub(/[ \t\r]+$/, "") }
/^#/ || /^$/ { open = 0; next }

/^task [1-9][0-9]*[a-z]?\.[1-9][0-9]*$/ {
    finish_task()
    task = $2
    task_line = FNR
    hints = open = 0
    if (task in seen) wrong(FNR, "task " task " is here for the second time")
    seen[task] = 1
    next
}

/^hint [^ ]/ {
    if (task == "") wrong(FNR, "a hint before the first line `task 5.2`")
    print_later(task "\t" ++hints "\t" substr($0, 6))
    open = 1
    next
}

/^     [^ \t]/ && open { print_later(task "\t\t" substr($0, 6)); next }
{ wrong(FNR, "neither `task 5.2` nor `hint ...` nor a hint that goes on after five blanks: " $0) }

END {
    if (failed) exit 1
    finish_task()
    if (failed) exit 1
    if (task == "") wrong(FNR, "no hints")
    printf "%s", printed
}
