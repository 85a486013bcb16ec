# make grade SUBMISSIONS=dir    a class: each directory, .zip or .tar.gz in dir is a submission
#     OUT=dir                   where the results go (build/grades); none is made twice, unless
#                               the submission, LESSONS or SEED have changed
#     JOBS=2                    at a time
#     LESSONS=1-5               which count
#     SEED=7                    draw the hidden scenes of this number, too
# make grade-one SUBMISSION=path OUT=dir     one of them
# make grade-merge OUT=dir      the class, from what is there
# make grade-tools              what all of these use
GRADES = $(or $(OUT),$(BUILD)/grades)
.PHONY: grade grade-one grade-merge grade-tools
grade-tools: $(BUILD)/check $(BUILD)/limited $(BUILD)/similar models \
             $(if $(SEED),$(BUILD)/hidden $(BUILD)/solutions/.built)

grade: grade-tools
	@tests/grade/grade.sh '$(BUILD)' '$(MAKE) -s' '$(SUBMISSIONS)' '$(GRADES)' '$(JOBS)' \
	    '$(LESSONS)' '$(SEED)'

grade-one: grade-tools
	@tests/grade/grade_one.sh '$(BUILD)' '$(MAKE) -s' '$(SUBMISSION)' '$(GRADES)' \
	    '$(LESSONS)' '$(SEED)'

grade-merge: $(BUILD)/similar
	@tests/grade/merge.sh '$(BUILD)' '$(GRADES)'

# What the hidden scenes are held against.
$(BUILD)/solutions/.built: $(STEPS:%=%/main.c) $(BUILD)/libcommon.a
	@tests/hidden/solutions.sh '$(@D)' '$(MAKE) -s' '$(SOLUTION)'
	@touch $@

$(BUILD)/limited: $(BUILD)/tests/grade/limited.o $(CHECKER) $(BUILD)/libcommon.a
	$(LINK) $^ -lm $(PLACED)

# A lesson of a submission: compiled and linked where it can do no harm.
CONTAINED = CONTAIN_WRITES='$(abspath $(@D))' tests/grade/contain.sh
$(BUILD)/grade.%: force
	@[ -f $(@D)/sources/$(@F)/main.c ] || { echo 'error: no $(@F)/main.c was handed in' >&2; exit 1; }
	$(CONTAINED) $(filter-out -MMD -MP,$(COMPILE)) -I$(@F) -c $(@D)/sources/$(@F)/main.c -o $@.o
	$(CONTAINED) $(LINK) $@.o $(BUILD)/libcommon.a -lm -o $@
