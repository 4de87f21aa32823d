# How every target of the project is compiled: warnings as errors when we are the
# top project, and the sanitizers or coverage when a preset asks for them.
add_library(morph_options INTERFACE)
target_compile_features(morph_options INTERFACE cxx_std_20)

# The same bytes on every machine: a fused multiply-add rounds once where two
# operations round twice.
target_compile_options(morph_options INTERFACE -ffp-contract=off)

if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(morph_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wold-style-cast
                         -Wcast-qual -Wnon-virtual-dtor -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 reports these falsely inside Eigen and OpenMesh templates, and the last for
    # "text" + std::string (bug 105651).
    target_compile_options(morph_options INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds
                           -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
  endif()
endif()

if(MORPH_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -O1)
  add_link_options(-fsanitize=address,undefined)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # Eigen adds to the null pointer of an empty matrix where it takes a block of it; clang alone counts that.
    add_compile_options(-fno-sanitize=pointer-overflow)
  endif()
endif()

if(MORPH_COVERAGE)
  add_compile_options(--coverage -O0)
  add_link_options(--coverage)
endif()
