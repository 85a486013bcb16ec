# Builds every step, draws its pictures and compares them with the references.
#
#   make                draw every picture of the course into build/out
#   make check          compare the pictures with tests/reference (make check STEP=05 for one step)
#   make test           unit tests under sanitizers, and the tests of the check
#   make stress         hostile numbers against exact answers (STRESS=10, SEED=7, PROPERTY=line)
#   make bench          run time against error, a chart for each lesson (STEP=05 for one)
#   make charts         put these charts into the lessons
#   make portability    the same bytes from other compilers and on other machines (CONFIGURATIONS=arm64)
#   make compare-opengl the same pictures drawn by OpenGL (needs Mesa)
#   make fuzz           hostile files (needs clang; FUZZ_SECONDS=60 for each, TARGET=png)
#   make coverage       which lines and branches of common the tests reach
#   make figures        draw the other pictures that the lessons show
#   make references     draw the reference images again (never part of a check)
#   make clean
#
# CC=clang, CFLAGS=-O0, WERROR=-Werror and BUILD=some/directory may be given on the command line.

BUILD  = build
CFLAGS = -O3
STEPS  = step01_line step02_wireframe step03_triangle step04_flat step05_zbuffer \
         step06_texture step07_gouraud step08_projection step09_shaders step10_phong

# All cores, unless the command line says otherwise.
ifeq ($(filter -j%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif

WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes -Wmissing-prototypes
# One rounding for each operation, so that every machine computes the same bytes.
STRICT   = -std=c17 -ffp-contract=off
DEFINES  = -DCOURSE_BUILD='"$(abspath $(BUILD))"'
# Threads where the compiler has them; they change no byte.
OPENMP  := $(shell mkdir -p $(BUILD) && echo 'int main(void) { return 0; }' >$(BUILD)/probe.c && \
                   $(CC) -fopenmp $(BUILD)/probe.c -o $(BUILD)/probe 2>/dev/null && echo -fopenmp)
COMPILE  = $(CC) $(STRICT) $(WARNINGS) $(WERROR) $(CFLAGS) $(OPENMP) $(DEFINES) -Icommon -MMD -MP
SANITIZE = -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
# The tests' own build of everything: sanitized, and without threads.
TESTED   = $(CC) $(STRICT) $(WARNINGS) $(WERROR) $(SANITIZE) $(DEFINES) -Icommon -Itests/unit -Itests/oracle -MMD -MP

COMMON   = $(basename $(notdir $(wildcard common/*.c)))
LIBRARY  = $(BUILD)/libcommon.a
MODELS   = $(BUILD)/models/bust.obj
PROGRAMS = $(STEPS:%=$(BUILD)/%)
UNITS    = $(basename $(notdir $(wildcard tests/unit/test_*.c)))
CHECKERS = $(basename $(notdir $(wildcard tests/check/test_*.c)))
SCRIPTS  = $(wildcard tests/unit/*.sh)

.PHONY: all programs models check test stress bench charts portability compare-opengl fuzz coverage \
        figures references clean
.DELETE_ON_ERROR:
.SECONDARY:

all: $(STEPS:%=$(BUILD)/out/%/.drawn)
programs: $(PROGRAMS)
models: $(MODELS)

# ---- Programs ----

# Changes only when the compiler or its flags do, and then everything is built again.
$(BUILD)/flags: force
	@mkdir -p $(@D)
	@echo '$(COMPILE) $(TESTED)' | cmp -s - $@ || echo '$(COMPILE) $(TESTED)' >$@
.PHONY: force

$(BUILD)/common/%.o: common/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -c $< -o $@

$(LIBRARY): $(COMMON:%=$(BUILD)/common/%.o)
	@rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/step%: step%/main.c $(LIBRARY) $(BUILD)/flags
	$(COMPILE) -MF $@.d $< $(LIBRARY) -lm -o $@

# ---- Models and pictures ----

SCULPTOR = $(patsubst common/sculptor/%.c,$(BUILD)/sculptor/%.o,$(wildcard common/sculptor/*.c))

$(BUILD)/sculptor/%.o: common/sculptor/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -c $< -o $@

$(BUILD)/sculpt: $(SCULPTOR) $(LIBRARY)
	$(CC) $(CFLAGS) $(OPENMP) $^ -lm -o $@

$(BUILD)/models/bust.obj: $(BUILD)/sculpt
	@mkdir -p $(@D)
	$(BUILD)/sculpt $(@D)

$(BUILD)/out/%/.drawn: $(BUILD)/% $(MODELS)
	$(BUILD)/$* -o $(@D)
	@touch $@

FIGURES = $(STEPS:%=figures-%)
.PHONY: $(FIGURES)
figures: $(FIGURES)
$(FIGURES): figures-%: $(BUILD)/figures/% $(MODELS)
	$(BUILD)/figures/$* $*/figures

$(BUILD)/figures/%: %/figures.c %/main.c $(LIBRARY) $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -MF $@.d $< $(LIBRARY) -lm -o $@

# ---- The check ----

CHECKER = $(addprefix $(BUILD)/tests/check/,compare.o drawn.o run.o scenes.o)

$(BUILD)/check $(BUILD)/references: $(BUILD)/%: $(BUILD)/tests/check/%.o $(CHECKER) $(LIBRARY)
	$(CC) $(CFLAGS) $(OPENMP) $^ -lm -o $@

# The check builds the steps itself: one that does not build is a finding, not the end.
check: $(BUILD)/check
	@$(BUILD)/check --programs $(BUILD) --differences $(BUILD)/differences --make '$(MAKE) -s' $(STEP)

references: $(BUILD)/references $(PROGRAMS) $(MODELS)
	$(BUILD)/references --programs $(BUILD) $(STEP)

# ---- Tests ----

ORACLE = $(BUILD)/tested/tests/oracle/oracle.o
TESTED_COMMON = $(COMMON:%=$(BUILD)/tested/common/%.o)
TESTED_CHECKER = $(addprefix $(BUILD)/tested/tests/check/,compare.o drawn.o run.o scenes.o)
TEST_PROGRAMS = $(UNITS:%=$(BUILD)/tests/%) $(CHECKERS:%=$(BUILD)/tests/%)

$(BUILD)/tested/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(TESTED) -c $< -o $@

# A test that defines __wrap_malloc() or the like gets the calls of malloc() (GNU ld, option --wrap).
WRAPPED = $$(sed -n 's/.*__wrap_\([a-z]*\).*{$$/-Wl,--wrap=\1/p' tests/unit/$*.c)

$(UNITS:%=$(BUILD)/tests/%): $(BUILD)/tests/%: $(BUILD)/tested/tests/unit/%.o $(ORACLE) $(TESTED_COMMON)
	@mkdir -p $(@D)
	$(TESTED) $(WRAPPED) $^ -lm -o $@

$(CHECKERS:%=$(BUILD)/tests/%): $(BUILD)/tests/%: $(BUILD)/tested/tests/check/%.o $(TESTED_CHECKER) $(TESTED_COMMON)
	@mkdir -p $(@D)
	$(TESTED) $^ -lm -o $@

# Every test runs, also after one that failed.
test: $(TEST_PROGRAMS) $(BUILD)/check $(BUILD)/references $(MODELS)
	@passed=0; failed=0; \
	for test in $(TEST_PROGRAMS) $(SCRIPTS); do \
	    echo "== $$test"; \
	    if CHECK_PROGRAMS=$(BUILD) $$test; then passed=$$((passed + 1)); \
	    else failed=$$((failed + 1)); echo "FAILED $$test"; fi; \
	done; \
	echo "$$passed passed, $$failed failed"; [ $$failed -eq 0 ]

# ---- Stress ----

STRESS_PARTS = $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(wildcard tests/stress/*.c) tests/oracle/oracle.c)

$(BUILD)/tests/%.o: tests/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(COMPILE) -Itests/oracle -c $< -o $@

$(BUILD)/stress: $(STRESS_PARTS) $(LIBRARY)
	$(CC) $(CFLAGS) $(OPENMP) $^ -lm -o $@

stress: $(BUILD)/stress
	$(BUILD)/stress $(PROPERTY)

# ---- Run time against error ----

BENCHMARK = $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(wildcard tests/bench/*.c) tests/oracle/oracle.c)

$(BUILD)/benchmark: $(BENCHMARK) $(LIBRARY)
	$(CC) $(CFLAGS) $(OPENMP) $^ -lm -o $@

bench: $(BUILD)/benchmark $(MODELS)
	@mkdir -p $(BUILD)/bench
	$(BUILD)/benchmark -o $(BUILD) $(STEP)

# The charts of the last `make bench` become those of the lessons.
charts:
	@for step in $(STEPS); do \
	    if [ -f $(BUILD)/bench/$$step.svg ]; then cp $(BUILD)/bench/$$step.svg $$step/figures/bench.svg; \
	    else echo "$$step: no chart yet; make bench draws it"; fi; done

# ---- Other machines, other renderers, hostile files ----

portability:
	@tests/portability/portability.sh -b $(BUILD)/portability $(CONFIGURATIONS)

OPENGL_PARTS = $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(wildcard tests/opengl/*.c))

$(BUILD)/compare-opengl: $(OPENGL_PARTS) $(LIBRARY)
	$(CC) $(CFLAGS) $(OPENMP) $^ -lEGL -lGL -lm -o $@

compare-opengl: $(MODELS)
	@if printf '%s\n' '#include <EGL/egl.h>' '#include <GL/glcorearb.h>' | \
	    $(CC) -E - >/dev/null 2>&1; then \
	    $(MAKE) -s $(BUILD)/compare-opengl && $(BUILD)/compare-opengl; \
	else echo 'compare-opengl: Mesa is missing; on Debian: apt-get install libegl-dev libgl-dev' \
	    'libegl1 libgl1-mesa-dri'; exit 2; fi

FUZZ_SECONDS = 60
fuzz:
	tests/fuzz/run.sh $(BUILD) $(FUZZ_SECONDS) $(TARGET)

coverage: $(MODELS)
	tests/coverage.sh $(BUILD)

clean:
	rm -rf $(BUILD)

-include $(wildcard $(BUILD)/*.d $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/*/*/*/*.d)
