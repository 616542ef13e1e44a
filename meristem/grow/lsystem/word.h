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
inline constexpr LetterIndex kNoLetter = std::numeric_limits<LetterIndex>::max();  ///< marks a missing letter

/// A symbol with a number of parameters. F, F(l) and F(l, w) are three letters, because matching includes the number.
struct Letter {
  std::string symbol;       ///< as in the grammar
  std::uint16_t arity = 0;  ///< number of parameters

  bool operator==(const Letter&) const = default;
};

/// The letters of a grammar: first [ ] and %, then the others in the order of their first occurrence in the text.
class Alphabet {
 public:
  /// Returns the letter's index, and adds the letter if it is new. Throws std::length_error beyond 65,534 letters.
  LetterIndex add(std::string_view symbol, std::uint16_t arity);
  /// Returns kNoLetter if the letter does not exist.
  LetterIndex find(std::string_view symbol, std::uint16_t arity) const;

  std::size_t size() const { return letters_.size(); }  ///< number of letters
  /// Returns the letter with this index, which must exist.
  const Letter& operator[](LetterIndex letter) const { return letters_[letter]; }

 private:
  std::vector<Letter> letters_;
  std::unordered_map<std::string, LetterIndex> index_;  ///< key: symbol, a zero byte, and the arity in decimals
};

/// Leaves new items of a vector uninitialised. Long words are written by many threads, and each thread should touch its
/// own part first.
template <typename Item>
struct UnsetAllocator : std::allocator<Item> {
  /// The allocator for another type, which containers ask for.
  template <typename Other>
  struct rebind {
    using other = UnsetAllocator<Other>;  ///< the allocator of that type
  };
  /// Makes an item: without arguments its bytes stay undefined.
  template <typename Other>
  void construct(Other* item) noexcept {
    ::new (static_cast<void*>(item)) Other;
  }
  template <typename Other, typename... Arguments>
  void construct(Other* item, Arguments&&... arguments) {
    ::new (static_cast<void*>(item)) Other(std::forward<Arguments>(arguments)...);
  }
};

/// A column of a word. After `resize`, new items have undefined values.
template <typename Item>
using WordColumn = std::vector<Item, UnsetAllocator<Item>>;

/// A bracketed string of modules: their letters, and all their parameters in sequence. Each module has as many
/// parameters as its letter.
struct Word {
  WordColumn<LetterIndex> letters;  ///< one per module
  WordColumn<double> parameters;    ///< of all modules, in sequence
  /// The step in which each module was created, 0 for those of an axiom; in timed grammars the time. Empty unless
  /// births were requested.
  WordColumn<double> births;
  double time = 0;  ///< number of steps, or the time, of the word

  std::size_t module_count() const { return letters.size(); }  ///< number of modules
  bool operator==(const Word&) const = default;
};

/// Returns the word as text, such as "A(1,2)[+B]". Numbers have the fewest digits that restore the exact value. If the
/// alphabet has names with several characters, blanks separate neighbours that would read as one name.
std::string word_text(const Word& word, const Alphabet& alphabet);

/// Passes the text of word_text() to `write` piece by piece, each with about 64 kB and its number of modules, so that a
/// long text need not be in memory. No call for a word without modules.
void write_word_text(const Word& word, const Alphabet& alphabet,
                     FunctionRef<void(std::string_view piece, std::size_t modules)> write);

/// A symbol and the number of modules with this symbol.
using SymbolCount = std::pair<std::string, std::uint64_t>;

/// Counts the modules of a word by symbol, for all numbers of parameters together. Returns only symbols that occur, in
/// the order of the alphabet.
std::vector<SymbolCount> symbol_counts(const Word& word, const Alphabet& alphabet);

}  // namespace meristem
