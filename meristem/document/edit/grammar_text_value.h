// SPDX-License-Identifier: Apache-2.0
// A grammar in a document, as one text or as a list of lines, and patches that rename its symbols and constants.
#pragma once

#include <string>
#include <vector>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"
#include "meristem/grow/lsystem/grammar_reader.h"

namespace meristem {

class GrammarInDocument {
 public:
  /// `value` is a text or a list of texts.
  GrammarInDocument(const LocatedTree& tree, LocatedValue value);

  /// Returns true if the grammar contains the symbol.
  bool has_symbol(const std::string& symbol) const;
  /// Returns true if the grammar contains the symbol after a ~, which places a component.
  bool places(const std::string& symbol) const;

  /// Returns a patch that renames a symbol, including its declaration. A new name of several characters is declared.
  /// Throws an InputError with `path` if the grammar would then have another meaning.
  TextPatch with_symbol(const std::string& symbol, const std::string& name, const std::string& path) const;
  /// Returns a patch that renames a constant, with the same checks.
  TextPatch with_name(const std::string& constant, const std::string& name, const std::string& path) const;

 private:
  struct Line {
    std::size_t begin = 0;            // in the grammar's text
    std::vector<std::size_t> places;  // position of each of its bytes in the document
  };

  TextPatch in_document(const TextPatch& patch) const;
  void declare(const std::string& symbol, const std::string& name, TextPatch& patch) const;

  const LocatedTree& tree_;
  LocatedValue value_;
  std::string text_;
  std::vector<Line> lines_;
  GrammarWords words_;
};

}  // namespace meristem
