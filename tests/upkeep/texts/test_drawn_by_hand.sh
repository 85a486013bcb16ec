#!/bin/sh
# Four figures that no program draws: are their curves, tips and numbers those of the formulas?
# shellcheck disable=SC2016 # the dollars are those of awk
. "$(dirname "$0")/../../unit/script.sh"

# The numbers of the path in a line of SVG; what is tried; how many tries there must have been.
begin='
    function points(line) { sub(/.* d="/, "", line); gsub(/[MLZ"\/>]/, " ", line); return split(line, p, " ") }
    function near(what, is, wanted) {
        tried++
        if (is < wanted - 0.06 || is > wanted + 0.06) {
            printf "%s is %s and should be %.2f\n", what, is, wanted
            failed = 1
        }
    }
    function says(number) { tried++; if (!index(text, number)) { print "nowhere: " number; failed = 1 } }
    { text = text $0 }'
end='END { exit failed || tried != tries }'

# hand FILE TRIES PROGRAM
hand() {
    said=$work/said
    awk -v tries="$2" "$begin $3 $end" "$1" >"$said" || wrong "$1"
}

# A floor from z = 1 to z = -6 with d = 2, where w = 1 - z / 2: 1/w is linear across the picture.
hand step08_projection/figures/depths.svg 247 '
    function z_at(share) { return 2 * (1 - 1 / (2 + (0.25 - 2) * share)) }
    function ndc_at(share) { return z_at(share) / (1 - z_at(share) / 2) }
    /own thick/ {
        second = curves++
        for (i = points($0) / 2 - 1; i >= 0; i--) {
            near("x", p[2 * i + 1], (second ? 340 : 50) + 230 * i / 60)
            near("y", p[2 * i + 2], second ? 145 - 47.5 * ndc_at(i / 60) : 50 + (1 - z_at(i / 60)) * 190 / 7)
        }
    }
    END { says(sprintf(">%.2f<", z_at(0.5))); says(sprintf(">%.2f<", ndc_at(0.5))); says("mixed: -2.5<") }'

# Normals 100 degrees apart, mixed at a quarter, a half and three quarters: the tips are on the chord,
# then on the arc.
hand step10_phong/figures/chord.svg 14 '
    BEGIN { half = 50 * atan2(0, -1) / 180 }
    /s1 full/ {
        points($0)
        x = 168 * sin(half) * (tips % 3 - 1) / 2
        y = 168 * cos(half)
        scale = tips >= 3 ? 168 / sqrt(x * x + y * y) : 1
        near("x", p[1], (tips++ >= 3 ? 445 : 155) + x * scale)
        near("y", p[2], 205 - y * scale)
    }
    END { says(sprintf(">%.2f<", cos(half))); says(">1.00<") }'

# The steps (0.25, 0) and (0, 1) on a texture of 16 x 8 texels, each 22 wide.
hand step06_texture/figures/steps.svg 6 '
    / full" d=/ { points($0); dx[++steps] = p[3] - p[1]; dy[steps] = p[2] - p[4] }
    END {
        near("right", dx[1], 0.25 * 16 * 22); near("right", dy[1], 0)
        near("up", dx[2], 0); near("up", dy[2], 1 * 8 * 22)
        says("0.25 * 16 = 4 texels"); says(sprintf("level %d<", log(64) / log(2) / 2))
    }'

# n upwards, l, and r = 2 (n . l) n - l, each 170 long, from (300, 220); the foot of l on n.
hand step07_gouraud/figures/foot.svg 8 '
    / full" d=/ { points($0); x[++tips] = p[1] - 300; y[tips] = 220 - p[2] }
    /<circle/ { split($0, word, "\""); near("the foot", word[4], 300); foot = word[6] }
    END {
        near("n", x[1], 0); near("n", y[1], 170)
        near("l", sqrt(x[2] * x[2] + y[2] * y[2]), 170)
        near("r", x[3], 2 * (y[2] / 170) * x[1] - x[2]); near("r", y[3], 2 * (y[2] / 170) * y[1] - y[2])
        near("the foot", 220 - foot, y[2]); near("arrows", tips, 3)
    }'

exit $failed
