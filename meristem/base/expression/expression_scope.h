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
  /// Builds a table of `constants`. If a name repeats, the first one counts.
  explicit ConstantTable(std::vector<ExpressionNames::Constant> constants) : constants_(std::move(constants)) {
    for (const ExpressionNames::Constant& constant : constants_) names_.add(constant.name);
  }
  /// All constants, in the order given.
  const std::vector<ExpressionNames::Constant>& all() const { return constants_; }
  /// Returns the names of the constants, with their positions in all().
  const NameTable& names() const { return names_; }

 private:
  std::vector<ExpressionNames::Constant> constants_;
  NameTable names_;
};

/// The names that many expressions share. With tables, the time to compile an expression depends on the length of its
/// text and not on the number of names. The lists and tables must outlive the compilation. Names must be identifiers
/// and must not be built in, as for Expression::compile. This is not checked again for each expression.
struct ExpressionScope {
  std::span<const std::string> variables;                ///< names of the variables, in the order of their values
  std::span<const ExpressionNames::Constant> constants;  ///< names with fixed values
  const NameTable* variable_table = nullptr;             ///< positions of `variables`; null: the list is searched
  const NameTable* constant_table = nullptr;             ///< positions of `constants`; null: the list is searched
  bool has_nearest = true;                               ///< if false, errors name no similar name, which saves time
};

}  // namespace meristem
