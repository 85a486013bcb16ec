# Takes the points of lessons that print stored pictures, and tells the score then: of such a lesson
# more than half of the points were got, but none of its hidden scenes.
#
#     awk -f score.awk POINTS HIDDEN
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
    if (share[1] == 0 && share[2] > 0 && 2 * points[$1] > most[$1]) {
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
