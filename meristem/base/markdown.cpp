// SPDX-License-Identifier: Apache-2.0
// Escapes text for Markdown. A mark gets a backslash only where it would have a meaning, so that ordinary text stays
// readable.
//
// Based on: the CommonMark specification 0.30, section 2.4 (backslash escapes), and GitHub Flavored Markdown 0.29,
// section 6.9 (autolinks).
#include "meristem/base/markdown.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/utf8.h"

namespace meristem {

namespace {

constexpr std::string_view kMarks = "\\`*[]|~$";  // marks with a meaning anywhere in a line
constexpr std::string_view kFirstMarks = "#+-=";  // marks with a meaning at the beginning of a line

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Returns true for ASCII letters and digits and for all other letters of UTF-8.
bool is_word(char letter) {
  const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
  return is_letter || is_digit(letter) || static_cast<unsigned char>(letter) >= 0x80;
}

/// Returns true for C1 control characters and for direction marks.
bool is_invisible(std::uint32_t letter) {
  return (letter >= 0x7F && letter <= 0x9F) || letter == 0x61C || letter == 0x200E || letter == 0x200F ||
         (letter >= 0x2028 && letter <= 0x202E) || (letter >= 0x2066 && letter <= 0x2069) || letter == 0xFEFF;
}

/// Returns the UTF-8 letter that begins at `at`, and its number of bytes. A byte that begins no letter is returned as a
/// letter of one byte.
std::pair<std::uint32_t, std::size_t> letter_at(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t bytes = utf8_character_bytes(text.substr(at));
  if (bytes < 2) return {first, 1};
  std::uint32_t letter = first & (0x7FU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) letter = letter << 6U | (static_cast<unsigned char>(text[at + k]) & 0x3FU);
  return {letter, bytes};
}

/// Returns true if the letter at `at` has a meaning because of its neighbours.
bool has_meaning(std::string_view text, std::size_t at) {
  const char before = at > 0 ? text[at - 1] : ' ';
  const char after = at + 1 < text.size() ? text[at + 1] : ' ';
  switch (text[at]) {
    case '_':  // emphasis only at the border of a word
      return !is_word(before) || !is_word(after);
    case ':':  // http://
      return after == '/';
    case '@':
      return true;
    case '.':  // www.oak.org, and "1. " at the beginning of a line
      return (at >= 3 && text.substr(at - 3, 3) == "www") ||
             (at > 0 && after == ' ' && text.find_first_not_of("0123456789") == at);
    case ')':  // "1) " at the beginning of a line
      return at > 0 && after == ' ' && text.find_first_not_of("0123456789") == at;
    default:
      return at == 0 && kFirstMarks.find(text[at]) != std::string_view::npos;
  }
}

}  // namespace

std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (const char letter : text) {
    if (letter == '|') cell += '\\';
    cell += letter;
  }
  return cell;
}

std::string markdown_text(std::string_view text) {
  // Four spaces at the beginning of a line would make a block of code.
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    const auto [code, bytes] = letter_at(text, at);
    if (letter == '\n' || letter == '\r' || letter == '\t') {
      out += ' ';
    } else if (code < 0x20 || is_invisible(code)) {
      out += fmt::format("\\\\u{:04X}", code);
    } else if (letter == '<') {
      out += "&lt;";
    } else if (letter == '>') {
      out += "&gt;";
    } else if (letter == '&') {
      out += "&amp;";
    } else {
      if (kMarks.find(letter) != std::string_view::npos || has_meaning(text, at)) out += '\\';
      out += text.substr(at, bytes);
    }
    at += bytes;
  }
  return out;
}

}  // namespace meristem
