# Libraries that have no CMake package of their own in Debian, as imported targets. The installed package includes this
# file too, so that it holds names and no paths of the machine that built it.
function(morph_import_library target library)
  if(TARGET ${target})
    return()
  endif()
  add_library(${target} UNKNOWN IMPORTED)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${library})
endfunction()

find_library(LZ4_LIBRARY lz4 REQUIRED)
find_library(OPENBLAS_LIBRARY openblas REQUIRED)
find_library(CGNS_LIBRARY cgns REQUIRED)
morph_import_library(libmorph_lz4 ${LZ4_LIBRARY})
morph_import_library(libmorph_openblas ${OPENBLAS_LIBRARY})
morph_import_library(libmorph_cgns ${CGNS_LIBRARY})
