##   make start STEP=05          turn main.c into the starter: what you write is left out
##   make solution STEP=05       bring the lesson's own solution back
##   make hint STEP=05           a hint for what is to do, and more each time (TASK=5.2)
##   make show STEP=05           the pictures in the terminal, next to the references (SCENE=depth,
##                               WHICH=yours,reference,difference, KIND=blocks or kitty)
##   make open STEP=05           the same in the browser, in one page
##   make live STEP=05           your program under the mouse, in the browser; each save is drawn
##   make watch STEP=05          check and show again at every save, until Ctrl-C
##   make new NAME=mine          a program of your own, mine/main.c, which draws with the pipeline; or
##                               with what you wrote in lesson 3 (AFTER=3)
##   make mine                   build it, draw into build/out/mine and show that (MODEL=a.obj, or several)
##   make renderer               what you wrote in ten lessons becomes one C file (OUT=renderer.c; SPEED=1:
##                               and how long a frame takes)
##   make MINE=1                 lessons draw with what you wrote in earlier ones (STEP=05; also with
##                               check, live, show, open, watch)
.PHONY: start solution hint show open live watch new renderer
start solution:
	@sh tests/student/start.sh $@ '$(STEP)'

hint:
	$(END_LINE)
	@sh tests/student/hint.sh '$(BUILD)' '$(STEP)' '$(TASK)' '$(AGAIN)' '$(MAKE) -s'

# They draw themselves: what hangs or crashes is shown as far as it comes. Of the lesson that STEP
# names; without one the scripts say what is wrong.
SHOWN = $(if $(STEP),$(CHOSEN:%=$(BUILD)/quick/%) $(MODEL))

open: $(BUILD)/compare_page $(SHOWN)
	$(END_LINE)
	@sh tests/student/open.sh '$(BUILD)' '$(STEP)' '$(SCENE)'

show: $(BUILD)/show $(SHOWN)
	$(END_LINE)
	@sh tests/student/show.sh '$(BUILD)' '$(STEP)' '$(SCENE)' '$(WHICH)' '$(KIND)'

live: $(BUILD)/live $(SHOWN:$(BUILD)/quick/%=$(BUILD)/moving/%)
	$(END_LINE)
	@sh tests/student/live.sh '$(BUILD)' '$(MAKE) -s $(KNOWN)' '$(STEP)' '$(MODEL)'

# The lesson's program with what the page lets be changed, and what it says of a pixel.
$(STEPS:%=$(BUILD)/moving/%): $(BUILD)/moving/%: %/main.c $(BUILD)/%.text $(BUILD)/quick/libcommon.a \
                                                 $(BUILD)/flags
	@mkdir -p $(@D)
	$(call BUILD_LESSON,$(QUICK) $(LESSON_FLAGS),$(LESSON_OBJECTS),live)
$(STEPS:%=$(BUILD)/moving/sanitized/%): $(BUILD)/moving/sanitized/%: %/main.c $(BUILD)/%.text \
                                        $(BUILD)/quick/libcommon.a $(BUILD)/flags
	@mkdir -p $(@D)
	$(call BUILD_LESSON,$(SANITIZED) $(LESSON_FLAGS),$(LESSON_OBJECTS),live)

$(BUILD)/live: $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/student/live/*.c)) $(CHECKER) \
               $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@

watch:
	@sh tests/student/watch.sh '$(BUILD)' '$(MAKE) -s $(KNOWN)' '$(STEP)' '$(SCENE)'

$(BUILD)/show $(BUILD)/compare_page: $(BUILD)/%: $(BUILD)/tests/student/%.o \
                                     $(BUILD)/tests/student/terminal.o $(CHECKER) \
                                     $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@

# ---- A renderer of one's own ----

renderer: $(BUILD)/models/bust.obj $(if $(SPEED),$(BUILD)/step10_phong)
	@sh tests/student/renderer/renderer.sh '$(BUILD)' '$(OUT)' '$(CC)' '$(SPEED)'

# ---- A program of one's own: a directory with a file .new ----

# A NAME of the environment does not count: WSL has one.
new:
	@sh tests/student/new.sh '$(MAKE) -s' $(if $(findstring command,$(origin NAME)),"$$NAME" "$$AFTER")

OWN := $(patsubst %/.new,%,$(wildcard */.new))
.PHONY: $(OWN)
$(OWN): %: $(BUILD)/own/% $(BUILD)/models/bust.obj $(if $(MAKE_TERMOUT),$(BUILD)/show)
	$(SAY) DRAW $@
	$(Q)$< $(if $(filter 1 01,$(shell cat $@/.new)),,--fit $(MODEL)) --format png
	@[ ! -t 1 ] || sh tests/student/next.sh '$(BUILD)' '' $(BUILT)/out/$@/*.png

$(OWN:%=$(BUILD)/own/%): $(BUILD)/own/%: %/main.c $(BUILD)/libcommon.a $(BUILD)/flags
	@mkdir -p $(@D)
	$(call BUILD_LESSON,$(patsubst %,-DCOURSE_LESSON=% -Wno-unused,$(shell cat $*/.new)))

# ---- MINE=1 ----

# What mine.mk wants first.
$(BUILD)/shared: $(SHARED)
	@:
ifneq ($(HOUSE),)
include tests/student/mine/hers.mk
endif
