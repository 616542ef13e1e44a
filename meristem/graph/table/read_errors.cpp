// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/read_errors.h"

#include <fmt/format.h>

namespace meristem {

void ReadErrors::add_error(const DocumentPath& path, std::string message, std::string expected, std::string nearest,
                           int text_offset) {
  if (++errors_ > limits_.diagnostics) return;
  diagnostics_.push_back({.message = std::move(message),
                          .expected = std::move(expected),
                          .nearest = std::move(nearest),
                          .path = path.text(),
                          .file = {},
                          .text_offset = text_offset});
}

void ReadErrors::add_name_error(const DocumentPath& path, std::string message, std::string expected,
                                std::string nearest) {
  add_error(path, std::move(message), std::move(expected), std::move(nearest), kAtName);
}

void ReadErrors::add_meaning_error(const DocumentPath& path, std::string message, std::string expected,
                                   const DocumentPath* other) {
  meaningless_.push_back({path.text(), other == nullptr ? std::string() : other->text()});
  add_name_error(path, std::move(message), std::move(expected), "");
}

void ReadErrors::add_limit_error(const DocumentPath& path, std::string_view what, double wanted, std::uint64_t limit,
                                 std::string_view limit_name) {
  if (++errors_ > limits_.diagnostics) return;
  diagnostics_.push_back(limit_diagnostic(what, wanted, limit, limit_name, path.text()));
}

void ReadErrors::wrong_kind(const Parameter& parameter, const Value& value, const DocumentPath& path) {
  add_error(path, fmt::format("'{}' cannot be {}", parameter.name, value.description()), parameter.expectation());
}

void ReadErrors::warn(const DocumentPath& path, std::string message) {
  if (diagnostics_.size() > 2 * limits_.diagnostics) return;
  diagnostics_.push_back({.severity = Severity::warning,
                          .message = std::move(message),
                          .expected = {},
                          .nearest = {},
                          .path = path.text(),
                          .file = {}});
}

void ReadErrors::add_found(const DocumentPath& path, const Diagnostic& found, int text_offset) {
  if (found.severity == Severity::warning) {
    warn(path, found.message);
  } else {
    add_error(path, found.message, found.expected, found.nearest, text_offset);
  }
}

std::string ReadErrors::nearest(std::string_view name, std::span<const std::string> candidates) const {
  if (!may_compare(candidates.size())) return {};
  count_compared(candidates.size());
  return nearest_name(name, candidates);
}

bool ReadErrors::may_compare(std::size_t count) const {
  return errors_ < limits_.diagnostics && names_compared_ + count <= kMaxNamesCompared;
}

}  // namespace meristem
