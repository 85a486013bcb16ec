# The points of a class in the form that a learning platform imports: the roster that it gave, with points.
#
#     awk -v roster=FILE -v column=NAME -v others=FILE -F '\t' -f sums.awk -f gradebook.awk RESULTS
#
# FILE is Moodle's grading worksheet (Identifier, Full name, Email address, ..., Grade, Maximum Grade),
# Canvas's export of its gradebook (Student, ID, SIS User ID, SIS Login ID, Section, ...), or any table
# with a heading, as CSV. A row's submission has the number, login, e-mail address (or what is before its
# @) or name of the row in its own name. NAME is the column that gets the points; without it Moodle's
# `Grade`, as a share of the maximum, Canvas's last assignment, or a new column, Points. Who handed in
# twice gets the points of the later name. `others` becomes a list of submissions that are nobody's.

# Fields of a line of CSV, in field[1], ...; how many.
function read_fields(text, field,    count, value) {
    split("", field)
    for (count = 1; ; count++) {
        if (match(text, /^"([^"]|"")*"/)) {
            value = substr(text, 2, RLENGTH - 2)
            gsub(/""/, "\"", value)
        } else {
            match(text, /^[^,]*/)
            value = substr(text, 1, RLENGTH)
        }
        field[count] = value
        text = substr(text, RLENGTH + 1)
        if (text == "") return count
        text = substr(text, 2)
    }
}

# The next row, over several lines where a field has some; false at the end.
function next_row(    line, quotes) {
    row = ""
    while ((getline line < roster) > 0) {
        sub(/\r$/, "", line)
        if (row line == "") continue
        row = row (row == "" ? "" : "\n") line
        quotes = row
        if (gsub(/"/, "", quotes) % 2 == 0) return 1
    }
    return row != ""
}

function quoted(value) {
    if (value !~ /[",\n]/) return value
    gsub(/"/, "\"\"", value)
    return "\"" value "\""
}

# Small letters and digits with one blank between; other letters are %XX, as in names of submissions.
function plain(text) {
    text = tolower(text)
    while (match(text, /[\200-\377]/)) {
        text = substr(text, 1, RSTART - 1) code[substr(text, RSTART, 1)] substr(text, RSTART + 1)
    }
    gsub(/%[0-7][0-9a-f]/, " ", text)
    gsub(/[^a-z0-9@%]+/, " ", text)
    return " " text " "
}

# How surely the field says who somebody is: 1 a number, 2 a login or address, 3 a name; 0 not at all.
function kind_of(title) {
    title = tolower(title)
    if (title ~ /^(.*id|identifier|.*number)$/) return 1
    if (title ~ /login|e-?mail|username/) return 2
    return title ~ /^(student|.*name)$/ ? 3 : 0
}

# The submission of the row, or "": of one person the last. By the surest field that somebody has; where
# that is more than one person, by none.
function submission_of(count,    kind, i, n, key, found, sum) {
    for (kind = 1; kind <= 3; kind++) {
        sum = 0
        for (i = 1; i <= count; i++) {
            key = field[i]
            if (kind_of(title[i]) != kind || key ~ /^ *$/) continue
            sub(/^Participant /, "", key)
            if (key ~ /, /) key = substr(key, index(key, ", ") + 2) " " substr(key, 1, index(key, ", ") - 1)
            else sub(/@.*/, "", key)
            for (n = 1; n <= name_count; n++)
                if (index(known_as[n], plain(key)) || kind == 3 &&
                    (index(known_as[n], plain(field[i])) || index(known_as[n], squeezed(field[i])))) {
                    if (sum == 0 || person(names[n]) != person(found)) sum++
                    found = names[n]
                }
        }
        if (sum == 1) return found
        if (sum > 1) return ""
    }
    return ""
}

# "Doe, Jane" as Canvas names files: doejane.
function squeezed(text) {
    text = plain(text)
    gsub(/ /, "", text)
    return " " text " "
}

END {
    if (!next_row()) {
        print "make grade: ROSTER=" roster " is empty or not there" > "/dev/stderr"
        exit 1
    }
    sub(/^\357\273\277/, "", row)
    for (i = 128; i < 256; i++) code[sprintf("%c", i)] = sprintf("%%%02x", i)
    for (n = 1; n <= name_count; n++) known_as[n] = plain(person(names[n]))
    columns = read_fields(row, title)
    for (i = 1; i <= columns; i++) {
        if (title[i] == (column == "" ? "Grade" : column)) goal = i
        if (title[i] == "Maximum Grade") maximum = i
    }
    for (i = columns; i > 1 && !goal && column == "" && title[1] == "Student"; i--)
        if (title[i] ~ /\([0-9]+\)$/) goal = i # an assignment of Canvas
    if (!goal) title[goal = ++columns] = column == "" ? "Points" : column
    for (count = 0; next_row(); rows_of[person(whose[count])]++) {
        text[++count] = row
        read_fields(row, field)
        whose[count] = submission_of(columns)
    }
    for (r = 0; r <= count; r++) { # the first is the heading
        if (r > 0) {
            read_fields(text[r], field)
            name = whose[r]
            if (name != "" && rows_of[person(name)] == 1) { # and not two people's
                taken[person(name)] = 1
                share = field[maximum] + 0 > 0 && title[goal] == "Grade" ? field[maximum] / total_most() : 1
                field[goal] = sprintf("%.2f", total(name) * share)
                sub(/\.?0+$/, "", field[goal])
                if (field[goal] == "") field[goal] = 0
            }
        }
        for (i = 1; i <= columns; i++) printf "%s%s", (i > 1 ? "," : ""), quoted(r == 0 ? title[i] : field[i])
        printf "\n"
    }
    for (n = 1; n <= name_count; n++) if (!(person(names[n]) in taken)) print names[n] > others
}
