# Install the build into a fresh prefix, build the small project tests/install against it, and let it morph a mesh.
# Called with BUILD, SOURCE, WORK and MESH.
function(must_run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
must_run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
must_run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
         -DCMAKE_PREFIX_PATH=${WORK}/prefix)
must_run(${CMAKE_COMMAND} --build ${WORK}/build)
must_run(${WORK}/build/user ${MESH} ${WORK}/moved.su2)
foreach(tool deform fit mesh quality view)
  must_run(${WORK}/prefix/bin/morph-${tool} --version)
endforeach()
must_run(${WORK}/prefix/bin/morph-quality ${WORK}/moved.su2)
