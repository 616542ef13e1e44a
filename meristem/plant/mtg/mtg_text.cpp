// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/mtg/mtg_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace meristem {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestShown = 60;

MtgWord trimmed(std::string_view line, std::size_t begin, std::size_t end) {
  while (begin < end && kBlanks.find(line[begin]) != std::string_view::npos) ++begin;
  while (end > begin && kBlanks.find(line[end - 1]) != std::string_view::npos) --end;
  return {line.substr(begin, end - begin), begin};
}

template <class Number>
std::optional<Number> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || stop != end || !std::isfinite(number)) return {};
  return number;
}

}  // namespace

std::vector<MtgWord> MtgLine::words() const {
  std::vector<MtgWord> words;
  std::size_t begin = text.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    words.push_back({text.substr(begin, end - begin), begin});
    begin = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::vector<MtgWord> MtgLine::cells() const {
  std::vector<MtgWord> cells;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\t', begin), text.size());
    cells.push_back(trimmed(text, begin, end));
    begin = end + 1;
  }
  return cells;
}

MtgLines::MtgLines(std::string_view text) : rest_(text) {
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool MtgLines::next(MtgLine& line) {
  while (!rest_.empty()) {
    stop_.step();
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view whole = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    line = {whole.substr(0, whole.find('#')), number_};
    if (line.text.find_first_not_of(kBlanks) != std::string_view::npos) return true;
  }
  return false;
}

void MtgErrors::add(const MtgLine& line, std::size_t offset, Diagnostic diagnostic) {
  const std::string_view before = line.text.substr(0, offset);
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  diagnostic.file = file_;
  diagnostic.line = static_cast<int>(line.number);
  diagnostic.column = 1 + static_cast<int>(std::count_if(before.begin(), before.end(), begins_character));
  errors_.push_back(std::move(diagnostic));
  if (errors_.size() >= max_) throw InputError(errors_);
}

void MtgErrors::fail(const MtgLine& line, std::size_t offset, Diagnostic diagnostic) {
  add(line, offset, std::move(diagnostic));
  throw InputError(errors_);
}

void MtgErrors::throw_if_any() const {
  if (!errors_.empty()) throw InputError(errors_);
}

std::string shown(std::string_view text) {
  if (text.size() <= kLongestShown) return fmt::format("'{}'", text);
  return fmt::format("'{}...'", text.substr(0, kLongestShown));
}

std::optional<double> to_number(std::string_view text) { return number_of<double>(text); }

std::optional<float> to_float(std::string_view text) {
  if (const auto number = number_of<float>(text)) return number;
  // Values too small for a 32-bit float are 0 or nearly 0.
  const auto number = to_number(text);
  return number && std::abs(*number) < 1 ? std::optional(static_cast<float>(*number)) : std::nullopt;
}

}  // namespace meristem
