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
run("edit a document" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./edit_document ${MODELS}/oak.json)
run("grow into points" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./grow_points)
run("grow a component of one's own" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./own_component)
run("run the examples of the reference" ${CMAKE_COMMAND} -E chdir ${WORK}/build ./examples)
# The starter project of plug-ins: built as its page says, listed and grown by the installed program, and refused where
# it is none.
run("configure the plug-in" ${CMAKE_COMMAND} -S ${PLUGIN} -B ${WORK}/plugin -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run("build the plug-in" ${CMAKE_COMMAND} --build ${WORK}/plugin)
set(program ${WORK}/prefix/bin/meristem)
run("list the plug-in's component" ${program} components thorn --plugin ${WORK}/plugin/libthorn.so)
run("grow the plug-in's component" ${program} grow ${PLUGIN}/thorns.json --plugin ${WORK}/plugin/libthorn.so
    -o ${WORK}/build/plugin.glb)
execute_process(COMMAND ${program} check ${PLUGIN}/thorns.json RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 2 OR NOT errors MATCHES "'thorn' is not a type of component")
  message(FATAL_ERROR "without the plug-in its type is known: ${errors}")
endif()
execute_process(COMMAND ${program} check ${PLUGIN}/thorns.json --plugin ${WORK}/plugin/libthorn.so
                        --plugin ${WORK}/plugin/libthorn.so RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 2 OR NOT errors MATCHES "there is already a component type 'thorn'")
  message(FATAL_ERROR "a plug-in may be loaded twice: ${errors}")
endif()
foreach(name plugin.glb plant.glb plant.png measures.json edited.json skeleton.csv skeleton.glb thorns.obj)
  if(NOT EXISTS ${WORK}/build/${name})
    message(FATAL_ERROR "the programs did not write ${name}")
  endif()
endforeach()
