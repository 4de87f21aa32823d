# The front door; CMake does the work. `make demo` and `make test` set up a bare Debian 12 by themselves.

# The Debian packages that the libraries and tools are built with: all that `make demo` installs.
PACKAGES := \
	g++ cmake ninja-build pkg-config \
	libeigen3-dev libopenmesh-dev libcgal-dev libflann-dev liblz4-dev libopenblas-pthread-dev libcgns-dev \
	libcli11-dev libtomlplusplus-dev nlohmann-json3-dev zlib1g-dev libcairo2-dev

# What comes on top of them for the tests; for the tests under the sanitizers, whose reports llvm-14 gives names
# and lines; for lint.
TEST_PACKAGES := libgtest-dev libgmock-dev
SANITIZE_PACKAGES := clang-14 libclang-rt-14-dev llvm-14
LINT_PACKAGES := clang-format-14 clang-tidy-14

# What only the benchmarks need and compare with: NumPy, meshio, Gmsh, and VTK with some 150 packages that it brings
# along.
BENCH_PACKAGES := libbenchmark-dev time libvtk9-dev python3-numpy gmsh python3-meshio

# The programs that `make peers` lets read what we write.
PEER_PACKAGES := gmsh python3-gmsh python3-meshio python3-vtk9 cgns-convert

PREFIX ?= /usr/local
JOBS ?= $(shell nproc)
FUZZ_SECONDS ?= 60
ROOT := $(shell [ $$(id -u) -eq 0 ] || echo sudo)

.PHONY: help deps build demo test sanitize peers bench lint docs install clean

help:
	@echo 'make demo      set up, build, morph a real mesh, draw it before and after'
	@echo 'make test      set up, build, run every test'
	@echo 'make build     set up and build the tools into build/bin'
	@echo 'make sanitize  the tests under AddressSanitizer and UndefinedBehaviorSanitizer, then every fuzzer for'
	@echo '              FUZZ_SECONDS ($(FUZZ_SECONDS))'
	@echo 'make peers     let Gmsh, meshio, VTK and others read what we write, and read what they write'
	@echo 'make bench     run the benchmarks (tests/bench/README.md explains the table)'
	@echo 'make lint      clang-format and clang-tidy; SINCE=REV: on what changed since that revision'
	@echo 'make docs      the API reference, in out/docs/html'
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

# A folder is configured without the tests, which need more packages, until `make test` asks for them; they stay
# from then on.
configure_tools = cmake --preset release $(if $(wildcard build/build.ninja),,-DMORPH_TESTS=OFF) $(CMAKE_FLAGS) >/dev/null

deps:
	$(call install_missing,$(PACKAGES) $(TEST_PACKAGES))

build:
	$(call install_missing,$(PACKAGES))
	@$(configure_tools)
	@cmake --build --preset release -j $(JOBS) --target tools/all

demo:
	$(call install_missing,$(PACKAGES))
	@$(configure_tools)
	@cmake --build --preset release -j $(JOBS) --target morph-deform morph-view
	@sh examples/demo.sh build/bin out/demo

test: deps
	@cmake --preset release -DMORPH_TESTS=ON $(CMAKE_FLAGS) >/dev/null
	@cmake --build --preset release -j $(JOBS)
	@ctest --preset release -j $(JOBS)

sanitize: deps
	$(call install_missing,$(SANITIZE_PACKAGES))
	@cmake --preset debug >/dev/null
	@cmake --build --preset debug -j $(JOBS)
	@ctest --preset debug -j $(JOBS)
	@[ $(FUZZ_SECONDS) -eq 0 ] || sh tests/fuzz/search.sh $(FUZZ_SECONDS)

peers: build
	$(call install_missing,$(PEER_PACKAGES))
	@sh tests/peers/run.sh build/bin

bench:
	$(call install_missing,$(PACKAGES) $(BENCH_PACKAGES))
	@cmake --preset bench >/dev/null
	@cmake --build --preset bench -j $(JOBS)
	@sh tests/bench/run.sh

lint: deps
	$(call install_missing,$(LINT_PACKAGES))
	@cmake --preset lint >/dev/null
	@sh .ci/lint.sh build/lint $(JOBS) $(SINCE)

docs:
	$(call install_missing,cmake doxygen)
	@mkdir -p out/docs
	@{ cat docs/Doxyfile; cmake -D PROJECT_SOURCE_DIR=. -P cmake/DoxygenInput.cmake; } | doxygen -

install: build
	@cmake --install build --prefix $(PREFIX)

clean:
	@rm -rf build out
