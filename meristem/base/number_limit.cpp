// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/number_limit.h"

#include <fmt/format.h>

namespace meristem {

std::string NumberLimit::expected() const { return fmt::format("{} from {:.7g} to {:.7g}", noun, min, max); }

Diagnostic number_error(std::string_view what, const NumberLimit& limit) {
  return {.message = fmt::format("{} is out of range", what), .expected = limit.expected()};
}

}  // namespace meristem
