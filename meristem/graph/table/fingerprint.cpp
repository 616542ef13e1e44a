// SPDX-License-Identifier: Apache-2.0
// Computes hashes of what a document says at one path. A hash covers the value, the variables whose names occur in its
// texts, and the files that were read with it. Names are found in one pass over each text.
#include "meristem/graph/table/fingerprint.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "meristem/base/fingerprint.h"
#include "meristem/base/read_file.h"

namespace meristem {

namespace {

/// The kinds of values; their numbers are part of hashes.
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

void add_value(const Value& value, Fingerprint& to) {
  if (const bool* boolean = value.boolean()) {
    to.add(Kind::boolean).add(*boolean);
  } else if (const double* number = value.number()) {
    to.add(Kind::number).add(*number);
  } else if (const std::string* text = value.text()) {
    to.add(Kind::text).add_text(*text);
  } else if (const Value::List* list = value.list()) {
    to.add(Kind::list).add(list->size());
    for (const Value& element : *list) add_value(element, to);
  } else if (const Value::Object* object = value.object()) {
    to.add(Kind::object).add(object->size());
    for (const auto& [name, member] : *object) add_value(member, to.add_text(name));
  } else {
    to.add(Kind::null);
  }
}

/// Appends the position, in the table, of every name that a text mentions. A name may appear several times.
void add_mentioned_in_text(std::string_view text, const NameTable& names, std::vector<std::size_t>& found) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    while (at < text.size() && is_of_name(text[at])) ++at;
    if (at == begin) {
      ++at;
    } else if (const auto position = names.find(text.substr(begin, at - begin))) {
      found.push_back(*position);
    }
  }
}

void add_mentioned(const Value& value, const NameTable& names, std::vector<std::size_t>& found) {
  if (const std::string* text = value.text()) add_mentioned_in_text(*text, names, found);
  if (const Value::List* list = value.list()) {
    for (const Value& element : *list) add_mentioned(element, names, found);
  }
  if (const Value::Object* object = value.object()) {
    for (const auto& [key, member] : *object) add_mentioned(member, names, found);
  }
}

/// Returns the positions of the names that the texts of a value mention, in rising order.
std::vector<std::size_t> mentioned(const Value& value, const NameTable& names) {
  std::vector<std::size_t> found;
  if (names.size() == 0) return found;
  add_mentioned(value, names, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

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

std::optional<std::uint64_t> fingerprint_of(const Value& value, const ConstantTable& constants,
                                            std::span<const NamedFile> files, std::uint64_t file_bytes) {
  Fingerprint fingerprint;
  add_value(value, fingerprint);
  const auto add_constant = [&](const ExpressionNames::Constant& constant) {
    fingerprint.add_text(constant.name).add(constant.value);
  };
  if (files.empty()) {
    for (const std::size_t k : mentioned(value, constants.names())) add_constant(constants.all()[k]);
  } else {
    for (const ExpressionNames::Constant& constant : constants.all()) add_constant(constant);
  }
  for (const NamedFile& file : files) {
    std::error_code error;
    if (!file.hash && !std::filesystem::is_regular_file(file.path, error)) return std::nullopt;
    fingerprint.add_text(file.path).add(file.hash ? *file.hash : hash64(read_file(file.path, file_bytes)));
  }
  return fingerprint.hash();
}

}  // namespace meristem
