// SPDX-License-Identifier: Apache-2.0
// Reads axioms and single rules of a grammar's text. Private to the reader of grammars.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/grammar_text.h"
#include "meristem/grow/lsystem/module_reader.h"

namespace meristem {

inline constexpr std::string_view kEmptyWord = "\u03B5";

/// Position and size of the arrow in a line.
struct Arrow {
  std::size_t begin;
  std::size_t size;
};

/// Finds the first arrow of a line.
std::optional<Arrow> find_arrow(std::string_view line);

/// Named constants for the grammar's expressions.
class GrammarConstants {
 public:
  explicit GrammarConstants(std::vector<ExpressionNames::Constant> constants);
  /// Sets a constant. A later value hides an earlier one.
  void set(const std::string& name, double value);
  bool has(const std::string& name) const { return index_.count(name) > 0; }
  const std::vector<ExpressionNames::Constant>& all() const { return constants_; }
  /// Returns the constants that `text` uses. The cost of compiling therefore does not depend on the number of
  /// constants.
  std::vector<ExpressionNames::Constant> used_in(std::string_view text) const;

 private:
  std::vector<ExpressionNames::Constant> constants_;
  std::unordered_map<std::string, std::size_t> index_;
};

class RuleReader {
 public:
  RuleReader(const GrammarText& text, GrammarErrors& errors, const SizeLimits& limits, ModuleReader& modules,
             std::vector<ExpressionNames::Constant> constants);

  GrammarConstants& constants() { return constants_; }

  /// Appends each name in an expression that is no parameter of its rule to `names`, some of them twice. Null disables
  /// this.
  void note_names(std::vector<std::string_view>* names) { noted_ = names; }

  /// The features that rules of a section may use.
  enum class Kind {
    production,      ///< lives
    decomposition,   ///< no additional features
    interpretation,  ///< the name `age` for the age of the drawn module
  };

  /// Returns the rule. Returns nothing after adding errors, and for rules that rewrite a bracket to itself.
  std::optional<GrammarRule> read_rule(std::string_view line, Kind kind);
  /// Appends the axiom's modules. `open` lists the brackets that are not closed yet.
  void read_axiom(std::string_view text, std::vector<std::string_view>& open, std::vector<ModuleTemplate>& axiom);
  /// Returns the finite value of a constant expression, or nothing after adding errors.
  std::optional<double> read_constant(std::string_view text);

 private:
  struct Parts;

  bool split_rule(std::string_view line, Parts& parts);
  bool split_left_side(std::string_view left_side, Parts& parts);
  bool split_conditions(std::string_view text, Parts& parts);
  bool split_contexts(std::string_view text, Parts& parts);

  bool read_predecessor(const Parts& parts, GrammarRule& rule);
  bool read_context(std::string_view text, bool may_branch, std::vector<ContextModule>& context);
  bool name_parameters(const ModuleText& module);
  bool read_conditions(const Parts& parts, GrammarRule& rule);
  bool read_life(const Parts& parts, Kind kind, GrammarRule& rule);
  static void note_age(GrammarRule& rule);
  bool read_modules(std::string_view text, std::vector<std::string_view>& open, std::vector<ModuleTemplate>& modules);
  std::optional<Expression> read_expression(std::string_view text, bool is_condition = false);
  void begin_rule();
  void note_names_of(std::string_view expression);

  const GrammarText& text_;
  GrammarErrors& errors_;
  const SizeLimits& limits_;
  ModuleReader& modules_;
  GrammarConstants constants_;
  std::vector<std::string_view>* noted_ = nullptr;

  std::vector<std::string> variables_;                       ///< variables of the rule
  std::unordered_map<std::string, Expression> expressions_;  ///< expressions of the rule, by their text
};

}  // namespace meristem
