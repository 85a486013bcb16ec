# What class.awk and page.awk know of a class, from the lines of merge.sh.
function add_name(name) {
    if (!(name in known)) {
        known[name] = 1
        names[++name_count] = name
    }
}

function add_task(task) {
    if (!(task in task_known)) {
        task_known[task] = 1
        tasks[++task_count] = task
    }
}

$2 == "state" { add_name($1); state[$1] = $3 }
$2 == "seconds" { seconds[$1] = $3 }
$2 == "task" {
    add_task($4)
    step_of[$4] = $3
    task_state[$1, $4] = $5
    points[$1, $4] = $6
    most[$4] = $7
}
$2 == "hidden" {
    hidden[$1] += $4
    hidden_most[$1] += $5
    any_hidden = 1
}
$2 == "stored" { stored[$1, $3] = 1 }
$2 == "looks" {
    looks = $3 "\t" $4
    if (!looks_count[looks]++) looks_list[++looks_total] = looks
    looks_who[looks] = looks_who[looks] (looks_who[looks] == "" ? "" : " ") $1
}
$2 == "alike" {
    pair = $5 "\t" $6
    if (!(pair in alike)) pairs[++pair_count] = pair
    alike[pair] += $3
    alike_in[pair] = alike_in[pair] (alike_in[pair] == "" ? "" : ", ") $4 " " $3 " %"
}
$2 == "not_compared" { not_compared[++not_compared_count] = $3 }

# Tasks of different submissions come in different orders: sort them by lesson, part and number.
function sort_tasks(    i, k, task) {
    for (i = 2; i <= task_count; i++) {
        task = tasks[i]
        for (k = i - 1; k > 0 && task_key(tasks[k]) > task_key(task); k--) tasks[k + 1] = tasks[k]
        tasks[k + 1] = task
    }
}

# 8b.2 as 008b002
function task_key(task,    part) {
    split(task, part, ".")
    return sprintf("%03d%s%03d", part[1] + 0, substr(part[1], length(part[1] + 0 "") + 1), part[2])
}

function points_of(name, task) {
    return stored[name, step_of[task]] ? 0 : points[name, task] + 0
}

function total(name,    t, sum) {
    sum = 0
    for (t = 1; t <= task_count; t++) sum += points_of(name, tasks[t])
    return sum
}

function total_most(    t, sum) {
    sum = 0
    for (t = 1; t <= task_count; t++) sum += most[tasks[t]]
    return sum
}
