# nagata3 needs a C99 compiler, GNU make and sh. What is built lies below $(BUILD).
CC     ?= cc
CXX    ?= c++
CFLAGS ?= -O2
PREFIX ?= /usr/local
ROUNDS ?= 21
BUILD   = build
MAKEFLAGS += -j$(shell nproc 2>/dev/null || echo 2)

COMPILE  = $(CC) -std=c99 -Wall -Wextra -Wpedantic $(INCLUDE) $(CPPFLAGS) $(CFLAGS) $(THREADS)
LINK     = $(COMPILE) $(LDFLAGS) -o $@ $(filter %.c,$^) $(filter %.a,$^) -lm
INCLUDE  = -I. -Itests -Iexamples -Iexamples/brown -Iexamples/join
EXAMPLES = smooth brown join gallery ray gap demo_mesh figure7 \
           $(patsubst examples/%.c,%,$(wildcard examples/[0-9]*.c))
PROGRAMS = $(addprefix $(BUILD)/,$(EXAMPLES) facts scale accuracy seams) $(BENCH) $(ASKED)
PARALLEL = $(addprefix $(BUILD)/,smooth brown join gallery ray gap dump pictures)
BENCH    = $(addprefix $(BUILD)/bench_,double float)
ASKED    = $(addprefix $(BUILD)/query_,double float)
COUNTS   = $(addprefix $(BUILD)/counts_,double float)
HEADER   = $(addprefix $(BUILD)/test_,double float)
BROWN    = $(addprefix $(BUILD)/brown_test_,double float)
JOIN     = $(addprefix $(BUILD)/join_test_,double float)
TESTS    = $(HEADER) $(BROWN) $(JOIN)
TOOLS    = $(addprefix $(BUILD)/,write_seeds dump pictures fuzz)
TEST_SRC = $(filter-out tests/golden_gen.c,$(wildcard tests/*.c)) $(wildcard bench/accuracy_m*.c) \
           bench/accuracy_surface.c
SEEDS    = $(addprefix tests/fuzz/,mutate.c seeds.c)
FUZZ     = tests/fuzz/sandbox.c $(filter-out examples/mesh_file.c,$(wildcard examples/mesh*.c))
COUNTED  = -O2 -march=x86-64-v3
NATIVE  := $(shell $(CC) -march=native -E -xc /dev/null >/dev/null 2>&1 && echo -march=native)
OPENMP  := $(shell echo 'int main(void) { return 0; }' | $(CC) -fopenmp -xc - -o /dev/null \
           2>/dev/null && echo -fopenmp)
SANITIZE = -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
SHARED   = $(wildcard $(addprefix examples/,mesh*.c picture*.c smooth_*.c png.c deflate.c colour.c))
HEADERS  = $(wildcard nagata3.h tests/*.h tests/*/*.h examples/*.h examples/*/*.h bench/*.h)
VERSION  = $(shell sed -n 's/^.define NAGATA3_VERSION "\(.*\)"/\1/p' nagata3.h)
LIB      = $(DESTDIR)$(PREFIX)/lib

all: $(PROGRAMS)  ## the programs; this is what make alone does

demo: $(BUILD)/smooth $(BUILD)/demo_mesh  ## a small mesh smoothed, as .vtu, .obj, .png and .html
	@$(BUILD)/demo_mesh > $(BUILD)/demo_in.obj
	@$(BUILD)/smooth $(BUILD)/demo_in.obj -o $(BUILD)/demo.obj --quiet
	@$(BUILD)/smooth $(BUILD)/demo_in.obj -o $(BUILD)/demo.png --quiet --view zebra
	@$(BUILD)/smooth $(BUILD)/demo_in.obj -o $(BUILD)/demo.html --quiet
	@$(BUILD)/smooth $(BUILD)/demo_in.obj -o $(BUILD)/demo.vtu --quiet --report
	@echo 'Open $(BUILD)/demo.vtu in ParaView or $(BUILD)/demo.obj in any viewer of meshes.'
	@echo 'Look at $(BUILD)/demo.png, or turn it in a browser: $(BUILD)/demo.html.'

test: $(HEADER) $(BUILD)/smooth $(BUILD)/demo_mesh  ## all tests; N3_SAMPLES=n scales them
	@sh tests/run.sh $(HEADER) "sh tests/smooth_test.sh $(BUILD)/smooth $(BUILD)/demo_mesh"

brown: $(BROWN) $(BUILD)/brown $(BUILD)/smooth  ## Brown's surfaces, the program too
	@sh tests/run.sh $(BROWN) "sh tests/brown/brown_test.sh $(BUILD)/brown $(BUILD)/smooth"

files: $(BUILD)/write_seeds $(BUILD)/dump $(BUILD)/smooth  ## every variant of every format
	@sh tests/run.sh "sh tests/files_test.sh $(BUILD)/smooth $(BUILD)/write_seeds $(BUILD)/dump"

pictures: $(BUILD)/pictures $(BUILD)/smooth $(BUILD)/demo_mesh  ## what smooth draws
	@sh tests/run.sh $(BUILD)/pictures \
	    "sh tests/pictures_test.sh $(BUILD)/smooth $(BUILD)/demo_mesh"

join: $(JOIN) $(BUILD)/join $(BUILD)/seams  ## two meshes joined by a smooth bridge
	@sh tests/run.sh $(JOIN) "sh tests/join/join_test.sh $(BUILD)/join $(BUILD)/seams"

joined: $(BUILD)/join $(BUILD)/smooth $(BUILD)/seams  ## pictures of joined meshes in build/joined
	@sh examples/join/pictures.sh $(BUILD)/join $(BUILD)/smooth $(BUILD)/seams $(BUILD)/joined

query: $(BUILD)/ray $(BUILD)/gap $(BUILD)/demo_mesh  ## rays and gaps, on bodies that are known
	@sh tests/run.sh "sh tests/query_test.sh $(BUILD)/ray $(BUILD)/gap $(BUILD)/demo_mesh"

gap: $(BUILD)/gap  ## the README's table of the gaps between smooth bodies
	@$(BUILD)/gap

seams: $(BUILD)/seams  ## the README's table of the angles at the seams of joined meshes
	@$(BUILD)/seams

large: $(BUILD)/smooth $(BUILD)/demo_mesh  ## two million triangles through smooth, in 2 GiB
	@sh tests/run.sh "bash tests/large_test.sh $(BUILD)/smooth $(BUILD)/demo_mesh"

fuzz: $(BUILD)/fuzz  ## read broken files of every format under the sanitizers; FILES=n of them
	@$(BUILD)/fuzz $(FILES)

ledger:  ## every equation that the header cites has its test, and the reverse
	@sh tests/ledger.sh

dialects:  ## the header alone, in every dialect of CC and CXX
	@CC="$(CC)" CXX="$(CXX)" sh tests/compile/run.sh $(BUILD)/dialects

mutants:  ## break the header in 60 places, the tests must notice; MUTANTS=--all for everywhere
	@CC="$(CC)" python3 tests/mutants.py $(MUTANTS) $(TEST_SRC)

bench: $(BENCH) $(ASKED) $(BUILD)/scale  ## what calls and meshes cost; also as CSV below build
	@for b in $(BENCH); do $$b $(ROUNDS) $$b.csv || exit; done
	@for b in $(ASKED); do $$b $(ROUNDS) || exit; done
	@$(BUILD)/scale $(LARGEST)

bench-counts: $(COUNTS)  ## instructions of each call against bench/counts.csv, by valgrind
	@sh bench/counts.sh "$$($(CC) --version | head -n 1), $(COUNTED)" $(COUNTS) bench/counts.csv

accuracy: $(BUILD)/accuracy  ## how far from surfaces that are known exactly
	@$(BUILD)/accuracy $(SURFACES)

quads: $(BUILD)/accuracy  ## Brown's squares over quads, against two triangles for each
	@$(BUILD)/accuracy --quads

sweep: $(BUILD)/accuracy  ## the constants that the paper leaves open, over the same surfaces
	@$(BUILD)/accuracy --sweep

facts: $(BUILD)/facts  ## the README's figures
	@$(BUILD)/facts

golden: $(BUILD)/golden.csv  ## compute tests/golden.csv anew, in __float128
	cp $(BUILD)/golden.csv tests/golden.csv

gallery: $(BUILD)/gallery  ## draw the paper's figures and three more anew, into examples/gallery
	mkdir -p examples/gallery && $(BUILD)/gallery examples/gallery

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
	@sed -n 's/^\([a-z-]*\):.*  ## \(.*\)/\1:\2/p' Makefile | \
	    while IFS=: read -r name what; do printf '%-12s %s\n' "$$name" "$$what"; done

clean:  ## remove what was built
	rm -rf $(BUILD)

# Each from its own sources, and from what the programs share.
$(HEADER): $(TEST_SRC)
$(BROWN): $(wildcard tests/brown/*.c) tests/samples.c
$(JOIN): $(wildcard tests/join/*.c) tests/shapes.c examples/join/inputs.c
$(TESTS): tests/check.c
$(BUILD)/brown: $(wildcard examples/brown/*.c)
$(BUILD)/join: examples/join/join.c
$(BUILD)/seams: examples/join/seams.c examples/join/inputs.c
$(BUILD)/gallery: $(wildcard examples/gallery*.c)
$(BUILD)/ray $(BUILD)/gap: $(BUILD)/%: examples/query/%.c examples/query/tree.c
$(BUILD)/accuracy: $(wildcard bench/accuracy*.c)
$(BENCH) $(COUNTS): bench/bench.c
$(ASKED): bench/query.c
$(BUILD)/write_seeds: tests/fuzz/write_seeds.c $(SEEDS)
$(BUILD)/fuzz: tests/fuzz/fuzz.c $(SEEDS) $(FUZZ)
$(BUILD)/dump: tests/fuzz/dump.c
$(BUILD)/pictures: $(wildcard tests/pictures/*.c)
$(PARALLEL): $(BUILD)/shared.a
$(addprefix $(BUILD)/,facts scale): $(BUILD)/%: bench/%.c
$(filter-out %/brown %/join %/gallery %/ray %/gap,$(addprefix $(BUILD)/,$(EXAMPLES))): \
  $(BUILD)/%: examples/%.c

$(PROGRAMS) $(TESTS) $(TOOLS) $(COUNTS): $(HEADERS) | $(BUILD)
	$(LINK)
$(BUILD)/golden_gen: tests/golden_gen.c | $(BUILD)
	$(CC) -O2 -o $@ $< -lquadmath -lm
$(BUILD)/shared.a: $(SHARED:examples/%.c=$(BUILD)/%.o)
	rm -f $@ && $(AR) rcs $@ $^
$(BUILD)/%.o: examples/%.c $(HEADERS) | $(BUILD)
	$(COMPILE) -I$(BUILD) -c -o $@ $<
$(BUILD)/smooth_page.o: $(BUILD)/page.inc
$(BUILD)/page.inc: examples/page.html | $(BUILD) # its bytes, as numbers of an array in C
	od -An -v -tu1 $< | sed 's/[0-9][0-9]*/&,/g' > $@.part && mv $@.part $@
$(BUILD)/%.csv: $(BUILD)/%_gen
	$< > $@.part && mv $@.part $@
$(BUILD)/%.svg: $(BUILD)/%
	$< > $@.part && mv $@.part $@

$(BUILD)/%_float: CPPFLAGS += -DNAGATA3_FLOAT
$(BUILD)/fuzz: CPPFLAGS += $(SANITIZE) -Dfree=sandbox_free
$(PARALLEL) $(BUILD)/shared.a $(BUILD)/03_threads: THREADS = $(OPENMP)
$(BENCH) $(COUNTS): THREADS = -pthread
$(BENCH) $(BUILD)/scale: CFLAGS := $(if $(filter file,$(origin CFLAGS)),-O3 $(NATIVE),$(CFLAGS))
$(COUNTS): CFLAGS := $(COUNTED)
$(TESTS): CFLAGS := $(if $(filter file,$(origin CFLAGS)),-O1,$(CFLAGS)) # compiles in half the time
$(BUILD):
	mkdir -p $@

.PHONY: all demo test brown quads join joined seams query gap files pictures large \
        fuzz ledger dialects mutants bench bench-counts accuracy sweep facts golden gallery \
        figures install help clean
