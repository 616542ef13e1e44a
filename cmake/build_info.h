// SPDX-License-Identifier: Apache-2.0
// Facts about a build for people who report errors. Only the program and the Python module link them: what the library
// writes depends on its version and never on these.
#pragma once

#include <string_view>

namespace meristem {

/// Returns the first digits of the git commit that was built, such as "72fe62c0". Empty if the source tree has no git.
std::string_view build_commit();

/// Returns CMake's build type, such as "Release". Empty if none was chosen.
std::string_view build_type();

}  // namespace meristem
