// SPDX-License-Identifier: Apache-2.0
// The table of functions and constants that every expression knows. Private to the expression language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "meristem/base/expression/expression_bytecode.h"

namespace meristem {

struct ExpressionFunction {
  std::string name;
  std::string signature;  ///< as messages and the manual show it
  std::uint8_t arities;   ///< bit k is set where k arguments are allowed
  bool takes_more;        ///< any number above the largest of these too, taken two by two from the left
  ExpressionOp op;        ///< with the fewest arguments

  bool takes(std::size_t arguments) const;
  std::size_t largest_arity() const;
  ExpressionOp op_for(std::size_t arguments) const;
};

struct ExpressionConstant {
  std::string name;
  double value;
};

std::span<const ExpressionFunction> expression_functions();
std::span<const ExpressionConstant> expression_constants();
/// Null where there is none of that name.
const ExpressionFunction* find_expression_function(std::string_view name);
const ExpressionConstant* find_expression_constant(std::string_view name);

}  // namespace meristem
