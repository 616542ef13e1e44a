// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/mentions.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace meristem {

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

}  // namespace

bool is_of_name(char c) { return c == '_' || is_digit(c) || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

void for_each_name(std::string_view text, FunctionRef<void(std::string_view name)> take) {
  std::size_t at = 0;
  while (at < text.size()) {
    if (!is_of_name(text[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && is_of_name(text[at])) ++at;
    if (!is_digit(text[begin])) take(text.substr(begin, at - begin));
  }
}

void for_each_mention(const Value& value, FunctionRef<void(std::string_view name)> take) {
  std::vector<const Value*> ahead{&value};
  while (!ahead.empty()) {
    const Value& next = *ahead.back();
    ahead.pop_back();
    if (const std::string* text = next.text()) for_each_name(*text, take);
    if (const Value::List* list = next.list()) {
      for (const Value& element : *list) ahead.push_back(&element);
    }
    if (const Value::Object* object = next.object()) {
      for (const auto& [name, member] : *object) ahead.push_back(&member);
    }
  }
}

const Value* find_value(const Value& root, std::string_view path) {
  const Value* found = nullptr;
  const Value* at = &root;
  while (at != nullptr && !path.empty()) {
    if (path.front() == '[') {
      std::size_t index = 0;
      const auto parsed = std::from_chars(path.data() + 1, path.data() + path.size(), index);
      const Value::List* list = at->list();
      at = parsed.ec == std::errc() && list != nullptr && index < list->size() ? &(*list)[index] : nullptr;
      path.remove_prefix(std::min(path.size(), static_cast<std::size_t>(parsed.ptr - path.data()) + 1));
    } else {
      const std::size_t end = std::min(path.find_first_of(".["), path.size());
      at = at->find(path.substr(0, end));
      path.remove_prefix(end);
    }
    if (!path.empty() && path.front() == '.') path.remove_prefix(1);
    if (at != nullptr) found = at;
  }
  return found;
}

}  // namespace meristem
