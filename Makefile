# The short way to everything. CMake's presets do the work; this file only calls them.
#
#   make demo       install what is missing, build, render scenes/demo.cli
#   make test       install what is missing, build, run all tests
#   make build      install what is missing, build the release
#   make test-long  all tests, and those that take longer: half an hour of fuzzing, random events for the window,
#                   point sets of every size, adaptive errors, renders killed 200 times, and 500 times while they write
#   make mutants    break a copy of the program in some fifty places, one by one, and expect a test to notice
#   make coverage   which share of the lines of src/ the tests run
#   make test-cluster  a frame and an animation on a three-node Slurm on this machine, and all that can go wrong there
#   make bench      compare speeds, as ratios of runs taken in turn, also with the last tag or BEFORE=REVISION
#   make bench-peers  compare with POV-Ray and Cycles; takes half an hour (docs/performance.md)
#   make instructions  record how many instructions four small renders take now (bench/README.md)
#   make lint       formatting and static analysis
#   make format     format the code
#   make docs       regenerate the generated pages and pictures
#   make gallery    render the pictures of docs/lecture.md
#   make clean      remove everything that was built

JOBS := $(shell nproc)
CMAKE_FLAGS ?=
PRESET ?= release
BUILD := build/$(PRESET)
FUZZ_SECONDS ?= 300
FUZZ_ORDER ?= 0
WINDOW_EVENTS ?= 10000
PEERS_FLAGS ?=
BEFORE ?= $(shell git describe --tags --abbrev=0 2> /dev/null)

.PHONY: demo test build test-long mutants coverage test-cluster bench bench-peers instructions check-instructions lint \
  format docs gallery fuzz window-events clean

build:
	@scripts/install-dependencies.sh build
	@cmake --preset $(PRESET) -DPENUMBRA_TESTS=OFF $(CMAKE_FLAGS) > /dev/null
	@cmake --build --preset $(PRESET) -j $(JOBS)

demo: build
	@$(BUILD)/penumbra render scenes/demo.cli -o build/demo.png
	@echo "The picture is build/demo.png. All options: $(BUILD)/penumbra render --help"

test:
	@scripts/install-dependencies.sh test
	@cmake --preset $(PRESET) -DPENUMBRA_TESTS=ON $(CMAKE_FLAGS) > /dev/null
	@cmake --build --preset $(PRESET) -j $(JOBS)
	@ctest --preset $(PRESET) -j $(JOBS)

test-long: test fuzz window-events
	@$(BUILD)/tests/sampling/sampling_test --gtest_also_run_disabled_tests --gtest_filter='*AtEveryCount'
	@python3 bench/adaptive.py --penumbra $(BUILD)/penumbra --check
	@$(BUILD)/tests/sittings/sittings_test --gtest_also_run_disabled_tests --gtest_filter='Kill.*Many*'

mutants:
	@scripts/install-dependencies.sh test
	@tests/mutants/run.py --jobs $(JOBS) --cmake-flags "$(CMAKE_FLAGS)"

# A test that fails does not keep the figures from being printed, but fails the target.
coverage:
	@scripts/install-dependencies.sh coverage
	@cmake --preset coverage -DPENUMBRA_TESTS=ON $(CMAKE_FLAGS) > /dev/null
	@cmake --build --preset coverage -j $(JOBS)
	@find build/coverage -name '*.gcda' -delete
	@ctest --preset coverage -j $(JOBS); passed=$$?; \
	  gcovr --root . --filter src/ --exclude-throw-branches --print-summary -j $(JOBS) build/coverage && exit $$passed

test-cluster: build
	@scripts/install-dependencies.sh cluster
	@python3 tests/cluster/cluster_test.py --penumbra $(BUILD)/penumbra

# Thousands of random events for the window, under AddressSanitizer and UndefinedBehaviorSanitizer, then under
# ThreadSanitizer.
window-events:
	@scripts/install-dependencies.sh test
	@for preset in asan-ubsan tsan; do \
	  cmake --preset $$preset -DPENUMBRA_TESTS=OFF $(CMAKE_FLAGS) > /dev/null && \
	  cmake --build --preset $$preset -j $(JOBS) --target penumbra penumbra-view && \
	  python3 tests/window/random_events.py build/$$preset/penumbra --events $(WINDOW_EVENTS) || exit 1; \
	done

bench: build
	@cmake --build --preset $(PRESET) -j $(JOBS) --target parse_bench mesh_replay embree_memory bumpy_sphere
	@python3 bench/bench.py --penumbra $(BUILD)/penumbra --parse-bench $(BUILD)/bench/parse_bench \
	  --mesh-replay $(BUILD)/bench/mesh_replay --bumpy-sphere $(BUILD)/bench/bumpy_sphere --embree-memory $(BUILD)/bench/embree_memory \
	  --before "$(BEFORE)"
	@scripts/install-dependencies.sh test
	@bench/window_latency.py --penumbra $(BUILD)/penumbra

# Debian's own python3, which has Debian's numpy and matplotlib.
bench-peers: build
	@scripts/install-dependencies.sh peers
	@/usr/bin/python3 bench/peers/compare.py --penumbra $(BUILD)/penumbra $(PEERS_FLAGS)

instructions: build
	@scripts/install-dependencies.sh instructions
	@python3 bench/instructions.py --penumbra $(BUILD)/penumbra --update

check-instructions: build
	@scripts/install-dependencies.sh instructions
	@python3 bench/instructions.py --penumbra $(BUILD)/penumbra
	@python3 bench/scaling.py --penumbra $(BUILD)/penumbra

lint:
	@scripts/install-dependencies.sh lint
	@scripts/lint.sh

format:
	@scripts/install-dependencies.sh lint
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

docs: build
	@cmake --build --preset $(PRESET) --target language_page options_page
	@scripts/make-pictures.sh $(BUILD)/penumbra
	@scripts/install-dependencies.sh test
	@scripts/make-window-pictures.py $(BUILD)/penumbra

gallery: build
	@scripts/make-gallery.sh $(BUILD)/penumbra

fuzz:
	@scripts/install-dependencies.sh lint
	@cmake --preset fuzz $(CMAKE_FLAGS) > /dev/null
	@cmake --build --preset fuzz -j $(JOBS) --target fuzzers
	@scripts/fuzz.sh build/fuzz/fuzz $(FUZZ_SECONDS) $(FUZZ_ORDER)

clean:
	@rm -rf build
