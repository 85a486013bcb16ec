# How far from the limits of each scene the correct programs stay, and how far beyond them the
# mistakes that name it are.
#
#   awk -v lighter=1250 -f limits.awk tests/check/scenes.txt WORK/shares
#
# Prints for each scene its limits (wrong, apart, coverage, and near where there is one), each with the
# most that a correct program reaches, in percent of the drawn pixels; by how many levels a correct
# program is too light or too dark at most (the limit is `lighter` thousandths for all scenes); and the
# mistake that is least beyond the limits, with how many times one of them it reaches.

# How many times the limit is that? Beyond a limit of 0 infinitely many, here a thousand.
function times(share, limit) {
    return limit > 0 ? share / limit : share > 0 ? 1000 : 0
}

function absolute(x) {
    return x < 0 ? -x : x
}

BEGIN { lighter /= 1000 }

FNR == NR {
    sub(/#.*/, "")
    if ((NF == 7 || NF == 8) && $1 != "work" && $1 != "same") {
        key = $1 " " $2
        order[++count] = key
        for (i = 1; i <= 3; i++) limit[key, i] = $(4 + i)
        limit[key, 4] = NF == 8 ? $8 : 100
        limit[key, 5] = lighter
    }
    next
}

{ key = $3 " " $4 }
!((key, 1) in limit) { next }

$1 == "accept" {
    accepted[key]++
    for (i = 1; i <= 5; i++) {
        if (absolute($(4 + i)) > most[key, i]) {
            most[key, i] = absolute($(4 + i))
            who[key, i] = $2
        }
    }
}
$1 == "mistake" {
    beyond = 0
    for (i = 1; i <= 5; i++) {
        reached = times(absolute($(4 + i)), limit[key, i])
        if (reached > beyond) beyond = reached
    }
    if (beyond <= 1) next # it fails for another reason: a crash, too much work
    if (!(key in least) || beyond < least[key]) { least[key] = beyond; nearest[key] = $2 }
}

# A limit and the most of a correct program, with its name.
function column(limit, key, i) {
    if (!(key in accepted)) return sprintf("%-5s %-30s", limit, "-")
    if (!((key, i) in who)) return sprintf("%-5s %-30s", limit, 0)
    return sprintf("%-5s %-30s", limit, sprintf("%.3f %.22s", most[key, i], who[key, i]))
}

END {
    printf "%-30s%-36s%-36s%-36s%-36s%-36s%s\n", "scene", "wrong: limit, most", "apart: limit, most", \
        "coverage: limit, most", "near: limit, most", "lighter: limit, most", "nearest mistake"
    for (k = 1; k <= count; k++) {
        key = order[k]
        if (!(key in accepted) && !(key in least)) continue
        printf "%-30s", key
        for (i = 1; i <= 5; i++) printf "%s", column(limit[key, i], key, i)
        print key in least ? sprintf("%.1f times %s", least[key], nearest[key]) : "-"
    }
}
