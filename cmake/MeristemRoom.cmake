# SPDX-License-Identifier: Apache-2.0

# Option that lets ccache recognise an unchanged precompiled header.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(MERISTEM_PCH_OPTIONS -fpch-preprocess)
else()
  set(MERISTEM_PCH_OPTIONS "SHELL:-Xclang -fno-pch-timestamp")
endif()

# Headers that most sources of the library include. Parsing them is a third of a small source's compile time. Each
# source still includes the headers that it uses, since packagers may build without precompiled headers.
set(MERISTEM_LIBRARY_PCH <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
    <string> <string_view> <unordered_map> <variant> <vector> <fmt/format.h> <glm/common.hpp> <glm/geometric.hpp>
    <glm/mat3x3.hpp>)

# Warnings, determinism and sanitizers for every target of the project.
function(meristem_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    -Wno-missing-field-initializers  # members left out of a designated initializer have their defaults, on purpose
    # A fused multiply-add rounds once, and two operations round twice. Fusing would depend on the machine and the
    # optimisation level, and plants must have equal bytes on all of them.
    -ffp-contract=off
    # In a batch GCC treats each source as a header, and warns of types in unnamed namespaces of headers.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>
    # GCC's garbage collection takes a twentieth of a batch's time. It begins at this number of kilobytes.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:--param=ggc-min-heapsize=1048576>
    $<$<BOOL:${MERISTEM_WERROR}>:-Werror>)
  if(MERISTEM_SANITIZE)
    # The excluded checks cost half the compile time, and the address sanitizer finds the same faults.
    target_compile_options(${target} PRIVATE -fsanitize=${MERISTEM_SANITIZE} -fno-sanitize=null,object-size,vptr
                           -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${MERISTEM_SANITIZE})
  endif()
endfunction()

# For code that takes no time during growth. Optimising it would cost users more build time than they ever gain. Debug
# builds do not change.
function(meristem_cold_options target)
  target_compile_options(${target} PRIVATE "$<$<NOT:$<CONFIG:Debug>>:${MERISTEM_COLD_OPTIONS}>")
endfunction()

# Sets the options of a library in addition to meristem_compile_options. COLD adds the cold options.
function(meristem_library_options target)
  cmake_parse_arguments(LIBRARY "COLD" "" "" ${ARGN})
  meristem_compile_options(${target})
  if(MERISTEM_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  set(headers MERISTEM_HEADERS_OF)
  if(LIBRARY_COLD)
    meristem_cold_options(${target})
    set(headers MERISTEM_COLD_HEADERS_OF)
  endif()
  if(MERISTEM_PRECOMPILE)
    target_compile_options(${target} PRIVATE ${MERISTEM_PCH_OPTIONS})
    # The first library of its kind makes them, and the others reuse them.
    get_property(first GLOBAL PROPERTY ${headers})
    if(first)
      target_precompile_headers(${target} REUSE_FROM ${first})
    else()
      target_precompile_headers(${target} PRIVATE ${MERISTEM_LIBRARY_PCH})
      set_property(GLOBAL PROPERTY ${headers} ${target})
    endif()
  endif()
endfunction()

# Reduces the list `files` to files that have a matching name or suite of a test, and files that only help tests.
function(meristem_tests_named name files)
  set(matching "")
  foreach(file IN LISTS ${files})
    file(STRINGS ${file} found REGEX "^[A-Z_]*(TEST|GTEST)[A-Z_]*\\(.*(${name})" LIMIT_COUNT 1)
    if(found OR NOT file MATCHES "_test\\.cpp$")
      list(APPEND matching ${file})
    endif()
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${${files}})
  set(${files} "${matching}" PARENT_SCOPE)
endfunction()

# meristem_room(NAME [COLD] SOURCES ... HEADERS ... TESTS ... PUBLIC ... PRIVATE ... TESTED_WITH ...)
#
# One static library `meristem_NAME`, alias `meristem::NAME`, and one test program `meristem_NAME_tests` from the files
# in TESTS. PUBLIC and PRIVATE are the link lists: the rooms whose headers this room's headers and sources include. The
# links between the targets are therefore the architecture. TESTED_WITH names libraries that only the tests link.
function(meristem_room name)
  cmake_parse_arguments(ROOM "COLD" "" "SOURCES;HEADERS;TESTS;PUBLIC;PRIVATE;TESTED_WITH" ${ARGN})
  set(target meristem_${name})
  if(ROOM_SOURCES)
    add_library(${target} STATIC ${ROOM_SOURCES})
    if(ROOM_COLD)
      meristem_library_options(${target} COLD)
    else()
      meristem_library_options(${target})
    endif()
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE ${ROOM_PRIVATE})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(meristem::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} ${scope} ${ROOM_PUBLIC})
  # A source includes the header of its own name first (tests/architecture checks it), so this header compiles alone. A
  # verification compiles each other header separately.
  set(with_source ${ROOM_HEADERS})
  set(without_source "")
  foreach(header IN LISTS ROOM_HEADERS)
    string(REGEX REPLACE "\\.h$" ".cpp" source ${header})
    if(NOT source IN_LIST ROOM_SOURCES)
      list(REMOVE_ITEM with_source ${header})
      list(APPEND without_source ${header})
    endif()
  endforeach()
  target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${with_source})
  if(without_source)
    target_sources(${target} ${scope} FILE_SET without_source TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
                   FILES ${without_source})
    set_target_properties(${target} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY without_source)
  else()
    set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)
  endif()
  set_property(GLOBAL APPEND PROPERTY MERISTEM_ROOM_LIST meristem::${name})
  set_property(GLOBAL APPEND PROPERTY MERISTEM_EXPORTED_TARGETS ${target})

  if(MERISTEM_TESTS_NAMED)
    meristem_tests_named("${MERISTEM_TESTS_NAMED}" ROOM_TESTS)
  endif()
  if(MERISTEM_TESTS AND ROOM_TESTS)
    add_executable(${target}_tests ${ROOM_TESTS})
    meristem_compile_options(${target}_tests)
    target_compile_options(${target}_tests PRIVATE ${MERISTEM_TEST_OPTIONS} ${MERISTEM_PCH_OPTIONS})
    target_precompile_headers(${target}_tests REUSE_FROM meristem_test_headers)
    # In larger batches tests would see headers whose functions have equal names to the tests' helpers.
    set_target_properties(${target}_tests PROPERTIES UNITY_BUILD_BATCH_SIZE 24)
    target_link_libraries(${target}_tests PRIVATE meristem::${name} ${ROOM_TESTED_WITH} meristem_test_support
                          GTest::gmock GTest::gtest_main)
    gtest_discover_tests(${target}_tests DISCOVERY_MODE PRE_TEST PROPERTIES LABELS ${name})
  endif()
endfunction()
