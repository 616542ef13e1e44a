// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace meristem {

/// `text` in quotes for a message, as visible_text(), shortened after a whole character (UTF-8) where it is long.
std::string in_quotes(std::string_view text);

}  // namespace meristem
