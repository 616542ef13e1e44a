// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace meristem {

/// Returns `text` in quotes for a message, as visible_text(). A long text is cut after a whole character (UTF-8).
std::string in_quotes(std::string_view text);

}  // namespace meristem
