#!/bin/sh
# shellcheck disable=SC2034,SC2154 # the scripts that are read use and set variables
# Writes the course as web pages, in which the lessons' solutions draw under the mouse:
#
#     site.sh BUILD OUT
#
# OUT is a directory that is not there yet, or empty. Each text of README.md and of the lessons
# becomes a page next to its pictures. Pages work from disk as from any server, and without scripts;
# they load nothing from elsewhere. Solutions are there only as compiled code, in live/program.js.
# BUILD has the models, and the programs of `make live`: what they can draw is known by them.
#
# Exit status: 0 done; 1 it cannot be done, and OUT is as it was; 2 wrong usage; 77 a tool is missing.

cd "$(dirname "$0")/../../.." || exit 1
target=site
build=$1
out=$2
wanted=
. tests/student/lesson.sh
. tests/student/marked.sh
. tests/teacher/handout/out.sh

compile="clang --target=wasm32-wasi -Os -msimd128 -std=c17 -ffp-contract=off -fno-math-errno -Wno-psabi
    -Icommon"
missing=
for tool in cmark-gfm cwebp clang wasm-ld; do
    command -v $tool >/dev/null || missing="$missing $tool,"
done
echo 'int main(void) { return 0; }' | $compile -x c - -o /dev/null 2>/dev/null || missing="$missing WebAssembly for clang,"
[ -z "$missing" ] || fail 77 "there is no${missing%,} here; on Debian: apt-get install" \
    cmark-gfm webp clang lld wasi-libc libclang-rt-dev-wasm32
begin_out "$(mktemp -d)"

# ---- Texts and pictures ----

texts=README.md
for directory in tests/student $lessons; do
    texts="$texts $directory/README.md $(find "$directory" -name '[!R]*.md' | sort)"
done
# shellcheck disable=SC2086 # one word a file
{
    printf '%s\n' $texts
    grep -oE '(src="|\]\()[^")]*\.(png|svg)' README.md | sed 's/^src="//; s/^](//'
} | put_all
finish_texts

# What a picture's title says of a living figure must be something that the lesson's program can do.
for lesson in $lessons; do
    texts_of="$lesson/*.md $(grep -l "src=.$lesson/.*\"live: " README.md)"
    # shellcheck disable=SC2086 # one word a file
    "$build/moving/$lesson" --live </dev/null |
        awk -f tests/teacher/site/figures.awk - $texts_of ||
        fail 1 "$lesson shows a living figure that its program cannot draw"
done

# The sizes of all pictures: a PNG has them in bytes 16 to 23, an SVG in its first element.
(cd "$new" && find . -name '*.png' -o -name '*.svg') | while IFS= read -r picture; do
    case $picture in
    *.png) od -An -tu1 -j16 -N8 "$new/$picture" | awk '{ print $3 * 256 + $4 "\t" $7 * 256 + $8 }' ;;
    *) sed -n 's/^<svg .* width="\([0-9]*\)" height="\([0-9]*\)".*/\1\t\2/p' "$new/$picture" ;;
    esac | awk -v picture="${picture#./}" '{ print picture "\t" $0 }'
done >"$work/sizes"

# bytes_of FILE
bytes_of() {
    wc -c <"$1"
}

# The map's, as small as a screen of twice the pixels shows them.
grep -oE 'src="[^"]*" width="80"' README.md | sed 's/^src="//; s/\.png".*//' | while IFS= read -r picture; do
    cwebp -quiet -resize 160 0 -q 85 "$picture.png" -o "$new/${picture}_small.webp" || fail 1 "cannot convert $picture"
done || exit 1

# Pictures keep every pixel, except large ones that become much smaller when they change so little that nobody sees it.
find "$new" -name '*.png' | while IFS= read -r picture; do
    exact=${picture%png}webp
    cwebp -quiet -lossless -z 8 "$picture" -o "$exact" || fail 1 "cannot convert $picture"
    if [ "$(bytes_of "$exact")" -ge 20000 ]; then
        cwebp -quiet -q 80 -m 6 -sharp_yuv "$picture" -o "$work/similar.webp" || fail 1 "cannot convert $picture"
        [ $((5 * $(bytes_of "$work/similar.webp"))) -gt $((3 * $(bytes_of "$exact"))) ] || mv "$work/similar.webp" "$exact"
    fi
    rm "$picture"
done || exit 1

# page_of TEXT: its page's address.
page_of() {
    echo "$1" | sed 's/README\.md$/index.md/; s/md$/html/'
}

for text in $texts; do
    printf '%s\t%s\n' "$(page_of "$text")" "$(sed -n '1s/^# //p' "$text")"
done >"$work/contents"
mkdir "$new/live"
for text in $texts; do
    cmark-gfm --unsafe --full-info-string -e table -e strikethrough -e autolink "$new/$text" >"$work/text" &&
        awk -v page="$(page_of "$text")" -v contents="$work/contents" -v sizes="$work/sizes" -v words="$work/words" \
            -f tests/teacher/site/page.awk "$work/text" >"$new/$(page_of "$text")" &&
        cat "$work/words" >>"$work/all_words" && rm "$new/$text" || fail 1 "cannot write the page of $text"
done
{ echo 'const words = ['; cat "$work/all_words"; echo '];'; } >"$new/live/words.js"

# ---- Programs ----

# A list as a macro of C.
names=
for lesson in $lessons; do
    names="$names X($lesson)"
    main=$lesson/main.c
    find_marked
    text solution "$work/marked" "$main" >"$work/$lesson.c" &&
        cat "tests/lessons/$lesson/live.c" >"$work/$lesson.live.c" 2>/dev/null ||
        cp "$work/$lesson.c" "$work/$lesson.live.c" || fail 1 "no solution of $lesson"
done
# shellcheck disable=SC2086 # several words
printf '%s\n' $lessons | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I @ \
    $compile -w -I@ -Itests -Itests/lessons/@ -Dmain=@_main -DMORE_MAIN=@_main "-DLESSON=\"$work/@.c\"" \
    -c "$work/@.live.c" -o "$work/@.o" &&
    $compile -mexec-model=reactor "-DLESSONS(X)=$names" -o "$work/program" \
        -Wl,--stack-first,-z,stack-size=1048576,-s,--wrap=live_loop,--wrap=stage_draw,--wrap=file_read,--wrap=file_exists,--wrap=file_find \
        -Wl,--export=start,--export=answer,--allow-undefined \
        tests/teacher/site/answer.c "$work"/*.o common/*.c common/[bfpr]*/*.c -lm || fail 1 "cannot compile the lessons"
textures='bust_diffuse bust_nm bust_spec'
{
    printf 'const lessonPrograms = {lessons: "%s".split(" "), files: "bust knot %s".split(" "), models: [' \
        "${lessons# }" "$textures" # the files as in answer.c
    for model in bust.obj knot.off; do
        printf '"%s", ' "$(awk -f tests/teacher/site/model.awk "$build/models/$model" | gzip -9n | base64 | tr -d '\n')"
    done
    printf '], program: "%s"};\n' "$(gzip -9nc "$work/program" | base64 | tr -d '\n')"
} >"$new/live/program.js"
clang -O2 -std=c17 -Icommon tests/teacher/site/texture.c "$build/quick/libcommon.a" -lm -o "$work/texture" ||
    fail 1 "cannot compile what converts textures"
for texture in $textures; do
    "$work/texture" "$build/models/$texture.tga" "$work/$texture.png" && {
        printf 'lessonPrograms.%s = "' "$texture"
        base64 <"$work/$texture.png" | tr -d '\n'
        echo '";'
    } >"$new/live/$texture.js" || fail 1 "cannot convert $texture"
done

# ---- The live page of each lesson ----

for file in tests/student/live/*.css tests/student/live/*.js tests/teacher/site/*.css tests/teacher/site/*.js; do
    case $file in */server.js | */text.js | */figures.*) ;; *) put "$file" "live/${file##*/}" ;; esac # of make live
done
policy="default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; worker-src blob:; img-src data:"
for lesson in $lessons; do
    sed -e 's|=\([a-z]*\.[cj]s*\)>|=../live/\1>|' -e "s|/server.js|/wasm.js data-lesson=$lesson|" \
        -e "s|<meta charset=utf-8>|&<meta http-equiv=Content-Security-Policy content=\"$policy\">|" \
        -e "s|^<a href=figures.html>.*|<a href=index.html target=_top>$(sed -n '1s/^# //p' "$lesson/README.md")</a>|" \
        tests/student/live/page.html >"$new/$lesson/live.html"
done
end_out
