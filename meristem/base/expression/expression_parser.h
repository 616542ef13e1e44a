// SPDX-License-Identifier: Apache-2.0
// From an expression's text to bytecode in one pass. Private to the expression language.
#pragma once

#include <string_view>

#include "meristem/base/expression/expression.h"
#include "meristem/base/expression/expression_bytecode.h"

namespace meristem {

/// Parentheses, calls, branches, signs and powers inside each other.
inline constexpr int kDeepestExpression = 200;

/// Throws ExpressionError for the first fault.
ExpressionBytecode parse_expression(std::string_view text, const ExpressionScope& scope);

}  // namespace meristem
