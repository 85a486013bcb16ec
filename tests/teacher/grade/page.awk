# The class as a page (after sums.awk): who has how many points, how each task went, and what went
# wrong most often. One file without scripts; names lead to the reports next to it.
function html(text) {
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    gsub(/"/, "\\&quot;", text)
    return text
}

# A name as people write it, where its %XX are UTF-8 without control characters.
function readable(name,    text, rest) {
    text = ""
    for (rest = name; match(rest, /%[0-9A-F][0-9A-F]/); rest = substr(rest, RSTART + 3))
        text = text substr(rest, 1, RSTART - 1) letter[substr(rest, RSTART + 1, 2)]
    text = rest = text rest
    gsub(/[\302-\337][\200-\277]|[\340-\357][\200-\277][\200-\277]|[\360-\364][\200-\277][\200-\277][\200-\277]/, "", rest)
    return html(rest ~ /[\001-\037\177-\377]/ || name ~ /%(00|C2%[89])/ ? name : text)
}

# Names hold % for what is no plain letter, which a link has to say once more.
function link_to(name,    address) {
    address = name
    gsub(/%/, "%25", address)
    return "<a href=\"submissions/" address "/" (state[name] ~ /^GRADED/ ? "report.html" : "log") \
        "\"><bdi>" readable(name) "</bdi></a>"
}

function links_to(list,    i, many, name, text) {
    many = split(list, name, " ")
    for (i = 1; i <= many; i++) text = text (i > 1 ? ", " : "") link_to(name[i])
    return text
}

function class_of(state) {
    return state == "PASS" ? "pass" : state == "TODO" ? "todo" : state == "FAIL" ? "fail" : "error"
}

function print_head() {
    print "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
    print "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
    print "<title>The class</title><style>"
    print ":root { color-scheme: light dark; --pass: #1a7f37; --todo: #8c959f; --fail: #bc4c00;"
    print "    --error: #8250df; }"
    print "body { font: 15px/1.5 sans-serif; margin: 1em auto; max-width: 60em; padding: 0 1em;"
    print "    background: Canvas; color: CanvasText; }"
    print "table { border-collapse: collapse; } td, th { padding: 2px 8px; text-align: left; }"
    print "td, th { vertical-align: top; } td.number { text-align: right; white-space: nowrap; }"
    print ".wide { overflow-x: auto; } .bar { display: flex; width: min(16em, 30vw); height: 1em; margin: 4px 0; }"
    print ".pass { background: var(--pass); } .todo { background: var(--todo); }"
    print ".fail { background: var(--fail); } .error { background: var(--error); }"
    print ".key span { display: inline-block; width: 1em; height: 1em; vertical-align: -2px; }"
    print ".who { font-size: 13px; } bdi { overflow-wrap: anywhere; } td:has(bdi) { min-width: 9em; }"
    print "@media (max-width: 40em) { .wide { font-size: 13px; } td, th { padding: 2px 4px; } }"
    print "</style></head><body><main>\n<h1>The class</h1>"
}

# A table in a box of its own, which may be wider than the page: its heading.
function open_table(titles,    i, many, title) {
    printf "<div class=\"wide\"><table>\n<tr>"
    many = split(titles, title, ",")
    for (i = 1; i <= many; i++) printf "<th>%s</th>", title[i]
    print "</tr>"
}

function print_points(    n, i, all, least, row) {
    all = total_most()
    print "<h2>Points</h2>\n<table>"
    for (n = 1; n <= name_count; n++)
        bin[all > 0 ? int(total(names[n]) * 9.999 / all) : 0]++
    for (i = 0; i < 10; i++) {
        least = int((all * i + 9) / 10)
        printf "<tr><td class=\"number\">%d to %d</td><td class=\"number\">%d</td>", least,
            i == 9 ? all : int((all * (i + 1) + 9) / 10) - 1, bin[i]
        printf "<td><div class=\"bar\"><span class=\"pass\" style=\"flex: %d\"></span>", bin[i]
        printf "<span style=\"flex: %d\"></span></div></td></tr>\n", name_count - bin[i]
    }
    print "</table>"
}

function print_tasks(    t, n, i, task, name, sum, count, kinds, kind) {
    split("pass todo fail error", kinds, " ")
    print "<h2>Tasks</h2>\n<p class=\"key\"><span class=\"pass\"></span> passed"
    print "<span class=\"todo\"></span> still to do <span class=\"fail\"></span> wrong"
    print "<span class=\"error\"></span> does not build, crashes or takes too long</p>"
    open_table("task,lesson,mean,of,how it went")
    for (t = 1; t <= task_count; t++) {
        task = tasks[t]
        sum = 0
        split("", count)
        for (n = 1; n <= name_count; n++) {
            name = names[n]
            sum += points[name, task]
            if ((name, task) in task_state) count[class_of(task_state[name, task])]++
        }
        printf "<tr><td>%s</td><td>%s</td><td class=\"number\">%.1f</td>" \
            "<td class=\"number\">%d</td>", task, step_of[task], sum / name_count, most[task]
        printf "<td><div class=\"bar\" role=\"img\" aria-label=\"%d passed, %d to do, %d wrong, %d with an error\">", count["pass"],
            count["todo"], count["fail"], count["error"]
        for (i = 1; i <= 4; i++) {
            kind = kinds[i]
            if (count[kind])
                printf "<span class=\"%s\" title=\"%d\" style=\"flex: %d\"></span>", kind,
                    count[kind], count[kind]
        }
        print "</div></td></tr>"
    }
    print "</table></div>"
}

function print_looks(    i, k, best, part, who, many, shown) {
    if (looks_total == 0) return
    print "<h2>Most frequent diagnoses</h2>"
    open_table("how many,lesson,diagnosis")
    for (shown = 0; shown < 20; shown++) {
        best = ""
        for (k = 1; k <= looks_total; k++)
            if (looks_count[looks_list[k]] > looks_count[best]) best = looks_list[k]
        if (best == "") break
        split(best, part, "\t")
        many = split(looks_who[best], who, " ")
        printf "<tr><td class=\"number\">%d</td><td>%s</td><td>looks like %s<div class=\"who\">",
            looks_count[best], html(part[1]), html(part[2])
        for (i = 1; i <= many && i <= 8; i++) printf "%s%s", (i > 1 ? ", " : ""), link_to(who[i])
        print (many > 8 ? " and others" : "") "</div></td></tr>"
        looks_count[best] = 0
    }
    print "</table></div>"
}

# The largest groups first.
function print_groups(    one, root, best, shown, lesson, count) {
    print "<h2>Submissions that are alike</h2>"
    for (one = 1; one <= not_compared_count; one++) print "<p>" readable(not_compared[one]) "</p>"
    if (pair_count == 0) return
    print "<p>Each of a group shares at least this part of its text with another one of it. Names, numbers, comments,"
    print "white space and the lines of the starter don't count. Look at both before you judge: in a short task right"
    print "programs are often alike, and a large group says so."
    print "<a href=\"similar.csv\">similar.csv</a> has all pairs (" pair_count "). The lines that"
    print "agree: <code>sim_c -r 16 -d submissions/ONE/sources/LESSON/main.c"
    print "submissions/OTHER/sources/LESSON/main.c</code></p>"
    open_table("lesson,how many,shared,who")
    for (one in above) {
        root = group_of(one)
        lesson[root] = substr(one, 1, index(one, "\t") - 1)
        count[root]++
    }
    for (shown = 0; shown < 50; shown++) {
        best = ""
        for (root in count) if (count[root] > count[best] || count[root] == count[best] && root < best) best = root
        if (best == "") break
        printf "<tr><td>%s</td><td class=\"number\">%d</td><td class=\"number\">%d %%</td><td>", lesson[best],
            count[best], least[best]
        print members(best) "</td></tr>"
        delete count[best]
    }
    print "</table></div>"
}

# Who is in a group, in the order of the names.
function members(root,    n, one, text) {
    for (n = 1; n <= name_count; n++) {
        one = substr(root, 1, index(root, "\t")) names[n]
        if (one in above && group_of(one) == root) text = text (text == "" ? "" : ", ") link_to(names[n])
    }
    return text
}

function print_names(    n, name) {
    print "<h2>Submissions</h2>"
    open_table("submission,points," (any_hidden ? "hidden scenes," : "") "state")
    for (n = 1; n <= name_count; n++) {
        name = names[n]
        printf "<tr><td>%s</td><td class=\"number\">%d/%d</td>", link_to(name), total(name),
            total_most()
        if (any_hidden)
            printf "<td class=\"number\">%s</td>", hidden_most[name] ? hidden[name] "/" hidden_most[name] : ""
        print "<td>" html(state[name]) \
            (look_at[name] == "" ? "" : ": look at " html(look_at[name])) \
            (versions(name) == "" ? "" : "; same student: " links_to(versions(name))) "</td></tr>"
    }
    print "</table></div>"
}

END {
    for (i = 1; i < 256; i++) letter[sprintf("%02X", i)] = sprintf("%c", i)
    sort_tasks()
    print_head()
    print "<p>" name_count " submissions. <a href=\"class.csv\">class.csv</a> has their points, a"
    print "column a task.</p>"
    print_points()
    print_tasks()
    print_looks()
    print_groups()
    print_names()
    print "</main></body></html>"
}
