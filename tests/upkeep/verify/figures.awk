# Do the tables of wrong pictures, the lists of mistakes and the pictures agree?
#
#   awk -f tests/upkeep/verify/figures.awk stepNN_name/WRONG.md stepNN_name/mistakes.txt stepMM_name/...
#
# In the table with the column `figure`, a row begins with the
# number of its figure and has its picture, `| 4 | ![words](figures/wrong_04.png) | ...`, or with
# neither, `| | | ...`, where there is nothing to see. The numbers go from 1 on; each figure is named
# by a mistake (`figure 4`), and each that a mistake names is in the table; no picture is left over.
# What is wrong is said, and the exit status is 1.

function wrong(where, what) {
    print where ": " what
    failed = 1
}

function is_there(path,    line, there) {
    there = (getline line <path) >= 0
    close(path)
    return there
}

function trimmed(text) {
    gsub(/^ +| +$/, "", text)
    return text
}

# The lesson that ends: what is left over, and what no mistake draws.
function end_lesson(    i, path) {
    if (lesson == "") {
        return
    }
    for (i = 1; i <= rows; i++) {
        if (!(i in named)) wrong(lesson "/WRONG.md", "no mistake draws figure " i)
    }
    for (i in named) {
        if (i + 0 > rows) wrong(named[i], "figure " i " is not in the table of WRONG.md")
    }
    for (i = rows + 1; i <= 99; i++) {
        path = sprintf("%s/figures/wrong_%02d.png", lesson, i)
        if (is_there(path)) wrong(path, "is in no row of the table")
    }
}

function begin_file() {
    directory = FILENAME
    sub(/\/[^\/]*$/, "", directory)
    is_table = 0
    if (directory != lesson) {
        end_lesson()
        lesson = directory
        rows = 0
        split("", named)
    }
}

# A row of the table: its number and its picture belong together.
function read_row(    cell, number, picture, path) {
    split($0, cell, "|")
    number = trimmed(cell[2])
    picture = trimmed(cell[3])
    if (number == "") {
        if (picture != "") wrong(FILENAME ":" FNR, "a picture without a number")
        return
    }
    if (number !~ /^[0-9]+$/) {
        wrong(FILENAME ":" FNR, "a row begins with neither a number nor an empty column")
        return
    }
    if (number != rows + 1) wrong(FILENAME ":" FNR, "figure " number " follows " rows)
    rows++
    path = sprintf("figures/wrong_%02d.png", rows)
    if (picture !~ /^!\[[^\]]+\]\([^)]*\)$/ || index(picture, "(" path ")") == 0) {
        wrong(FILENAME ":" FNR, "figure " number " is not ![words](" path ")")
    } else if (!is_there(lesson "/" path)) {
        wrong(FILENAME ":" FNR, path " is missing: make mistakes draws it")
    }
}

FNR == 1 { begin_file() }
/^\| figure \|/ { is_table = getline; next } # the line below it has no words
!/^\|/ { is_table = 0 }
is_table { read_row() }
FILENAME ~ /mistakes\.txt$/ && /^figure / && !($2 in named) { named[$2] = FILENAME ":" FNR }
END {
    end_lesson()
    exit failed
}
