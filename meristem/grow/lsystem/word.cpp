// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/word.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace meristem {

namespace {

std::string key_of(std::string_view symbol, std::uint16_t arity) {
  std::string key(symbol);
  key += '\0';
  key += std::to_string(arity);
  return key;
}

void append_number(std::string& text, double number) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

/// Whether `symbol` is, or may be a part of, a name of several characters.
bool is_name_part(std::string_view symbol) {
  const char c = symbol.back();
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool has_longer_names(const Alphabet& alphabet) {
  for (std::size_t k = 0; k < alphabet.size(); ++k) {
    const std::string& symbol = alphabet[static_cast<LetterIndex>(k)].symbol;
    if (symbol.size() > 1 && is_name_part(symbol)) return true;
  }
  return false;
}

}  // namespace

LetterIndex Alphabet::add(std::string_view symbol, std::uint16_t arity) {
  if (const LetterIndex found = find(symbol, arity); found != kNoLetter) return found;
  if (letters_.size() >= kNoLetter - 1U) throw std::length_error("an alphabet holds at most 65534 letters");
  const auto letter = static_cast<LetterIndex>(letters_.size());
  letters_.push_back({std::string(symbol), arity});
  index_.emplace(key_of(symbol, arity), letter);
  return letter;
}

LetterIndex Alphabet::find(std::string_view symbol, std::uint16_t arity) const {
  const auto found = index_.find(key_of(symbol, arity));
  return found == index_.end() ? kNoLetter : found->second;
}

std::string word_text(const Word& word, const Alphabet& alphabet) {
  const bool keeps_apart = has_longer_names(alphabet);
  std::string text;
  std::size_t parameter = 0;
  for (const LetterIndex index : word.letters) {
    const Letter& letter = alphabet[index];
    if (keeps_apart && !text.empty() && is_name_part(text) && is_name_part(letter.symbol)) text += ' ';
    text += letter.symbol;
    for (std::size_t k = 0; k < letter.arity; ++k) {
      text += k == 0 ? '(' : ',';
      append_number(text, word.parameters.at(parameter++));
    }
    if (letter.arity > 0) text += ')';
  }
  return text;
}

}  // namespace meristem
