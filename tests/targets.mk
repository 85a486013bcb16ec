# The targets for the course as a whole: pictures, tests, measurements. Included by the Makefile,
# which has what is used here: STEPS, COMMON, CHECKER, COMPILE, LINK and the objects of tests/.
# Lessons, tests, benchmarks and fuzz targets are found by the names of their files.

# ---- Pictures: make figures, make references, make charts ----

# Drawn from main.c as it is, which may be a starter: so into the build directory. Those of the
# lessons change only by `make lesson-figures`, which is for who changes a lesson.
FIGURES = $(patsubst %/figures.c,%,$(wildcard $(STEPS:%=%/figures.c)))
CHOSEN_FIGURES = $(if $(STEP),$(filter $(STEP) step$(STEP)_% step0$(STEP)_%,$(FIGURES)),$(FIGURES))
.PHONY: figures lesson-figures $(FIGURES:%=figures-%) $(FIGURES:%=lesson-figures-%) references charts
figures: $(CHOSEN_FIGURES:%=figures-%)
lesson-figures: $(CHOSEN_FIGURES:%=lesson-figures-%)

$(FIGURES:%=figures-%): figures-%: $(BUILD)/figures/% $(BUILD)/models/bust.obj
	@mkdir -p $(BUILD)/out/$*/figures
	$(BUILD)/figures/$* $(BUILD)/out/$*/figures >$(BUILD)/figures/$*.txt && cat $(BUILD)/figures/$*.txt

$(FIGURES:%=lesson-figures-%): lesson-figures-%: $(BUILD)/figures/% $(BUILD)/models/bust.obj
	@mkdir -p $*/figures
	$(BUILD)/figures/$* $*/figures >$(BUILD)/figures/$*.txt && cat $(BUILD)/figures/$*.txt

$(BUILD)/figures/%: %/figures.c $(BUILD)/tests/figures.o $(BUILD)/libcommon.a $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -MF $@.d $< $(BUILD)/tests/figures.o $(BUILD)/libcommon.a -lm -o $@

$(BUILD)/references: $(BUILD)/tests/check/references.o $(CHECKER) $(BUILD)/libcommon.a
	$(LINK) $^ -lm -o $@

references: $(BUILD)/references programs models
	$(BUILD)/references --programs $(BUILD) $(STEP)

# The charts of the last `make bench` become those of the lessons.
charts:
	@for step in $(STEPS); do \
	    if [ -f $(BUILD)/bench/$$step.svg ]; then \
	        mkdir -p $$step/figures && cp $(BUILD)/bench/$$step.svg $$step/figures/bench.svg; \
	    elif [ -f tests/bench/$${step%%_*}.c ]; then \
	        echo "$$step: no chart yet; make bench draws it"; \
	    fi; done

# ---- Submissions that are alike, of a class ----

SIMILAR = $(patsubst %.c,$(BUILD)/%.o,$(filter-out %/similar.c tests/similar/test_%.c, \
              $(wildcard tests/similar/*.c)))

$(BUILD)/similar: $(BUILD)/tests/similar/similar.o $(SIMILAR) $(CHECKER) $(BUILD)/libcommon.a
	$(LINK) $^ -lm -o $@

# ---- make test ----

# The tests' own build of everything: sanitized, and without threads.
# What is always inlined elsewhere are functions here: with the sanitizers' code in each copy, gcc
# would need more than twice as long.
# (Vectors wider than the processor's are passed otherwise than by gcc 4.5, which it would tell.)
TESTED   = $(CC) $(STRICT) $(WARNINGS) $(WERROR) $(SANITIZED) -Dalways_inline=unused \
           -Dflatten=unused $(DEFINES) -Icommon -Itests/unit -Itests/oracle -MMD -MP

UNITS    = $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(wildcard tests/unit/test_*.c)))
CHECKERS = $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(wildcard tests/check/test_*.c)))
HELPERS  = $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(wildcard tests/help/test_*.c)))
ALIKE    = $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(wildcard tests/similar/test_*.c)))
REPLAYS  = $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(wildcard tests/fuzz/fuzz_*.c)))
SCRIPTS  = $(wildcard tests/unit/*.sh) tests/fuzz/replay.sh

ORACLE         = $(BUILD)/tested/tests/oracle/oracle.o
TESTED_COMMON  = $(COMMON:%=$(BUILD)/tested/common/%.o)
TESTED_CHECKER = $(CHECKER:$(BUILD)/%=$(BUILD)/tested/%)

$(BUILD)/tested/flags: force
	@mkdir -p $(@D) $(BUILD)/tests
	@[ "$$(cat $@ 2>/dev/null)" = '$(TESTED)' ] || echo '$(TESTED)' >$@

# Those of lanes_native.h and pixel_mask.h with the instructions of this processor, which they choose.
NATIVE_TESTS = $(BUILD)/tested/tests/unit/test_lanes% $(BUILD)/tested/tests/unit/test_pixel_mask%
$(BUILD)/tested/%.o: %.c $(BUILD)/tested/flags
	@mkdir -p $(@D)
	$(TESTED) $(if $(filter $(NATIVE_TESTS),$@),$(MARCH)) -c $< -o $@

$(BUILD)/tested/tests/help/page_files.o: $(BUILD)/tests/help/page_files.c $(BUILD)/tested/flags
	@mkdir -p $(@D)
	$(TESTED) -Itests/help -c $< -o $@

# A test that defines __wrap_malloc() or the like gets the calls of malloc() (--wrap of GNU ld).
WRAPPED = $$(sed -n 's/.*__wrap_\([a-z_]*\)(.*{$$/-Wl,--wrap=\1/p' tests/unit/$*.c)

$(UNITS): $(BUILD)/tests/%: $(BUILD)/tested/tests/unit/%.o $(ORACLE) $(TESTED_COMMON)
	$(TESTED) $(WRAPPED) $^ -lm -o $@

$(CHECKERS): $(BUILD)/tests/%: $(BUILD)/tested/tests/check/%.o $(TESTED_CHECKER) $(TESTED_COMMON)
	$(TESTED) $^ -lm -o $@

$(HELPERS): $(BUILD)/tests/%: $(BUILD)/tested/tests/help/%.o $(HELPING:$(BUILD)/%=$(BUILD)/tested/%) \
                              $(TESTED_COMMON)
	$(TESTED) $^ -lm -o $@

$(ALIKE): $(BUILD)/tests/%: $(BUILD)/tested/tests/similar/%.o $(SIMILAR:$(BUILD)/%=$(BUILD)/tested/%) \
                            $(TESTED_CHECKER) $(TESTED_COMMON)
	$(TESTED) $^ -lm -o $@

$(REPLAYS): $(BUILD)/tests/%: $(BUILD)/tested/tests/fuzz/%.o $(BUILD)/tested/tests/fuzz/replay.o \
                              $(TESTED_COMMON)
	$(TESTED) $^ -lm -o $@

.PHONY: test
test: $(UNITS) $(CHECKERS) $(HELPERS) $(ALIKE) $(REPLAYS) $(BUILD)/check $(BUILD)/looks_make \
      $(BUILD)/figure_make $(BUILD)/references $(BUILD)/show $(BUILD)/compare_page \
      $(BUILD)/hidden $(BUILD)/similar $(BUILD)/limited programs models
	@CHECK_PROGRAMS=$(BUILD) tests/run_tests.sh $(SCRIPTS) $(UNITS) $(CHECKERS) $(HELPERS) $(ALIKE)

# ---- make stress, make bench: exact answers, and run time against error ----

# Benchmarks have Mesa's renderer beside ours where it is installed. Whether it is there is asked
# when it matters.
FIND_MESA = printf '%s\n' '\#include <EGL/egl.h>' '\#include <GL/glcorearb.h>' | \
            $(CC) -E - >/dev/null 2>&1
ifneq ($(filter bench bench-frame $(BUILD)/bench%,$(MAKECMDGOALS)),)
HAS_MESA := $(shell $(FIND_MESA) && echo yes)
endif
PEER_OBJECTS = $(addprefix $(BUILD)/tests/,frame/child.o frame/pairs.o frame/scene.o \
                   frame/vertices.o $(if $(HAS_MESA), \
                   frame/llvmpipe.o opengl/context.o opengl/picture.o,frame/without_llvmpipe.o))

SAY_WITHOUT_MESA = $(if $(HAS_MESA),,echo 'without llvmpipe: $(MESA_IS_MISSING)')

# Changes only when Mesa comes or goes.
$(BUILD)/with-mesa: force
	@[ "$$(cat $@ 2>/dev/null)" = 'with: $(HAS_MESA)' ] || echo 'with: $(HAS_MESA)' >$@

# Stress and benchmarks share out their cases with OpenMP, where the compiler has it.
OPENMP = $(call ONCE,OPENMP,$(call PROBE,-fopenmp))

OBJECTS_OF = $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(wildcard $(1:%=tests/%/*.c)))
.PHONY: stress bench

$(BUILD)/stress: $(call OBJECTS_OF,stress oracle) $(BUILD)/libcommon.a
	$(LINK) $(OPENMP) $^ -lm -o $@

stress: $(BUILD)/stress
	$(BUILD)/stress $(PROPERTY)

$(BUILD)/benchmark: $(call OBJECTS_OF,bench oracle) $(BUILD)/tests/bench/list.o \
                    $(BUILD)/tests/help/escape.o $(PEER_OBJECTS) $(BUILD)/libcommon.a \
                    $(BUILD)/with-mesa
	$(LINK) $(OPENMP) $(filter-out %-mesa,$^) $(if $(HAS_MESA),-lEGL -lGL) -lm -o $@

# With lesson 9 also what it is worth to skip, where most of a scene is hidden or off screen.
bench: $(BUILD)/benchmark $(BUILD)/bench-frame models
	@mkdir -p $(BUILD)/bench
	@$(if $(filter-out 9 09,$(STEP)),,$(SAY_WITHOUT_MESA))
	$(BUILD)/benchmark -o $(BUILD) $(STEP)
	$(if $(filter-out 9 09,$(STEP)),,$(BUILD)/bench-frame --skipping --frames 7)

# Instructions, which no other process disturbs.
.PHONY: counts
counts:
	@tests/counts.sh $(BUILD) '$(STEP)'

# A whole run, beside the same bytes only read and copied.
.PHONY: bench-run
bench-run:
	@tests/whole_run.sh $(BUILD)

# Files, beside libpng where it is installed.
LIBPNG = $(shell echo '\#include <libpng16/png.h>' | $(CC) -E - >/dev/null 2>&1 && echo -lpng16)
.PHONY: bench-files
bench-files: $(BUILD)/bench-files all
	$(BUILD)/bench-files

$(BUILD)/bench-files: $(call OBJECTS_OF,files) $(BUILD)/tests/bench/measure.o \
                      $(BUILD)/tests/bench/report.o $(BUILD)/tests/check/compare.o \
                      $(BUILD)/libcommon.a
	$(LINK) $^ $(LIBPNG) -lm -o $@

# ---- make compare-opengl, make bench-frame: beside Mesa's renderer ----

.PHONY: compare-opengl has-mesa bench-frame
MESA_IS_MISSING = Mesa is missing; on Debian: apt-get install libegl-dev libgl-dev libegl1 \
                  libgl1-mesa-dri

OPENGL_OBJECTS = $(call OBJECTS_OF,opengl) $(BUILD)/tests/opengl/list.o

compare-opengl: $(BUILD)/compare-opengl models
	$(BUILD)/compare-opengl

$(BUILD)/compare-opengl: $(OPENGL_OBJECTS) $(BUILD)/libcommon.a
	$(LINK) $^ -lEGL -lGL -lm -o $@

# Says what is missing before the compiler does.
$(OPENGL_OBJECTS): | has-mesa
has-mesa:
	@$(FIND_MESA) || { echo 'compare-opengl: $(MESA_IS_MISSING)'; exit 2; }


bench-frame: $(BUILD)/bench-frame models
	@$(SAY_WITHOUT_MESA)
	@$(BUILD)/bench-frame $(OPTIONS)

$(BUILD)/bench-frame: $(sort $(filter-out %llvmpipe.o,$(call OBJECTS_OF,frame oracle)) \
                        $(PEER_OBJECTS)) $(BUILD)/libcommon.a $(BUILD)/with-mesa
	$(LINK) $(filter-out %-mesa,$^) $(if $(HAS_MESA),-lEGL -lGL) -lm -o $@

# ---- make verify: what the check makes of wrong programs, and of correct ones ----

.PHONY: verify
verify: $(BUILD)/check $(BUILD)/figure_make models
	@tests/verify/verify.sh $(BUILD) '$(MAKE) -s' '$(STEP)' '$(NAME)'

# What is found out about the compiler, for who calls make hundreds of times.
.PHONY: found
found:
	@echo "THREADED='$(THREADED)' MARCH='$(MARCH)'"

# What the mistakes look like, which the check knows them by, and the lessons' figures of them.
.PHONY: mistakes
mistakes: $(BUILD)/check $(BUILD)/looks_make $(BUILD)/figure_make models
	@tests/verify/mistakes.sh $(BUILD) '$(MAKE) -s' '$(STEP)' '$(MEASURE)'

$(BUILD)/looks_make $(BUILD)/figure_make: $(BUILD)/%: $(BUILD)/tests/check/%.o $(CHECKER) \
                                           $(BUILD)/libcommon.a
	$(LINK) $^ -lm -o $@

# One of these programs, built with what is there: the library has the flags of the course.
$(BUILD)/verify.%: force
	$(COMPILE) -I$(@F) -c $(@D)/main.c -o $@.o
	$(LINK) $@.o $(BUILD)/libcommon.a -lm -o $@
# What such a program depends on is no program.
$(BUILD)/verify.%.d: ;

# ---- make handout, make key: what students get, and what their instructor gets ----

.PHONY: handout key
handout:
	@tests/handout/handout.sh '$(OUT)' '$(LESSONS)'

key: $(BUILD)/check models
	@tests/handout/key.sh $(BUILD) '$(MAKE) -s' '$(OUT)' '$(LESSONS)'

# ---- make mutants, portability, fuzz, coverage ----

.PHONY: mutants portability fuzz coverage
mutants:
	@tests/mutants/run.sh $(BUILD) '$(or $(NAME),*)' '$(ONLY)'

portability:
	@tests/portability/portability.sh -b $(BUILD)/portability $(CONFIGURATIONS)

FUZZ_SECONDS = 60
fuzz:
	tests/fuzz/run.sh $(BUILD) $(FUZZ_SECONDS) $(TARGET)

coverage: models
	tests/coverage.sh $(BUILD)

# ---- The lessons that are measured and compared with OpenGL ----

# list.c names what each stepNN.c of its directory defines; it is written again when a file comes or
# goes.
NAMES_IN = $(basename $(notdir $(sort $(wildcard tests/$(1)/step[0-9][0-9].c))))

$(BUILD)/tests/bench/list.c: tests/bench
	@mkdir -p $(@D)
	@{ echo '#include "bench.h"'; \
	   printf 'extern const struct bench_lesson bench_%s;\n' $(call NAMES_IN,bench); \
	   echo 'const struct bench_lesson *const bench_lessons[] = {'; \
	   printf '    &bench_%s,\n' $(call NAMES_IN,bench); echo '    NULL};'; } >$@

$(BUILD)/tests/opengl/list.c: tests/opengl
	@mkdir -p $(@D)
	@{ echo '#include "lesson.h"'; \
	   printf 'struct lesson lesson_%s(void);\n' $(call NAMES_IN,opengl); \
	   echo 'lesson_function *const lesson_functions[] = {'; \
	   printf '    lesson_%s,\n' $(call NAMES_IN,opengl); echo '    NULL};'; } >$@

$(BUILD)/tests/%/list.o: $(BUILD)/tests/%/list.c $(BUILD)/flags
	$(COMPILE) -Itests/$* -c $< -o $@
