##
## For teachers (tests/teacher/README.md says more):
##   make handout OUT=dir        what a student gets: starters, and no solution (LESSONS=1-3,5)
##   make key OUT=dir            what an instructor gets: solutions, the pictures of mistakes,
##                               points (LESSONS=1-5)
##   make check HIDDEN=7         the check, and then scenes that nobody has seen, made from that
##                               number (SOLUTION=dir holds them against dir/step05_zbuffer/main.c)
##   make site OUT=dir           the course as web pages, in which the solutions draw under the mouse
##   make grade SUBMISSIONS=dir  a class: points, reports, what is alike, into OUT=dir (LESSONS=1-5,
##                               SEED=7 for hidden scenes, JOBS=8, ROSTER=the platform's table,
##                               which comes back with points as gradebook.csv)
##   make grade-one SUBMISSION=path   one of them, into OUT=dir
##   make grade-merge OUT=dir    the class, from those that are there
##   make grade-tools            build what these use
.PHONY: handout key site grade grade-one grade-merge grade-tools
handout:
	@sh tests/teacher/handout/handout.sh '$(OUT)' '$(LESSONS)'

key: $(BUILD)/check models
	@sh tests/teacher/handout/key.sh $(BUILD) '$(MAKE) -s' '$(OUT)' '$(LESSONS)'

site: $(BUILD)/models/bust.obj $(STEPS:%=$(BUILD)/moving/%)
	@sh tests/teacher/site/site.sh '$(BUILD)' '$(OUT)'

# ---- Hidden scenes ----

THEN_HIDDEN = $(if $(HIDDEN),; status=$$?; sh tests/teacher/hidden/hidden.sh '$(BUILD)' '$(CHECKED)' \
                  '$(MAKE) -s' '$(HIDDEN)' '$(STEP)' '$(SOLUTION)' && exit $$status)

$(BUILD)/hidden: $(BUILD)/tests/teacher/hidden/hidden.o $(CHECKER) $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@

# A solution, built with what is there. (It has no .d: make would take that for a program to build.)
$(BUILD)/hidden.% $(BUILD)/solutions/%: force
	$(Q)$(filter-out -MMD -MP,$(COMPILE)) $(QUICK) -I$(@F) $(call WITH_MORE,$(@D)/main.c,trials,$(@F)) -o $@.o
	$(Q)$(LINK) $@.o $(BUILD)/quick/libcommon.a -lm -o $@

# ---- A class ----

GRADES = $(or $(OUT),$(BUILD)/grades)
grade-tools: $(BUILD)/check $(BUILD)/limited models \
             $(if $(SEED),$(BUILD)/hidden $(BUILD)/solutions/.built)

grade: grade-tools
	@bash tests/teacher/grade/grade.sh '$(BUILD)' '$(MAKE) -s' '$(SUBMISSIONS)' '$(GRADES)' '$(JOBS)' \
	    '$(LESSONS)' '$(SEED)' '$(ROSTER)' '$(COLUMN)'

grade-one: grade-tools
	@sh tests/teacher/grade/grade_one.sh '$(BUILD)' '$(MAKE) -s' '$(SUBMISSION)' '$(GRADES)' \
	    '$(LESSONS)' '$(SEED)'

grade-merge: $(BUILD)/limited
	@sh tests/teacher/grade/merge.sh '$(BUILD)' '$(GRADES)' '$(ROSTER)' '$(COLUMN)'

# What the hidden scenes are held against.
$(BUILD)/solutions/.built: $(STEPS:%=%/main.c) $(BUILD)/quick/libcommon.a $(BUILD)/hidden
	@sh tests/teacher/hidden/solutions.sh '$(@D)' '$(MAKE) -s' '$(SOLUTION)'
	@touch $@

$(BUILD)/limited: $(BUILD)/tests/teacher/grade/limited.o $(CHECKER) $(BUILD)/quick/libcommon.a
	$(Q)$(LINK) $^ -lm -o $@

# A lesson of a submission: compiled and linked where it can do no harm, in PLACE/STEP. What calls its
# functions with numbers is PLACE/numbers/STEP; of our tests the compiler sees only copies, in PLACE/ours.
PLACE     = $(patsubst %/numbers,%,$(@D))
HANDED_IN = $(PLACE)/sources/$(@F)/main.c
JUDGED_BY = $(if $(filter %/numbers,$(@D)),numbers,trials).c
CONTAINED = CONTAIN_WRITES='$(abspath $(PLACE))' sh tests/teacher/grade/contain.sh
$(BUILD)/grade.%.tried: # a class keeps all processors busy: each program when its turn comes
	@:
$(BUILD)/grade.%: force
	@[ -f $(HANDED_IN) ] || { echo 'error: no $(@F)/main.c was handed in' >&2; exit 1; }
	@mkdir -p $(PLACE)/ours && cp tests/*.h tests/lessons/$(@F)/$(JUDGED_BY) $(PLACE)/ours
	@[ $(PLACE) = $(@D) ] || { mkdir -p $(@D) && chmod 777 $(@D); }
	$(Q)$(CONTAINED) $(filter-out -MMD -MP,$(COMPILE)) $(TEACHES) -I$(@F) -I$(PLACE)/ours \
	    $(if $(filter numbers%,$(JUDGED_BY)),-O0 -w,$(QUICK)) -DLESSON='"$(abspath $(HANDED_IN))"' \
	    -c $(PLACE)/ours/$(JUDGED_BY) -o $@.o
	$(Q)$(CONTAINED) $(LINK) $@.o $(BUILD)/quick/libcommon.a -lm -o $@
