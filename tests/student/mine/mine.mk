# make MINE=1: later lessons draw with what a student wrote in earlier ones, where that is right.
#
# With MINE make first builds what all lessons share, and then calls itself with a build directory of
# its own, BUILD/mine, in which that is linked; HOUSE is the other one. So going to and fro compiles
# nothing twice. mine.sh says what is made there.

OURSELVES = $(MAKE) --no-print-directory MINE=
GOALS := $(or $(MAKECMDGOALS),all)
.PHONY: $(GOALS)
$(firstword $(GOALS)):
	@MAKEFLAGS=$$(echo "$$MAKEFLAGS" | sed 's/ -j[0-9]*//; s/ --jobserver-[a-z]*=[^ ]*//'); export MAKEFLAGS; \
	$(OURSELVES) $(BUILD)/shared SHARED='$(addprefix $(BUILD)/,quick/libcommon.a models/bust.obj check \
	    $(if $(filter-out check live open show watch,$(GOALS)),libcommon.a) $(filter live,$(GOALS)) \
	    $(patsubst open,compare_page,$(filter open,$(GOALS))) \
	    $(if $(filter show watch,$(GOALS))$(MAKE_TERMOUT),show))' && \
	sh tests/student/mine/mine.sh link '$(BUILD)' && \
	$(OURSELVES) HOUSE='$(BUILD)' BUILD='$(BUILD)/mine' $(GOALS)
$(wordlist 2,99,$(GOALS)): $(firstword $(GOALS)) ; @:
