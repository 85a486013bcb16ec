#!/bin/sh
# Does OpenGL draw lesson 8's picture? Runs what the answer to question 5 of CAMERA.md tells to run.
. "$(dirname "$0")/../../unit/script.sh"

echo '#include <EGL/egl.h>' | cc -E - >/dev/null 2>&1 ||
    skip 'apt-get install libegl-dev libgl-dev libgl1-mesa-dri'
cd "$work" || exit 1
mkdir build
ln -s "$top/common" "$top/step08_projection" .
ln -s "$build/models" "$build/libcommon.a" build
said_by 0 "$build/step08_projection" --only lookat -o build/out/step08_projection
grep -A 1 '^ *cc .*opengl\.c' step08_projection/CAMERA.md >commands
said_by 0 env LIBGL_ALWAYS_SOFTWARE=1 sh -e commands
says '0 of 640000 pixels differ'
[ -s build/opengl.tga ] || wrong 'no picture is written'
exit $failed
