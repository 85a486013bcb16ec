# A model's text as gzip likes it. Lines that look alike follow each other, as those of all positions:
# they become what they look like, with . for 0.5 and 0 for a whole number, how many they are, and
# their columns, each number less the one above it, where 0.5 is 500000. answer.c makes the text of it again.

/^#/ { next }

{
    look = $0
    gsub(/-?[0-9]+\.[0-9]+/, ".", look)
    gsub(/-?[0-9]+/, "0", look)
    if (look != last) end_rows()
    last = look
    rows++
    gsub(/[^-.0-9]+/, " ")
    for (i = 1; i <= NF; i++) {
        number = $i ~ /\./ ? sprintf("%.0f", 1e6 * $i) : $i
        column[i, rows] = number - above[i]
        above[i] = number + 0
    }
    columns = NF
}

function end_rows(    i, row) {
    if (rows > 0) print last "\n" rows
    for (i = 1; i <= columns; i++) {
        for (row = 1; row <= rows; row++) printf "%d ", column[i, row]
        print ""
        above[i] = 0
    }
    rows = columns = 0
}

END { end_rows() }
