# This page builds the lessons and draws their pictures; a student needs no other. The rest of what
# `make help` lists is in tests/*/*.mk, each with its room.
#
## For a lesson, here lesson 5:
##   make                        draw every picture of the course into build/out (V=1 shows commands)
##   make STEP=05                draw only the pictures of this lesson
##   make clean                  remove everything that was built
##   make help                   this list
#
# CC=clang, CFLAGS=-O0, MARCH=, WERROR=-Werror, BUILD=some/directory, LANES=1 (one pixel at a time,
# for a debugger) and REAL=double (twice the precision) may be added to any of these.

# BSD make stops here and says this. For GNU make it is a target that nobody needs.
.error : use gmake, this is for GNU make

BUILD  = build
CFLAGS = -O3

# MINE=1: lessons draw with what was written in earlier ones. make calls itself for that.
ifneq ($(MINE),)
include tests/student/mine/mine.mk
else

# A lesson is a directory with a README.md. STEP=05 chooses one.
STEPS  := $(sort $(patsubst %/README.md,%,$(wildcard step[0-9][0-9]_*/README.md)))
CHOSEN := $(if $(STEP),$(filter $(STEP) step$(STEP)_% step0$(STEP)_%,$(STEPS)),$(STEPS))

# What else the course has, in the order of `make help`.
ROOMS := $(wildcard $(foreach room,check student teacher bench upkeep,tests/$(room)/$(room).mk))

# ---- What is said: a line a file, or with V=1 each command ----

Q   = $(if $(V),,@)
SAY = $(if $(V)$(SILENT),@:,@printf '$(if $(IN_PLACE),\r\033[K)$(HOW_FAR)%-6s %s$(if $(IN_PLACE),,\n)')

# On a terminal (make 4.1 and newer knows) the lines of a student's commands replace each other; what
# follows them begins with $(END_LINE).
SILENT   = $(findstring s,$(firstword -$(MAKEFLAGS)))
IN_PLACE = $(if $(filter-out all check show open live watch hint $(STEPS),$(MAKECMDGOALS))$(V)$(SILENT),,$(MAKE_TERMOUT))
END_LINE = $(if $(IN_PLACE),@printf '\r\033[K',@:)

# How far a first build is, [17/70]: of the parts that were not there when it began. (What is built
# again has no such number; nor has what other commands need.)
FULLY   = $(if $(MAKECMDGOALS),$(filter $(STEPS),$(MAKECMDGOALS)$(if $(filter all,$(MAKECMDGOALS)), $(CHOSEN))),$(CHOSEN))
QUICKLY = $(filter check show open live,$(MAKECMDGOALS))
PARTS   = $(if $(FULLY),$(COMMON) $(FULLY:%=$(BUILD)/%) $(FULLY:%=$(BUILD)/out/%/.drawn)) \
          $(if $(FULLY)$(QUICKLY),$(QUICK_COMMON) $(MODEL) $(MODEL:%=$(BUILD)/quick/common/sculptor/all.o)) \
          $(if $(QUICKLY)$(MAKE_TERMOUT),$(CHECKER) $(QUICKLY:%=$(BUILD)/quick/tests/check/check.o))
TO_DO   = $(eval TO_DO := $(filter-out $(wildcard $(PARTS)),$(PARTS)))$(TO_DO)
HOW_FAR = $(eval BEGUN += .)$(if $(word $(words $(BEGUN)),$(TO_DO)),[$(words $(BEGUN))/$(words $(TO_DO))] )

# ---- Pictures ----

.PHONY: all programs models $(STEPS)
all: $(CHOSEN) $(if $(MAKE_TERMOUT),$(BUILD)/show)
	$(END_LINE)
	@$(if $(SILENT)$(STEP),:,sh tests/student/next.sh '$(BUILD)')
programs: $(STEPS:%=$(BUILD)/%)
models: $(BUILD)/models/bust.obj
$(STEPS): %: $(BUILD)/out/%/.drawn

# What draws lesson 1 needs no model.
MODEL = $(if $(filter-out step01_%,$(CHOSEN)),$(BUILD)/models/bust.obj)
$(BUILD)/out/%/.drawn: $(BUILD)/% $(BUILD)/models/bust.obj
	$(SAY) DRAW $*
	$(Q)$(BUILD)/$* -o $(@D) >/dev/null
	@touch $@

# The head that the lessons draw is sculpted by a program of the course.
$(BUILD)/models/bust.obj: $(BUILD)/sculptor
	$(SAY) SCULPT $(@D)
	@mkdir -p $(@D)
	$(Q)$(BUILD)/sculptor $(@D)

# ---- How the compiler is called ----

WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes \
           -Wmissing-prototypes -Wno-psabi $(CONSTANTS)
# The course's constants are enums, also in sums with double, of which clang 19 begins to warn.
ifneq ($(origin CONSTANTS),command line)
CONSTANTS := $(shell $(CC) -Werror -Wenum-float-conversion -E -x c /dev/null >/dev/null 2>&1 && \
                     echo -Wno-enum-float-conversion)
endif
# One rounding for each operation, so that every machine computes the same bytes.
STRICT   = -std=c17 -ffp-contract=off -fno-math-errno
# Everything this processor can do, where the compiler knows it; no byte of a picture changes.
ifneq ($(origin MARCH),command line)
MARCH   := $(shell $(CC) -march=native -E -x c /dev/null >/dev/null 2>&1 && echo -march=native)
endif
THREADED = -pthread
BUILT    = $(abspath $(or $(HOUSE),$(BUILD)))
DEFINES  = -DCOURSE_BUILD='"$(BUILT)"' $(LANES:%=-DLANES=%) $(REAL:%=-DREAL=%)
# Also with -Ofast: what would add up in another order is left out.
EXACT    = $(patsubst -Ofast,-O3,$(filter-out -f%-math -f%-math-optimizations -f%-math-only,$(CFLAGS)))
COMPILE  = $(CC) $(STRICT) $(WARNINGS) $(WERROR) $(EXACT) $(MARCH) $(THREADED) $(DEFINES) \
           -Icommon -MMD -MP
LINK     = $(CC) $(EXACT) $(MARCH) $(THREADED)
# What a make that is called at each save is told, so that it asks nobody for it.
KNOWN    = $(foreach name,CONSTANTS MARCH MISSING,$(if $(filter file,$(origin $(name))),\
             $(name)=$(filter-out temporary,$($(name)))))

# The path of the build directory is a word of make and of the shell, and a string of C.
ifneq ($(words $(BUILD))$(strip $(foreach sign,' " \,$(findstring $(sign),$(abspath $(BUILD))))),1)
$(error the build directory $(abspath $(BUILD)) holds a quote or a backslash, or BUILD a blank)
endif

# What a machine must have, and what Windows has otherwise.
include $(wildcard tests/student/machine.mk)

# Changes only when the compiler or its flags do, and then everything is built again.
$(BUILD)/flags: force
	@mkdir -p $(@D)
	@echo '$(COMPILE)' | cmp -s - $@ || echo '$(COMPILE)' >$@
.PHONY: force

# ---- A lesson's program: its main.c and what all lessons share ----

# What the lesson of that number teaches is not given in it: common/given/later.h.
TEACHES = $(patsubst %,-DCOURSE_LESSON=%,$(patsubst 0%,%,$(LESSON_NUMBER)))
LESSON_NUMBER = $(patsubst step%,%,$(firstword $(subst _, ,$(filter $(STEPS),$(basename $(@F))))))

# It is linked under another name first: `make watch` may run the old one meanwhile. It is as old as the
# text that was read, so that what is saved during a build is built next. What the compiler warns of is
# kept, because the check repeats it.
define BUILD_LESSON
	@$(foreach h,$(filter $(notdir $(wildcard common/*.h)),$(notdir $(wildcard $(<D)/*.h))),\
	    echo "$(<D)/$h: error: it hides common/$h: give it another name" >&2; exit 1;) : >$@.begun
	$(SAY) CC $<
	$(Q)$(COMPILE) $(TEACHES) $$([ ! -t 2 ] || echo -fdiagnostics-color=always) $(1) \
	    -MF $@.d -MT $@ $(call WITH_MORE,$<,$(3)) -o $@.o 2>$@.said || { $(SAID) >&2; exit 1; }
	@[ ! -s $@.said ] || $(SAID) >&2
	$(Q)$(LINK) $(1) $@.o $(2) $(filter %.a,$^) -lm -o $@.$$$$ && touch -r $@.begun $@.$$$$ && mv -f $@.$$$$ $@
endef
# A lesson's main.c with more scenes: trials, which make check judges, or live, under the mouse.
WITH_MORE = $(or $(addprefix -iquote . -Itests -DLESSON='"$1"' -c ,\
                $(wildcard tests/lessons/$(or $3,$(patsubst %/main.c,%,$1))/$2.c)),-c $1)
# Where main.c is part of another file, its lines are named as they are without.
SAID = { $(if $(IN_PLACE),echo;) sed '/^\(In file included\| *\) *from .*tests.\(lesson\|more_scenes\)/d; s|\./\(step[0-9]\)|\1|' $@.said; }
$(STEPS:%=$(BUILD)/%): $(BUILD)/%: %/main.c $(BUILD)/%.text $(BUILD)/libcommon.a $(BUILD)/flags
	$(call BUILD_LESSON,$(LESSON_FLAGS),$(LESSON_OBJECTS))

# The text of a lesson's sources and of WITH_MORE: changes when that does, even where an unpacked
# main.c is older than the program that was built of the one before it, or where trials.c is new.
TEXTS = $(wildcard $*/*.[ch] $*/*/*.[ch] tests/lessons/$*/trials.c tests/lessons/$*/live.c)
$(STEPS:%=$(BUILD)/%.text): $(BUILD)/%.text: force
	@mkdir -p $(@D)
	@cat $(TEXTS) | cmp -s - $@ || cat $(TEXTS) >$@

# ---- What all lessons share ----

COMMON = $(patsubst %.c,$(BUILD)/%.o,$(wildcard common/*.c common/[!s]*/*.c))

$(BUILD)/libcommon.a: $(COMMON)
$(BUILD)/libcommon.a $(BUILD)/quick/libcommon.a:
	@rm -f $@
	$(Q)$(AR) qcs $@ $^

$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY) CC $<
	$(Q)$(COMPILE) $(INCLUDES) -c $< -o $@

# ---- The same, built in a third of the time ----

# What is drawn once and not timed need not be as fast as it can be: the check judges build/quick/STEP,
# and make show, open, live and watch draw with it. Each byte that it draws is the same. What is always
# inlined elsewhere are functions there. CFLAGS=... hold here, too.
QUICK      = $(if $(filter file,$(origin CFLAGS)),-O2 -Dalways_inline=unused -Dflatten=unused)
QUICK_ROOM = $(if $(filter file,$(origin CFLAGS)),$(if $(filter %/sculptor/all.o,$@),-O2,-O1))

# Until make builds it in full, build/STEP is this program too, so that it always is what was judged.
# (Its date says that make has to.)
define LEND_QUICK
	@[ -n "$$(find $(BUILD)/$* -newer $(BUILD)/$*.text 2>/dev/null)" ] || { \
	    cp $@ $(BUILD)/$*.$$$$ && touch -t 200001010000 $(BUILD)/$*.$$$$ && mv -f $(BUILD)/$*.$$$$ $(BUILD)/$*; }
endef
$(STEPS:%=$(BUILD)/quick/%): $(BUILD)/quick/%: %/main.c $(BUILD)/%.text $(BUILD)/quick/libcommon.a \
                                               $(BUILD)/flags
	$(call BUILD_LESSON,$(QUICK) $(LESSON_FLAGS),$(LESSON_OBJECTS),trials)
	$(LEND_QUICK)

# A room is compiled as if it were one file, all.o: so no two of its files may give the same name to
# different things. Each system shows it all that it has, and not what the first file asks for. (What the
# compiler warns of it says of the files one by one, in the full build.)
QUICK_ROOMS := $(sort $(patsubst %/,$(BUILD)/quick/%/all.o,$(dir $(wildcard common/*/*.c))))
$(foreach room,$(QUICK_ROOMS),$(eval $(room): $(wildcard $(room:$(BUILD)/quick/%/all.o=%/*.c))))
define COMPILE_ROOM
	@mkdir -p $(@D)
	$(SAY) CC $(@D:$(BUILD)/quick/%=%)
	$(Q)printf '#include "%s"\n' $(filter $(wildcard common/*/*.c) $(CHECKER_FILES),$^) | $(COMPILE) $(QUICK_ROOM) $(INCLUDES) \
	    -iquote . -w -D_GNU_SOURCE -D_DARWIN_C_SOURCE -include stdio.h -MF $(@:.o=.d) -MT $@ -x c -c - -o $@
endef
$(QUICK_ROOMS): $(BUILD)/flags
	$(COMPILE_ROOM)

$(BUILD)/quick/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY) CC $<
	$(Q)$(COMPILE) -w $(QUICK_ROOM) $(INCLUDES) -c $< -o $@

QUICK_COMMON = $(patsubst %.c,$(BUILD)/quick/%.o,$(wildcard common/*.c)) \
               $(filter-out %/sculptor/all.o,$(QUICK_ROOMS))
$(BUILD)/quick/libcommon.a: $(QUICK_COMMON)

$(BUILD)/sculptor: $(BUILD)/quick/common/sculptor/all.o $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@.new && mv -f $@.new $@

# ---- make help, make clean, and how make works here ----

.PHONY: help clean
help:
	@sed -n 's/^## \{0,1\}//p' Makefile $(ROOMS)

clean:
	rm -rf $(BUILD)

# All processors, none of make's own rules, and no file that a command has not finished.
ifeq ($(filter -j%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif
MAKEFLAGS += -r
.DELETE_ON_ERROR:
.SECONDARY:

include $(ROOMS)
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
endif # MINE
