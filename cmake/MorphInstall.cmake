# Headers, libraries, tools and a CMake package, so that another project needs
# find_package(libmorph) and morph::morph or morph::formats, no more.
include(CMakePackageConfigHelpers)

set(MORPH_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/libmorph)
set(MORPH_INCLUDE_DIR ${CMAKE_INSTALL_INCLUDEDIR}/libmorph)

install(TARGETS morph morph_formats EXPORT libmorphTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT libmorphTargets NAMESPACE morph:: DESTINATION ${MORPH_CMAKE_DIR})
include(MorphPublicHeaders)
foreach(header IN LISTS MORPH_PUBLIC_HEADERS)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${MORPH_INCLUDE_DIR}/${folder})
endforeach()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libmorph)

configure_package_config_file(cmake/libmorphConfig.cmake.in ${PROJECT_BINARY_DIR}/libmorphConfig.cmake
                              INSTALL_DESTINATION ${MORPH_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/libmorphConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/libmorphConfig.cmake ${PROJECT_BINARY_DIR}/libmorphConfigVersion.cmake
        cmake/MorphLibraries.cmake DESTINATION ${MORPH_CMAKE_DIR})
