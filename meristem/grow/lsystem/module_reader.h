// SPDX-License-Identifier: Apache-2.0
// Cuts a grammar's words into modules and makes letters of them. Private to the reader of grammars.
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

/// A module as it stands in the text.
struct ModuleText {
  std::string_view all;
  std::string_view symbol;
  std::vector<std::string_view> arguments;  ///< trimmed
};

class ModuleReader {
 public:
  /// Faults go to `faults`, letters to `alphabet`.
  ModuleReader(GrammarFaults& faults, Alphabet& alphabet) : faults_(faults), alphabet_(alphabet) {}
  /// Takes each symbol as it stands in the text, some of them twice; null: none.
  void note_symbols(std::vector<std::string_view>* symbols) { noted_ = symbols; }

  /// Makes `name`, a piece of the grammar's text, a symbol of its own; others are single characters.
  void declare(std::string_view name);
  bool is_declared(std::string_view name) const { return symbols_.count(name) > 0; }

  /// The next module of `rest`, which is shortened by it; nothing at its end or after adding a fault (`rest` is empty
  /// then).
  std::optional<ModuleText> next(std::string_view& rest);
  /// kNoLetter after adding a fault.
  LetterIndex letter_of(const ModuleText& module);

  /// Keeps account of the brackets that are not closed yet; false after adding a fault for one that closes none.
  bool match_bracket(const ModuleText& module, std::vector<std::string_view>& open);
  /// Adds a fault for each of the brackets.
  void report_unclosed(const std::vector<std::string_view>& open);

 private:
  std::string_view symbol_of(std::string_view text) const;

  GrammarFaults& faults_;
  Alphabet& alphabet_;
  std::vector<std::string_view>* noted_ = nullptr;
  std::unordered_set<std::string_view> symbols_;  ///< the declared ones
  std::vector<std::size_t> symbol_sizes_;         ///< of these, largest first
};

}  // namespace meristem
