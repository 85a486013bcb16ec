##
## What holds the course to its word (.github/CONTRIBUTING.md says more):
##   make test                   unit tests under sanitizers, and the tests of the check
##   make stress                 hostile numbers, independent answers (STRESS=10, SEED=7, PROPERTY=line)
##   make prove                  what holds for every input there is (needs frama-c)
##   make verify                 the check fails every mistake and passes every correct program that
##                               is listed (STEP=05, NAME=depth)
##   make portability            the same bytes from other compilers (CONFIGURATIONS=arm64)
##   make fuzz                   hostile files (needs clang; FUZZ_SECONDS=60 for each, TARGET=png)
##   make mutants                small changes of the code that some test must notice (COUNT=300,
##                               SEED=7, FILE=common/files/png.c)
##   make everything             what .ci/run leaves out because it takes long, before a release
##   make figures                draw the lessons' other pictures into build/out/*/figures (STEP=05)
##   make lesson-figures         the same into the lessons, after a change to them (STEP=05)
##   make references             draw the reference images again, never part of a check (STEP=05)
##   make mistakes               keep what the listed mistakes look like, by which the check knows
##                               them, and draw the lessons' wrong pictures (STEP=05)
.PHONY: test stress prove verify portability fuzz mutants everything figures lesson-figures references \
        mistakes

# ---- make test ----

# The tests' own build of everything: sanitized, and without threads.
# What is always inlined elsewhere are functions here: with the sanitizers' code in each copy, gcc
# would need more than twice as long.
TESTED_AS = -Dalways_inline=unused -Dflatten=unused -Icommon -Itests
TESTED    = $(CC) $(STRICT) $(WARNINGS) $(WERROR) $(SANITIZED) $(DEFINES) $(TESTED_AS) -MMD -MP

# Found by their names: test_*.c are programs, test_*.sh scripts.
UNITS  := $(patsubst %.c,$(BUILD)/%,$(shell find tests -name 'test_*.c'))
REPLAYS = $(patsubst %.c,$(BUILD)/%,$(wildcard tests/upkeep/fuzz/fuzz_*.c))
SCRIPTS = $(shell find tests -name 'test_*.sh') tests/upkeep/fuzz/replay.sh

# What they test.
$(BUILD)/tested/all.a: $(COMMON:$(BUILD)/%=$(BUILD)/tested/%) $(BUILD)/tested/tests/oracle/oracle.o
$(BUILD)/tested/check.a: $(patsubst %.c,$(BUILD)/tested/%.o,$(CHECKER_FILES:$(BUILD)/%=%)) \
                         $(BUILD)/tested/tests/student/terminal.o
$(BUILD)/tested/all.a $(BUILD)/tested/check.a:
	@rm -f $@
	$(Q)$(AR) qcs $@ $^

$(BUILD)/tested/flags: force
	@mkdir -p $(@D)
	@echo '$(TESTED)' | cmp -s - $@ || echo '$(TESTED)' >$@

$(BUILD)/tested/%.o: %.c $(BUILD)/tested/flags
	@mkdir -p $(@D)
	$(SAY) TEST $<
	$(Q)$(TESTED) $(if $(filter test_lanes.o,$(@F)),$(MARCH)) -c $< -o $@

$(BUILD)/tested/tests/check/page/page_files.o: $(BUILD)/tests/check/page/page_files.c $(BUILD)/tested/flags
	@mkdir -p $(@D)
	$(Q)$(TESTED) -c $< -o $@

# A test that defines __wrap_malloc() or the like gets the calls of malloc() (--wrap of GNU ld).
WRAPPED = $$(sed -n 's/.*__wrap_\([a-z_]*\)(.*{$$/-Wl,--wrap=\1/p' tests/$*.c)
$(UNITS): $(BUILD)/tests/%: $(BUILD)/tested/tests/%.o $(BUILD)/tested/all.a
	@mkdir -p $(@D)
	$(Q)$(TESTED) $(WRAPPED) $< $(filter %/check.a,$^) $(filter %/all.a,$^) -lm -o $@
$(filter $(BUILD)/tests/check/% $(BUILD)/tests/student/%,$(UNITS)): $(BUILD)/tested/check.a

# Some tests of the pipeline are built in several kinds besides, with the pipeline under them, and with
# the instructions of this processor: so many LANES, and REAL where it is not float. (test_lanes-8-double
# has LANES=8 and REAL=double.)
KINDS = test_borders-1 test_borders-8 test_borders-16 test_borders-8-double \
        test_lanes-1 test_lanes-2 test_lanes-4 test_lanes-8 test_lanes-16 test_lanes-8-double
PIPELINE = $(patsubst %.c,%.o,common/pipeline.c $(wildcard common/pipeline/*.c))
define TEST_OF_KIND
$(BUILD)/tested/$(1)/%.o: %.c $(BUILD)/tested/flags
	@mkdir -p $$(@D)
	$$(Q)$$(TESTED) -ULANES -DLANES=$(firstword $(subst -, ,$(1))) \
	    -UREAL -DREAL=$(or $(word 2,$(subst -, ,$(1))),float) $(MARCH) -c $$< -o $$@
$(BUILD)/tested/$(1)/pipeline.a: $(PIPELINE:%=$(BUILD)/tested/$(1)/%)
	@rm -f $$@
	$$(Q)$$(AR) qcs $$@ $$^
# This links no pipeline, which does not come with every number of LANES.
$(BUILD)/tests/test_lanes-$(1): $(BUILD)/tested/$(1)/tests/unit/pipeline/test_lanes.o $(BUILD)/tested/all.a
	$$(Q)$$(TESTED) $$^ -lm -o $$@
$(BUILD)/tests/%-$(1): $(BUILD)/tested/$(1)/tests/unit/pipeline/%.o \
                       $(BUILD)/tested/$(1)/pipeline.a $(BUILD)/tested/all.a
	$$(Q)$$(TESTED) $$^ -lm -o $$@
endef
$(foreach kind,1 2 4 8 16 8-double,$(eval $(call TEST_OF_KIND,$(kind))))

$(REPLAYS): $(BUILD)/tests/%: $(BUILD)/tested/tests/%.o $(BUILD)/tested/tests/upkeep/fuzz/replay.o \
                              $(BUILD)/tested/all.a
	@mkdir -p $(@D)
	$(Q)$(TESTED) $^ -lm -o $@

# The tests make starter and solution of each main.c.
.PHONY: marked
marked:
	@for step in $(STEPS); do grep -q 'BEGIN SOLUTION [1-9]' $$step/main.c || { \
	    echo "make test: $$step/main.c has lost its marks: make start or make solution made it what it is." >&2; \
	    echo "Bring the course's own back: git checkout $$step/main.c, or cp $$step/main.c.marked $$step/main.c" >&2; \
	    exit 1; }; done

test: marked $(UNITS) $(KINDS:%=$(BUILD)/tests/%) $(REPLAYS) $(BUILD)/check $(BUILD)/looks_make $(BUILD)/figure_make \
      $(BUILD)/show $(BUILD)/compare_page $(BUILD)/hidden $(BUILD)/limited programs models \
      $(STEPS:%=$(BUILD)/quick/%) $(patsubst %,$(BUILD)/moving/%,$(filter step01_% step05_%,$(STEPS)))
	@CHECK_PROGRAMS=$(BUILD) sh tests/upkeep/run_tests.sh $(SCRIPTS) $(UNITS) $(KINDS:%=$(BUILD)/tests/%)

# Programs besides the lessons, for a compiler to find fault with.
.PHONY: tools
tools: $(addprefix $(BUILD)/,check show compare_page hidden limited looks_make figure_make \
         stress benchmark bench-frame)

# ---- make stress ----

$(BUILD)/stress: $(call OBJECTS_OF,upkeep/stress oracle) \
                 $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/lessons/*/stress.c)) $(BUILD)/libcommon.a
	$(Q)$(LINK) $(OPENMP) $^ -lm -o $@

stress: $(BUILD)/stress
	$(Q)$(BUILD)/stress $(PROPERTY)

prove:
	$(Q)sh tests/upkeep/prove/prove.sh $(BUILD)/prove

# ---- make verify, make mistakes: what the check makes of wrong programs, and of correct ones ----

verify: $(BUILD)/check $(BUILD)/figure_make models
	@sh tests/upkeep/verify/verify.sh $(BUILD) '$(MAKE) -s' '$(STEP)' '$(NAME)'

# How a lesson's program is compiled and linked, and with what, for scripts that do it hundreds of
# times.
.PHONY: commands
commands:
	@: $(info $(filter-out -MMD -MP,$(COMPILE)))$(info $(LINK))$(info $(BUILD)/quick/libcommon.a -lm)

mistakes: $(BUILD)/check $(BUILD)/looks_make $(BUILD)/figure_make models
	@sh tests/upkeep/verify/mistakes.sh $(BUILD) '$(MAKE) -s' '$(STEP)'

$(BUILD)/looks_make $(BUILD)/figure_make: $(BUILD)/%: $(BUILD)/tests/check/%.o $(CHECKER) \
                                           $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@

# ---- make mutants, portability, fuzz ----

# What is wrong with a change must show at once, and what is wrong with memory too when nothing does.
MUTATED = $(CC) $(STRICT) $(MARCH) $(WARNINGS) -Werror $(TESTED_AS) -O1
mutants: export MUTANTS_CC = $(MUTATED) -fsanitize=undefined -fsanitize-undefined-trap-on-error
mutants: export MUTANTS_SANITIZED = $(MUTATED) $(filter -f%,$(SANITIZED))
mutants: export MUTANTS_STRESS = $(wildcard tests/upkeep/stress/*.c tests/lessons/*/stress.c)
mutants: $(BUILD)/check models
	@sh tests/upkeep/mutants/mutants.sh $(BUILD) $(or $(COUNT),40) $(or $(SEED),1) $(FILE)

portability:
	@bash tests/upkeep/portability/portability.sh -b $(BUILD)/portability $(CONFIGURATIONS)

FUZZ_SECONDS = 60
fuzz:
	@bash tests/upkeep/fuzz/run.sh $(BUILD) '$(MAKE) -s' $(FUZZ_SECONDS) $(TARGET)

$(BUILD)/fuzz_%: $(BUILD)/tested/tests/upkeep/fuzz/fuzz_%.o $(BUILD)/tested/all.a
	$(Q)$(TESTED) -fsanitize=fuzzer $^ -lm -o $@

everything:
	@.ci/run test-clang portability-all grade-unshare verify-all mutants-300 constants

# ---- Pictures: make figures, make references ----

# Drawn from main.c as it is, which may be a starter: so into the build directory. Those of the
# lessons change only by `make lesson-figures`, for a change of a lesson.
FIGURES = $(patsubst tests/lessons/%/figures.c,%,$(wildcard $(CHOSEN:%=tests/lessons/%/figures.c)))
.PHONY: $(FIGURES:%=figures-%) $(FIGURES:%=lesson-figures-%)
figures: $(FIGURES:%=figures-%)
lesson-figures: $(FIGURES:%=lesson-figures-%)

$(FIGURES:%=figures-%): figures-%: $(BUILD)/figures/% $(BUILD)/models/bust.obj
	@mkdir -p $(BUILD)/out/$*/figures
	$(Q)$(BUILD)/figures/$* $(BUILD)/out/$*/figures >$(BUILD)/figures/$*.txt && cat $(BUILD)/figures/$*.txt

# Scenes of live.c that a text shows, ![...](figures/NAME.png "live: NAME, ..."), are drawn by it.
$(FIGURES:%=lesson-figures-%): lesson-figures-%: $(BUILD)/figures/% $(BUILD)/models/bust.obj $(BUILD)/moving/%
	@mkdir -p $*/figures
	$(Q)for scene in $$(sed -n 's/^!.*(figures\/\([a-z_]*\)\.png "live: \1,.*/\1/p' $*/*.md); do \
	    $(BUILD)/moving/$* --only $$scene --format png -o $*/figures || exit; \
	done
	$(Q)$(BUILD)/figures/$* $*/figures >$(BUILD)/figures/$*.txt && cat $(BUILD)/figures/$*.txt

$(BUILD)/figures/%: tests/lessons/%/figures.c $(BUILD)/tests/bench/figures.o $(BUILD)/libcommon.a $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY) CC $<
	$(Q)$(COMPILE) -Itests -MF $@.d $< $(BUILD)/tests/bench/figures.o $(BUILD)/libcommon.a -lm -o $@

references: $(BUILD)/check $(CHOSEN:%=$(BUILD)/quick/%) models
	$(Q)sh tests/check/references.sh $(BUILD) '$(MAKE) -s' $(CHOSEN)
