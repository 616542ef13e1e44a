// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace meristem {

/// Returns the version of the program, such as "1.2.3".
std::string_view version();

}  // namespace meristem
