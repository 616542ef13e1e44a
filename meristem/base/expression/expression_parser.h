// SPDX-License-Identifier: Apache-2.0
// Compiles the text of an expression to bytecode in one pass. Private to the expression language.
#pragma once

#include <string_view>

#include "meristem/base/expression/expression.h"
#include "meristem/base/expression/expression_bytecode.h"

namespace meristem {

/// Maximum nesting of parentheses, calls, branches, signs and powers.
inline constexpr int kDeepestExpression = 200;

/// Throws ExpressionError for the first error.
ExpressionBytecode parse_expression(std::string_view text, const ExpressionScope& scope);

}  // namespace meristem
