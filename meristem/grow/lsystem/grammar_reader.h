// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/expression.h"
#include "meristem/base/limits.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

struct GrammarOptions {
  std::string file;                                     ///< its name in messages
  std::vector<ExpressionNames::Constant> constants;     ///< names that its expressions may use; `#define` hides them
  std::function<std::string(const std::string&)> read;  ///< the text of an included grammar; unset: none can be
  std::vector<Diagnostic>* warnings = nullptr;          ///< takes what is odd but not wrong; may be null
  Limits limits;                                        ///< of faults, of the text's and an expression's bytes
};

/// Reads a grammar's text. Throws one InputError with all faults (up to the limit), each with line, column, the
/// offending text and what was expected.
Grammar read_grammar(std::string_view text, const GrammarOptions& options = {});

}  // namespace meristem
