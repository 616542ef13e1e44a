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
  std::string signature;  ///< as in messages and in the manual
  std::uint8_t arities;   ///< bit k is set if k arguments are allowed
  bool takes_more;        ///< also accepts more than the largest of these numbers, combined two by two from the left
  ExpressionOp op;        ///< operation for the smallest number of arguments

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
/// Return null if there is no function or constant with that name.
const ExpressionFunction* find_expression_function(std::string_view name);
const ExpressionConstant* find_expression_constant(std::string_view name);

}  // namespace meristem
