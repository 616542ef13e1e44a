// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/function_ref.h"

namespace meristem {

/// Index into an Alphabet.
using LetterIndex = std::uint16_t;
inline constexpr LetterIndex kNoLetter = std::numeric_limits<LetterIndex>::max();

/// A symbol with a number of parameters. F, F(l) and F(l, w) are three letters: the number is part of a match.
struct Letter {
  std::string symbol;
  std::uint16_t arity = 0;

  bool operator==(const Letter&) const = default;
};

/// The letters of a grammar: [ ] and % first, then in the order in which its text first has them.
class Alphabet {
 public:
  /// The letter's index; it is added if it is new. Throws std::length_error beyond 65,534 letters.
  LetterIndex add(std::string_view symbol, std::uint16_t arity);
  /// kNoLetter where there is none.
  LetterIndex find(std::string_view symbol, std::uint16_t arity) const;

  std::size_t size() const { return letters_.size(); }
  const Letter& operator[](LetterIndex letter) const { return letters_[letter]; }

 private:
  std::vector<Letter> letters_;
  std::unordered_map<std::string, LetterIndex> index_;  ///< by symbol, a zero byte, and the arity in decimals
};

/// Leaves new items of a vector as the memory is, where standard ones would set them to zero: long words are written by
/// many threads, and each is to be the first to touch its part.
template <typename Item>
struct UnsetAllocator : std::allocator<Item> {
  template <typename Other>
  struct rebind {
    using other = UnsetAllocator<Other>;
  };
  template <typename Other>
  void construct(Other* item) noexcept {
    ::new (static_cast<void*>(item)) Other;
  }
  template <typename Other, typename... Arguments>
  void construct(Other* item, Arguments&&... arguments) {
    ::new (static_cast<void*>(item)) Other(std::forward<Arguments>(arguments)...);
  }
};

/// A column of a word; after `resize` new items have any value.
template <typename Item>
using WordColumn = std::vector<Item, UnsetAllocator<Item>>;

/// A bracketed string of modules: their letters, and all their parameters one after another. A module's parameters
/// follow those of the module before it, as many as its letter has.
struct Word {
  WordColumn<LetterIndex> letters;
  WordColumn<double> parameters;
  /// The step in which each module has come about, 0 for those of an axiom; of timed grammars the time. Empty where
  /// nobody has asked for it.
  WordColumn<double> births;
  double time = 0;  ///< steps, or time, at which the word stands

  std::size_t module_count() const { return letters.size(); }
  bool operator==(const Word&) const = default;
};

/// "A(1,2)[+B]": numbers with the fewest digits that read back as the same. Where the alphabet has names of several
/// characters, blanks keep neighbours apart that would read as one.
std::string word_text(const Word& word, const Alphabet& alphabet);

/// Hands out the same text piece by piece, each the text of the next `modules` modules, so that a long word's text need
/// not be in memory as a whole: pieces have some 64 kB. None for a word without modules.
void write_word_text(const Word& word, const Alphabet& alphabet,
                     FunctionRef<void(std::string_view piece, std::size_t modules)> write);

/// A symbol and how many modules have it.
using SymbolCount = std::pair<std::string, std::uint64_t>;

/// Counts a word's modules by symbol, with any number of parameters together. Symbols that it has not are left out; the
/// others are in the order of the alphabet.
std::vector<SymbolCount> symbol_counts(const Word& word, const Alphabet& alphabet);

}  // namespace meristem
