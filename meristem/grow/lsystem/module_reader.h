// SPDX-License-Identifier: Apache-2.0
// Splits the words of a grammar into modules and their letters. Private to the reader of grammars.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/grammar_text.h"

namespace meristem {

inline constexpr std::string_view kArrow = "\u2192";

/// A module as written in the text.
struct ModuleText {
  std::string_view all;
  std::string_view symbol;
  std::vector<std::string_view> arguments;  ///< trimmed
};

class ModuleReader {
 public:
  /// Adds errors to `errors` and letters to `alphabet`.
  ModuleReader(GrammarErrors& errors, Alphabet& alphabet) : errors_(errors), alphabet_(alphabet) {}
  /// Appends each symbol of the text to `symbols`, some of them twice. Null disables this.
  void note_symbols(std::vector<std::string_view>* symbols) { noted_ = symbols; }

  /// Declares `name`, a piece of the grammar's text, as one symbol. All other symbols are single characters.
  void declare(std::string_view name);
  bool is_declared(std::string_view name) const { return symbols_.count(name) > 0; }

  /// Removes the next module from `rest` and returns it. Returns nothing at the end. After an error, adds the error,
  /// clears `rest` and returns nothing.
  std::optional<ModuleText> next(std::string_view& rest);
  /// Returns the letter of a module. Returns kNoLetter after adding an error.
  LetterIndex letter_of(const ModuleText& module);

  /// Updates the list of open brackets. Adds an error and returns false for a closing bracket without an opening one.
  bool match_bracket(const ModuleText& module, std::vector<std::string_view>& open);
  /// Adds an error for each open bracket.
  void report_unclosed(const std::vector<std::string_view>& open);

 private:
  std::string_view symbol_of(std::string_view text) const;

  GrammarErrors& errors_;
  Alphabet& alphabet_;
  std::vector<std::string_view>* noted_ = nullptr;
  std::unordered_set<std::string_view> symbols_;  ///< the declared symbols
  std::vector<std::size_t> symbol_sizes_;         ///< sizes of the declared symbols, largest first
};

}  // namespace meristem
