#!/bin/sh
# Is the page that `make open` writes complete, and does it do what its keys and buttons say? The
# second part needs chromium, and is left out where there is none.
#
# Exit status 0: all of that is so; 1: something is not.

top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
build=$(cd "$top" && cd "${CHECK_PROGRAMS:-build}" && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
unset MAKEFLAGS MFLAGS STEP SCENE DISPLAY WAYLAND_DISPLAY # of the make that runs this test
failed=0

wrong() {
    echo "open: $*"
    failed=1
}

# make_open STATUS ARGUMENT...: what is said stands in `said`.
make_open() {
    status=$1
    shift
    (cd "$top" && make -s open BUILD="$build" "$@") >"$work/said" 2>&1
    got=$?
    [ "$status" -eq $((got != 0)) ] || wrong "status $got: make open $*: $(cat "$work/said")"
}

# has COUNT TEXT: the page has the text in so many lines.
has() {
    count=$(grep -cF -e "$2" "$page")
    [ "$count" -eq "$1" ] || wrong "$count lines with $2, not $1"
}

# ---- The file ----

page=$build/pages/step01_line.html
make_open 0 STEP=01 SCENE=pixel
[ "$(tail -n 1 "$work/said")" = "$page" ] || wrong "not the page's path: $(cat "$work/said")"
has 1 '<title>step01_line</title>'
has 1 'exact: all pixels are equal'
has 3 'src="data:image/png;base64,iVBORw0KGgo'
has 0 'http:'
has 0 'https:'
make_open 0 STEP=01
has "$(find "$top/tests/reference/step01_line" -name '*.png' | wc -l)" '<section>'
make_open 1 STEP=01 SCENE=none
grep -q 'there is no scene "none" in step01_line' "$work/said" || wrong "$(cat "$work/said")"
make_open 1
grep -q 'make open: say which step' "$work/said" || wrong "$(cat "$work/said")"

page=$work/page.html
cd "$top/tests/reference" || exit 1
"$build/compare_page" "$page" '<i>"A" & '"'b'" '<scene>' step01_line/pixel.png step01_line/line.png \
    alone none.png step01_line/line.png sizes step01_line/pixel.png step03_triangle/outline.png ||
    wrong "cannot write $page"
has 2 '&lt;i&gt;&quot;A&quot; &amp; &#39;b&#39;'
has 1 '<h2>&lt;scene&gt;</h2>'
has 1 'pixels differ, the first at ('
has 1 'your picture is not there'
has 1 'yours has 100x100 pixels, the reference 200x200'
has 7 '<figure '
for arguments in "" "page title" "page title scene yours"; do
    # shellcheck disable=SC2086
    "$build/compare_page" $arguments 2>"$work/said"
    [ $? -eq 2 ] || wrong "arguments \"$arguments\" are not refused"
done
"$build/compare_page" "$work/none/page.html" title scene step01_line/pixel.png none 2>"$work/said"
[ $? -eq 1 ] || wrong "a directory that does not exist"

# ---- In a browser ----

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
if [ -z "$browser" ]; then
    echo "open: no chromium here: what the page does is not tried"
    exit $failed
fi
cat >>"$page" <<'EOF'
<script>
addEventListener('load', () => {
  const failed = [], figures = [...document.querySelectorAll('figure')].slice(0, 3);
  const expect = (what, holds) => { if (!holds) failed.push(what); };
  const seen = () => figures.filter(f => f.clientWidth > 0).map(f => f.dataset.name).join();
  const press = key => document.body.dispatchEvent(
    new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
  const image = figures[0].querySelector('img');
  expect('all side by side', seen() == 'yours,reference,difference');
  expect('enlarged by a whole number', image.width > 100 && image.width % 100 == 0);
  expect('squares', getComputedStyle(image).imageRendering == 'pixelated');
  for (const [key, names] of [['r', 'reference'], ['d', 'difference'], ['y', 'yours'],
      [' ', 'reference'], [' ', 'yours'], ['s', 'yours,reference,difference']]) {
    press(key);
    expect('key ' + key, seen() == names);
  }
  for (const name of ['yours', 'reference', 'difference']) {
    const button = document.getElementById(name);
    button.click();
    expect('button ' + name, seen() == name && button.getAttribute('aria-pressed') == 'true');
  }
  press('s');
  press('+'); press('+');
  expect('twice as large', image.width == 200);
  press('-'); press('-'); press('-');
  expect('fit', document.getElementById('zoom').textContent == 'fit');
  for (let i = 0; i < 9; i++) press('+');
  expect('32 times as large', image.width == 3200);
  const views = figures.map(f => f.querySelector('.view'));
  views[0].scrollLeft = 700;
  views[0].dispatchEvent(new Event('scroll'));
  expect('scrolled together', views[2].scrollLeft == 700);
  views[0].scrollLeft = 52 * 32;
  const box = image.getBoundingClientRect();
  image.dispatchEvent(new MouseEvent('mousemove', {bubbles: true,
    clientX: box.left + 52.5 * 32, clientY: box.top + (99 - 41 + 0.5) * 32}));
  expect('values: ' + document.getElementById('values').textContent,
    document.getElementById('values').textContent ==
      '(52,41) yours 255,0,0 reference 0,0,0  error 255');
  document.title = failed.length ? 'FAILED ' + failed.join('; ') : 'ALL RIGHT';
});
</script>
EOF
title=$("$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/browser" \
    --window-size=1200,800 --dump-dom "file://$page" 2>"$work/said" |
    sed -n 's/.*<title>\(.*\)<\/title>.*/\1/p')
[ "$title" = "ALL RIGHT" ] || wrong "in the browser: $title $(tail -n 3 "$work/said")"

exit $failed
