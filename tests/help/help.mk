# make hint STEP=05       the next hint for the first task that is still to do (TASK=5.2, AGAIN=1)
# make show STEP=05       the pictures in the terminal (SCENE=depth; WHICH=yours,reference,difference;
#                         KIND=blocks, sixel or kitty, where it is not seen what the terminal can)
.PHONY: hint show
hint:
	@tests/help/hint.sh '$(BUILD)' '$(STEP)' '$(TASK)' '$(AGAIN)'

# Of the lesson that STEP names; without one the scripts say what is wrong.
HELPED = $(if $(STEP),$(filter $(STEP:%/=%) step$(STEP)_% step0$(STEP)_%,$(STEPS)))

show: $(BUILD)/show $(HELPED:%=$(BUILD)/out/%/.drawn)
	@tests/help/show.sh '$(BUILD)' '$(STEP)' '$(SCENE)' '$(WHICH)' '$(KIND)'

TERMINAL = $(addprefix $(BUILD)/tests/,help/base64.o help/pictures.o help/terminal.o check/compare.o)

$(BUILD)/show: $(BUILD)/tests/help/show.o $(TERMINAL) $(BUILD)/libcommon.a
	$(LINK) $^ -lm -o $@
