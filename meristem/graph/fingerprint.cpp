// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/fingerprint.h"

#include <filesystem>
#include <system_error>

#include "meristem/base/hash.h"
#include "meristem/base/read_file.h"

namespace meristem {

namespace {

/// What a value holds, by the number of its kind.
enum class Kind : std::uint8_t { null, boolean, number, text, list, object };

bool is_of_name(char c) {
  return c == '_' || ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
}

bool contains_name(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_of_name(text[at - 1])) && (end == text.size() || !is_of_name(text[end]))) return true;
  }
  return false;
}

/// Whether a text of the value names it. Values nest no deeper than a document may.
bool mentions(const Value& value, std::string_view name) {
  if (const std::string* text = value.text()) return contains_name(*text, name);
  if (const Value::List* list = value.list()) {
    for (const Value& element : *list) {
      if (mentions(element, name)) return true;
    }
  }
  if (const Value::Object* object = value.object()) {
    for (const auto& [key, member] : *object) {
      if (mentions(member, name)) return true;
    }
  }
  return false;
}

}  // namespace

Fingerprint& Fingerprint::add_text(std::string_view text) {
  add(text.size());
  bytes_.append(text);
  return *this;
}

Fingerprint& Fingerprint::add_value(const Value& value) {
  if (const bool* boolean = value.boolean()) return add(Kind::boolean).add(*boolean);
  if (const double* number = value.number()) return add(Kind::number).add(*number);
  if (const std::string* text = value.text()) return add(Kind::text).add_text(*text);
  if (const Value::List* list = value.list()) {
    add(Kind::list).add(list->size());
    for (const Value& element : *list) add_value(element);
  } else if (const Value::Object* object = value.object()) {
    add(Kind::object).add(object->size());
    for (const auto& [name, member] : *object) add_text(name).add_value(member);
  } else {
    add(Kind::null);
  }
  return *this;
}

std::uint64_t Fingerprint::hash() const { return hash64(bytes_); }

std::optional<std::uint64_t> fingerprint_of(const Value& value, std::span<const ExpressionNames::Constant> constants,
                                            std::span<const std::string> files, std::uint64_t file_bytes) {
  Fingerprint fingerprint;
  fingerprint.add_value(value);
  for (const ExpressionNames::Constant& constant : constants) {
    if (files.empty() && !mentions(value, constant.name)) continue;
    fingerprint.add_text(constant.name).add(constant.value);
  }
  for (const std::string& file : files) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    fingerprint.add_text(file).add_text(read_file(file, file_bytes));
  }
  return fingerprint.hash();
}

}  // namespace meristem
