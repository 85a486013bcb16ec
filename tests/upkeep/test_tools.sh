#!/bin/sh
# Do the scripts that students and instructors run use only what the tools of a Mac and of busybox have
# as well? They are searched for what only GNU's have; and with busybox's tools, where it is installed,
# they write the same. So are the makefiles for what make 3.81 lacks, which checks a lesson where it is
# called make-3.81.
. "$(dirname "$0")/../unit/script.sh"

# What CI alone runs may use GNU's: tests, and what makes or tries classes and templates.
find Makefile tests/student tests/check tests/teacher -name Makefile -o -name '*.sh' -o -name '*.mk' |
    grep -v -e 'test_[^/]*$' -e /wrong/ -e /templates/ -e /try_ -e make_class -e contain.sh >"$work/scripts"

# foreign PATTERN WORDS: of a command that is written otherwise elsewhere, or not there.
foreign() {
    xargs grep -nE -e "$1" <"$work/scripts" | grep -v '^[^:]*:[0-9]*: *#' >"$work/said" || return
    said=$work/said
    wrong "$2"
    said=
}
begins='(^|[|;&({`]|then|do|else|if|!) *'
foreign "${begins}sed( -[a-zA-Z]+)* -[a-zA-Z]*[iz]" "sed -i, -z are GNU's"
foreign "${begins}sed .*;[^'\"]*\}'" "a } of sed has its own line, or is GNU's"
foreign "${begins}sed [^|]*(\\\\[+?|]|\\\\[tnwbs])" "\\+ \\? \\| \\t \\n \\w \\b of sed are GNU's"
foreign "${begins}grep [^|]*\\\\[|+?wbs]" "\\| \\+ \\? \\w \\b of grep are GNU's"
foreign "${begins}grep( -[a-zA-Z]+)* -[a-zA-Z]*[Pz]" "grep -P, -z are GNU's"
foreign "${begins}(stat|tac|timeout|nproc|realpath|seq|sha256sum|md5sum|setsid|shuf|numfmt) " \
    "not on a Mac, or with other options"
foreign "${begins}(date .*(%N|-d |--)|readlink -f|mktemp .*--|cp -[a-zA-Z]*[at]|mv -[a-zA-Z]*t|touch -d|ln .*-r)" \
    "an option that is GNU's"
foreign "${begins}(sort|head|tail|cut|tr|wc|cp|mv|ln|ls|find|xargs|diff|cmp|mkdir|awk) +(-[a-zA-Z]+ +)*--[a-z]" \
    "a long option is GNU's"
foreign "${begins}(xargs .*-(r|d|a) |find .*-printf|head -n *-[0-9]|sort .*-[a-zA-Z]*[zVh] |echo -[ne] |ls .*--)" \
    "an option that is GNU's"
foreign '(gensub|strftime|systime|asorti?)\(|\\y' "a function of gawk's"

foreign '^([A-Za-z_]+ *(!|::+)=|define .*=|undefine |private |\.(ONESHELL|RECIPEPREFIX)|.*\$[({](file|guile) )' \
    "make 3.81, a Mac's, does not know it"

# ---- make 3.81, where it is called so ----

if command -v make-3.81 >/dev/null; then
    said_by 0 make-3.81 -s BUILD="$work/old" CFLAGS=-O0 MARCH= check STEP=01
    says 'step01_line  PASS'
    said_by 0 make-3.81 -s BUILD="$work/old" CFLAGS=-O0 MARCH= open STEP=01
fi

# ---- busybox ----

command -v busybox >/dev/null || exit $failed
mkdir "$work/bin" && busybox --install -s "$work/bin" || exit 1
rm -f "$work/bin/make"
for tool in make git cc as ld; do
    [ ! -e "$(command -v $tool)" ] || ln -s "$(command -v $tool)" "$work/bin/$tool"
done

# alike COMMAND...: ends, says and leaves the same with either kind of tools, in the lesson's directory.
alike() {
    for tools in usual busybox; do
        rm -rf build step01_line && cp -R "$top/step01_line" . || exit 1
        path=$PATH
        [ $tools = usual ] || path=$work/bin
        env PATH="$path" sh "$@" >"$work/$tools" 2>&1
        { echo $? && cat step01_line/main.c*; } >>"$work/$tools"
    done
    diff "$work/usual" "$work/busybox" >"$work/said" && return
    said=$work/said
    wrong "with busybox: $*"
    said=
}

# Both run in one place, so that they say the same.
mkdir "$work/course" && cp -R Makefile README.md LICENSE .gitattributes .gitignore common step* "$work/course" &&
    mkdir "$work/course/tests" && cp -R tests/[!l]* "$work/course/tests" &&
    cp -R tests/lessons tests/*.h "$work/course/tests" && cd "$work/course" || exit 1
alike tests/student/start.sh start 1
alike tests/student/hint.sh build 1 1.2 ''
alike tests/student/hint.sh build 77
alike tests/student/next.sh build
alike tests/student/next.sh build step01_line
alike tests/student/show.sh "$build" 1 line '' blocks
alike tests/student/open.sh "$build" 1 line
alike tests/teacher/handout/handout.sh "$work" 1
alike tests/teacher/handout/handout.sh "$work/out" 1-x
for tools in usual busybox; do
    path=$PATH
    [ $tools = usual ] || path=$work/bin
    env PATH="$path" sh tests/teacher/handout/handout.sh "$work/out.$tools" 1-2 >"$work/said" 2>&1 ||
        wrong "handout: $(cat "$work/said")"
done
diff -r "$work/out.usual" "$work/out.busybox" >"$work/said" ||
    wrong "the hand-out differs: $(head -n 5 "$work/said")"
exit $failed
