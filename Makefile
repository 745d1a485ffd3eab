# make demo: set up, build, run thesis sample 8 and say where the report is. make test: set up, build, run every test.
BUILD ?= build
JOBS ?= $(shell nproc)
CMAKE_FLAGS ?=
COMMON = cmake -S . -B $(BUILD) -G Ninja $(CMAKE_FLAGS)
# A first look needs no Python; a build folder that has the module keeps it.
WITHOUT_MODULE = $(if $(wildcard $(BUILD)/CMakeCache.txt),,-DARENITE_PYTHON=OFF)
WITH_MODULE = -DARENITE_PYTHON=ON

.PHONY: demo test build install deb dist bench peers petsc fuzz docs clean

demo:
	@scripts/setup run
	@$(COMMON) $(WITHOUT_MODULE) -DARENITE_TESTS=OFF >/dev/null
	@ninja -C $(BUILD) -j $(JOBS) arenite
	@$(BUILD)/arenite run examples/01-thesis-sample-08/recipe.toml --out out/demo --threads $(JOBS)

build:
	@scripts/setup run python
	@$(COMMON) $(WITH_MODULE) -DARENITE_TESTS=OFF >/dev/null
	@ninja -C $(BUILD) -j $(JOBS)

# make install PREFIX=/opt/arenite: program, Python module, completion, manual page, examples.
PREFIX ?= /usr/local
install: build
	@cmake --install $(BUILD) --prefix $(PREFIX)

# One Debian package in $(BUILD), to install with apt-get install ./arenite_*.deb.
deb:
	@scripts/setup run python deb
	@$(COMMON) $(WITH_MODULE) -DARENITE_TESTS=OFF >/dev/null
	@ninja -C $(BUILD) -j $(JOBS)
	@cd $(BUILD) && cpack -G DEB

# The archive of a release in $(BUILD), with the pages built: building from it needs no Node.js.
dist:
	@scripts/setup run
	@$(COMMON) $(WITHOUT_MODULE) -DARENITE_TESTS=OFF >/dev/null
	@ninja -C $(BUILD) pages
	@scripts/dist $(BUILD)

# Benchmarks, peers' drivers, the program for many machines and fuzz targets, too: what nobody compiles and runs does
# not stay whole. Two tests more than jobs at a time: many wait for a browser or a killed run.
test:
	@scripts/setup run python test bench petsc fuzz docs
	@$(COMMON) $(WITH_MODULE) -DARENITE_TESTS=ON -DARENITE_BENCH=ON -DARENITE_PETSC=ON >/dev/null
	@ninja -C $(BUILD) -j $(JOBS)
	@$(MAKE) --no-print-directory fuzz FUZZ_FOR=-runs=0 FUZZ_SEARCH=OFF
	@ctest --test-dir $(BUILD) -j $$(($(JOBS) + 2)) --timeout 1200 --output-on-failure

bench:
	@scripts/setup run python bench
	@$(COMMON) $(WITH_MODULE) -DARENITE_BENCH=ON >/dev/null
	@ninja -C $(BUILD) -j $(JOBS)
	@for b in $(BUILD)/bench/*; do [ -x $$b ] && [ -f $$b ] && $$b || true; done

peers:
	@scripts/setup run python bench peers
	@$(COMMON) $(WITH_MODULE) -DARENITE_BENCH=ON >/dev/null
	@ninja -C $(BUILD) -j $(JOBS)
	@bench/peers/run $(BUILD)
	@bench/peers/peridynamics $(BUILD)

# arenite-petsc for many machines (docs/cluster.md), and its fields on 1, 2 and 4 processes beside those of arenite.
petsc:
	@scripts/setup run petsc
	@$(COMMON) $(WITHOUT_MODULE) -DARENITE_TESTS=OFF -DARENITE_PETSC=ON >/dev/null
	@ninja -C $(BUILD) -j $(JOBS) arenite arenite_petsc
	@ARENITE=$(abspath $(BUILD))/arenite ARENITE_PETSC=$(abspath $(BUILD))/arenite-petsc \
	  /usr/bin/python3 -B -m pytest -q -p no:cacheprovider tests/cluster

# Every fuzz target for FUZZ_SECONDS; inputs that reach new code gather in build-fuzz/found.
# (The tests run their corpora.)
FUZZ_SECONDS ?= 60
FUZZ_FOR ?= -max_total_time=$(FUZZ_SECONDS)
FUZZ_SEARCH ?= ON
fuzz:
	@scripts/setup run fuzz
	@[ -e $(BUILD)/CMakeCache.txt ] || $(COMMON) $(WITHOUT_MODULE) >/dev/null
	@ninja -C $(BUILD) -j $(JOBS) arenite_core
	@cmake --preset fuzz -DARENITE_LIBRARY=$(abspath $(BUILD))/libarenite.a -DARENITE_FUZZ_SEARCH=$(FUZZ_SEARCH) >/dev/null
	@cmake --build --preset fuzz -j $(JOBS)
	@cd build-fuzz && for f in tests/fuzz/fuzz_*; do \
	  what=$${f##*fuzz_}; mkdir -p found/$$what; \
	  dict=../tests/fuzz/$$what.dict; [ -e $$dict ] && words=-dict=$$dict || words=; \
	  $$f $(FUZZ_FOR) -max_len=4096 -timeout=60 $$words \
	    -artifact_prefix=found/$$what- found/$$what ../tests/fuzz/corpus/$$what > found/$$what.log 2>&1 \
	    || { tail -60 found/$$what.log; echo "$$f found this, in build-fuzz/found"; exit 1; }; \
	  echo "$$f: $$(tail -1 found/$$what.log)"; \
	done

# HTML of all pages with search and the reference of Python and C++, in $(BUILD)/html; it is
# made with the Python module.
docs: build
	@scripts/setup docs
	@scripts/docs $(BUILD)/html $(BUILD)
	@echo "pages: $(BUILD)/html/docs/index.html   (open it in a browser)"

clean:
	@rm -rf $(BUILD) out
