# The front door; CMake does the work. `make demo` and `make test` set up a bare Debian 12 by themselves.

# Every Debian package the project builds, tests and measures with. One list, so that nothing is forgotten.
PACKAGES := \
	g++ cmake ninja-build pkg-config \
	libeigen3-dev libopenmesh-dev libcgal-dev libflann-dev liblz4-dev libopenblas-pthread-dev libcgns-dev \
	libcli11-dev libtomlplusplus-dev nlohmann-json3-dev zlib1g-dev libcairo2-dev \
	libgtest-dev libgmock-dev libbenchmark-dev time \
	clang-14 libclang-rt-14-dev clang-format-14 clang-tidy-14

# What only the benchmarks compare with: NumPy, meshio, Gmsh, and VTK with some 150 packages that it brings along.
BENCH_PACKAGES := libvtk9-dev python3-numpy gmsh python3-meshio

# The programs that `make peers` lets read what we write.
PEER_PACKAGES := gmsh python3-gmsh python3-meshio python3-vtk9 cgns-convert

PREFIX ?= /usr/local
JOBS ?= $(shell nproc)
FUZZ_SECONDS ?= 60
ROOT := $(shell [ $$(id -u) -eq 0 ] || echo sudo)
SOURCES = $(shell git ls-files '*.h' '*.cpp')

.PHONY: help deps bench-deps build demo test sanitize peers bench lint install clean

help:
	@echo 'make demo      set up, build, morph a real mesh, draw it before and after'
	@echo 'make test      set up, build, run every test'
	@echo 'make build     set up and build the tools into build/bin'
	@echo 'make sanitize  the tests under AddressSanitizer and UndefinedBehaviorSanitizer, then the fuzzers'
	@echo 'make peers     let Gmsh, meshio, VTK and others read what we write, and read what they write'
	@echo 'make bench     run the benchmarks (tests/bench/README.md explains the table)'
	@echo 'make lint      clang-format and clang-tidy'
	@echo 'make install   install below PREFIX ($(PREFIX))'

# Silent when nothing is missing.
define install_missing
@missing=$$(for p in $(1); do \
    dpkg-query -W -f='$${Status}' $$p 2>/dev/null | grep -q 'ok installed' || echo $$p; done); \
[ -z "$$missing" ] || { echo "installing:" $$missing && \
    $(ROOT) apt-get update -qq && \
    $(ROOT) env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$missing \
        >/dev/null; }
endef

deps:
	$(call install_missing,$(PACKAGES))

bench-deps: deps
	$(call install_missing,$(BENCH_PACKAGES))

build: deps
	@cmake --preset release $(CMAKE_FLAGS) >/dev/null
	@cmake --build --preset release -j $(JOBS)

demo: deps
	@cmake --preset release $(CMAKE_FLAGS) >/dev/null
	@cmake --build --preset release -j $(JOBS) --target morph-deform morph-quality morph-view
	@sh examples/demo.sh build/bin out/demo

test: build
	@ctest --preset release -j $(JOBS)

sanitize: deps
	@cmake --preset debug >/dev/null
	@cmake --build --preset debug -j $(JOBS)
	@ctest --preset debug -j $(JOBS)
	@cmake --preset fuzz >/dev/null
	@cmake --build --preset fuzz -j $(JOBS)
	@sh tests/fuzz/run.sh $(FUZZ_SECONDS)

peers: build
	$(call install_missing,$(PEER_PACKAGES))
	@sh tests/peers/run.sh build/bin

bench: bench-deps
	@cmake --preset bench >/dev/null
	@cmake --build --preset bench -j $(JOBS)
	@sh tests/bench/run.sh

lint: deps
	@cmake --preset lint >/dev/null
	@clang-format-14 --dry-run -Werror $(SOURCES)
	@printf '%s\n' $(filter %.cpp,$(filter-out tests/fuzz/% tests/bench/%,$(SOURCES))) | \
	    xargs -P $(JOBS) -n 4 clang-tidy-14 -p build/lint --quiet

install: build
	@cmake --install build --prefix $(PREFIX)

clean:
	@rm -rf build out
