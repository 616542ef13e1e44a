// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/json.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "meristem/base/diagnostic.h"
#include "meristem/document/locate.h"

namespace meristem {

namespace {

using Json = nlohmann::ordered_json;

/// What stopped the parser, if it was not the syntax.
struct Fault {
  std::string message;
  std::string expected;
};

/// Builds the tree from the parser's events, without recursion, and stops at the first fault.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const Limits& limits) : text_(text), limits_(limits) {}

  bool null() override { return add(Value()); }
  bool boolean(bool value) override { return add(Value(value)); }
  bool number_integer(number_integer_t value) override { return add(Value(static_cast<double>(value))); }
  bool number_unsigned(number_unsigned_t value) override { return add(Value(static_cast<double>(value))); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(Value(value)); }
  bool string(string_t& value) override { return add(Value(std::move(value))); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(Value(Value::Object{})); }
  bool start_array(std::size_t /*size*/) override { return open(Value(Value::List{})); }
  bool key(string_t& value) override {
    keys_.push_back(std::move(value));
    return true;
  }
  bool end_object() override {
    if (const std::string* twice = repeated_key(*open_.back().object())) {
      stop(fmt::format("the key '{}' is given twice in one object", *twice), "each key once");
      return false;
    }
    return close();
  }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    fault_ = {reason(error.what()), ""};
    offset_ = position == 0 ? 0 : position - 1;
    return false;
  }

  Value take() {
    if (fault_.message.empty() && !open_.empty()) stop("the document ends too early", "");
    return std::move(root_);
  }
  const Fault& fault() const { return fault_; }
  std::size_t offset() const { return offset_; }
  /// Faults found while building are placed by the path at which they arose.
  const std::string& path() const { return path_; }

 private:
  void stop(std::string message, std::string expected) {
    fault_ = {std::move(message), std::move(expected)};
    path_ = present_path();
  }

  bool add(Value value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (Value::List* list = open_.back().list()) {
      list->push_back(std::move(value));
    } else {
      open_.back().object()->emplace_back(std::move(keys_.back()), std::move(value));
      keys_.pop_back();
    }
    return true;
  }

  bool open(Value container) {
    if (open_.size() >= limits_.nesting) {
      stop(fmt::format("lists and objects are nested deeper than {} levels", limits_.nesting), "a flatter document");
      return false;
    }
    open_.push_back(std::move(container));
    return true;
  }

  bool close() {
    Value done = std::move(open_.back());
    open_.pop_back();
    return add(std::move(done));
  }

  static const std::string* repeated_key(const Value::Object& object) {
    std::vector<const std::string*> names;
    names.reserve(object.size());
    for (const Value::Member& member : object) names.push_back(&member.first);
    std::sort(names.begin(), names.end(), [](const auto* a, const auto* b) { return *a < *b; });
    const auto twice =
        std::adjacent_find(names.begin(), names.end(), [](const auto* a, const auto* b) { return *a == *b; });
    return twice == names.end() ? nullptr : *twice;
  }

  std::string present_path() const {
    std::string path;
    std::size_t key = 0;
    for (const Value& container : open_) {
      if (container.list() != nullptr) {
        path += fmt::format("[{}]", container.list()->size());
      } else if (key < keys_.size()) {
        if (!path.empty()) path += '.';
        path += keys_[key++];
      }
    }
    return path;
  }

  /// The parser's reason without its own prefix and position, which are given in ours.
  static std::string reason(std::string_view what) {
    for (const std::string_view marker : {"syntax error ", "syntax error"}) {
      const std::size_t at = what.find(marker);
      if (at != std::string_view::npos)
        return std::string("syntax error ") + std::string(what.substr(at + marker.size()));
    }
    const std::size_t bracket = what.find("] ");
    return std::string(bracket == std::string_view::npos ? what : what.substr(bracket + 2));
  }

  std::string_view text_;
  const Limits& limits_;
  Value root_;
  std::vector<Value> open_;
  std::vector<std::string> keys_;
  Fault fault_;
  std::size_t offset_ = 0;
  std::string path_;
};

Json to_json(const Value& value) {
  if (const bool* boolean = value.boolean()) return *boolean;
  if (const double* number = value.number()) {
    const bool whole = *number == std::floor(*number) && std::abs(*number) < 9e15;
    return whole ? Json(static_cast<std::int64_t>(*number)) : Json(*number);
  }
  if (const std::string* text = value.text()) return *text;
  if (const Value::List* list = value.list()) {
    Json array = Json::array();
    for (const Value& element : *list) array.push_back(to_json(element));
    return array;
  }
  if (const Value::Object* object = value.object()) {
    Json members = Json::object();
    for (const auto& [name, member] : *object) members[name] = to_json(member);
    return members;
  }
  return nullptr;
}

}  // namespace

Value parse_json(std::string_view text, const Limits& limits) {
  if (text.size() > limits.document_bytes) {
    throw_limit("bytes in a document", static_cast<double>(text.size()), limits.document_bytes, "document_bytes", "");
  }
  TreeBuilder builder(text, limits);
  const bool good = nlohmann::json::sax_parse(text.begin(), text.end(), &builder, nlohmann::json::input_format_t::json,
                                              /*strict=*/true, /*ignore_comments=*/true);
  Value value = builder.take();
  if (good && builder.fault().message.empty()) return value;
  Diagnostic diagnostic{.message = builder.fault().message, .expected = builder.fault().expected};
  if (builder.path().empty()) {
    const TextPosition position = text_position(text, builder.offset());
    diagnostic.line = position.line;
    diagnostic.column = position.column;
  } else {
    diagnostic.path = builder.path();
    locate_diagnostics(text, std::span(&diagnostic, 1));
  }
  throw InputError(std::move(diagnostic));
}

std::string write_json(const Value& value) { return to_json(value).dump(2) + "\n"; }

}  // namespace meristem
