// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/value.h"

#include <fmt/format.h>

namespace meristem {

const Value* Value::find(std::string_view name) const {
  if (const Object* members = object()) {
    for (const Member& member : *members) {
      if (member.first == name) return &member.second;
    }
  }
  return nullptr;
}

Value* Value::find(std::string_view name) { return const_cast<Value*>(std::as_const(*this).find(name)); }

std::string Value::description() const {
  constexpr std::size_t kShown = 40;
  if (const bool* b = boolean()) return *b ? "true" : "false";
  if (const double* x = number()) return fmt::format("the number {:.12g}", *x);
  if (const std::string* s = text()) {
    return s->size() <= kShown ? fmt::format("the text '{}'", *s) : "a text of " + std::to_string(s->size()) + " bytes";
  }
  if (const List* l = list()) return l->empty() ? "an empty list" : fmt::format("a list of {}", l->size());
  return is_null() ? "null" : "an object";
}

std::string DocumentPath::text() const {
  if (parent_ == nullptr) return {};
  std::string above = parent_->text();
  if (is_index_) return fmt::format("{}[{}]", above, index_);
  return above.empty() ? std::string(member_) : fmt::format("{}.{}", above, member_);
}

}  // namespace meristem
