// SPDX-License-Identifier: Apache-2.0
// Formats the errors of exceeded limits.
#include "meristem/base/limits.h"

#include <fmt/format.h>

namespace meristem {

Diagnostic limit_diagnostic(std::string_view what, double wanted, std::uint64_t limit, std::string_view limit_name,
                            std::string_view path) {
  // Above 2^53, the last digits of a double have no meaning.
  const std::string number = wanted < 9e15 ? fmt::format("{:.0f}", wanted) : fmt::format("{:.3g}", wanted);
  Diagnostic diagnostic;
  diagnostic.message = fmt::format("{} {} are too many", number, what);
  diagnostic.expected = fmt::format("at most {} (limits.{})", limit, limit_name);
  diagnostic.path = path;
  return diagnostic;
}

void throw_limit(std::string_view what, double wanted, std::uint64_t limit, std::string_view limit_name,
                 std::string_view path) {
  throw InputError(limit_diagnostic(what, wanted, limit, limit_name, path));
}

}  // namespace meristem
