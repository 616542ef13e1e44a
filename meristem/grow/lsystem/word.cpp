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

/// Returns true if `symbol` is, or may be a part of, a name with several characters.
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
  std::string text;
  write_word_text(word, alphabet, [&](std::string_view piece, std::size_t) { text += piece; });
  return text;
}

void write_word_text(const Word& word, const Alphabet& alphabet,
                     FunctionRef<void(std::string_view piece, std::size_t modules)> write) {
  constexpr std::size_t kPiece = 1U << 16U;
  const bool keeps_apart = has_longer_names(alphabet);
  std::string piece;
  std::size_t begin = 0;        // the first module of the piece
  bool follows_a_name = false;  // the last module has a name and no parameters that would separate it from the next
  std::size_t parameter = 0;
  for (std::size_t module = 0; module < word.letters.size(); ++module) {
    const Letter& letter = alphabet[word.letters[module]];
    const bool is_name = is_name_part(letter.symbol);
    if (keeps_apart && follows_a_name && is_name) piece += ' ';
    piece += letter.symbol;
    for (std::size_t k = 0; k < letter.arity; ++k) {
      piece += k == 0 ? '(' : ',';
      append_number(piece, word.parameters.at(parameter++));
    }
    if (letter.arity > 0) piece += ')';
    follows_a_name = is_name && letter.arity == 0;
    if (piece.size() < kPiece && module + 1 < word.letters.size()) continue;
    write(piece, module + 1 - begin);
    piece.clear();
    begin = module + 1;
  }
}

std::vector<SymbolCount> symbol_counts(const Word& word, const Alphabet& alphabet) {
  std::vector<std::uint64_t> of_letter(alphabet.size());
  for (const LetterIndex letter : word.letters) ++of_letter[letter];
  std::vector<SymbolCount> counts;
  std::unordered_map<std::string_view, std::size_t> places;
  for (std::size_t k = 0; k < of_letter.size(); ++k) {
    if (of_letter[k] == 0) continue;
    const std::string& symbol = alphabet[static_cast<LetterIndex>(k)].symbol;
    const auto [place, is_new] = places.emplace(symbol, counts.size());
    if (is_new) counts.emplace_back(symbol, 0);
    counts[place->second].second += of_letter[k];
  }
  return counts;
}

}  // namespace meristem
