# Takes the points of lessons that print stored pictures, and tells the score then: of such a lesson
# more than half of the points were got, but none of its hidden scenes.
#
#     awk -f report.awk -f score.awk POINTS HIDDEN
#
# POINTS is what `check --json` wrote, HIDDEN what the hidden scenes said.
FNR == NR {
    if (is_task()) {
        points[step] += number_of("points")
        most[step] += number_of("most")
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
