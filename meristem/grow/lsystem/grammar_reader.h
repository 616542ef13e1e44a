// SPDX-License-Identifier: Apache-2.0
// The text format of grammars.
//
//   #define r = 0.6            a constant for all later expressions; "=" is optional
//   #symbols Leaf Bud          symbols with several characters; all others have one. The longest name matches
//   #axiom                     a word, here or on the next lines; "ω :" may precede it
//   #rules                     one rule per line:
//       [id :] [left <] predecessor [> right] [: condition] [: weight] -> successor
//       [id :] predecessor @ life [: condition] -> successor
//                              in continuous time: the module is replaced at this age
//   #decompose  #interpret     rules, one per line
//   #ignore +-                 symbols that contexts ignore; "#ignore:" is also accepted
//   #steps 5   #angle 22.5     constant expressions
//   #time 7.5                  the time of the word, for a grammar with lives
//   #include fir.txt as T for 6 steps
//                              T is drawn as the word of that grammar after this number of steps. Default: its #steps.
//                              The path is relative to the folder of the grammar that includes it
//   #include "meristem/whorl"  the symbols and rules of a part of the kit (grammar_parts.h)
//
// Directives are at the beginning of a line. Before the first of #axiom and #rules, lines belong to the axiom. There
// and after #axiom, a line with an arrow begins the rules. Arrows are -> and →, and --> after a symbol. Blanks between
// modules have no meaning. Comments are /* ... */, lines that begin with // or with ;, and // between blanks (S/////F
// turns five times). A \ after a blank at a line's end joins the next line.
//
// A symbol is any printable character except ( ) < > : and →. An id has two characters or more. A single section after
// the predecessor is a weight if it contains no comparison and no logic operator. * is always true, also as a context.
// In conditions, = & | mean == && ||, as in the book. An empty successor or ε deletes the module. An identity rule is
// removed if it is the only rule of its letter.
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
  std::string text;        ///< the symbol or name

  bool operator==(const GrammarWord&) const = default;
};

/// The words of a grammar that refer to symbols and names, in order.
struct GrammarWords {
  std::vector<GrammarWord> symbols;  ///< all occurrences, also after #symbols and in contexts
  /// Names in expressions, except parameters of the rule, and names defined by `#define`.
  std::vector<GrammarWord> names;
};

/// Inputs of a grammar's text, and results that the reader collects.
struct GrammarOptions {
  std::string file;  ///< name of the grammar in messages
  /// Constants for expressions of the grammar and of included grammars. A `#define` of such a name is only a default
  /// and is ignored.
  std::vector<ExpressionNames::Constant> constants;
  /// Values that replace the `#define`s of these names. A name without a `#define` is an error. Included grammars are
  /// not affected.
  std::vector<ExpressionNames::Constant> overrides;
  /// Returns the text of an included grammar; unset: inclusions are errors.
  std::function<std::string(const std::string&)> read;
  std::vector<Diagnostic>* warnings = nullptr;  ///< receives warnings; may be null
  GrammarWords* words = nullptr;                ///< receives the words of the text; may be null
  SizeLimits limits;                            ///< limits of errors, of the text's bytes and of an expression's bytes
};

/// Reads a grammar's text. Throws one InputError with all errors (up to the limit), each with line, column, the
/// offending text and the expected form.
Grammar read_grammar(std::string_view text, const GrammarOptions& options = {});

/// Returns a function for GrammarOptions::read that reads files relative to the folder of `file`, which contains the
/// grammar. Appends the paths of files that it reads to `paths`, which may be null.
std::function<std::string(const std::string&)> read_beside(const std::string& file,
                                                           std::vector<std::string>* paths = nullptr);

}  // namespace meristem
