# Print the line of a Doxyfile that names the public headers: cmake -D PROJECT_SOURCE_DIR=. -P cmake/DoxygenInput.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/MorphPublicHeaders.cmake)
list(JOIN MORPH_PUBLIC_HEADERS " " headers)
execute_process(COMMAND ${CMAKE_COMMAND} -E echo "INPUT += ${headers}")
