# SPDX-License-Identifier: Apache-2.0
# The library meristem_build_info: the commit and the build type, for the program and the Python module. Each build looks
# for a new commit. A new commit compiles this one source and links the program and the module again.
set(build_info_source ${PROJECT_BINARY_DIR}/build_info/build_info.cpp)
add_custom_target(meristem_commit
                  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${build_info_source}
                          -P ${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake
                  BYPRODUCTS ${build_info_source} COMMENT "Looking for a new commit" VERBATIM)
add_library(meristem_build_info STATIC ${build_info_source})
add_dependencies(meristem_build_info meristem_commit)
meristem_compile_options(meristem_build_info)
target_include_directories(meristem_build_info PUBLIC ${PROJECT_SOURCE_DIR}/cmake)
target_compile_definitions(meristem_build_info PRIVATE MERISTEM_BUILD_TYPE="$<CONFIG>")
