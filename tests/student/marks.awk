# The marks in a lesson's main.c, which hold its solution and its starter in one text:
#
#     /* BEGIN SOLUTION 5.2 depth test */      step and task, then the task's title
#     ...the solution...
#     /* STARTER
#     ...what the starter has in its place; comments only with //...
#     END SOLUTION */
#
# In a lesson of several parts the number names the part, too: 8b.2 is the second task of part b.
# Where the starter has nothing in its place, /* END SOLUTION */ follows the solution. Marks are
# alone on their lines. A task may have several such regions. What clang-format lines up (includes,
# comments behind fields) is in a region as a whole, or all of it outside.
#
#     awk -v mode=MODE -f marks.awk step05_zbuffer/main.c
#
# MODE starter or solution prints that text without marks; with solution and -v undone=5.2 this task
# is as in the starter. tasks prints "5.2<TAB>depth test" for
# each task, by number. With -v name=FILE the text is called FILE, whatever file it is read from.
#
# Exit status 1: a mark is wrong. It is named on standard error as FILE:LINE; nothing is printed.

function wrong(line, message) {
    printf "%s:%d: %s\n", name, line, message | "cat >&2"
    failed = 1
    exit 1
}

function kind_of(line) {
    if (line !~ /BEGIN SOLUTION|STARTER|END SOLUTION/) return "text"
    sub(/^[ \t]+/, "", line)
    if (line ~ /^\/\* BEGIN SOLUTION [1-9][0-9]*[a-z]?\.[1-9][0-9]* [^ *]([^*]*[^ *])? \*\/$/)
        return "begin"
    if (line == "/* STARTER") return "starter"
    if (line == "/* END SOLUTION */") return "end"
    if (line == "END SOLUTION */") return "end of starter"
    return "unknown"
}

function find_step(file) {
    sub(/\/[^\/]*$/, "", file)
    sub(/.*\//, "", file)
    if (file !~ /^step[0-9]+_/) wrong(NR, "marks outside of a directory like step05_zbuffer")
    return substr(file, 5) + 0
}

function begin_task(number,   part_of, title) {
    title = $0
    sub(/.*BEGIN SOLUTION [^ ]+ /, "", title)
    sub(/ \*\/$/, "", title)
    split(number, part_of, ".")
    step = find_step(name)
    if (part_of[1] + 0 != step) wrong(NR, "task " number " is not one of step " step)
    if (number in titles && titles[number] != title)
        wrong(NR, "task " number " is called \"" title "\" here, but \"" titles[number] "\" before")
    titles[number] = title
    task = number
    task_line = NR
    if (part_of[2] + 0 > last) last = part_of[2] + 0
}

# Where a region leaves nothing, the empty lines around it become one, and none before a brace.
function keep(line) {
    if (line == "") {
        empty = 1
        return
    }
    if (empty && kept > 0 && line !~ /^[ \t]*[}]/) text[++kept] = ""
    empty = 0
    text[++kept] = line
}

BEGIN {
    part = "what is given"
    # Where each mark may be, and what follows it.
    place["begin"] = "what is given";      after["begin"] = "a solution"
    place["starter"] = "a solution";       after["starter"] = "a starter"
    place["end"] = "a solution";           after["end"] = "what is given"
    place["end of starter"] = "a starter"; after["end of starter"] = "what is given"
}

NR == 1 && name == "" { name = FILENAME }
{ kind = kind_of($0) }

kind == "text" {
    if (part == "a starter" && /\/\*|\*\//) wrong(NR, "a block comment in a starter: use //")
    if (part == "what is given" || part == "a " (task == undone ? "starter" : mode)) keep($0)
    next
}

kind == "unknown" { wrong(NR, "not a mark as tests/student/marks.awk knows them: " $0) }
part != place[kind] { wrong(NR, "this mark belongs in " place[kind] ", but here is " part) }
kind == "begin" { begin_task($4) }
{ part = after[kind] }

END {
    if (failed) exit 1
    if (part != "what is given") wrong(task_line, "task " task " has no END SOLUTION")
    if (mode == "tasks") {
        parts = split("- a b c d e f g h i j k l m n o p q r s t u v w x y z", part_names, " ")
        for (p = 1; p <= parts; p++)
            for (i = 1; i <= last; i++) {
                number = step (p > 1 ? part_names[p] : "") "." i
                if (number in titles) print number "\t" titles[number]
            }
    } else {
        for (i = 1; i <= kept; i++) print text[i]
    }
}
