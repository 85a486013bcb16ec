# A student needs this page and no other: what is drawn, how a lesson is built, how it is checked.
# The rest (`make test` and below) stands in tests/targets.mk.

define HELP
For a lesson, here lesson 5:
  make                        draw every picture of the course into build/out
  make step05_zbuffer         draw only the pictures of this lesson
  make check                  compare the pictures with tests/reference
  make check STEP=05          the same for one lesson (REPORT=file writes file.html, and .xml,
                              .json and .tap for other programs)
  make check STEP=05 SANITIZE=1   the same, and in which line a program goes wrong
  make start STEP=05          turn main.c into the starter: what you write is left out
  make solution STEP=05       bring the lesson's own solution back
  make hint STEP=05           a hint for what is to do, and more each time (TASK=5.2)
  make show STEP=05           the pictures in the terminal, beside the references (SCENE=depth,
                              WHICH=yours,reference,difference, KIND=blocks, sixel or kitty)
  make open STEP=05           the same in the browser, in one page
  make watch STEP=05          check and show again at every save, until Ctrl-C
  make clean                  remove all that was built

For the course as a whole:
  make check HIDDEN=7         and then scenes that nobody has seen, made from that number
                              (SOLUTION=dir holds them against dir/step05_zbuffer/main.c)
  make test                   unit tests under sanitizers, and the tests of the check
  make stress                 hostile numbers, independent answers (STRESS=10, SEED=7, PROPERTY=line)
  make bench                  run time against error, a chart for each lesson (STEP=05 for one)
  make counts                 the instructions of each scene, beside those committed (STEP=05)
  make bench-files            how fast files are read and written, beside libpng and plain bytes
  make bench-run              where the time of a whole run goes, beside cat and cp of its files
  make charts                 put these charts into the lessons
  make bench-frame            the time of a frame beside Mesa's llvmpipe (OPTIONS=--help)
  make figures                draw the lessons' other pictures into build/out/*/figures (STEP=05)
  make lesson-figures         the same into the lessons, after a change to them (STEP=05)
  make references             draw the reference images again, never part of a check (STEP=05)
  make portability            the same bytes from other compilers (CONFIGURATIONS=arm64)
  make compare-opengl         the same pictures drawn by OpenGL (needs Mesa)
  make fuzz                   hostile files (needs clang; FUZZ_SECONDS=60 for each, TARGET=png)
  make mutants                small changes of the code that some test must notice (NAME=geometry)
  make verify                 the check fails every mistake and passes every correct program that is
                              listed (STEP=05, NAME=depth)
  make handout OUT=dir        what a student gets: starters, and no solution (LESSONS=1-5)
  make key OUT=dir            what an instructor gets: solutions, answers, the pictures of mistakes,
                              points (LESSONS=1-5)
  make grade SUBMISSIONS=dir  a class: points, reports, what is alike, into OUT=dir (LESSONS=1-5,
                              SEED=7 for hidden scenes, JOBS=8)
  make grade-one SUBMISSION=path   one of them, into OUT=dir
  make grade-merge OUT=dir    the class, from those that are there
  make grade-tools            build what these use
  make mistakes               keep what the listed mistakes look like, by which the check knows them,
                              and draw the lessons' wrong pictures (STEP=05)
  make coverage               which lines and branches of common the tests reach
  make help                   this list

CC=clang, CFLAGS=-O0, MARCH=, WERROR=-Werror, BUILD=some/directory, LANES=1 (one pixel at a time, for
a debugger), REAL=double (twice the precision) and LINE=mine (lessons 2 to 8 draw with what you wrote
in lessons 1 and 3; not with check) may be added to any of these.
endef

BUILD  = build
CFLAGS = -O3
ifneq ($(words $(BUILD)),1)
$(error BUILD=$(BUILD) is not one word of make: choose a name without blanks)
endif
# None of make's own rules: they are of no use here, and to look for them takes half of its time.
MAKEFLAGS += -r
# A lesson is a directory with a main.c.
STEPS := $(sort $(patsubst %/main.c,%,$(wildcard step[0-9][0-9]_*/main.c)))

# ---- make: draw every picture ----

.PHONY: all programs models $(STEPS)
all: $(STEPS)
programs: $(STEPS:%=$(BUILD)/%)
models: $(BUILD)/models/bust.obj
$(STEPS): %: $(BUILD)/out/%/.drawn

$(BUILD)/out/%/.drawn: $(BUILD)/drawn/% $(BUILD)/models/bust.obj
	$(BUILD)/$* -o $(@D)
	@touch $@

# The program that drew last. A new one of the same bytes, which is what the check makes, draws the
# same.
$(BUILD)/drawn/%: $(BUILD)/%
	@mkdir -p $(@D)
	@cmp -s $< $@ || cp $< $@

# LINE=mine: lessons 2 and 3 draw with the line() of lesson 1's main.c, lessons 4 to 8 with the
# triangles of lesson 3's, whoever wrote them. (The house versions get their names.)
ifeq ($(LINE),mine)
ifneq ($(filter check,$(MAKECMDGOALS)),)
$(error make check judges each lesson by itself: leave LINE=mine out)
endif
ifeq ($(wildcard step01_line/mine.c)$(wildcard step03_triangle/mine.c),)
$(error LINE=mine draws with what you wrote in lessons 1 and 3, which are not here)
endif
MINE = $(patsubst %/mine.c,$(BUILD)/mine/%.o,$(wildcard step*/mine.c))
$(BUILD)/step02% $(BUILD)/step03%: DRAW_WITH = -DLINE_IS_MINE -Wno-unused-function
$(foreach n,4 5 6 7 8,$(BUILD)/step0$(n)%): DRAW_WITH = -Dedges_setup=my_triangle_setup \
                                                         -Dedges_span=my_triangle_span
endif

# A lesson's program is its main.c and what all lessons share.
$(STEPS:%=$(BUILD)/%): $(BUILD)/%: %/main.c $(BUILD)/sums/% $(BUILD)/libcommon.a $(MINE) \
                                   $(BUILD)/line $(BUILD)/flags
	$(call PROGRAM,$(DRAW_WITH),$(MINE))

$(BUILD)/mine/%.o: %/mine.c %/main.c $(BUILD)/sums/% $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -c $< $(OBJECT)

# Changes only when what a lesson's program is built from does, whatever its date: a main.c that was
# unpacked or copied may be older than the program of the one before it.
$(STEPS:%=$(BUILD)/sums/%): $(BUILD)/sums/%: force
	@mkdir -p $(@D)
	@sums=$$(cksum $$(ls $*/*.[ch] $*/*/*.[ch] common/*.h 2>/dev/null | \
	                  sed '/\/figures\.c$$/d') 2>/dev/null); \
	 [ "$$(cat $@ 2>/dev/null)" = "$$sums" ] || echo "$$sums" >$@

# Changes only when LINE does.
$(BUILD)/line: force
	@mkdir -p $(@D)
	@[ "$$(cat $@ 2>/dev/null)" = 'LINE=$(LINE)' ] || echo 'LINE=$(LINE)' >$@

COMMON   = $(basename $(notdir $(wildcard common/*.c)))
SCULPTOR = $(basename $(notdir $(wildcard common/sculptor/*.c)))

$(BUILD)/libcommon.a: $(COMMON:%=$(BUILD)/common/%.o)
	$(AR) rcs $@.$$$$ $^ && mv -f $@.$$$$ $@

# The head that the lessons draw is sculpted by a program, once: again when a file is not as it was
# written, which the check would count against a lesson, or it is another program, and not whenever
# it is linked again.
MODELS = $(addprefix $(BUILD)/models/,bust.obj bust_diffuse.tga bust_nm.tga bust_spec.tga \
                                      knot.off sphere.obj torus.obj)
SUMS   = (cd $(BUILD)/models && cksum $(notdir $(MODELS)))
$(BUILD)/models/bust.obj: $(BUILD)/sculptor $(BUILD)/sums/models
	@mkdir -p $(@D)
	@rmdir $(MODELS) 2>/dev/null || :
	$(BUILD)/sculptor $(@D)
	@$(SUMS) >$(BUILD)/sums/models 2>/dev/null; touch $@

# Changes only when a file is not what was sculpted.
$(BUILD)/sums/models: force
	@mkdir -p $(@D)
	@$(SUMS) 2>/dev/null | cmp -s - $@ || echo 'To be sculpted' >$@

$(BUILD)/sculptor: $(BUILD)/sculpt
	@cmp -s $< $@ || { cp $< $@.$$$$ && mv -f $@.$$$$ $@; }

$(BUILD)/sculpt: $(SCULPTOR:%=$(BUILD)/common/sculptor/%.o) $(BUILD)/libcommon.a
	$(LINK) $^ -lm $(PLACED)

# ---- How the compiler is called ----

# (Functions on `lanes` are inlined: how older compilers passed their arguments matters to nobody.)
WARNINGS = -Wno-psabi -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes -Wmissing-prototypes
# One rounding for each operation, so that every machine computes the same bytes.
STRICT   = -std=c17 -ffp-contract=off -fno-math-errno
DEFINES  = -DCOURSE_BUILD='"$(abspath $(BUILD))"'
# LANES=1 shades one pixel at a time, for a debugger; REAL=double shades with twice the precision.
DEFINES += $(LANES:%=-DLANES=%) $(REAL:%=-DREAL=%)
# The same path is a word of the shell and a string of C.
ifneq ($(strip $(foreach sign,' " \,$(findstring $(sign),$(abspath $(BUILD))))),)
$(error the path $(abspath $(BUILD)) holds a quote or a backslash: move the course, or set BUILD)
endif
# Threads, where the compiler wants to be told; and all that this processor can do. Neither changes
# a byte of a picture. MARCH= makes programs that run on any processor of the kind. (One by one only
# where they are not known together.)
PROBE    = $(shell mkdir -p $(BUILD) && probe=$(BUILD)/probe.$$$$ && \
                   echo 'int main(void) { return 0; }' >$$probe.c && \
                   $(CC) $(1) $$probe.c -o $$probe 2>/dev/null && echo $(1); rm -f $$probe $$probe.c)
BOTH     = $(call ONCE,BOTH,$(call PROBE,-pthread -march=native))
THREADED = $(call ONCE,THREADED,$(or $(filter -pthread,$(BOTH)),$(call PROBE,-pthread)))
MARCH    = $(call ONCE,MARCH,$(or $(filter -march=%,$(BOTH)),$(call PROBE,-march=native)))
# What a variable is found to be when it is first asked for.
ONCE     = $(eval $(1) := $(2))$(2)
COMPILE  = $(CC) $(STRICT) $(WARNINGS) $(WERROR) $(CFLAGS) $(MARCH) $(THREADED) $(DEFINES) \
           -Icommon -MMD -MP
# What the lessons stand on (library, models, check) computes exactly whatever CFLAGS say: -Ofast is
# for main.c alone, and constants of single precision, which clang does not know. Where the linker
# saw -Ofast, numbers next to 0 would be 0 in the whole program. -fno-fast-math also brings back
# errno and traps, which keep loops from being vectorised.
EXACT    = $(subst -fsingle-precision-constant,,$(subst -Ofast,-O3,$(COMPILE))) -fno-fast-math \
           $(STRICT)
INEXACT  = -Ofast -ffast-math -funsafe-math-optimizations
LINK     = $(CC) $(filter-out $(INEXACT),$(CFLAGS)) $(MARCH) $(THREADED)
# A lesson's program, with these flags and objects. Where the compiler has nothing to say a copy is
# kept, so that the check need not build the program again to show its warnings.
define PROGRAM
@mkdir -p $(@D)/built && rm -f $(@D)/built/$(@F)
$(COMPILE) $(COLORED) $(1) -MF $@.d -MT $@ -c $< -o $@.o 2>$@.said || { cat $@.said >&2; exit 1; }
@cat $@.said >&2
$(LINK) $(1) $@.o $(2) $(BUILD)/libcommon.a -lm $(PLACED)
@[ -s $@.said ] || cp $@ $(@D)/built
endef
COLORED  = $(call ONCE,COLORED,$(shell [ ! -t 2 ] || echo -fdiagnostics-color))
# Written under another name first: while a program is written no other make of the same directory
# could run it, nor link an object.
PLACED   = -o $@.$$$$ && mv -f $@.$$$$ $@
OBJECT   = -MF $(@:.o=.d) -MT $@ $(PLACED)

$(BUILD)/common/%.o: common/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(EXACT) -c $< $(OBJECT)

# Changes only when the compiler or its flags do, and then everything is built again.
$(BUILD)/flags: force
	@[ "$$(cat $@ 2>/dev/null)" = '$(COMPILE)' ] || echo '$(COMPILE)' >$@
.PHONY: force

# All cores, unless the command line says otherwise.
ifeq ($(filter -j%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif
.DELETE_ON_ERROR:
.SECONDARY:

# ---- make check ----

# Its parts; the files with a main() are not among them.
CHECKER = $(patsubst %.c,$(BUILD)/%.o,$(filter-out %/check.c %/references.c %/looks_make.c \
              %/figure_make.c tests/check/test_%.c,$(wildcard tests/check/*.c))) \
          $(addprefix $(BUILD)/tests/help/,base64.o escape.o page.o page_files.o \
                                               pictures.o)

# The check builds the lessons itself: one that does not build is a finding, not the end.
# SANITIZE=1: their main.c with the sanitizers, which tell in which line a program goes wrong. They
# are slow; what is not freed at the end is not meant, and a failed assert() is.
CHECKED = $(BUILD)$(if $(SANITIZE),/sanitized)
ifneq ($(HIDDEN),)
ifeq ($(wildcard tests/hidden/hidden.mk),)
$(error HIDDEN=$(HIDDEN): hidden scenes are drawn where the solutions are)
endif
endif
.PHONY: check
check: $(BUILD)/check $(HIDDEN:%=$(BUILD)/hidden)
	@$(if $(SANITIZE),ASAN_OPTIONS=detect_leaks=0:handle_abort=1 UBSAN_OPTIONS=print_stacktrace=1 \
	                CHECK_TIMEOUT=$${CHECK_TIMEOUT:-60}) \
	$(BUILD)/check --programs $(CHECKED) --differences $(CHECKED)/differences --make '$(MAKE) -s' \
	    $(if $(SANITIZE),--sanitized) \
	    $(if $(REPORT),--junit $(REPORT).xml --json $(REPORT).json --tap $(REPORT).tap \
	                   --html $(REPORT).html) \
	    $(KEEP_POINTS) $(STEP) $(THEN_HIDDEN)

SANITIZED = -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
$(STEPS:%=$(BUILD)/sanitized/%): $(BUILD)/sanitized/%: %/main.c $(BUILD)/sums/% \
                                                       $(BUILD)/libcommon.a $(BUILD)/flags
	$(call PROGRAM,$(SANITIZED))

-include $(wildcard tests/hidden/hidden.mk)

$(BUILD)/check: $(BUILD)/tests/check/check.o $(CHECKER) $(BUILD)/libcommon.a
	$(LINK) $^ -lm $(PLACED)

$(BUILD)/tests/%.o: tests/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(EXACT) $(OPENMP) -Itests/oracle -c $< $(OBJECT)

# Style and script of the pages, as strings of C.
$(BUILD)/tests/help/page_files.c: tests/help/page.css tests/help/page.js
	@mkdir -p $(@D)
	@{ echo '#include "page.h"'; \
	   for file in css js; do \
	       echo "const char *const page_$$file[] = {"; \
	       sed 's/[\\"]/\\&/g; s/.*/    "&\\n",/' tests/help/page.$$file; \
	       echo '    NULL};'; \
	   done; } >$@.$$$$ && mv -f $@.$$$$ $@

$(BUILD)/tests/help/page_files.o: $(BUILD)/tests/help/page_files.c $(BUILD)/flags
	$(EXACT) -Itests/help -c $< $(OBJECT)

# ---- make start, make solution ----

-include $(wildcard tests/starter/starter.mk tests/handout/handout.mk)

# ---- make hint, make show, make open, make watch ----

-include $(wildcard tests/help/help.mk)

# ---- make help, make clean, and what nobody knows ----

.PHONY: help clean
help:
	@: $(info $(HELP))

clean:
	rm -rf $(BUILD)

# A lesson's program whose main.c is gone would be up to date.
GONE = $(filter-out $(STEPS:%=$(BUILD)/%),$(wildcard $(filter $(BUILD)/step%,$(MAKECMDGOALS))))
.PHONY: $(GONE)
$(GONE):
	$(error there is no $(@F)/main.c)

.PHONY: common tests
.DEFAULT common tests:
	$(error there is no target '$@'; `make help` prints them (one lesson: `make check STEP=05`))

# `make STEP=05` does not say what is to be done with lesson 5.
ifeq ($(MAKECMDGOALS)$(origin STEP),command line)
$(error what about STEP=$(STEP)? `make check STEP=$(STEP)`, for example; `make help` prints all)
endif

-include $(wildcard tests/targets.mk tests/grade/grade.mk)
-include $(wildcard $(BUILD)/*.d $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/*/*/*/*.d)
