# Puts one C file together from what a student wrote, and what that needs.
#
#     awk -v names=FILE -v root=PREFIX -f renderer.awk given.c stepNN_name/main.c ... common/FILE ...
#
# given.c is the frame: its comments `@lesson step03_triangle triangle_setup ...: its triangles` say where
# the functions of a lesson go, with everything of that main.c that they need, and `@common geometry
# ...:` where what is needed of those files goes. Of the frame, too, comes what main() needs. Each file is taken apart into items: functions, structs, enums, constants,
# each with the comment above it. FILE says by which name later lessons know what a lesson wrote:
#
#     step03_triangle triangle_setup edges_setup
#
# What a main.c needs is looked for in itself, then in given.c, then among those names, then in common.
# All call hers as she named it. A name that stands twice gets the lesson's number behind it. What is
# still to do comes from common, where it has it under its later name.
#
# Exit status 1: something is to do, or cannot be found or read; standard error says what, and nothing is
# printed.

function complain(message) {
    print "make renderer: " message | "cat >&2"
    failed = 1
}

# The path as the student knows it.
function shown(path) { return substr(path, 1, length(root)) == root ? substr(path, length(root) + 1) : path }
function place_of(item) { return shown(file_of[item]) ":" line_of[item] }

# ---- Text without comments, strings and characters ----

# Their contents become blanks; `in_comment` goes on from line to line.
function code_of(line,    out, c, i, two, quote) {
    out = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        two = substr(line, i, 2)
        if (in_comment) {
            if (two == "*/") { in_comment = 0; i++ }
            continue
        }
        if (two == "/*") { in_comment = 1; i++; out = out " "; continue }
        if (two == "//") break
        if (c == "\"" || c == "'") {
            quote = c
            out = out c
            for (i++; i <= length(line) && substr(line, i, 1) != quote; i++) if (substr(line, i, 1) == "\\") i++
            out = out quote
            continue
        }
        out = out c
    }
    return out
}

function count(text, what) { return gsub(what, "", text) }

# ---- Items ----

# The last identifier of a text.
function last_word(text) {
    gsub(/\[[^]]*\]/, "", text)
    sub(/[^A-Za-z_0-9]*$/, "", text)
    return match(text, /[A-Za-z_][A-Za-z_0-9]*$/) ? substr(text, RSTART) : ""
}

function add_name(item, name) {
    if (name == "") return
    if (!((file, name) in own)) own[file, name] = item
    item_names[item] = item_names[item] " " name
}

# Finds what an item defines; `code` is its text on one line.
function name_item(item, code,    head, tail, tag, word, n, words, i) {
    head = code
    sub(/[{].*/, "", head)
    gsub(/__attribute__ *\(\([^)]*\)*\)\)/, "", head)
    if (code ~ /^#define/) {
        split(code, words, /[ \t(]+/)
        add_name(item, words[2])
        return
    }
    if (index(code, "{") && head ~ /\(/ && head !~ /=/ && code !~ /^typedef/) { # a function
        sub(/\(.*/, "", head)
        add_name(item, last_word(head))
        is_function[item] = 1
        return
    }
    if (code ~ /^[A-Z_]+ *\(/) { # a macro that defines something of that name
        head = code
        sub(/^[A-Z_]+ *\( */, "", head)
        match(head, /^[A-Za-z_0-9]+/)
        add_name(item, substr(head, 1, RLENGTH))
        return
    }
    if (match(head, /(struct|union|enum) +[A-Za-z_][A-Za-z_0-9]* *$/) && index(code, "{")) {
        tag = substr(head, RSTART, RLENGTH)
        gsub(/ +/, " ", tag)
        sub(/ $/, "", tag)
        add_name(item, tag)
    }
    if (head ~ /(^|[ \t])enum[ \t]*[A-Za-z_0-9]*[ \t]*$/) { # its constants
        tail = code
        sub(/^[^{]*[{]/, "", tail)
        sub(/[}][^}]*$/, "", tail)
        n = split(tail, words, ",")
        for (i = 1; i <= n; i++) {
            sub(/=.*/, "", words[i])
            add_name(item, last_word(words[i]))
        }
    }
    if (code ~ /^typedef/) {
        tail = code
        sub(/__attribute__.*/, "", tail)
        if (match(tail, /\( *\* *[A-Za-z_0-9]+ *\)/)) {
            tail = substr(tail, RSTART, RLENGTH - 1)
        } else if (tail !~ /[}]/ && match(tail, /[A-Za-z_0-9]+ *\(/)) {
            tail = substr(tail, 1, RSTART + RLENGTH - 2)
        } else sub(/;.*/, "", tail)
        add_name(item, last_word(tail))
    } else if (code ~ /=/) {
        head = code
        sub(/=.*/, "", head)
        sub(/.*[}]/, "", head)
        add_name(item, last_word(head))
    } else if (code !~ /\(/ && code ~ /^(static|const|extern)/) {
        head = code
        sub(/;.*/, "", head)
        sub(/.*[}]/, "", head)
        add_name(item, last_word(head))
    }
}

# Is the item complete that has this text, with no bracket open?
function is_complete(code,    head) {
    if (code ~ /;[ \t]*$/) return 1
    if (code !~ /[}][ \t]*$/) return 0
    head = code
    sub(/[{].*/, "", head)
    return head ~ /\(/ && head !~ /=/ && code !~ /^[ \t]*typedef/
}

function end_item(    item, code) {
    code = item_code
    gsub(/[ \t]+/, " ", code)
    sub(/^ /, "", code)
    sub(/ $/, "", code)
    item = ++item_count
    text_of[item] = lead item_text
    if (count(item_text, "\n") == 1) is_short[item] = 1
    code_of_item[item] = code
    file_of[item] = file
    line_of[item] = item_line
    if (item_text ~ /\/\/ to do [0-9]+[a-z]?\.[0-9]+/ && match(item_text, /to do [0-9]+[a-z]?\.[0-9]+/))
        to_do[item] = substr(item_text, RSTART + 6, RLENGTH - 6)
    name_item(item, code)
    last_of[file] = item
    if (!(file in first_of)) first_of[file] = item
    lead = item_text = item_code = ""
}

function read_file(    line, code, n) {
    lead = item_text = item_code = ""
    in_comment = depth = skipping = n = 0
    while ((getline line <file) > 0) {
        n++
        sub(/\r$/, "", line)
        was_comment = in_comment
        code = code_of(line)
        if (skipping || (item_code == "" && code ~ /^#if COURSE_LESSON/)) {
            skipping = code !~ /^#endif/ # what is not given yet has another name there
            continue
        }
        if (item_code == "" && code ~ /^[ \t]*$/) { # a comment, or nothing
            if (line ~ /^[ \t]*$/ && !was_comment) lead = ""
            else if (file == frame && (line ~ /@(lesson|common|frame)/ || joined)) {
                sub(/^ \*/, "", line)
                joined = joined line
                if (!in_comment) {
                    directive[item_count, ++directives[item_count]] = joined
                    joined = ""
                }
                lead = ""
            } else lead = lead line "\n"
            if (line ~ /^\/\* (----|====|(BEGIN|END) SOLUTION)/) lead = ""
            continue
        }
        if (item_code == "" && code ~ /^[ \t]*#/ && code !~ /^#define/) {
            if (code ~ /^#include "scenes.h"/) break # the rest is not hers
            if (file == frame && code ~ /^#include </) includes = includes line "\n"
            lead = ""
            continue
        }
        if (item_code == "") item_line = n
        item_text = item_text line "\n"
        item_code = item_code " " code
        depth += count(code, "[{(]") - count(code, "[})]")
        if (item_code ~ /^ #define/ ? line !~ /\\$/ : depth == 0 && is_complete(item_code)) end_item()
        if (depth < 0) break
    }
    close(file)
    if (item_code != "" || depth != 0)
        complain(shown(file) ":" item_line ": cannot be read from here on: is a bracket missing?")
}

# ---- What an item needs ----

function is_word(c) { return c ~ /[A-Za-z_0-9]/ }

# The item that a name means in a file; 0 for what is of the C library, a field or a parameter.
function resolve(from, name,    item) {
    item = 0
    if (name ~ / / && (frame, substr(name, index(name, " ") + 1)) in own) sub(/.* /, "", name) # a macro
    if ((from, name) in own) item = own[from, name]
    else if (from == frame && name in taken) return taken[name]
    else if ((frame, name) in own) return own[frame, name]
    if (from ~ /^common/ || item == 0) {
        if ((frame, name) in own) return own[frame, name]
        if (name in hers && !(hers[name] in to_do)) return hers[name]
        if (item == 0 && name in common) item = common[name]
    }
    return item
}

# Has the code a variable or a parameter of that name?
function declares(code, name) {
    gsub(/return /, "", code)
    return code ~ ("[A-Za-z_0-9] +[*]*" name " *[=;,)[]")
}

function need(item,    code, name, before, after, found, tag, i) {
    if (item in needed) return
    needed[item] = 1
    code = code_of_item[item]
    before = ""
    tag = ""
    while (match(code, /[A-Za-z_][A-Za-z_0-9]*/)) {
        before = substr(before substr(code, 1, RSTART - 1), 1)
        name = substr(code, RSTART, RLENGTH)
        code = substr(code, RSTART + RLENGTH)
        if (name == "struct" || name == "union" || name == "enum") {
            tag = name " "
            before = ""
            continue
        }
        after = code
        sub(/^[ \t]+/, "", after)
        sub(/[ \t]+$/, "", before)
        if (tag == "" && before ~ /(\.|->)$/) {
            before = ""
            continue
        }
        found = name == "LANES_INLINE" ? 0 : resolve(file_of[item], tag name) # put_item() has its own word
        # A function is called, or handed over: a variable of its name is neither.
        if (found && found != item &&
            (tag != "" || !(found in is_function) || after ~ /^\(/ ||
             (before ~ /[=,(?:&{)]$/ && after ~ /^[,);}:]/ && !declares(code_of_item[item], name))))
            { needs[item, ++need_count[item]] = found; need(found) }
        tag = before = ""
    }
}

# ---- Names ----

# Each item's names as they are written: another where one is taken already.
function settle_names(item, number,    n, words, i, name, text) {
    n = split(item_names[item], words, " ")
    for (i = 1; i <= n; i++) {
        name = words[i]
        if (name == "struct" || name == "union" || name == "enum") name = name " " words[++i]
        text = name
        if (text in written && written[text] != item && number != "") text = text "_" number
        written[text] = item
        new_name[file_of[item], name] = text
    }
}

# The text with the new names of its file.
function renamed(item,    text, out, name, from, before, tag, to) {
    text = text_of[item]
    from = file_of[item]
    out = tag = ""
    while (match(text, /[A-Za-z_][A-Za-z_0-9]*/)) {
        before = substr(text, 1, RSTART - 1)
        name = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        out = out before
        if (before !~ /^[ \t\n]*$/ || before == "") tag = ""
        to = name
        if (tag != "" && (from, tag " " name) in new_name) {
            to = new_name[from, tag " " name]
            sub(/^[a-z]+ /, "", to)
        } else if (tag == "" && before !~ /(\.|->|")$/ && (from, name) in new_name) to = new_name[from, name]
        out = out to
        tag = name == "struct" || name == "union" || name == "enum" ? name : ""
    }
    return out text
}

# ---- Putting it together ----

function put(text,    lines) {
    lines = count(text, "\n")
    total += lines
    if (is_hers) her_lines += lines
    body = body text
}

# Lines that go on behind an open bracket begin below it again, where names before it became longer.
function realigned(old, new,    olds, news, n, i, k, c, at, depth, shift, move, line, out) {
    n = split(old, olds, "\n")
    split(new, news, "\n")
    depth = 0
    for (i = 1; i < n; i++) {
        line = news[i]
        move = depth && line !~ /^ ?[\/*]/ ? shift[depth] : 0
        for (; move > 0; move--) line = " " line
        for (; move < 0 && line ~ /^ /; move++) line = substr(line, 2)
        out = out line "\n"
        at = 0
        for (k = 1; k <= length(olds[i]); k++) {
            c = substr(olds[i], k, 1)
            if (c ~ /[({]/) {
                at += index(substr(line, at + 1), c)
                shift[++depth] = k < length(olds[i]) ? at - k : 0
            } else if (c ~ /[)}]/ && depth > 0) depth--
        }
    }
    return out
}

# With a line between items, but not between those of a single line.
function put_item(item,    text) {
    text = renamed(item)
    if (file_of[item] ~ /^common/) { # all is in one file
        sub(/LANES_INLINE /, "static ", text)
        sub(/static inline /, "static ", text)
        if (item in is_function && text !~ /(^|\n)static /)
            text = text ~ /^\/\*/ ? gensub_static(text) : "static " text
    }
    put((was_short && text !~ /\n./ ? "" : "\n") realigned(text_of[item], text))
    was_short = item in is_short
}

# `static` before the first line behind the comment.
function gensub_static(text,    at) {
    at = index(text, "*/\n")
    return substr(text, 1, at + 2) "static " substr(text, at + 3)
}

function put_items(from,    item) {
    for (item = first_of[from]; item <= last_of[from]; item++) if (item in needed) put_in_order(item)
}

# Behind what it needs of common, which is in several files.
function put_in_order(item,    i) {
    if (item in is_put) return
    is_put[item] = 1
    for (i = 1; i <= need_count[item] && file_of[item] ~ /^common/; i++)
        if (file_of[needs[item, i]] ~ /^common/) put_in_order(needs[item, i])
    put_item(item)
}

function put_title(title) {
    contents = contents sprintf(" *    %2d  %s\n", ++sections, title)
    put(sprintf("\n/* ==== %d. %s ==== */\n", sections, title))
    was_short = 0
}

# "/* @lesson step03_triangle edges_setup edges_span: triangles */"
function put_directive(line,    words, title, lesson, i) {
    title = line
    sub(/^[^:]*: */, "", title)
    sub(/ *\*\/.*/, "", title)
    if (line !~ /@lesson/) {
        if (title != "") put_title(title)
        gsub(/.*@[a-z]+ *|:.*/, "", line)
        gsub(/ /, "|", line)
        for (i = 1; i <= common_count && line != ""; i++)
            if (common_file[i] ~ ("/(" line ")[.][ch]$")) put_items(common_file[i])
        return
    }
    split(line, words, /[ \t:]+/)
    lesson = words[3]
    is_hers = 1
    put_title("Lesson " number_of(lesson) ": " title)
    put_items(lesson_file[lesson])
    is_hers = 0
}

function number_of(lesson) {
    sub(/^step0*/, "", lesson)
    sub(/_.*/, "", lesson)
    return lesson
}

# The items that the frame's comments ask for.
function take(line,    n, words, i, lesson, name, item) {
    sub(/:.*/, "", line)
    n = split(line, words, /[ \t]+/)
    lesson = words[3]
    for (i = 4; i <= n; i++) {
        name = words[i]
        sub(/^struct\./, "struct ", name)
        item = (lesson_file[lesson], name) in own ? own[lesson_file[lesson], name] : 0
        if (!item || item in to_do) {
            if (item && (item in house_of) && house_of[item] in common) {
                ours = ours (ours ? ", " : "") name "() of lesson " number_of(lesson)
                taken[house_of[item]] = common[house_of[item]]
                continue
            }
            complain(lesson "/main.c: " (item ? "task " to_do[item] " is to do, in " name "()" : "there is no " name "()"))
            continue
        }
        taken[item in house_of ? house_of[item] : name] = item
    }
}

BEGIN {
    item_count = 0
    frame = ARGV[1]
    for (i = 1; i < ARGC; i++) {
        file = ARGV[i]
        if (match(file, /step[0-9]+_[a-z0-9_]+\/main\.c$/)) {
            lesson = substr(file, RSTART, RLENGTH - 7)
            lesson_file[lesson] = file
        }
        read_file()
        if (file ~ /^common/) {
            common_file[++common_count] = file
            for (item = first_of[file]; item <= last_of[file]; item++) {
                n = split(item_names[item], words, " ")
                for (k = 1; k <= n; k++) {
                    name = words[k] ~ /^(struct|union|enum)$/ ? words[k] " " words[++k] : words[k]
                    if (!(name in common)) common[name] = item
                }
            }
        }
    }
    while ((getline line <names) > 0) {
        split(line, words, " ")
        if (line ~ /^step/ && (lesson_file[words[1]], words[2]) in own) {
            item = own[lesson_file[words[1]], words[2]]
            hers[words[3]] = item
            house_of[item] = words[3]
            her_name[item] = words[2]
        }
    }
    # Given functions that are hers do not come from common, unless hers are to do.
    for (i = 0; i <= item_count; i++)
        for (k = 1; k <= directives[i]; k++) if (directive[i, k] ~ /@lesson/) take(directive[i, k])
    if (failed) exit 1
    need(own[frame, "main"])
    for (name in taken) need(taken[name])
    for (item = 1; item <= item_count; item++)
        if (item in needed && item in to_do)
            complain(place_of(item) ": task " to_do[item] " is to do")
    if (failed) exit 1
    # Names of the frame first, then of common, then of the lessons in their order.
    for (item = first_of[frame]; item <= last_of[frame]; item++) if (item in needed) settle_names(item, "")
    for (i = 1; i <= common_count; i++)
        for (item = first_of[common_file[i]]; item <= last_of[common_file[i]]; item++)
            if (item in needed) settle_names(item, "")
    for (i = 2; i < ARGC; i++)
        if (match(ARGV[i], /step[0-9]+_[a-z0-9_]+\/main\.c$/))
            for (item = first_of[ARGV[i]]; item <= last_of[ARGV[i]]; item++)
                if (item in needed) settle_names(item, number_of(substr(ARGV[i], RSTART)))
    # What is hers under the house's name is called by her own.
    for (name in hers) for (i = 1; i < ARGC; i++) {
        item = hers[name]
        if (item in needed && (!((ARGV[i], name) in own) || ARGV[i] ~ /^common/))
            new_name[ARGV[i], name] = new_name[file_of[item], her_name[item]]
    }
    for (name in taken) if (!(taken[name] in house_of)) new_name[frame, name] = new_name[file_of[taken[name]], name]
    for (item = first_of[frame] - 1; item <= last_of[frame]; item++) {
        if (item in needed) put_item(item)
        for (k = 1; k <= directives[item]; k++) put_directive(directive[item, k])
    }
    if (ours) print "ours: " ours | "cat >&2"
    printf "/*\n * A software renderer in one file: it reads a model and its textures, and draws them.\n *\n"
    printf " *     cc -O2 -o renderer renderer.c -lm\n"
    printf " *     ./renderer head.obj                                 turns it under a light\n"
    printf " *     ./renderer head.obj --look toon --eye 1,0.5,3 --frames 1\n *\n%s *\n", contents
    printf " * Of its %d lines %d are from your ten main.c.\n */\n%s%s", total + count(contents, "\n") + count(includes, "\n") + 10, her_lines, includes, body
}
