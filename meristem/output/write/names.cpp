// SPDX-License-Identifier: Apache-2.0
// Makes names valid and unique for text formats.
#include "meristem/output/write/names.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

namespace meristem {

namespace {

bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }

/// Returns true for the second and later bytes of a UTF-8 character.
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

std::string single_line(std::string_view text) {
  constexpr std::size_t kMaxBytes = 200;
  if (text.size() > kMaxBytes) {
    std::size_t end = kMaxBytes;
    while (end > 0 && continues_character(text[end])) --end;
    text = text.substr(0, end);
  }
  std::string line(text);
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  return line;
}

std::string single_word(std::string_view text) {
  std::string word(text);
  const auto parts_words = [](char c) { return is_control(c) || c == ' ' || c == '#' || c == '\\'; };
  std::replace_if(word.begin(), word.end(), parts_words, '_');
  return word.empty() ? "_" : word;
}

std::string file_word(std::string_view text) {
  std::string word = single_word(text);
  std::replace(word.begin(), word.end(), '/', '_');
  return word;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

std::vector<std::string> distinct_words(std::span<const std::string> names) {
  std::vector<std::string> words;
  std::set<std::string> taken;
  std::map<std::string, int> last_number;
  for (const std::string& name : names) {
    const std::string plain = single_word(name);
    std::string word = plain;
    // The next number is remembered, so that a thousand equal names do not need half a million lookups.
    while (!taken.insert(word).second) {
      int& number = last_number.try_emplace(plain, 1).first->second;
      word = fmt::format("{}_{}", plain, ++number);
    }
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace meristem
