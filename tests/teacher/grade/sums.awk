# What class.awk and page.awk know of a class, from the lines of merge.sh.
function add_name(name) {
    if (!(name in known)) {
        known[name] = 1
        names[++name_count] = name
        by = person(name)
        handed_in[by] = handed_in[by] (handed_in[by] == "" ? "" : " ") name
        late[by] = late[by] || is_late
    }
}

function group_of(one) {
    if (!(one in above)) {
        above[one] = one
        least[one] = 100
    }
    while (above[one] != one) one = above[one]
    return one
}

function join(one, other, share) {
    one = group_of(one)
    other = group_of(other)
    if (least[other] > least[one]) least[other] = least[one]
    if (share < least[other]) least[other] = share
    above[one] = other
}

# Who handed that in: the name without a word for a late or second version, as Canvas (name, LATE, number
# of the student, number of the submission) and people write it.
function person(name,    part) {
    name = tolower(name)
    sub(/\.(zip|tar|tar\.[a-z0-9]+|tgz|c)$/, "", name)
    gsub(/(%[0-7][0-9a-f]|[-_.])+/, " ", name)
    is_late = sub(/ (late|resubmission|resubmitted|corrected|v[0-9])( |$)/, " ", name)
    sub(/ $/, "", name)
    if (name ~ /^[^ ]+ [0-9]+ [0-9]+( |$)/) {
        split(name, part, " ")
        return part[1] " " part[2]
    }
    return name
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
$2 == "look" { look_at[$1] = look_at[$1] (look_at[$1] == "" ? "" : "; ") $3 }
$2 == "looks" {
    looks = $3 "\t" $4
    if (!looks_count[looks]++) looks_list[++looks_total] = looks
    looks_who[looks] = looks_who[looks] (looks_who[looks] == "" ? "" : " ") $1
}
# In each lesson those are a group that are alike, directly or through others.
$2 == "alike" {
    pair_count++
    join($4 "\t" $5, $4 "\t" $6, $3 + 0)
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

function total(name,    t, sum) {
    sum = 0
    for (t = 1; t <= task_count; t++) sum += points[name, tasks[t]]
    return sum
}

function total_most(    t, sum) {
    sum = 0
    for (t = 1; t <= task_count; t++) sum += most[tasks[t]]
    return sum
}

# The other versions by the same student, where one calls itself late.
function versions(name,    by, all, i, many, others) {
    by = person(name)
    many = late[by] ? split(handed_in[by], all, " ") : 0
    for (i = 1; i <= many; i++) if (all[i] != name) others = others (others == "" ? "" : " ") all[i]
    return others
}
