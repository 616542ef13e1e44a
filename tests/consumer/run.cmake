# SPDX-License-Identifier: Apache-2.0
# Installs the build in LIBRARY to a fresh prefix below WORK, then configures, builds and runs the project in SOURCE
# against that prefix and nothing else of this tree.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed:\n${output}")
  endif()
  message(STATUS "${what}")
endfunction()

file(REMOVE_RECURSE ${WORK})
run("install the library" ${CMAKE_COMMAND} --install ${LIBRARY} --prefix ${WORK}/prefix)
run("configure the consumer" ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run("build the consumer" ${CMAKE_COMMAND} --build ${WORK}/build)
run("grow a document" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./grow_document ${MODELS}/oak.json age=10)
run("grow into points" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./grow_points)
run("grow a component of one's own" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./own_component)
foreach(name plant.glb plant.png measures.json skeleton.csv thorns.obj)
  if(NOT EXISTS ${WORK}/build/${name})
    message(FATAL_ERROR "the programs did not write ${name}")
  endif()
endforeach()
