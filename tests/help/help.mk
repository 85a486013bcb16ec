# make hint STEP=05       the next hint for the first task that is still to do (TASK=5.2, AGAIN=1)
# make show STEP=05       the pictures in the terminal (SCENE=depth; WHICH=yours,reference,difference;
#                         KIND=blocks, sixel or kitty, where it is not seen what the terminal can)
# make open STEP=05       the same in the browser, as a page that needs nothing else (SCENE=depth)
# make watch STEP=05      builds, checks and shows at every save; Ctrl-C ends it (SCENE=depth)
.PHONY: hint show open watch
hint:
	@tests/help/hint.sh '$(BUILD)' '$(STEP)' '$(TASK)' '$(AGAIN)'

# Of the lesson that STEP names; without one the scripts say what is wrong.
HELPED = $(if $(STEP),$(filter $(STEP:%/=%) step$(STEP)_% step0$(STEP)_%,$(STEPS)))

# They draw themselves, since what hangs or crashes is to be shown as far as it comes.
DRAWS  = $(HELPED:%=$(BUILD)/drawn/%) $(BUILD)/models/bust.obj

open: $(BUILD)/compare_page $(DRAWS)
	@tests/help/open.sh '$(BUILD)' '$(STEP)' '$(SCENE)'

show: $(BUILD)/show $(DRAWS)
	@tests/help/show.sh '$(BUILD)' '$(STEP)' '$(SCENE)' '$(WHICH)' '$(KIND)'

watch:
	@tests/help/watch.sh '$(BUILD)' '$(MAKE) -s' '$(STEP)' '$(SCENE)'

HELPING = $(addprefix $(BUILD)/tests/,help/base64.o help/escape.o help/page.o help/page_files.o \
                                       help/pictures.o help/terminal.o check/compare.o check/scenes.o check/verdict.o)

$(BUILD)/show $(BUILD)/compare_page: $(BUILD)/%: $(BUILD)/tests/help/%.o $(HELPING) \
                                     $(BUILD)/libcommon.a
	$(LINK) $^ -lm $(PLACED)
