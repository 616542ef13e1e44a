// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/base/name_table.h"

namespace meristem {

/// Constants of expressions, each found by its name in constant time.
class ConstantTable {
 public:
  ConstantTable() = default;
  /// A table of `constants`; where a name repeats, the first counts.
  explicit ConstantTable(std::vector<ExpressionNames::Constant> constants) : constants_(std::move(constants)) {
    for (const ExpressionNames::Constant& constant : constants_) names_.add(constant.name);
  }
  /// All constants, in the order given.
  const std::vector<ExpressionNames::Constant>& all() const { return constants_; }
  /// The names of the constants, with their positions in all().
  const NameTable& names() const { return names_; }

 private:
  std::vector<ExpressionNames::Constant> constants_;
  NameTable names_;
};

/// The names that many expressions share. Compiling an expression with tables takes time by the length of its text,
/// however many names there are. The lists and tables must outlive the compilation. Names must be identifiers and not
/// built in, as of Expression::compile; this is not checked again for each expression.
struct ExpressionScope {
  std::span<const std::string> variables;                ///< names of the variables, in the order of their values
  std::span<const ExpressionNames::Constant> constants;  ///< names with fixed values
  const NameTable* variable_table = nullptr;             ///< positions of `variables`; null: the list is searched
  const NameTable* constant_table = nullptr;             ///< positions of `constants`; null: the list is searched
  bool has_nearest = true;                               ///< false: faults name no similar name, which saves time
};

}  // namespace meristem
