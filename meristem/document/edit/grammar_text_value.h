// SPDX-License-Identifier: Apache-2.0
// A grammar that stands in a document, as one text or as a list of lines, and words of it that get other names.
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

  /// Whether the symbol stands in it.
  bool has_symbol(const std::string& symbol) const;
  /// Whether it stands in it behind a ~.
  bool places(const std::string& symbol) const;

  /// Gives a symbol another name, also where it is declared; a name of several characters is declared. Throws an
  /// InputError with `path` where the grammar would then say something else.
  Patch with_symbol(const std::string& symbol, const std::string& name, const std::string& path) const;
  /// Gives a constant another name, in the same way.
  Patch with_name(const std::string& constant, const std::string& name, const std::string& path) const;

 private:
  struct Line {
    std::size_t begin = 0;            // in the grammar's text
    std::vector<std::size_t> places;  // of its bytes in the document
  };

  Patch in_document(const Patch& patch) const;
  void declare(const std::string& symbol, const std::string& name, Patch& patch) const;

  const LocatedTree& tree_;
  LocatedValue value_;
  std::string text_;
  std::vector<Line> lines_;
  GrammarWords words_;
};

}  // namespace meristem
