# shellcheck shell=bash
# each FUNCTION WORD...: the function of each word, as many at a time as there are processors. What
# a function sees here is exported. Status 0 when it is that of all of them.
# shellcheck disable=SC2016 # expanded by the shell of each word
each() {
    printf '%s\n' "${@:2}" |
        xargs -n 1 -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)" bash -c "$1"' "$0"'
}
