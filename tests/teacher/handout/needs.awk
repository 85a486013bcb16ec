# What sources need of the others: the headers that they include, whatever these include, the sources
# of these headers, and the whole of a room of common that something is needed of.
#
#   awk -f needs.awk FILE... = SOURCE...
#
# Prints those of the FILEs (.c and .h, with their places in the course) that the SOURCEs need. A
# source belongs to the header that it includes first, unless it is a program.

# The file that `name` means in an #include of `file`; "" where it is none of the FILEs.
function included(file, name,    beside) {
    beside = file
    sub(/[^\/]*$/, name, beside)
    while (sub(/[^\/]+\/\.\.\//, "", beside));
    if (beside in is_there) return beside
    if (("common/" name) in is_there) return "common/" name
    return ("tests/" name) in is_there ? "tests/" name : ""
}

# Sets includes[file] to what the file includes, and is_program[file].
function read(file,    line, name) {
    while ((getline line <file) > 0) {
        if (line ~ /^int main\(/) is_program[file] = 1
        if (line !~ /^#include "/) continue
        split(line, part, "\"")
        name = included(file, part[2])
        if (name != "") includes[file] = includes[file] " " name
    }
    close(file)
}

function room_of(file) {
    return match(file, /^common\/[^\/]*\//) ? substr(file, 1, RLENGTH) : ""
}

function need(file) {
    if (file in is_needed) return
    is_needed[file] = 1
    needed[++needed_count] = file
}

# Everything that comes along with a needed file.
function need_others(file,    i, count, others, room) {
    count = split(includes[file], others, " ")
    for (i = 1; i <= count; i++) need(others[i])
    room = room_of(file)
    for (i = 1; i <= file_count; i++)
        if (owner[files[i]] == file || (room != "" && room_of(files[i]) == room)) need(files[i])
}

BEGIN {
    for (i = 1; ARGV[i] != "="; i++) is_there[files[++file_count] = ARGV[i]] = 1
    for (i = 1; i <= file_count; i++) {
        read(files[i])
        if (files[i] ~ /\.c$/ && !(files[i] in is_program)) {
            split(includes[files[i]], first, " ")
            owner[files[i]] = first[1]
        }
    }
    for (i = file_count + 2; i < ARGC; i++) {
        if (!(ARGV[i] in is_there)) read(ARGV[i])
        need(ARGV[i])
    }
    for (i = 1; i <= needed_count; i++) need_others(needed[i])
    for (i = 1; i <= file_count; i++) if (files[i] in is_needed) print files[i]
}
