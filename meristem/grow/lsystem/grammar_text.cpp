// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/grammar_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/utf8.h"

namespace meristem {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

unsigned char byte_at(std::string_view text, std::size_t offset) { return static_cast<unsigned char>(text[offset]); }

bool goes_on(unsigned char byte) { return (byte & 0xC0U) == 0x80U; }

}  // namespace

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t character_bytes(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && goes_on(byte_at(text, length))) ++length;
  return length;
}

GrammarText::GrammarText(std::string_view text, std::string file, const SizeLimits& limits) : file_(std::move(file)) {
  const bool has_mark = text.starts_with(kByteOrderMark);
  line_starts_.push_back(has_mark ? kByteOrderMark.size() : 0);
  if (text.size() > limits.document_bytes) {
    throw InputError(error(0, fmt::format("the grammar has {} bytes", text.size()),
                           fmt::format("at most {} (limit document_bytes)", limits.document_bytes)));
  }
  text_ = text;
  for (std::size_t k = 0; k < text_.size(); ++k) {
    if (text_[k] == '\n') line_starts_.push_back(k + 1);
  }
  if (const std::size_t invalid = find_invalid_utf8(text_); invalid < text_.size()) {
    throw InputError(
        error(invalid, fmt::format("byte 0x{:02x} is not UTF-8 text", byte_at(text_, invalid)), "text in UTF-8"));
  }
  if (has_mark) blank(0, kByteOrderMark.size());
  remove_comments();
}

void GrammarText::blank(std::size_t begin, std::size_t end) {
  std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.begin() + static_cast<std::ptrdiff_t>(end), ' ');
}

void GrammarText::remove_comments() {
  const std::string_view text = text_;
  bool is_line_empty = true;  // true until a character that is not blank
  for (std::size_t k = 0; k < text.size(); ++k) {
    const std::string_view rest = text.substr(k);
    const bool follows_blank = k == 0 || is_blank(text[k - 1]);
    const auto is_blank_or_end = [&](std::size_t at) { return at >= rest.size() || is_blank(rest[at]); };
    if (rest.front() == '\n') {
      is_line_empty = true;
    } else if (rest.starts_with("/*")) {
      const std::size_t end = text.find("*/", k + 2);
      if (end == std::string_view::npos) throw InputError(error(k, "the comment '/*' is not closed", "'*/'"));
      blank(k, end + 2);
      k = end + 1;
    } else if ((is_line_empty && rest.front() == ';') ||
               (rest.starts_with("//") && (is_line_empty || (follows_blank && is_blank_or_end(2))))) {
      const std::size_t end = std::min(text.find('\n', k), text.size());
      blank(k, end);
      k = end - 1;
    } else if (rest.front() == '\\' && follows_blank && (rest.starts_with("\\\n") || rest.starts_with("\\\r\n"))) {
      const std::size_t end = text.find('\n', k) + 1;
      blank(k, end);
      k = end - 1;
    } else if (!is_blank(rest.front())) {
      is_line_empty = false;
    }
  }
}

std::vector<std::string_view> GrammarText::lines() const {
  std::vector<std::string_view> lines;
  const std::string_view text = text_;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    if (!line.empty()) lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

std::size_t GrammarText::offset(std::string_view piece) const {
  return static_cast<std::size_t>(piece.data() - text_.data());
}

int GrammarText::line(std::string_view piece) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset(piece));
  return static_cast<int>(std::max<std::ptrdiff_t>(1, after - line_starts_.begin()));
}

Diagnostic GrammarText::error(std::size_t offset, std::string message, std::string expected,
                              std::string nearest) const {
  Diagnostic result;
  result.message = std::move(message);
  result.expected = std::move(expected);
  result.nearest = std::move(nearest);
  result.file = file_;
  result.text_offset = static_cast<int>(offset);
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  result.line = static_cast<int>(std::max<std::ptrdiff_t>(1, after - line_starts_.begin()));
  result.column = 1;
  for (std::size_t k = line_starts_[static_cast<std::size_t>(result.line - 1)]; k < offset && k < text_.size(); ++k) {
    if (!goes_on(byte_at(text_, k))) ++result.column;
  }
  return result;
}

void GrammarErrors::add(std::string_view at, std::string message, std::string expected, std::string nearest) {
  if (is_full()) return;
  const std::size_t offset = text_.offset(at);
  errors_.push_back({offset, text_.error(offset, std::move(message), std::move(expected), std::move(nearest))});
}

void GrammarErrors::warn(std::string_view at, std::string message, std::string expected) {
  if (at.data() == nullptr || warnings_.size() >= max_) return;
  const std::size_t offset = text_.offset(at);
  Diagnostic warning = text_.error(offset, std::move(message), std::move(expected));
  warning.severity = Severity::warning;
  warnings_.push_back({offset, std::move(warning)});
}

void GrammarErrors::add_all(std::string_view at, const std::vector<Diagnostic>& others) {
  for (const Diagnostic& other : others) {
    if (!is_full()) errors_.push_back({text_.offset(at), other});
  }
}

std::vector<Diagnostic> GrammarErrors::sorted(std::vector<Placed> placed) {
  std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.offset < b.offset; });
  std::vector<Diagnostic> result;
  result.reserve(placed.size());
  for (Placed& one : placed) result.push_back(std::move(one.diagnostic));
  return result;
}

}  // namespace meristem
