# SPDX-License-Identifier: Apache-2.0
# cmake -DSOURCE=DIR -DOUTPUT=FILE -P write_build_info.cmake
#
# Writes FILE, the source of build_info.h, with the commit of the source tree DIR. A FILE that already has this commit is
# not touched, so nothing is compiled again. The commit is empty if DIR is not the top folder of a git tree, as in a
# source archive that was unpacked inside another project.
set(commit "")
find_program(git git)
if(git AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${git} -C ${SOURCE} rev-parse --short=8 HEAD OUTPUT_VARIABLE commit ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
  if(failed)
    set(commit "")
  endif()
endif()
set(text "// Written by the build (cmake/write_build_info.cmake).
#include \"build_info.h\"

namespace meristem {

std::string_view build_commit() { return \"${commit}\"; }
std::string_view build_type() { return MERISTEM_BUILD_TYPE; }

}  // namespace meristem
")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT before STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
