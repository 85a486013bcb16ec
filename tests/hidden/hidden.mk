# make check HIDDEN=7     after the check, scenes that nobody has seen, made from that number; the
#                         pictures are held against those of the solution (the lesson's own, as git
#                         or make start keeps it, or SOLUTION=dir's, dir/step05_zbuffer/main.c)
#                         A lesson that prints stored pictures loses its points.
POINTS = $(CHECKED)/points.csv
KEEP_POINTS = $(if $(HIDDEN),--csv '$(POINTS)')
THEN_HIDDEN = $(if $(HIDDEN),; status=$$?; tests/hidden/hidden.sh '$(BUILD)' '$(CHECKED)' \
                  '$(MAKE) -s' '$(HIDDEN)' '$(STEP)' '$(SOLUTION)' '$(POINTS)' && exit $$status)

$(BUILD)/hidden: $(BUILD)/tests/hidden/hidden.o $(BUILD)/tests/hidden/lock.o $(CHECKER) \
                 $(BUILD)/libcommon.a
	$(LINK) $^ -lm -o $@

# A solution, built with what is there. (It has no .d: make would take that for a program to build.)
$(BUILD)/hidden.% $(BUILD)/solutions/%: force
	$(filter-out -MMD -MP,$(COMPILE)) -I$(@F) -c $(@D)/main.c -o $@.o
	$(LINK) $@.o $(BUILD)/libcommon.a -lm -o $@
