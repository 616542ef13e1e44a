// SPDX-License-Identifier: Apache-2.0
// Cuts an expression's text into tokens. Private to the expression language.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meristem {

struct ExpressionToken {
  enum class Kind { end, number, name, operation };
  Kind kind = Kind::end;
  std::size_t offset = 0;  ///< offset in bytes
  std::string_view text;   ///< for an operation: one of the operators, "(", ")", ",", "?" or ":"
  double value = 0;        ///< value of a number

  bool is(std::string_view operation) const { return kind == Kind::operation && text == operation; }
};

class ExpressionLexer {
 public:
  explicit ExpressionLexer(std::string_view text) : text_(text) {}
  /// Returns the next token. After the last token, every call returns the end. Throws ExpressionError for bytes that
  /// begin no token and for malformed numbers.
  ExpressionToken next();

 private:
  ExpressionToken take(ExpressionToken::Kind kind, std::size_t bytes);
  ExpressionToken number();

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace meristem
