##
## What the course measures:
##   make bench                  run time against error, a chart for each lesson (STEP=05 for one)
##   make charts                 put these charts into the lessons
##   make bench-frame            the time of a frame next to Mesa's llvmpipe (OPTIONS=--help)
##   make counts                 the instructions of each scene, next to those committed (STEP=05)
.PHONY: bench charts bench-frame counts

# Stress and benchmarks share out their cases with OpenMP, where the compiler has it.
OPENMP = $(eval OPENMP := $$(shell $$(CC) -fopenmp -E -x c /dev/null >/dev/null 2>&1 && echo -fopenmp))$(OPENMP)
$(BUILD)/tests/lessons/%.o $(BUILD)/tests/upkeep/stress/%.o: INCLUDES = -Itests $(OPENMP)

OBJECTS_OF = $(patsubst %.c,$(BUILD)/%.o,$(wildcard $(1:%=tests/%/*.c)))

# ---- make bench, make charts ----

# The lessons that are measured: list.c names what each bench.c defines.
MEASURED = $(patsubst tests/lessons/%/bench.c,%,$(sort $(wildcard tests/lessons/*/bench.c)))
$(BUILD)/tests/bench/list.c: $(MEASURED:%=tests/lessons/%/bench.c)
	@mkdir -p $(@D)
	@{ echo '#include "bench/bench.h"'; \
	   for step in $(MEASURED); do echo "extern const struct bench_lesson bench_$${step%%_*};"; done; \
	   echo 'const struct bench_lesson *const bench_lessons[] = {'; \
	   for step in $(MEASURED); do echo "    &bench_$${step%%_*},"; done; echo '    NULL};'; } >$@

$(BUILD)/tests/bench/list.o: $(BUILD)/tests/bench/list.c $(BUILD)/flags
	$(Q)$(COMPILE) -Itests -c $< -o $@

$(BUILD)/benchmark: $(filter-out %/figures.o,$(call OBJECTS_OF,bench oracle)) $(BUILD)/tests/bench/list.o \
                    $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/lessons/*/bench.c)) \
                    $(BUILD)/libcommon.a
	$(Q)$(LINK) $(OPENMP) $^ -lm -o $@

# With lesson 9 also what it is worth to skip, where most of a scene is hidden.
bench: $(BUILD)/benchmark $(BUILD)/bench-frame models
	@mkdir -p $(BUILD)/bench
	$(Q)$(BUILD)/benchmark $(STEP)
	$(Q)$(if $(filter-out 9 09,$(STEP)),,$(BUILD)/bench-frame --skipping --frames 7)

# The charts of the last `make bench` become those of the lessons.
charts:
	@for step in $(STEPS); do \
	    if [ -f $(BUILD)/bench/$$step.svg ]; then \
	        mkdir -p $$step/figures && cp $(BUILD)/bench/$$step.svg $$step/figures/bench.svg; \
	    elif [ -f tests/lessons/$$step/bench.c ]; then \
	        echo "$$step: no chart yet; make bench draws it"; \
	    fi; done

# ---- Frames, instructions ----

# With Mesa's renderer next to ours where it is installed, which is asked when it
# matters.
ifneq ($(filter bench bench-frame $(BUILD)/bench-frame,$(MAKECMDGOALS)),)
HAS_MESA := $(shell printf '%s\n' '\#include <EGL/egl.h>' '\#include <GL/glcorearb.h>' | \
                    $(CC) -E - >/dev/null 2>&1 && echo yes)
endif
NOT_LINKED = $(if $(HAS_MESA),%/without_llvmpipe.o,%/llvmpipe.o)

# Changes only when Mesa comes or goes.
$(BUILD)/with-mesa: force
	@mkdir -p $(@D)
	@echo 'with: $(HAS_MESA)' | cmp -s - $@ || echo 'with: $(HAS_MESA)' >$@

bench-frame: $(BUILD)/bench-frame models
	@$(if $(HAS_MESA),,echo 'without llvmpipe: Mesa is missing; on Debian: apt-get install \
	    libegl-dev libgl-dev libegl1 libgl1-mesa-dri')
	$(Q)$(BUILD)/bench-frame $(OPTIONS)

$(BUILD)/bench-frame: $(filter-out $(NOT_LINKED),$(call OBJECTS_OF,bench/frame oracle)) \
                      $(BUILD)/tests/check/arguments.o $(BUILD)/libcommon.a $(BUILD)/with-mesa
	$(Q)$(LINK) $(filter-out %-mesa,$^) $(if $(HAS_MESA),-lEGL -lGL) -lm -o $@

# Instructions, which no other process disturbs.
counts:
	@sh tests/bench/counts.sh $(BUILD) '$(STEP)'
