// SPDX-License-Identifier: Apache-2.0
// Formats diagnostics and finds the nearest valid name. The nearest name minimises the edit distance (optimal string
// alignment). The search stops early where the distance already exceeds the best one so far.
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

/// Returns the number of edits that lead from a to b, or `limit` if there are at least that many. Both names have at
/// most kLongestName bytes. Optimal string alignment with three rows of the table; only cells near the diagonal can be
/// below the limit.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  using Row = std::array<std::size_t, kLongestName + 2>;
  std::array<Row, 3> rows;
  const std::size_t band = limit - 1;  // cells farther from the diagonal need at least `limit` edits
  for (Row& row : rows) std::fill_n(row.begin(), b.size() + 2, limit);
  for (std::size_t j = 0; j <= std::min(b.size(), band); ++j) rows[0][j] = j;
  std::size_t min_above = 0;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    Row& row = rows[i % 3];
    const Row& above = rows[(i + 2) % 3];
    const Row& before = rows[(i + 1) % 3];
    const std::size_t first = i > band ? i - band : 1;
    const std::size_t last = std::min(b.size(), i + band);
    row[first - 1] = first == 1 && i <= band ? i : limit;
    std::size_t min = row[first - 1];
    for (std::size_t j = first; j <= last; ++j) {
      const std::size_t replaced = above[j - 1] + (are_equal(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool is_swap = i > 1 && j > 1 && are_equal(a[i - 1], b[j - 2]) && are_equal(a[i - 2], b[j - 1]);
      if (is_swap) row[j] = std::min(row[j], before[j - 2] + 1);
      min = std::min(min, row[j]);
    }
    row[last + 1] = limit;  // the next row reads this cell
    // A swap reads the row two above, so both rows must reach the limit.
    if (min >= limit && min_above >= limit) return limit;
    min_above = min;
  }
  return std::min(limit, rows[a.size() % 3][b.size()]);
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
  std::size_t allowed = name.size() / 3 + 1;  // one more than allowed, so that any smaller distance counts
  for (const std::string& candidate : candidates) {
    if (allowed == 0) break;  // no candidate is nearer than an equal name
    if (candidate.size() > kLongestName || candidate.size() + allowed <= name.size()) continue;
    if (name.size() + allowed <= candidate.size()) continue;
    const std::size_t distance = edit_distance(name, candidate, allowed);
    if (distance >= allowed) continue;
    allowed = distance;
    nearest = &candidate;
  }
  return nearest == nullptr ? std::string() : *nearest;
}

}  // namespace meristem
