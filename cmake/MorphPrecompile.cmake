# Headers that nearly every source of a target reads are compiled once for all of them. Sources include what
# they need all the same: without MORPH_PCH, as for `make lint`, they have to compile too.
option(MORPH_PCH "Compile common headers once for each library and for the tests" ON)

# CMake would make system headers of them, whose warnings are hidden; ours are among them.
set(CMAKE_PCH_PROLOGUE "")

# morph_precompile(target ...): target_precompile_headers() with these arguments, where MORPH_PCH is on.
function(morph_precompile)
  if(MORPH_PCH)
    target_precompile_headers(${ARGV})
  endif()
endfunction()
