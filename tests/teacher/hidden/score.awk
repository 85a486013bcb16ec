# Takes the points of lessons that print stored pictures (stored.awk), and tells the score then.
#
#     awk -f stored.awk -f score.awk POINTS HIDDEN
#
# POINTS is what `check --csv` wrote, HIDDEN what the hidden scenes said.
FNR == NR {
    if (split($0, field, ",") == 5 && FNR > 1) {
        points[field[1]] += field[4]
        most[field[1]] += field[5]
    }
    next
}
/^step[^ ]*  HIDDEN / {
    split($3, share, "/")
    if (prints_stored(points[$1], most[$1], share[1], share[2])) {
        print $1 "  prints stored pictures: it counts nothing"
        points[$1] = 0
        any = 1
    }
}
END {
    for (step in most) {
        sum += points[step]
        sum_most += most[step]
    }
    if (any) printf "SCORE %d/%d\n", sum, sum_most
}
