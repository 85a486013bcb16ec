# The rules of `make MINE=1` in its own build directory: see mine.mk.

# A lesson's task is right where its own check, in the other build directory, gives it all points.
HERS := $(filter $(shell sed -n 's/^\(via \)*\(step[0-9][^ ]*\) .*/\2/p' tests/student/mine.txt),$(STEPS))
$(HERS:%=$(BUILD)/hers/%.json): $(BUILD)/hers/%.json: $(BUILD)/%.text
	@mkdir -p $(@D)
	$(SAY) CHECK $*
	@$(HOUSE)/check --programs $(HOUSE)/quick --differences $(HOUSE)/differences --json $@ \
	    --make '$(MAKE) -s $(KNOWN) HOUSE= BUILD=$(HOUSE)' $* >$@.said 2>&1 || [ -s $@ ] || { cat $@.said >&2; exit 1; }

# The right ones of its functions, as one object; they call those of earlier lessons, too. Where it
# doesn't compile, none is right.
COMPILE_HERS = $(COMPILE) -w -O2 -iquote $* -iquote . -include $(@:.o=.h) -MF $@.d -MT $@ -c $(@:.o=.c) -o $@
$(HERS:%=$(BUILD)/hers/%.o): $(BUILD)/hers/%.o: $(BUILD)/hers/%.json $(BUILD)/hers/%.h \
                                                $(wildcard tests/student/mine/*) $(BUILD)/flags
	@sh tests/student/mine/mine.sh hers '$(BUILD)' $*
	@$(COMPILE_HERS) 2>$@.said || { : >$(@:.o=.names); echo 'typedef int nothing;' >$(@:.o=.c); $(COMPILE_HERS); }

# What a lesson is compiled behind: the names of earlier lessons' functions.
before = $(foreach one,$2,$(if $(filter-out $1,$(one)),$(if $(filter $(one),$(firstword $(sort $1 $(one)))),$(one))))
$(STEPS:%=$(BUILD)/hers/%.h): $(BUILD)/hers/%.h: $(BUILD)/%.text tests/student/mine.txt
	@mkdir -p $(@D)
	@sh tests/student/mine/mine.sh names '$(BUILD)' $* $(call before,$*,$(HERS))
$(foreach lesson,$(STEPS),$(eval $(BUILD)/hers/$(lesson).h: $(patsubst %,$(BUILD)/hers/%.o,$(call before,$(lesson),$(HERS)))))

# The cameras of lessons 9 and 10 are made in a source of the pipeline.
with_camera = $(if $(and $(filter step09_%,$(STEPS)),$(filter step09_% step10_%,$1)),$(BUILD)/hers/camera.o)
$(BUILD)/hers/camera.o: common/pipeline.c $(BUILD)/hers/step09_shaders.h
	@$(COMPILE) -w -iquote . -include $(BUILD)/hers/step09_shaders.h -MF $@.d -MT $@ -c $< -o $@

LESSON_FLAGS   = -iquote . -include $(BUILD)/hers/$*.h
LESSON_OBJECTS = $(patsubst %,$(BUILD)/hers/%.o,$(call before,$*,$(HERS))) $(call with_camera,$*)
$(foreach room,/ /quick/ /moving/ /sanitized/ /moving/sanitized/,$(foreach lesson,$(STEPS),\
    $(eval $(BUILD)$(room)$(lesson): $(BUILD)/hers/$(lesson).h $(call with_camera,$(lesson)))))

all check show open live watch: hers
.PHONY: hers
hers: $(CHOSEN:%=$(BUILD)/hers/%.h)
	@sh tests/student/mine/mine.sh say '$(BUILD)' $(CHOSEN)
