# What a machine must have to build the course, said in a sentence where it is missing; and what is
# otherwise where Windows itself builds it. The Makefile includes this page.

define NO_COMPILER
there is no C compiler called $(firstword $(CC)). Is another one here (make CC=gcc)? To install one:
    Debian, Ubuntu, WSL   sudo apt-get install gcc libc6-dev make
    Fedora                sudo dnf install gcc make
    Alpine                sudo apk add gcc musl-dev make
    Arch                  sudo pacman -S gcc make
    macOS                 xcode-select --install
    MSYS2                 pacman -S make mingw-w64-ucrt-x86_64-gcc
endef

ifneq ($(filter-out help clean start solution handout commands,$(or $(MAKECMDGOALS),all)),)
ifneq ($(origin MISSING),command line)
MISSING := $(shell command -v $(firstword $(CC)) >/dev/null 2>&1 || echo compiler; \
                   known=$$($(CC) $(CFLAGS) $(MARCH) -MMD -MF /dev/null -dM -E -x c /dev/null 2>/dev/null) || \
                       echo options; \
                   case $$known in (*FLT_EVAL_METHOD__\ [12]*) echo wide ;; esac; \
                   [ -d '$(or $(TMPDIR),.)' ] || echo temporary; \
                   { mkdir -p '$(BUILD)' && [ -w '$(BUILD)' ]; } 2>/dev/null || echo build; \
                   case $$($(CC) -dumpmachine 2>/dev/null) in (*mingw*) echo windows; \
                       [ "$$(uname -s)" != Linux ] || grep -qs '^magic 4d5a' /proc/sys/fs/binfmt_misc/* || \
                       echo wine ;; esac)
endif
$(if $(filter compiler,$(MISSING)),$(error $(NO_COMPILER)))
$(if $(filter options,$(MISSING)),$(error $(CC) does not take the options of gcc and clang, or CFLAGS has \
    one that it does not know. Try make CC=gcc (from version 11) or CC=clang (from 13)))
$(if $(filter wide,$(MISSING)),$(error $(CC) $(CFLAGS) computes more exactly than double, so no picture can be \
    equal: add -msse2 -mfpmath=sse, as in make CC="gcc -m32 -msse2 -mfpmath=sse"))
$(if $(filter build,$(MISSING)),$(error nothing can be written into $(BUILD): name another directory, \
    for example make BUILD=/tmp/course))
ifneq ($(filter temporary,$(MISSING)),)
$(warning TMPDIR=$(TMPDIR) is no directory: /tmp is taken)
override TMPDIR := /tmp
export TMPDIR
endif
# Windows itself draws and checks the pictures. It has no sanitizers in gcc and no terminal that is
# asked for its size, calls directories otherwise than the shell of MSYS2, converts to float in its
# isfinite(), and has its own printf() without %zu.
ifneq ($(filter windows,$(MISSING)),)
POSIX := $(filter-out all programs models new check hint $(patsubst %/.new,%,$(wildcard */.new)) \
             $(STEPS) $(BUILD)/%,$(MAKECMDGOALS)) $(SANITIZE:%=SANITIZE=%)
$(if $(strip $(POSIX)),$(error make $(strip $(POSIX)) needs WSL: README.md, "Start"))
ifneq ($(and $(filter wine,$(MISSING)),$(filter all check models $(STEPS),$(or $(MAKECMDGOALS),all))),)
$(error what $(CC) builds runs on Windows, and not here: call make there, or install wine and its binfmt)
endif
override MAKE_TERMOUT =
BUILT := $(or $(shell cygpath -am '$(BUILD)' 2>/dev/null),$(BUILT))
WARNINGS += -Wno-float-conversion
DEFINES += -D__USE_MINGW_ANSI_STDIO=1
endif
endif
