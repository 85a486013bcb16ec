##   make check                  compare the pictures with tests/reference
##   make check STEP=05          the same for one lesson (REPORT=file writes file.html, and .xml
##                               and .json for other programs)
##   make check STEP=05 SANITIZE=1   the same, and in which line a program goes wrong

# The parts of the check; the files with a main() are not among them.
CHECKER_FILES = $(filter-out %/check.c %/looks_make.c %/figure_make.c tests/check/test_%.c, \
                    $(wildcard tests/check/*.c tests/check/page/*.c)) $(BUILD)/tests/check/page/page_files.c
CHECKER       = $(BUILD)/quick/tests/check/all.o

# The check builds the lessons itself: one that does not build is a finding, not the end.
# SANITIZE=1: their main.c with the sanitizers, which tell in which line a program goes wrong. They
# are slow; memory that is not freed at the end is no fault here, and a failed assert() is.
CHECKED   = $(BUILD)/$(if $(SANITIZE),sanitized,quick)
SANITIZED = -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
ifneq ($(HIDDEN),)
ifeq ($(wildcard tests/teacher/hidden),)
$(error HIDDEN=$(HIDDEN): hidden scenes are drawn where the solutions are)
endif
endif
.PHONY: check
check: $(MODEL) $(BUILD)/check $(HIDDEN:%=$(BUILD)/hidden) $(if $(MAKE_TERMOUT),$(BUILD)/show)
	$(END_LINE)
	@$(if $(SANITIZE),ASAN_OPTIONS=detect_leaks=0:handle_abort=1 UBSAN_OPTIONS=print_stacktrace=1 \
	                CHECK_TIMEOUT=$${CHECK_TIMEOUT:-60}) \
	$(BUILD)/check --programs $(CHECKED) --differences $(BUILD)$(if $(SANITIZE),/sanitized)/differences \
	    --make '$(MAKE) -s $(KNOWN)' \
	    $(if $(SANITIZE),--sanitized) \
	    $(if $(REPORT),--junit $(REPORT).xml --json $(REPORT).json --html $(REPORT).html) \
	    $(if $(HOUSE),$(if $(REPORT),,--json $(BUILD)/checked.json)) $(STEP) $(THEN_HIDDEN) \
	    $(if $(HOUSE),|| { sh tests/student/mine/mine.sh whose '$(BUILD)' '$(or $(REPORT),$(BUILD)/checked).json'; exit 1; })

$(STEPS:%=$(BUILD)/sanitized/%): $(BUILD)/sanitized/%: %/main.c $(BUILD)/%.text \
                                                       $(BUILD)/quick/libcommon.a $(BUILD)/flags
	@mkdir -p $(@D)
	$(call BUILD_LESSON,$(SANITIZED),,trials)

# A lesson's functions called with numbers; the sanitizers know more of what ends them. (-O0 builds
# fastest; gcc 12 cannot build vectors of doubles with it.) NAME.tried is never there: to make it is
# to try NAME, and to say nothing.
CALLER  = $(@:.tried=)
CALLS   = tests/lessons/%/numbers.c $(BUILD)/%.text $(BUILD)/quick/libcommon.a $(BUILD)/flags
define BUILD_NUMBERS
	@mkdir -p $(@D)
	$(Q){ $(COMPILE) $(TEACHES) $(if $(REAL),-O1,-O0) -w -Itests $(1) -MF $(CALLER).d -MT $(CALLER) \
	    -c $< -o $(CALLER).o && $(LINK) $(1) $(CALLER).o $(filter %.a,$^) -lm -o $(CALLER).$$$$ && \
	    mv -f $(CALLER).$$$$ $(CALLER); } $(if $(filter %.tried,$@),>/dev/null 2>&1 || :)
endef
$(BUILD)/quick/numbers/%.tried: $(CALLS)
	$(call BUILD_NUMBERS)
$(BUILD)/quick/numbers/%: $(CALLS)
	$(call BUILD_NUMBERS)
$(BUILD)/sanitized/numbers/%.tried: $(CALLS)
	$(call BUILD_NUMBERS,$(SANITIZED))
$(BUILD)/sanitized/numbers/%: $(CALLS)
	$(call BUILD_NUMBERS,$(SANITIZED))

$(BUILD)/check: $(BUILD)/quick/tests/check/check.o $(CHECKER) $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@.$$$$ && mv -f $@.$$$$ $@

$(CHECKER): $(CHECKER_FILES) $(BUILD)/flags
	$(COMPILE_ROOM)

$(BUILD)/tests/%.o $(BUILD)/quick/tests/%.o: INCLUDES = -Itests

# Style and script of the pages, as strings of C.
PAGE_FILES = css=tests/check/page/page.css still=tests/check/page/still.js \
             live=tests/student/live/page.css js=tests/student/live/page.js \
             viewer=tests/student/live/page.html
$(BUILD)/tests/check/page/page_files.c: $(foreach file,$(PAGE_FILES),$(lastword $(subst =, ,$(file))))
	@mkdir -p $(@D)
	@{ echo '#include "check/page/page.h"'; \
	   for file in $(PAGE_FILES); do \
	       echo "const char *const page_$${file%%=*}[] = {"; \
	       case $$file in \
	       *.html) sed -n '/^<header>/,/^<.main>/p' "$${file#*=}" | sed '/figures.html/d; s/main class/div class/; s/.main>/\/div>/' ;; \
	       *) cat "$${file#*=}" ;; \
	       esac | \
	       sed 's/[\\"]/\\&/g; s/.*/    "&\\n",/'; \
	       echo '    NULL};'; \
	   done; } >$@
