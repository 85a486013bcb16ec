# The class as a table (after sums.awk): a row a submission, its state, its points, hidden scenes
# where they were drawn, and a column a task. What has no result of a task has an empty field there.
END {
    sort_tasks()
    printf "submission,state,points,most"
    if (any_hidden) printf ",hidden,hidden_most"
    for (t = 1; t <= task_count; t++) printf ",%s", tasks[t]
    printf ",reason\n"
    for (n = 1; n <= name_count; n++) {
        name = names[n]
        word = reason = state[name]
        sub(/ .*/, "", word)
        if (!sub(/^[A-Z]+ /, "", reason)) reason = ""
        if (look_at[name] != "") reason = "look at " look_at[name]
        if (versions(name) != "") reason = reason (reason == "" ? "" : "; ") "same student: " versions(name)
        gsub(/"/, "\"\"", reason)
        printf "%s,%s,%d,%d", name, word, total(name), total_most()
        if (any_hidden) printf ",%d,%d", hidden[name], hidden_most[name]
        for (t = 1; t <= task_count; t++)
            printf ",%s", (name, tasks[t]) in points ? points[name, tasks[t]] : ""
        printf ",%s\n", reason == "" ? "" : "\"" reason "\""
    }
}
