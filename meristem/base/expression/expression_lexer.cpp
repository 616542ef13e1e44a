// SPDX-License-Identifier: Apache-2.0
// Cuts the text of an expression into numbers, names and operations. Characters that only look like those of the
// language, and malformed numbers, produce errors that name the right form.
#include "meristem/base/expression/expression_lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/expression/expression.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/utf8.h"

namespace meristem {

namespace {

using Kind = ExpressionToken::Kind;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_character(char c) { return is_digit(c) || is_identifier(std::string_view(&c, 1)); }

/// Returns the number of bytes at the beginning of `text` for which `predicate` holds.
template <typename Predicate>
std::size_t run_length(std::string_view text, Predicate predicate) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), predicate) - text.begin());
}

/// Characters that people type or paste instead of the language's own.
struct Lookalike {
  std::string_view character;
  std::string_view instead;
};
constexpr Lookalike kLookalikes[] = {
    {"\u2212", "-"},  {"\u2013", "-"},  {"\u2014", "-"},  {"\u00D7", "*"},  {"\u00B7", "*"},
    {"\u22C5", "*"},  {"\u2217", "*"},  {"\u00F7", "/"},  {"\u2215", "/"},  {"\u2264", "<="},
    {"\u2265", ">="}, {"\u2260", "!="}, {"\u00B2", "^2"}, {"\u00B3", "^3"}, {"\u03C0", "pi"},
    {"\u00A0", " "},  {"=", "=="},      {"&", "&&"},      {"|", "||"},
};

constexpr std::string_view kOperations[] = {"||", "&&", "==", "!=", "<=", ">=", "<", ">", "+", "-",
                                            "*",  "/",  "%",  "!",  "^",  "(",  ")", ",", "?", ":"};

[[noreturn]] void throw_stray(std::string_view text, std::size_t offset) {
  const std::string_view rest = text.substr(offset);
  SyntaxError error;
  error.offset = offset;
  error.expected = "numbers, names, operators and parentheses";
  const std::size_t length = utf8_character_bytes(rest);
  const auto byte = static_cast<unsigned char>(rest.front());
  if (length == 0) {
    error.message = fmt::format("byte 0x{:02x} is not UTF-8 text", byte);
  } else if (byte < 0x20 || byte == 0x7F) {
    error.message = fmt::format("control character 0x{:02x} has no meaning here", byte);
  } else {
    error.message = fmt::format("'{}' has no meaning here", rest.substr(0, length));
  }
  for (const Lookalike& lookalike : kLookalikes) {
    if (rest.starts_with(lookalike.character)) error.nearest = lookalike.instead;
  }
  throw ExpressionError(std::move(error));
}

/// Throws an error for a run of digits, points and letters that begins like a number but is not a number. `digits` is
/// the length of the part that would be a number.
[[noreturn]] void throw_malformed_number(std::string_view text, std::size_t digits, std::size_t offset) {
  SyntaxError error;
  error.offset = offset;
  error.message = fmt::format("{} is not a number", in_quotes(text));
  error.expected = "a number such as 1, .5 or 2e-3";
  const std::string_view suffix = text.substr(digits);
  const bool is_hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (!is_hexadecimal && is_identifier(suffix) && suffix.size() <= 32) {
    error.nearest = fmt::format("{}*{}", text.substr(0, std::min<std::size_t>(digits, 32)), suffix);
  }
  throw ExpressionError(std::move(error));
}

}  // namespace

ExpressionToken ExpressionLexer::take(Kind kind, std::size_t bytes) {
  const ExpressionToken token{kind, position_, text_.substr(position_, bytes), 0};
  position_ += bytes;
  return token;
}

ExpressionToken ExpressionLexer::number() {
  const std::string_view rest = text_.substr(position_);
  const auto is_part = [](char c) { return is_digit(c) || c == '.'; };

  // Take the mantissa, the exponent, and all characters that follow without a gap.
  const std::size_t mantissa = run_length(rest, is_part);
  std::size_t length = mantissa;
  if (length < rest.size() && (rest[length] == 'e' || rest[length] == 'E')) {
    std::size_t digits = length + 1;
    if (digits < rest.size() && (rest[digits] == '-' || rest[digits] == '+')) ++digits;
    const std::size_t exponent = run_length(rest.substr(digits), is_digit);
    if (exponent > 0) length = digits + exponent;
  }
  const std::size_t glued = run_length(rest.substr(length), [&](char c) { return is_name_character(c) || c == '.'; });

  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + length, value);
  if (error == std::errc::result_out_of_range) {
    throw ExpressionError({position_,
                           fmt::format("{} is too large or too near zero", in_quotes(rest.substr(0, length))),
                           "a number below 1.8e308", ""});
  }
  if (glued > 0 || error != std::errc() || end != rest.data() + length) {
    throw_malformed_number(rest.substr(0, length + glued), length, position_);
  }
  ExpressionToken token = take(Kind::number, length);
  token.value = value;
  return token;
}

ExpressionToken ExpressionLexer::next() {
  position_ += run_length(text_.substr(position_), is_space);
  const std::string_view rest = text_.substr(position_);
  if (rest.empty()) return take(Kind::end, 0);
  if (is_digit(rest.front()) || rest.front() == '.') return number();
  std::size_t name = run_length(rest, is_name_character);
  // Names have no parts, but the error for "parent.length" must show the whole text.
  while (name > 0 && name + 1 < rest.size() && rest[name] == '.' && is_identifier(rest.substr(name + 1, 1))) {
    name += 1 + run_length(rest.substr(name + 1), is_name_character);
  }
  if (name > 0) return take(Kind::name, name);
  for (const std::string_view operation : kOperations) {
    if (rest.starts_with(operation)) return take(Kind::operation, operation.size());
  }
  throw_stray(text_, position_);
}

}  // namespace meristem
