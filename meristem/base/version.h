// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace meristem {

/// The program's version, "1.2.3".
std::string_view version();

}  // namespace meristem
