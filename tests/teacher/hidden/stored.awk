# A lesson of which more than half of the points were got, but none of its hidden scenes, prints
# stored pictures: it counts nothing.
function prints_stored(points, most, right, tried) {
    return tried > 0 && right == 0 && 2 * points > most
}
