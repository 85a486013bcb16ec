# shellcheck shell=sh
# encode TEXT: a name of a submission as it is in results: letters, digits and .-_ as they are,
# everything else as %XX, also a first character that a shell or a table would obey. Read with `.`.
encode() {
    printf '%s' "$1" | od -An -v -tx1 | tr 'a-f' 'A-F' | awk '
        BEGIN { for (i = 32; i < 127; i++) letter[sprintf("%02X", i)] = sprintf("%c", i) }
        { for (i = 1; i <= NF; i++) {
            plain = ++count == 1 ? "^[A-Za-z0-9_]$" : "^[A-Za-z0-9._-]$"
            printf "%s", letter[$i] ~ plain ? letter[$i] : "%" $i } }'
}
