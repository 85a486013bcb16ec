# make start STEP=05      step05_zbuffer/main.c becomes the lesson's starter
# make solution STEP=05   ... becomes its solution; what it held before is kept beside it
.PHONY: start solution
start solution:
	@tests/starter/start.sh $@ '$(STEP)'
