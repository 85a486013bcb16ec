# The points of each task, as a table, from what the check has written of solutions.
#
#   awk -v titles=FILE -f report.awk -f points.awk WORK/step05_zbuffer.json...
#
# FILE has a line `5.2<TAB>title` for each task.

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
{ lesson = step }
is_task() {
    task[++tasks] = text_of("task")
    points[task[tasks]] = number_of("most")
    sum += number_of("most")
}
is_item() {
    count = split(tasks_of(), of, ", ")
    for (i = 1; i <= count; i++) {
        gsub(/"/, "", of[i])
        shown[of[i]] = shown[of[i]] (shown[of[i]] == "" ? " " : "; ") item_name()
    }
}

END {
    print_lesson()
    print "| all | | | **" all "** | |"
}
