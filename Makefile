# The front door: thin names over the CMake presets. `make help` lists them.

JOBS ?= $(shell nproc)
MOLECULES ?= ../shared/molecules
PREFIX ?= /usr/local
PYTHON ?= /usr/bin/python3
SETS ?= 2000
SECONDS ?= 60
RESULTS ?= build/results
FUZZERS = molecule_fuzz gzip_fuzz mesh_fuzz msms_fuzz balls_fuzz
sources = $(shell find geometry surface implicit skin morse certify refine front morskin python app bench tests papers examples -name '*.h' -o -name '*.cpp')

.DEFAULT_GOAL := build
.PHONY: build command python deps demo figures test test-slow test-viewer viewer-asset stress fuzz bench bench-compare guard guard-record corpus morse-corpus prediction fetch reproduce reproduce-reference papers student-course test-papers papers-update solvers exercise lint tidy format sanitize install packaged deb static clean help

build: deps  ## build everything, optimised, into build/ (the default)
	cmake --preset release
	cmake --build build --parallel $(JOBS)

command: deps
	cmake --preset release
	cmake --build build --parallel $(JOBS) --target morskin_command

python: deps  ## build the Python module for PYTHON (default /usr/bin/python3) into build/python
	cmake --preset release -D MORSKIN_PYTHON=$(PYTHON)
	cmake --build build --parallel $(JOBS) --target morskin_python

deps:  ## install the Debian packages that are missing
	@cmake/install_packages.sh

demo: command  ## mesh the bundled gramicidin A and print the report
	build/morskin mesh bench/molecules/1grm_model1.pdb --model paper -o build/1grm.ply
	@build/morskin view bench/molecules/1grm_model1.pdb --model paper -o build/1grm.html -q
	@echo
	@echo "The mesh is in build/1grm.ply; MeshLab, ParaView and Blender open it."
	@echo "To look at it, and at the sweep that made it, open build/1grm.html in a browser."

figures: build  ## draw the pictures of the pages into papers/figures/, the paper's figures too
	@cmake/install_packages.sh cmake/pages_packages.txt
	@python3 papers/course/build.py --keep-pictures --jobs $(JOBS)

test: build  ## run every test but the slow ones
	ctest --test-dir build --output-on-failure

test-slow: build  ## run the slow tests, the commands of the pages and the fuzz targets
	@cmake/install_packages.sh cmake/python_packages.txt
	@cmake/install_packages.sh cmake/readers_packages.txt
	@cmake/install_packages.sh cmake/packaging_packages.txt
	@cmake/install_packages.sh cmake/engines_packages.txt
	ctest --test-dir build --output-on-failure -C slow -L slow
	cmake --preset dev
	cmake --build build/dev --parallel $(JOBS) --target morskin_command
	python3 tests/same_bytes.py build/morskin build/dev/morskin
	$(MAKE) papers
	$(MAKE) fuzz SECONDS=5

stress: deps  ## mesh SETS random sets of balls (default 2000), the nasty kinds in turn
	cmake --preset release
	cmake --build build --parallel $(JOBS) --target morskin_stress
	build/tests/morskin_stress $(SETS) $(STRESS)

# Needs clang and its libFuzzer, which nothing else does. What was found lands in build/fuzz/findings.
fuzz:  ## run each fuzz target for SECONDS (default 60)
	@cmake/install_packages.sh cmake/fuzz_packages.txt
	cmake --preset fuzz
	cmake --build build/fuzz --parallel $(JOBS) --target $(FUZZERS)
	@mkdir -p build/fuzz/findings
	@for target in $(FUZZERS); do \
	  name=$${target%_fuzz}; mkdir -p build/fuzz/corpus/$$name; echo "$$target, $(SECONDS) s"; \
	  build/fuzz/tests/fuzz/$$target -max_total_time=$(SECONDS) -timeout=60 -verbosity=0 \
	    -print_final_stats=1 -artifact_prefix=build/fuzz/findings/$$name- \
	    build/fuzz/corpus/$$name tests/fuzz/seeds/$$name || exit 1; done

# The page is in the repository; making it again takes node and npm, which nothing else does.
viewer-asset:  ## make viewer/dist/viewer.html, the page that `view` fills, from viewer/src
	@command -v npm > /dev/null || cmake/install_packages.sh cmake/viewer_packages.txt
	cd viewer && npm ci --no-audit --no-fund && node build.mjs

test-viewer: build  ## try the viewer in headless Chromium, every switch of it
	@{ command -v npm && command -v chromium; } > /dev/null || \
	  cmake/install_packages.sh cmake/viewer_packages.txt
	cd viewer && npm ci --no-audit --no-fund && npm test

bench: deps  ## build and run the benchmarks; raw figures in build/bench/*.json
	cmake --preset bench
	cmake --build build/bench --parallel $(JOBS)
	@for program in build/bench/*_bench; do \
	  $$program --benchmark_out=$$program.json --benchmark_out_format=json || exit 1; done

bench-compare: command  ## time this build and that of BASE=<commit> in turns (see bench/compare.py --help)
	@test -n "$(BASE)" || { echo "make bench-compare BASE=COMMIT, as in BASE=HEAD~1"; exit 2; }
	python3 bench/compare.py $(BASE) --molecules $(MOLECULES) --jobs $(JOBS) $(COMPARE)

guard: command  ## fail if instructions or heap are 5 % above the record (see bench/guard.py --help)
	@cmake/install_packages.sh cmake/guard_packages.txt
	python3 bench/guard.py --check

guard-record: command  ## record instructions and heap anew, in bench/guard.json
	@cmake/install_packages.sh cmake/guard_packages.txt
	python3 bench/guard.py --record

corpus: command  ## mesh every molecule of MOLECULES in every model (see bench/corpus.py --help)
	python3 bench/corpus.py --molecules $(MOLECULES) $(CORPUS)

morse-corpus: command  ## trace Morse-Smale complexes of MOLECULES (see bench/morse_corpus.py --help)
	python3 bench/morse_corpus.py --molecules $(MOLECULES) $(CORPUS)

prediction: command  ## count which touches of the front theory predicts (see bench/prediction.py --help)
	python3 bench/prediction.py --molecules $(MOLECULES) $(PREDICTION)

fetch:  ## get the corpus's PDB entries into build/corpus, and check them (see bench/fetch.py --help)
	python3 bench/fetch.py $(FETCH)

# The plots take matplotlib, which Debian installs for its own Python.
reproduce: command  ## the paper's Table 1 by all methods, scaling and topology, into build/results (QUICK=1: some 5 minutes)
	@cmake/install_packages.sh cmake/plot_packages.txt
	@cmake --build build --parallel $(JOBS) --target morskin_ablation
	@python3 bench/reproduce.py --molecules $(MOLECULES) --results $(RESULTS) $(REPRODUCE); \
	  outcome=$$?; /usr/bin/python3 bench/reproduce_plots.py $(RESULTS) && exit $$outcome

# An hour on a quiet machine. Afterwards: make papers-update.
reproduce-reference:  ## the same into papers/results, the committed files that the pages show
	@test "$(QUICK)" != 1 || { echo "the committed files are of whole runs: no QUICK=1"; exit 2; }
	$(MAKE) reproduce RESULTS=papers/results

papers: build  ## build the course of papers/ as a site, run its commands and check all it says
	@cmake/install_packages.sh cmake/pages_packages.txt
	@python3 papers/course/build.py --jobs $(JOBS)
	@$(PYTHON) tests/site_plugins_test.py
	@$(PYTHON) tests/kept_pictures_test.py

student-course: build  ## build the course without its solutions, as a site and an archive
	@cmake/install_packages.sh cmake/pages_packages.txt
	@python3 papers/course/build.py --student --no-run --jobs $(JOBS)

test-papers: papers  ## open every page of the course in headless Chromium, as on a phone and a desk
	@{ command -v npm && command -v chromium; } > /dev/null || \
	  cmake/install_packages.sh cmake/viewer_packages.txt
	cd viewer && npm ci --no-audit --no-fund && node --test test/site_test.mjs

papers-update: command  ## count triangles anew, and put all that papers/results says into the pages
	python3 bench/counts.py
	python3 bench/operations.py
	python3 papers/course/results.py

solvers: command  ## what solvers make of the meshes, into papers/results (see papers/solvers.md)
	@cmake/install_packages.sh cmake/plot_packages.txt
	/usr/bin/python3 bench/solvers/run.py $(SOLVERS)
	$(if $(findstring --results,$(SOLVERS)),,/usr/bin/python3 bench/solvers/plot.py)

exercise: deps  ## try the exercises of the page NAME (NAME=2.1-molecular-skin)
	@test -f "papers/exercises/$(NAME).h" || { echo "make exercise NAME=PAGE, one of:"; \
	  ls papers/exercises/*.h | sed -n 's|.*/\([0-9].*\)\.h|  \1|p'; exit 2; }
	@cmake --preset release > /dev/null
	cmake --build build --parallel $(JOBS) --target exercise-$(NAME)
	build/papers/exercises/tests/exercise-$(NAME)

lint:  ## check module order, layout and formatting, and run clang-tidy if it is there
	python3 cmake/lint.py
	@command -v clang-format > /dev/null || { echo "make lint needs clang-format: apt-get install clang-format"; exit 1; }
	clang-format --dry-run -Werror $(sources)
	@if command -v clang-tidy > /dev/null; then $(MAKE) --no-print-directory tidy; fi

# Programs that are built against an installed library, and the source of gemmi's headers, which
# Debian 12's clang cannot compile as C++20 (a vector of an incomplete type).
untidied = tests/installed/% examples/% skin/mmcif_file.cpp

tidy: deps
	cmake --preset tidy
	printf '%s\n' $(filter-out $(untidied),$(filter %.cpp,$(sources))) | \
	  xargs --max-args=1 --max-procs=$(JOBS) clang-tidy -p build/tidy --quiet

format:  ## lay out every source file with clang-format
	clang-format -i $(sources)

sanitize: deps  ## run the tests with the address and undefined behaviour sanitizers
	cmake --preset sanitize
	cmake --build build/sanitize --parallel $(JOBS)
	ctest --test-dir build/sanitize --output-on-failure

# Others may read what is installed, whatever the umask of who installs.
install: build  ## install command, library, manual and examples under PREFIX (DESTDIR too)
	umask 022 && cmake --install build --prefix "$(PREFIX)"

# Only what is installed: the packages and the static binary take no tests.
installed_targets = morskin_command morskin_manual installed_library
packaged: deps
	@cmake/install_packages.sh cmake/packaging_packages.txt
	cmake --preset release
	cmake --build build --parallel $(JOBS) --target $(installed_targets)

# The address of the maintainer is for whoever gives them to others to put in.
deb: packaged  ## make Debian packages in build/deb, and have lintian look at them
	rm -rf build/deb && mkdir -p build/deb/morskin && cp -r packaging/debian build/deb/morskin
	cd build/deb/morskin && BUILD="$(CURDIR)/build" dpkg-buildpackage --build=binary --no-sign
	lintian --allow-root --fail-on error \
	  --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog build/deb/*.changes

static: packaged  ## make build/static/morskin, which needs no shared library
	cmake --build build --parallel $(JOBS) --target morskin_static

clean:  ## remove everything built
	rm -rf build

help:  ## list these
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' Makefile | while IFS="$$(printf '\t')" read -r name text; \
	  do printf '  make %-13s %s\n' "$$name" "$$text"; done
