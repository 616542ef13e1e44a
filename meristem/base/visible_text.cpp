// SPDX-License-Identifier: Apache-2.0
// Replaces characters that a terminal or page would interpret by escapes. The text is read character by character, and
// bytes that are not valid UTF-8 are escaped one by one.
#include "meristem/base/visible_text.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "meristem/base/utf8.h"

namespace meristem {

namespace {

/// Returns the code point of a character of valid UTF-8.
std::uint32_t code_point(std::string_view character) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(character[k])); };
  std::uint32_t code = character.size() == 1 ? byte(0) : byte(0) & (0x7FU >> character.size());
  for (std::size_t k = 1; k < character.size(); ++k) code = code << 6U | (byte(k) & 0x3FU);
  return code;
}

bool is_acted_on(std::uint32_t code) {
  const auto is_in = [code](std::uint32_t first, std::uint32_t last) { return first <= code && code <= last; };
  return code < 0x20 || is_in(0x7F, 0x9F) || code == 0x61C || is_in(0x200E, 0x200F) || is_in(0x2028, 0x202E) ||
         is_in(0x2066, 0x2069);
}

bool is_plain(char c) { return c >= 0x20 && c < 0x7F; }

}  // namespace

std::string visible_text(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t bytes = utf8_character_bytes(text);
    if (bytes == 0) {
      fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(text[0]));
      text.remove_prefix(1);
      continue;
    }
    const std::string_view character = text.substr(0, bytes);
    if (const std::uint32_t code = code_point(character); is_acted_on(code)) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", code);
    } else {
      out += character;
    }
    text.remove_prefix(bytes);
  }
  return out;
}

std::string visible_lines(std::string_view text) {
  std::string out;
  for (;;) {
    const std::size_t end = text.find('\n');
    out += visible_text(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    out += '\n';
    text.remove_prefix(end + 1);
  }
}

Diagnostic visible(Diagnostic diagnostic) {
  for (std::string* text : {&diagnostic.message, &diagnostic.expected, &diagnostic.nearest}) {
    *text = visible_text(*text);
  }
  return diagnostic;
}

}  // namespace meristem
