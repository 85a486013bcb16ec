# A page of the site from what cmark-gfm makes of a text:
#
#     awk -v page=step05_zbuffer/index.html -v contents=FILE -v sizes=FILE -v words=FILE -f page.awk
#
# `contents` has the pages in their order, a line each: address and title, with a tab between; `sizes`
# has the pictures: address, width, height. For the search, `words` gets a row of JavaScript for each
# section: address, titles, text.

BEGIN {
    FS = "\t"
    lesson = page ~ /^step/ ? substr(page, 1, index(page, "/") - 1) : ""
    root = page
    gsub(/[^\/]*\//, "../", root)
    sub(/[^\/]*$/, "", root)
    while ((getline <contents) > 0) {
        address[++pages] = $1
        title[pages] = $2
        if ($1 == page) here = pages
    }
    while ((getline <sizes) > 0) {
        size[$1] = "width=" $2 " height=" $3 ($1 ~ /png$/ && $2 > 612 && $3 > .7 * $2 ? " class=tall" : "")
    }
}

function plain(html) {
    gsub(/<[^>]*>/, "", html)
    return html
}

# As GitHub names headings: small letters, without punctuation, blanks become hyphens.
function name_of(heading) {
    heading = tolower(plain(heading))
    gsub(/&[a-z]*;/, "", heading)
    gsub(/[!-,.\/:-@\[-^`{-~]/, "", heading)
    gsub(/ /, "-", heading)
    return heading (named[heading]++ ? "-" named[heading] - 1 : "")
}

# A heading begins a section.
function heading(line,    level, name) {
    level = substr(line, 3, 1)
    name = name_of(line)
    end_section()
    section = page (level > 1 ? "#" name : "")
    section_title = level > 1 ? plain(line) : ""
    if (level == 2) sections = sections "<li><a href=\"#" name "\">" plain(line) "</a></li>\n"
    sub(/>/, " id=\"" name "\">", line)
    return line
}

function quoted(text) {
    gsub(/\\/, "\\\\", text)
    gsub(/"/, "\\\"", text)
    gsub(/&quot;/, "\\\"", text)
    gsub(/&lt;/, "<", text)
    gsub(/&gt;/, ">", text)
    gsub(/&amp;/, "\\&", text)
    gsub(/[ \t]+/, " ", text)
    return "\"" text "\""
}

function end_section() {
    if (text != "") print "[" quoted(section) "," quoted(title[here]) "," quoted(section_title) "," quoted(text) "]," >words
    text = ""
}

# Links to texts become links to pages.
function link(line) {
    while (match(line, /href="([^":]*\/)?README\.md/)) {
        line = substr(line, 1, RSTART + RLENGTH - 10) "index.html" substr(line, RSTART + RLENGTH)
    }
    while (match(line, /href="[^":]*\.md["#]/)) {
        line = substr(line, 1, RSTART + RLENGTH - 4) "html" substr(line, RSTART + RLENGTH - 1)
    }
    return line
}

# A picture's address from the root of the site: without "..".
function address_of(source,    path) {
    path = page
    sub(/[^\/]*$/, "", path)
    path = path source
    while (sub(/[^\/]+\/\.\.\//, "", path)) {}
    return path
}

# Pictures are WebP, and say how large they are. One whose title begins with "live:" is a living figure:
# figure.js wakes it. Below the first heading pictures wait until they come into view.
function picture(line,    done, tag, source, offer) {
    while (match(line, /<img [^>]*>/)) {
        tag = substr(line, RSTART, RLENGTH)
        done = done substr(line, 1, RSTART - 1)
        line = substr(line, RSTART + RLENGTH)
        match(tag, /src="[^"]*/)
        source = address_of(substr(tag, RSTART + 5, RLENGTH - 5))
        if (tag !~ / width=/ && source in size) sub(/<img/, "<img " size[source], tag)
        if (sections != "") sub(/<img/, "<img loading=lazy", tag)
        if (tag ~ / width="80"/) sub(/\.png"/, "_small.png\"", tag) # a row of the map
        if (match(tag, / title="live: [^"]*"/)) {
            living++
            if (lesson == "") lesson = substr(source, 1, index(source, "/") - 1)
            offer = substr(tag, RSTART + 7, RLENGTH - 7)
            tag = "<figure data-live=" offer "><div class=pane>" substr(tag, 1, RSTART - 1) \
                  substr(tag, RSTART + RLENGTH) "</div></figure>"
        }
        done = done tag
    }
    line = done line
    if (line ~ /<p><figure/) gsub(/<\/?p>/, "", line)
    gsub(/\.png"/, ".webp\"", line)
    return line
}

# Words that belong to a figure (figures.awk says how they are written): figure.js makes them do so.
function touch(where, words, text) {
    return "<span data-of=" where " data-touch=\"" words "\">" text "</span>"
}

function touches(line,    done, words) {
    while (match(line, /<!-- (above|below): [^>]* -->/)) {
        done = done substr(line, 1, RSTART - 1)
        words = substr(line, RSTART + 5, RLENGTH - 9)
        line = substr(line, RSTART + RLENGTH)
        match(line, /<!-- \/ -->/)
        done = done touch(substr(words, 1, 5), substr(words, 8), substr(line, 1, RSTART - 1))
        line = substr(line, RSTART + RLENGTH)
    }
    return done line
}

# Of a block of code, each line that its fence names.
function touches_code(line,    i, count, word, tag, before) {
    if (match(line, /<pre><code[^>]* data-meta="[^"]*">/)) {
        tag = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        sub(/.*data-meta="/, "", tag)
        where = substr(tag, 1, 5)
        count = split(substr(tag, 8, length(tag) - 9), word, " ")
        for (i = 1; i <= count; i++) {
            tag = word[i]
            sub(/=.*/, "", tag)
            before = tag in parts ? parts[tag] " " : ""
            parts[tag] = before substr(word[i], length(tag) + 2)
        }
        code_line = 1
        return "<pre><code>" (1 in parts ? touch(where, parts[1], line) : line)
    }
    return ++code_line in parts && line !~ /<\/pre>/ ? touch(where, parts[code_line], line) : line
}

# Words of code in a sentence, as --no-skip, end no line at their hyphens.
function whole_words(line,    done, code) {
    while (match(line, /<code>[^<]*<\/code>/)) {
        code = substr(line, RSTART + 6, RLENGTH - 13)
        gsub(/[^ ]*-[^ ]*/, "<nobr>&</nobr>", code)
        done = done substr(line, 1, RSTART + 5) code "</code>"
        line = substr(line, RSTART + RLENGTH)
    }
    return done line
}

# The bars of a matrix's row become brackets.
function brackets(line,    done, side) {
    while (match(line, /\|/)) {
        side = side == "l" ? "r" : "l"
        done = done substr(line, 1, RSTART - 1) "<i class=\"" side (was_matrix ? "" : " t") "\">|</i>"
        line = substr(line, RSTART + 1)
    }
    return done line
}

/^<h[1-6]>/ { $0 = heading($0) }
/<pre>/ { split("", parts) }
/<pre>/, /<\/pre>/ { $0 = touches_code($0) }
/<!-- / { $0 = touches($0) }
{ text = text " " plain($0) }
/<code>[^<]*-/ && !/<pre>/ { $0 = whole_words($0) }
/<p><img [^>]*\.svg"/ { sub(/<p>/, "<p class=wide tabindex=0>") } # wider than a telephone
/<img/ { $0 = picture($0) }
/href=/ { $0 = link($0) }
page ~ /^step/ { gsub("make live STEP=" substr(page, 5, 2), "<a href=\"live.html\">&</a>") } # which is that
/<pre>/ { sub(/<pre>/, "<pre tabindex=0>") } # which may be wider than the page
/^<th[^>]*><\/th>$/ { gsub(/th/, "td") } # an empty one heads nothing
/^<tr>/ { column = 0 }
/^<th/ { head[++column] = plain($0) }
/^<td/ && /<figure/ { sub(/<td/, "<td data-label=\"" head[++column] "\"") }
/^<td/ && !/<figure/ { column++ }
/^<table>/ { $0 = "<div class=wide tabindex=0>" $0 }
{
    is_matrix = /^(<pre[^>]*><code>)?\| /
    if (is_matrix) $0 = brackets($0)
    else if (was_matrix) gsub(/<i class="./, "& b", before)
    was_matrix = is_matrix
    body = body before
    before = $0 "\n"
}
/<\/table>/ { before = before "</div>\n" }

function print_contents(    i, in_lesson) {
    if (page !~ /^step/) lesson = ""
    print "<nav id=\"contents\" aria-label=Contents>\n<ul>"
    for (i = 1; i <= pages; i++) {
        in_lesson = lesson != "" && index(address[i], lesson "/") == 1
        if (!in_lesson && !is_main(i)) continue
        print "<li" (is_main(i) ? "" : " class=part") "><a href=\"" root address[i] "\"" \
              (i == here ? " aria-current=page" : "") ">" title[i] "</a>"
        if (i == here && sections != "") printf "<ul>\n%s</ul>", sections
        print "</li>"
    }
    print "</ul>\n</nav>"
}

function is_main(i) { return address[i] !~ /^step/ || address[i] ~ /index\.html$/ }

# The first page, then the lessons; other pages are looked up.
function neighbour(step, name,    i) {
    for (i = here + step; i >= 1 && i <= pages && address[i] !~ /^(step[^\/]*\/)?index\.html$/; i += step) {}
    if (i >= 1 && i <= pages) print "<a rel=" name " href=\"" root address[i] "\">" title[i] "</a>"
}

END {
    end_section()
    body = body before
    print "<!DOCTYPE html>\n<html lang=en" (page == "index.html" ? " class=first" : "") ">\n<head>\n<meta charset=utf-8>"
    print "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; script-src 'self'" \
          (living ? " 'wasm-unsafe-eval'; worker-src blob:" : "") "; style-src 'self'; img-src 'self' data:; frame-src 'self'; base-uri 'none'; form-action 'none'\">"
    print "<meta name=viewport content=\"width=device-width,initial-scale=1\">"
    print "<meta name=referrer content=no-referrer>\n<title>" title[here] "</title>"
    print "<link rel=icon href=\"data:,\">\n<link rel=stylesheet href=\"" root "live/figure.css\">\n" \
          "<link rel=stylesheet href=\"" root "live/text.css\">\n" \
          "<link rel=stylesheet href=\"" root "live/site.css\">"
    if (living) {
        textures = page == "index.html" ? " data-textures=bust_diffuse,bust_nm,bust_spec" : ""
        print "<script defer src=\"" root "live/wasm.js\" data-lesson=" lesson textures "></script>\n<script defer src=\"" root "live/figure.js\"></script>"
    }
    print "<script defer src=\"" root "live/site.js\"></script>\n</head>\n<body>\n<header>"
    print "<a href=\"#contents\">Contents</a>"
    print "<search><input id=search type=search aria-label=\"Search the course\" placeholder=Search hidden></search>"
    print "<ol id=found hidden></ol>\n</header>\n<main>"
    if (page == "index.html") { # what comes before the map is its first screen
        at = index(body, "<h2")
        body = "<div class=stage>" substr(body, 1, at - 1) "</div>\n" substr(body, at)
    }
    printf "%s", body
    print "<nav class=neighbours aria-label=\"Next and previous\">"
    neighbour(-1, "prev")
    neighbour(1, "next")
    print "</nav>\n</main>"
    print_contents()
    print "</body>\n</html>"
}
