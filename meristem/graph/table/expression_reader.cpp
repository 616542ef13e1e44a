// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/expression_reader.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/graph/table/site.h"

namespace meristem {

namespace {

/// Returns the word of a text that begins at a byte.
std::string_view name_at(std::string_view text, std::size_t offset) {
  std::size_t end = offset;
  while (end < text.size() && is_identifier(text.substr(offset, end + 1 - offset))) ++end;
  return text.substr(std::min(offset, text.size()), end - std::min(offset, end));
}

}  // namespace

ExpressionReader::ExpressionReader(std::vector<ExpressionNames::Constant> constants, ReadErrors& errors)
    : errors_(errors), constants_(std::move(constants)), instance_names_(site_variables()) {}

std::optional<Expression> ExpressionReader::read(const Value& value, const DocumentPath& path,
                                                 std::span<const std::string> variables) {
  const std::string* text = value.text();
  if (text == nullptr) {
    errors_.add_error(path, fmt::format("an expression cannot be {}", value.description()),
                      "a text with an expression");
    return std::nullopt;
  }
  if (paths_ != nullptr) paths_->push_back(path.text());
  try {
    const bool is_of_instance = variables.data() == instance_names().data();
    return Expression::compile_in(*text,
                                  {.variables = variables,
                                   .constants = constants(),
                                   .variable_table = is_of_instance ? &instance_names_ : nullptr,
                                   .constant_table = &constants_.names(),
                                   .has_nearest = errors_.may_compare(0)},
                                  errors_.limits().expression_bytes);
  } catch (const ExpressionError& raised) {
    const SyntaxError& found = raised.details();
    errors_.count_compared(variables.size() + constants().size());
    const auto offset = static_cast<int>(found.offset);
    const std::string_view name = name_at(*text, found.offset);
    if (const auto refused = refused_names_.find(name); refused != refused_names_.end()) {
      errors_.add_error(path, fmt::format("'{}' {}", name, refused->second), "", "", offset);
    } else {
      errors_.add_error(path, found.message, found.expected, found.nearest, offset);
    }
    return std::nullopt;
  }
}

std::uint64_t ExpressionReader::constants_hash() {
  if (!constants_hash_) {
    Fingerprint all;
    for (const ExpressionNames::Constant& constant : constants()) all.add_text(constant.name).add(constant.value);
    constants_hash_ = all.hash();
  }
  return *constants_hash_;
}

}  // namespace meristem
