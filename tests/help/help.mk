# make hint STEP=05       the next hint for the first task that is still to do (TASK=5.2, AGAIN=1)
.PHONY: hint
hint:
	@tests/help/hint.sh '$(BUILD)' '$(STEP)' '$(TASK)' '$(AGAIN)'
