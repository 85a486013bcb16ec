#!/bin/sh
# Says make in a clear word what a machine lacks? Without a compiler, a directory for temporary files,
# a place to write to, or GNU make; and where main.c has no marks for make test.
. "$(dirname "$0")/../unit/script.sh"

said_by 1 make CC=no_such_compiler
says 'there is no C compiler called no_such_compiler'
says 'apt-get install gcc'
said_by 0 make -s CC=no_such_compiler help

: >"$work/file"
said_by 1 make BUILD="$work/file/build" programs
says "name another directory, for example make BUILD="
said_by 0 make -s BUILD="$work/file/build" help

echo 'all check: ; @echo TMPDIR is $$TMPDIR' >"$work/room.mk"
sed 's|^include $(ROOMS)|include room.mk|; s|tests/student/machine|'"$top"'/&|; s|^all:.*|build:|' Makefile >"$work/Makefile" || exit 1
said_by 0 env TMPDIR="$work/nowhere" make -s -C "$work" check
says "TMPDIR=$work/nowhere is no directory"
says 'TMPDIR is /tmp'
said_by 0 make -s -C "$work" check TMPDIR="$work/nowhere"
says 'TMPDIR is /tmp'
said_by 0 env TMPDIR="$work" make -s -C "$work" check
says "TMPDIR is $work"

mkdir -p "$work/step01_line" && : >"$work/step01_line/README.md" && : >"$work/step01_line/main.c" &&
    sed -n '/^marked:/,/^$/p' tests/upkeep/upkeep.mk >>"$work/room.mk" || exit 1
said_by 1 make -s -C "$work" marked
says 'step01_line/main.c has lost its marks'
cp step01_line/main.c "$work/step01_line" && said_by 0 make -s -C "$work" marked

# A compiler that builds for Windows, which draws and checks, and leaves the rest to WSL.
printf '#!/bin/sh\necho x86_64-w64-mingw32\n' >"$work/gcc" && chmod +x "$work/gcc" || exit 1
said_by 1 make CC="$work/gcc" show
says 'make show needs WSL'
said_by 1 make CC="$work/gcc" check SANITIZE=1
says 'make SANITIZE=1 needs WSL'
said_by 0 make -s CC="$work/gcc" -n programs
said_by 1 make CC="$work/gcc" BUILD="$work/build" check
silent 'needs WSL'
if [ "$(uname -s)" = Linux ] && ! grep -qs '^magic 4d5a' /proc/sys/fs/binfmt_misc/*; then
    says 'runs on Windows, and not here'
fi

# One that takes other options, as tcc does, and one that computes in long double, as gcc -m32 does.
printf '#!/bin/sh\necho "invalid option -- -MMD" >&2\nexit 1\n' >"$work/gcc"
said_by 1 make CC="$work/gcc" programs
says 'does not take the options of gcc and clang'
printf '#!/bin/sh\necho "#define __FLT_EVAL_METHOD__ 2"\n' >"$work/gcc"
said_by 1 make CC="$work/gcc" programs
says 'add -msse2 -mfpmath=sse'

# Sums stay in their order, whatever CFLAGS say.
said_by 0 make -sBn CFLAGS='-Ofast -ffast-math -fassociative-math' programs
silent 'fast'
silent 'associative'

if command -v bmake >/dev/null; then
    bmake check >"$work/said" 2>&1 && wrong "bmake makes it"
    said=$work/said
    says 'use gmake'
    [ "$(wc -l <"$said")" -le 2 ] || wrong "bmake says more"
fi
exit $failed
