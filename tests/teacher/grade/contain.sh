#!/bin/sh
# Runs a command that nobody trusts where it can do no harm: contain.sh COMMAND ARGUMENT...
#
# COMMAND is the program of a submission, or the compiler with a submission's source. It may write
# the directory that it runs in and no other; CONTAIN_WRITES names another one. It reads the system,
# its own file, and of the course common, the lessons' headers, the library and the models: no
# reference, no solution, no other submission. No network, no terminal, no other's processes, no
# variables. It ends with the command's status, or 128 and the number of the signal that ended it.
#
# CONTAIN_BY says by what: `bwrap` does all of this; `unshare` hides the course's secrets and lets
# nothing be written, but other files can be read; `nothing` just runs the command.
# CONTAIN_COURSE and CONTAIN_BUILD are absolute: the course and its build directory; CONTAIN_SECRET
# are directories, each on its own line, that unshare is to hide besides.
#
# Started by root, each command runs as a user of its own, whose processes can be counted: one that
# forks without end leaves the others theirs. Started by anyone else, it is the root of a namespace,
# which is nobody outside.
writes=${CONTAIN_WRITES:-$PWD}
perturb=MALLOC_PERTURB_=$MALLOC_PERTURB_ # by the check: see tests/check/run_posix.c
program=$1
small=67108864 # bytes of what is kept in memory for it to write

# What the command runs under in the end: no powers, so many processes, so much memory.
# A compiler has less already.
limits="prlimit"
# shellcheck disable=SC3045 # not in POSIX, but in every sh
[ "$(ulimit -v)" != unlimited ] || limits="$limits --as=4294967296"
powerless="--no-new-privs --inh-caps=-all --bounding-set=-all"
root=
if [ "$(id -u)" -eq 0 ]; then
    root=yes
    user=$((61184 + $$ % 4336)) # systemd keeps these numbers free for such users
    chown -R -h $user "$writes" 2>/dev/null && chmod 755 "$writes"
    if [ -d "${PWD%/*}/input" ]; then # see below
        chmod a+x "${PWD%/*}" && chmod -R a+rX "${PWD%/*}/input"
    fi
    limits="$limits --nproc=512"
    powerless="--reuid=$user --regid=$user --clear-groups $powerless"
fi

# Arguments are put in front of those that are there, so this is to be read from the end.
contain_by_bwrap() {
    # shellcheck disable=SC2086 # lists of words
    set -- --remount-ro /dev --remount-ro / --chdir "$PWD" $limits setpriv $powerless "$@"
    # What a program draws may lie next to where it draws: see tests/check/unseen.h.
    set -- --ro-bind "$CONTAIN_COURSE/common" "$CONTAIN_COURSE/common" \
        --ro-bind "$CONTAIN_BUILD/quick/libcommon.a" "$CONTAIN_BUILD/quick/libcommon.a" \
        --ro-bind "$CONTAIN_BUILD/models" "$CONTAIN_BUILD/models" \
        --ro-bind-try "$program" "$program" \
        --ro-bind-try "${PWD%/*}/input" "${PWD%/*}/input" --bind "$writes" "$writes" "$@"
    for header in "$CONTAIN_COURSE"/step*/*.h; do
        [ ! -f "$header" ] || set -- --ro-bind "$header" "$header" "$@"
    done
    # Directories that only lead to these would be for root alone.
    for path in "$CONTAIN_COURSE"/step*/scenes.h "$CONTAIN_BUILD/models" "$CONTAIN_BUILD/quick/libcommon.a" \
        "$program" "$writes"; do
        while [ "${path#/*/}" != "$path" ] && path=${path%/*}; do
            set -- --perms 0755 --dir "$path" "$@"
        done
    done
    if [ -n "$root" ]; then
        set -- --unshare-ipc --unshare-pid --unshare-net --unshare-uts --cap-drop ALL \
            --cap-add CAP_SETUID --cap-add CAP_SETGID --cap-add CAP_SETPCAP "$@"
    else
        set -- --unshare-all --cap-drop ALL "$@"
    fi
    set -- --perms 0755 --dir /etc --ro-bind-try /etc/alternatives /etc/alternatives \
        --ro-bind-try /etc/ld.so.cache /etc/ld.so.cache "$@"
    exec env -i PATH="$PATH" LC_ALL=C TMPDIR="$writes" "$perturb" \
        bwrap --die-with-parent --new-session --ro-bind /usr /usr \
        --ro-bind-try /bin /bin --ro-bind-try /lib /lib --ro-bind-try /lib32 /lib32 \
        --ro-bind-try /lib64 /lib64 --ro-bind-try /opt /opt \
        --proc /proc --dev /dev --size $small --tmpfs /dev/shm --size $small --tmpfs /tmp "$@"
}

# Inside its namespaces: nothing can be written but what may, of the devices only those are left
# that hold nothing.
# shellcheck disable=SC2016 # expanded there
inside='
    writes=$1 course=$2 secret=$3
    shift 3
    while read -r _ at _; do
        case $at in *\\*) at=$(printf %b "$at") ;; esac # a blank is \040 there
        mount -n -o remount,bind,ro "$at" 2>/dev/null
    done </proc/self/mounts
    mount -n --bind "$writes" "$writes" && mount -n -o remount,bind,rw "$writes" &&
        mkdir "$writes/.dev" && mount -n -t tmpfs none "$writes/.dev" || exit 126
    for device in null zero full random urandom; do
        : >"$writes/.dev/$device" && mount -n --bind "/dev/$device" "$writes/.dev/$device" ||
            exit 126
    done
    mount -n --move "$writes/.dev" /dev && rmdir "$writes/.dev" || exit 126
    printf "%s\n" "$course/tests" "$course/.git" "$secret" | while IFS= read -r hidden; do
        [ ! -d "$hidden" ] || mount -n -t tmpfs -o ro none "$hidden" || exit 126
    done || exit 126
    for hidden in "$course"/step*/main.c "$course"/step*/main.c.marked; do
        [ ! -f "$hidden" ] || mount -n --bind /dev/null "$hidden" || exit 126
    done
    cd "$PWD" || exit 126
    "$@"
    exit $?'

contain_by_unshare() {
    namespace=
    [ -n "$root" ] || namespace="--user --map-root-user"
    # shellcheck disable=SC2086
    exec env -i PATH="$PATH" LC_ALL=C TMPDIR="$writes" "$perturb" \
        unshare $namespace --mount --pid --fork --kill-child --mount-proc --ipc \
        --net --uts sh -c "$inside" contain "$writes" "$CONTAIN_COURSE" \
        "$CONTAIN_SECRET" $limits setpriv $powerless "$@"
}

case $CONTAIN_BY in
bwrap) contain_by_bwrap "$@" ;;
unshare) contain_by_unshare "$@" ;;
*) exec "$@" ;;
esac
