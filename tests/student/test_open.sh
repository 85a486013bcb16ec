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
exit $failed
