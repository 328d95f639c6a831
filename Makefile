# nagata3 needs a C99 compiler, GNU make and sh. What is built lies below $(BUILD).
CC     ?= cc
CXX    ?= c++
CFLAGS ?= -O2
PREFIX ?= /usr/local
BUILD   = build
MAKEFLAGS += -j$(shell nproc 2>/dev/null || echo 2)

COMPILE  = $(CC) -std=c99 -Wall -Wextra -Wpedantic -I. $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -o $@
EXAMPLES = smooth brown demo_mesh figure7 $(patsubst examples/%.c,%,$(wildcard examples/[0-9]*.c))
FIGURES  = facts scale accuracy bench_double bench_float
PROGRAMS = $(addprefix $(BUILD)/,$(EXAMPLES) $(FIGURES))
TESTS    = $(addprefix $(BUILD)/,test_double test_float)
TOOLS    = $(addprefix $(BUILD)/,write_seeds dump pictures)
TEST_SRC = $(filter-out tests/golden_gen.c,$(wildcard tests/*.c)) $(wildcard bench/accuracy_m*.c \
           bench/accuracy_surface.c)
MESH     = $(wildcard examples/mesh*.c)
PICTURE  = $(addprefix examples/,png.c deflate.c colour.c) $(wildcard examples/picture*.c)
PICTURES = $(wildcard tests/pictures/*.c) $(PICTURE) $(MESH)
SMOOTH   = $(wildcard examples/smooth*.c) $(PICTURE) $(MESH)
BROWN    = $(wildcard examples/brown/*.c) $(filter-out examples/smooth.c,$(SMOOTH))
BROWN_TESTS = $(addprefix $(BUILD)/,brown_double brown_float)
BROWN_SRC = $(wildcard tests/brown/*.c) tests/check.c tests/samples.c
JOIN     = examples/join/join.c $(filter-out examples/smooth.c,$(SMOOTH))
JOIN_TESTS = $(addprefix $(BUILD)/,join_double join_float)
JOIN_SRC = $(wildcard tests/join/*.c) tests/check.c tests/shapes.c examples/join/inputs.c
SEEDS    = $(addprefix tests/fuzz/,mutate.c seeds.c)
FUZZ     = tests/fuzz/sandbox.c $(filter-out examples/mesh_file.c,$(MESH))
SANITIZE = -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
ACCURACY = $(wildcard bench/accuracy*.c)
HEADERS  = $(wildcard nagata3.h tests/*.h tests/*/*.h examples/*.h examples/*/*.h bench/*.h)
VERSION  = $(shell sed -n 's/^.define NAGATA3_VERSION "\(.*\)"/\1/p' nagata3.h)
LIB      = $(DESTDIR)$(PREFIX)/lib

all: $(PROGRAMS)  ## the programs; this is what make alone does

demo: $(BUILD)/smooth $(BUILD)/demo_mesh  ## smooth a small mesh into build/demo.vtu, build/demo.obj
	@$(BUILD)/demo_mesh > $(BUILD)/demo_in.obj
	@$(BUILD)/smooth $(BUILD)/demo_in.obj -o $(BUILD)/demo.obj --quiet
	@$(BUILD)/smooth $(BUILD)/demo_in.obj -o $(BUILD)/demo.vtu --quiet --report
	@echo 'Open $(BUILD)/demo.vtu in ParaView or $(BUILD)/demo.obj in any viewer of meshes.'

test: $(TESTS) $(BUILD)/smooth $(BUILD)/demo_mesh  ## all tests; N3_SAMPLES=n scales them
	@sh tests/run.sh $(TESTS) "sh tests/smooth_test.sh $(BUILD)/smooth $(BUILD)/demo_mesh"

brown: $(BROWN_TESTS) $(BUILD)/brown $(BUILD)/smooth  ## Brown's surfaces, the program too
	@sh tests/run.sh $(BROWN_TESTS) "sh tests/brown/brown_test.sh $(BUILD)/brown $(BUILD)/smooth"

files: $(TOOLS) $(BUILD)/smooth  ## every variant of every format that smooth reads
	@sh tests/run.sh "sh tests/files_test.sh $(BUILD)/smooth $(BUILD)/write_seeds $(BUILD)/dump"

pictures: $(BUILD)/pictures $(BUILD)/smooth $(BUILD)/demo_mesh  ## what smooth draws
	@sh tests/run.sh $(BUILD)/pictures \
	    "sh tests/pictures_test.sh $(BUILD)/smooth $(BUILD)/demo_mesh"

join: $(JOIN_TESTS) $(BUILD)/join $(BUILD)/seams  ## two meshes joined by a smooth bridge
	@sh tests/run.sh $(JOIN_TESTS) "sh tests/join/join_test.sh $(BUILD)/join $(BUILD)/seams"

seams: $(BUILD)/seams  ## the README's table of the angles at the seams of joined meshes
	@$(BUILD)/seams

fuzz: $(BUILD)/fuzz  ## read broken files of every format under the sanitizers; FILES=n of them
	@$(BUILD)/fuzz $(FILES)

ledger:  ## every equation that the header cites has its test, and the reverse
	@sh tests/ledger.sh

dialects:  ## the header alone, in every dialect of CC and CXX
	@CC="$(CC)" CXX="$(CXX)" sh tests/compile/run.sh $(BUILD)/dialects

mutants:  ## break the header in 60 places, the tests must notice; MUTANTS=--all for everywhere
	@CC="$(CC)" python3 tests/mutants.py $(MUTANTS) $(TEST_SRC)

bench: $(BUILD)/bench_double $(BUILD)/bench_float $(BUILD)/scale  ## what calls and meshes cost
	@$(BUILD)/bench_double $(ROUNDS) && $(BUILD)/bench_float $(ROUNDS)
	@$(BUILD)/scale $(LARGEST)

accuracy: $(BUILD)/accuracy  ## how far from surfaces that are known exactly
	@$(BUILD)/accuracy $(SURFACES)

sweep: $(BUILD)/accuracy  ## the constants that the paper leaves open, over the same surfaces
	@$(BUILD)/accuracy --sweep

facts: $(BUILD)/facts  ## the README's figures
	@$(BUILD)/facts

golden: $(BUILD)/golden.csv  ## compute tests/golden.csv anew, in __float128
	cp $(BUILD)/golden.csv tests/golden.csv

figures: $(BUILD)/figure7.svg  ## draw the README's picture anew
	cp $(BUILD)/figure7.svg examples/figure7.svg

install:  ## the header, with what pkg-config and CMake need, below $(DESTDIR)$(PREFIX)
	mkdir -p $(DESTDIR)$(PREFIX)/include $(LIB)/pkgconfig $(LIB)/cmake/nagata3
	cp nagata3.h $(DESTDIR)$(PREFIX)/include/
	printf '%s\n' 'prefix=$(PREFIX)' 'Name: nagata3' 'Description: cubic Nagata patches' \
	    'Version: $(VERSION)' 'Cflags: -I$${prefix}/include' 'Libs: -lm' > $(LIB)/pkgconfig/nagata3.pc
	printf '%s\n' 'if(NOT TARGET nagata3::nagata3)' \
	    '  add_library(nagata3::nagata3 INTERFACE IMPORTED)' \
	    '  set_target_properties(nagata3::nagata3 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES' \
	    '    "$${CMAKE_CURRENT_LIST_DIR}/../../../include")' \
	    '  if(UNIX)' \
	    '    set_target_properties(nagata3::nagata3 PROPERTIES INTERFACE_LINK_LIBRARIES m)' \
	    '  endif()' 'endif()' > $(LIB)/cmake/nagata3/nagata3-config.cmake
	printf '%s\n' 'set(PACKAGE_VERSION $(VERSION))' \
	    'if(NOT PACKAGE_FIND_VERSION VERSION_GREATER PACKAGE_VERSION)' \
	    '  set(PACKAGE_VERSION_COMPATIBLE TRUE)' 'endif()' \
	    'if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)' \
	    '  set(PACKAGE_VERSION_EXACT TRUE)' \
	    'endif()' > $(LIB)/cmake/nagata3/nagata3-config-version.cmake

help:  ## this list
	@sed -n 's/^\([a-z]*\):.*  ## \(.*\)/\1:\2/p' Makefile | \
	    while IFS=: read -r name what; do printf '%-9s %s\n' "$$name" "$$what"; done

clean:  ## remove what was built
	rm -rf $(BUILD)

$(BUILD)/test_double $(BUILD)/test_float: $(TEST_SRC)
	$(COMPILE) -Itests $(TEST_SRC) -lm
$(BUILD)/smooth: $(SMOOTH)
	$(COMPILE) $(SMOOTH) -lm
$(BUILD)/pictures: $(PICTURES)
	$(COMPILE) -Iexamples $(PICTURES) -lm
$(BUILD)/brown: $(BROWN)
	$(COMPILE) $(BROWN) -lm
$(BROWN_TESTS): $(BROWN_SRC)
	$(COMPILE) -Itests -Iexamples/brown $(BROWN_SRC) -lm
$(BUILD)/join: $(JOIN)
	$(COMPILE) -Iexamples $(JOIN) -lm
$(BUILD)/seams: examples/join/seams.c examples/join/inputs.c
	$(COMPILE) $(filter %.c,$^) -lm
$(JOIN_TESTS): $(JOIN_SRC)
	$(COMPILE) -Itests -Iexamples/join $(JOIN_SRC) -lm
$(BUILD)/accuracy: $(ACCURACY)
	$(COMPILE) $(ACCURACY) -lm
$(BUILD)/dump: tests/fuzz/dump.c $(MESH)
	$(COMPILE) -Iexamples $< $(MESH) -lm
$(BUILD)/write_seeds: tests/fuzz/write_seeds.c $(SEEDS)
	$(COMPILE) $< $(SEEDS)
$(BUILD)/fuzz: tests/fuzz/fuzz.c $(SEEDS) $(FUZZ)
	$(COMPILE) $(SANITIZE) -Iexamples -Dfree=sandbox_free $< $(SEEDS) $(FUZZ) -lm
$(BUILD)/bench_double $(BUILD)/bench_float: bench/bench.c
	$(COMPILE) $< -lm
$(BUILD)/golden_gen: tests/golden_gen.c
	$(CC) -O2 -o $@ $< -lquadmath -lm
$(BUILD)/%: examples/%.c
	$(COMPILE) $< -lm
$(BUILD)/%: bench/%.c
	$(COMPILE) $< -lm
$(BUILD)/%.csv: $(BUILD)/%_gen
	$< > $@.part && mv $@.part $@
$(BUILD)/%.svg: $(BUILD)/%
	$< > $@.part && mv $@.part $@

$(BUILD)/%_float: CPPFLAGS += -DNAGATA3_FLOAT
$(TESTS): CFLAGS := $(if $(filter file,$(origin CFLAGS)),-O1,$(CFLAGS)) # compiles in half the time
$(PROGRAMS) $(TOOLS) $(TESTS) $(BROWN_TESTS) $(JOIN_TESTS): $(HEADERS) | $(BUILD)
$(BUILD)/join $(BUILD)/seams $(BUILD)/golden_gen $(BUILD)/fuzz: $(HEADERS) | $(BUILD)
$(BUILD):
	mkdir -p $@

.PHONY: all demo test brown join seams files pictures fuzz ledger dialects mutants bench accuracy \
        sweep facts golden figures install help clean
