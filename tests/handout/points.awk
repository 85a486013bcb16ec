# The points of each task, as a table, from what the check has written of solutions.
#
#   awk -v titles=FILE -f points.awk WORK/step05_zbuffer.json...
#
# FILE has a line `5.2<TAB>title` for each task.

function text_of(name,    rest) {
    if (!match($0, "\"" name "\": \"[^\"]*\"")) return ""
    rest = substr($0, RSTART, RLENGTH - 1)
    sub(/.*"/, "", rest)
    return rest
}

function number_of(name) {
    return match($0, "\"" name "\": [0-9]+") ? substr($0, RSTART + length(name) + 4) + 0 : 0
}

function print_lesson(    i) {
    for (i = 1; i <= tasks; i++)
        print "| " lesson " | " task[i] " | " title[task[i]] " | " points[task[i]] " |" \
            shown[task[i]] " |"
    if (tasks > 0) print "| **" lesson "** | | | **" sum "** | |"
    all += sum
    tasks = sum = 0
}

BEGIN {
    FS = "\t"
    while ((getline <titles) > 0) title[$1] = $2
    print "| lesson | task | | points | shown by |\n| --- | --- | --- | ---: | --- |"
}

FNR == 1 { print_lesson() }
/^ *"step": / { lesson = text_of("step") }
/^ *{"task": / {
    task[++tasks] = text_of("task")
    points[task[tasks]] = number_of("most")
    sum += number_of("most")
}
# Its tasks are the last list of an item; what shows them is a picture, or a counter of work.
/^ *{"scene": / {
    name = text_of("scene") (text_of("counter") == "" ? "" : ": " text_of("counter"))
    match($0, /"tasks": \[[^]]*/)
    count = split(substr($0, RSTART + 10, RLENGTH - 10), of, ", ")
    for (i = 1; i <= count; i++) {
        gsub(/"/, "", of[i])
        shown[of[i]] = shown[of[i]] (shown[of[i]] == "" ? " " : "; ") name
    }
}

END {
    print_lesson()
    print "| all | | | **" all "** | |"
}
