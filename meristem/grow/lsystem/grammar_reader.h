// SPDX-License-Identifier: Apache-2.0
// The text form of grammars.
//
//   #define r = 0.6            a constant, for all expressions behind it; "=" may be left out
//   #symbols Leaf Bud          symbols of several characters; all others have one. The longest name counts
//   #axiom                     a word, here or on the next lines; "ω :" may stand before it
//   #rules                     one per line:
//       [id :] [left <] predecessor [> right] [: condition] [: weight] -> successor
//       [id :] predecessor @ life [: condition] -> successor
//                              in continuous time: the module is replaced at this age
//   #decompose  #interpret     rules, one per line
//   #ignore +-                 symbols that contexts do not see; after "#ignore:" too
//   #steps 5   #angle 22.5     a constant expression each
//   #time 7.5                  the time at which a grammar with lives stands
//   #include fir.txt as T for 6 steps
//                              T is drawn as the word of that grammar after this number of steps; without them as its
//                              #steps; sought from the folder of the grammar that includes it
//
// Directives stand at the beginning of a line. Before the first of #axiom and #rules lines are the axiom, and a line
// with an arrow begins the rules, there and behind #axiom. Arrows are -> and →, and --> behind a symbol. Blanks
// between modules mean nothing. Comments are /* ... */, lines that begin with // or with ;, and // between blanks
// (S/////F turns five times). A \ after a blank at a line's end joins the next line to it.
//
// A symbol is any printable character but ( ) < > : and →. An id has two characters or more. A single section behind
// the predecessor is a weight if it has no comparison and no logic operator; * is always true, as a context too. In
// conditions = & | mean == && ||, as in the book. A successor that is empty or ε deletes. An identity rule that is the
// only one of its letter is dropped.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/expression/expression.h"
#include "meristem/base/limits.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

/// A word of a grammar's text.
struct GrammarWord {
  std::size_t offset = 0;  ///< bytes
  std::string text;

  bool operator==(const GrammarWord&) const = default;
};

/// The words of a grammar that call other things, in their order.
struct GrammarWords {
  std::vector<GrammarWord> symbols;  ///< wherever one stands, also behind #symbols and in contexts
  std::vector<GrammarWord> names;    ///< in expressions, but for parameters of the rule; and those that #define gives
};

struct GrammarOptions {
  std::string file;  ///< the grammar's name in messages
  /// Names that its expressions may use, and those of included grammars; a `#define` of one is a default that gives
  /// way.
  std::vector<ExpressionNames::Constant> constants;
  /// Values in the place of those that the `#define`s of these names have; it is a fault if there is none. Included
  /// grammars keep theirs.
  std::vector<ExpressionNames::Constant> overrides;
  std::function<std::string(const std::string&)> read;  ///< the text of an included grammar; unset: none can be
  std::vector<Diagnostic>* warnings = nullptr;          ///< takes what is odd but not wrong; may be null
  GrammarWords* words = nullptr;                        ///< takes the words of the text; may be null
  Limits limits;  ///< limits of faults, of the text's bytes and of an expression's bytes
};

/// Reads a grammar's text. Throws one InputError with all faults (up to the limit), each with line, column, the
/// offending text and what was expected.
Grammar read_grammar(std::string_view text, const GrammarOptions& options = {});

/// For GrammarOptions::read: reads files, sought from the folder of `file`, which holds the grammar. `paths` takes
/// those that are read; it may be null.
std::function<std::string(const std::string&)> read_beside(const std::string& file,
                                                           std::vector<std::string>* paths = nullptr);

}  // namespace meristem
