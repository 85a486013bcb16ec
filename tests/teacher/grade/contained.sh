# shellcheck shell=sh disable=SC2154 # build is set by who reads this
# By what contain.sh shuts programs in, on this machine: sets CONTAIN_BY, unless it is set
# (CONTAIN_BY=nothing does without). Read with `.` in the course's root, after `build` is set.
find_container() {
    for by in bwrap unshare; do
        # shellcheck disable=SC2016 # for that shell
        said=$(cd "$1" && CONTAIN_BY=$by CONTAIN_COURSE=$PWD CONTAIN_BUILD=$PWD CONTAIN_SECRET='' \
            sh "$2/tests/teacher/grade/contain.sh" sh -c 'echo works >"$PWD/x" && cat "$PWD/x"' 2>/dev/null)
        [ "$said" != works ] || return
    done
    by=nothing
}

# What is not kept from programs here, in one line; nothing when all of it is.
contain_note() {
    case $CONTAIN_BY in
    unshare) echo "Graded without bwrap: programs could read files outside of the course." ;;
    nothing) echo "Graded without bwrap and unshare: programs could use the network, read the" \
        "references and any file, write outside of their directory, and end the check." ;;
    esac
}

# The check starts it itself, also where a checkout has lost what makes it a program.
[ -x tests/teacher/grade/contain.sh ] || chmod +x tests/teacher/grade/contain.sh
if [ -z "$CONTAIN_BY" ]; then
    probe=$(mktemp -d "$build/contain.XXXXXX") && probe=$(cd "$probe" && pwd) &&
        mkdir "$probe/common" "$probe/models" "$probe/quick" && : >"$probe/quick/libcommon.a" || exit 1
    find_container "$probe" "$PWD"
    CONTAIN_BY=$by
    rm -rf "$probe"
fi
export CONTAIN_BY
