// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/diagnostic.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>

#include <fmt/format.h>

#include "meristem/base/visible_text.h"

namespace meristem {

namespace {

constexpr std::size_t kLongestName = 100;

char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool are_equal(char a, char b) { return lowered(a) == lowered(b); }

/// How many edits lead from a to b, both at most kLongestName long: optimal string alignment, three rows of the table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  using Row = std::array<std::size_t, kLongestName + 1>;
  Row before{};
  Row above{};
  Row row{};
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (are_equal(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool is_swap = i > 1 && j > 1 && are_equal(a[i - 1], b[j - 2]) && are_equal(a[i - 2], b[j - 1]);
      if (is_swap) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

std::string all_texts(std::span<const Diagnostic> diagnostics) {
  std::string lines;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!lines.empty()) lines += '\n';
    if (diagnostic.severity == Severity::warning) lines += "warning: ";
    lines += diagnostic.text();
  }
  return lines;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string place = file;
  for (const int number : {line, column}) {
    if (number <= 0) break;
    if (!place.empty()) place += ':';
    place += std::to_string(number);
  }
  std::string out;
  const auto out_end = std::back_inserter(out);
  if (!place.empty()) fmt::format_to(out_end, "{}: ", place);
  if (!path.empty()) fmt::format_to(out_end, "{}: ", path);
  out += message;
  if (!expected.empty()) fmt::format_to(out_end, "; expected {}", expected);
  if (!nearest.empty()) fmt::format_to(out_end, "; did you mean '{}'?", nearest);
  return visible_text(out);
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all_texts(diagnostics)), diagnostics_(std::move(diagnostics)) {
  for (Diagnostic& diagnostic : diagnostics_) diagnostic = visible(std::move(diagnostic));
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  if (name.size() > kLongestName) return {};
  const std::string* nearest = nullptr;
  std::size_t allowed = name.size() / 3 + 1;  // one too many, so that a distance below it counts
  for (const std::string& candidate : candidates) {
    if (candidate.size() > kLongestName || candidate.size() + allowed <= name.size()) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance >= allowed) continue;
    allowed = distance;
    nearest = &candidate;
  }
  return nearest == nullptr ? std::string() : *nearest;
}

}  // namespace meristem
