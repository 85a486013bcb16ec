#!/bin/sh
# Is the page that `make open` writes complete? What it does is tried in a browser:
# tests/upkeep/browser.
. "$(dirname "$0")/../unit/script.sh"

make_open() { # STATUS ARGUMENT...
    status=$1
    shift
    said_by "$status" make -s open BUILD="$build" "$@"
}

# has COUNT TEXT: the page has the text in so many lines.
has() {
    count=$(grep -cF -e "$2" "$page")
    [ "$count" -eq "$1" ] || wrong "$count lines with $2, not $1"
}

page=$build/pages/step01_line.html
make_open 0 STEP=01 SCENE=pixel
[ "$(tail -n 1 "$said")" = "$page" ] || wrong "not the page's path"
has 1 '<title>step01_line</title>'
has 1 '<p>exact</p>'
has 3 'src="data:image/png;base64,iVBORw0KGgo'
has 0 'http:'
has 0 'https:'
make_open 0 STEP=01
has "$(find tests/reference/step01_line -name '*.png' | wc -l)" '<section>'
make_open 1 STEP=01 SCENE=none
says 'there is no scene "none" in step01_line'
make_open 1
says 'make open: say which step'

page=$work/page.html
cd tests/reference || exit 1
said_by 0 "$build/compare_page" "$page" '<i>"A" & '"'b'" '<scene>' step01_line/pixel.png \
    step01_line/line.png alone none.png step01_line/line.png \
    sizes step01_line/pixel.png step03_triangle/outline.png
has 2 '&lt;i&gt;&quot;A&quot; &amp; &#39;b&#39;'
has 1 '<h2>&lt;scene&gt;</h2>'
has 1 'pixels differ, the first wrong one at ('
has 1 'there is no picture of yours'
has 1 '100x100 pixels, not 200x200'
has 7 '<figure '
for arguments in "" "page title" "page title scene yours"; do
    # shellcheck disable=SC2086 # several words, or none
    said_by 2 "$build/compare_page" $arguments
done
said_by 1 "$build/compare_page" "$work/none/page.html" title scene step01_line/pixel.png none

# ---- Which browser ----

said=

# opens WANTED PROGRAM...: browse.sh calls one of these so; wslpath names files as Windows does.
mkdir "$work/bin" && for tool in sh uname; do ln -s "$(command -v $tool)" "$work/bin/$tool"; done
opens() {
    wanted=$1
    shift
    for program; do
        printf '#!/bin/sh\necho "${0##*/} $*" >%s/opened\n' "$work" >"$work/bin/$program"
        [ "$program" != wslpath ] || printf '#!/bin/sh\necho "W:$2"\n' >"$work/bin/wslpath"
        chmod +x "$work/bin/$program"
    done
    : >"$work/opened"
    env PATH="$work/bin" sh "$top/tests/student/browse.sh" /page
    rm -f "$work"/bin/[ewx]*
    [ "$(cat "$work/opened")" = "$wanted" ] || wrong "with $*: $(cat "$work/opened")"
}
opens 'wslview /page' wslview explorer.exe
opens 'explorer.exe W:/page' explorer.exe wslpath
opens '' xdg-open # no desktop
DISPLAY=:0
export DISPLAY
opens 'xdg-open /page' xdg-open
exit $failed
