// SPDX-License-Identifier: Apache-2.0
// Reads JSON with comments into a tree. The parser sends events, and a builder without recursion makes the tree, checks
// limits and repeated keys, and stops at the first fault. Faults get line, column and path.
#include "meristem/document/json.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "meristem/base/diagnostic.h"
#include "meristem/base/free_later.h"
#include "meristem/base/name_index.h"
#include "meristem/document/locate.h"

namespace meristem {

namespace {

constexpr std::size_t kValuesBetweenChecks = 4096;
constexpr std::size_t kLongestKey = 1000;  // bytes; keys appear in messages, and names of parameters are short

/// Rewrites a message of the parser: "syntax error while parsing object - unexpected string literal; last read: '"b"';
/// expected '}'" becomes "unexpected string literal", with ',' or '}' as expected.
Diagnostic syntax_error(std::string_view what) {
  const std::size_t dash = what.find(" - ");
  if (dash != std::string_view::npos) {
    what.remove_prefix(dash + 3);
  } else if (const std::size_t bracket = what.find("] "); bracket != std::string_view::npos) {
    what.remove_prefix(bracket + 2);
  }
  constexpr std::string_view kExpected = "; expected ";
  Diagnostic error{.message = std::string(what)};
  if (const std::size_t at = what.rfind(kExpected); at != std::string_view::npos) {
    error.expected = what.substr(at + kExpected.size());
    error.message.resize(at);
  }
  // The text that was read last is removed: it may be the whole document, or not UTF-8.
  for (std::string* part : {&error.message, &error.expected})
    part->resize(std::min(part->find("; last read: "), part->size()));
  if (error.expected == "'}'" || error.expected == "']'") error.expected = "',' or " + error.expected;
  if (error.expected == "'[', '{', or a literal") error.expected = "a value";
  if (error.expected == "string literal") error.expected = "a key in quotes";
  return error;
}

/// Builds the tree from the parser's events without recursion. Stops at the first fault.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const SizeLimits& limits, const Progress* progress)
      : text_(text), limits_(limits), progress_(progress) {}

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
    if (value.size() > kLongestKey) {
      return stop(present_path(), {.message = fmt::format("a key is {} bytes long", value.size()),
                                   .expected = fmt::format("at most {}", kLongestKey)});
    }
    keys_.push_back(std::move(value));
    return true;
  }
  bool end_object() override {
    const std::string* twice = repeated_key(*open_.back().object());
    if (twice == nullptr) return close();
    const std::string path = present_path();
    return stop(path.empty() ? *twice : path + '.' + *twice,
                {.message = fmt::format("the key '{}' is given twice in one object", *twice),
                 .expected = "each key once",
                 .text_offset = kAtName});
  }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) override {
    // The parser counts the bytes that it has read. The count ends behind a whole token in a wrong position, and
    // otherwise one byte behind the wrong byte.
    const std::string_view what = error.what();
    const bool is_overflow = what.find("number overflow") != std::string_view::npos;
    const bool is_token = what.find(" - unexpected ") != std::string_view::npos &&
                          what.find(" literal", what.find(" - unexpected ")) < what.find("; ");
    const std::size_t back = is_token || is_overflow ? token.size() : 1;
    error_ = is_overflow ? Diagnostic{.message = fmt::format("the number {} is too large", token)} : syntax_error(what);
    const TextPosition at = text_position(text_, position - std::min(position, back));
    error_->line = at.line;
    error_->column = at.column;
    return false;
  }

  Value take_root() { return std::move(root_); }
  /// Returns all values so far.
  std::vector<Value> take_all() {
    open_.push_back(std::move(root_));
    return std::move(open_);
  }
  const std::optional<Diagnostic>& error() const { return error_; }

 private:
  /// Stops the parser with a fault at `path`.
  bool stop(std::string path, Diagnostic error) {
    error.path = std::move(path);
    locate_diagnostics(text_, std::span(&error, 1));
    error_ = std::move(error);
    return false;
  }

  bool add(Value value) {
    if (progress_ != nullptr && ++added_ % kValuesBetweenChecks == 0) progress_->check();
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
      return stop(present_path(),
                  {.message = fmt::format("lists and objects are nested deeper than {} levels", limits_.nesting),
                   .expected = "a flatter document"});
    }
    open_.push_back(std::move(container));
    return true;
  }

  bool close() {
    Value done = std::move(open_.back());
    open_.pop_back();
    return add(std::move(done));
  }

  /// Returns the first name, in alphabetical order, that is given twice. Returns null if all names differ.
  const std::string* repeated_key(const Value::Object& object) const {
    constexpr std::size_t kFew = 16;
    bool is_repeated = false;
    if (object.size() <= kFew) {
      for (std::size_t k = 1; k < object.size() && !is_repeated; ++k) {
        const auto is_equal = [&](const Value::Member& member) { return member.first == object[k].first; };
        is_repeated = std::any_of(object.begin(), object.begin() + static_cast<std::ptrdiff_t>(k), is_equal);
      }
    } else {
      const auto name_at = [&](std::size_t k) -> std::string_view { return object[k].first; };
      NameIndex seen(object.size());
      for (std::size_t k = 0; k < object.size() && !is_repeated; ++k) {
        if (progress_ != nullptr && k % kValuesBetweenChecks == 0) progress_->check();
        is_repeated = seen.enter(object[k].first, k, name_at).has_value();
      }
    }
    if (!is_repeated) return nullptr;
    std::vector<const std::string*> names;
    names.reserve(object.size());
    for (const Value::Member& member : object) names.push_back(&member.first);
    std::sort(names.begin(), names.end(), [](const auto* a, const auto* b) { return *a < *b; });
    const auto twice =
        std::adjacent_find(names.begin(), names.end(), [](const auto* a, const auto* b) { return *a == *b; });
    return twice == names.end() ? nullptr : *twice;
  }

  /// Returns the path of the value that the parser reads now. Every open object has its present key in `keys_`, except
  /// an object between two members.
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

  std::string_view text_;
  const SizeLimits& limits_;
  const Progress* progress_;
  std::size_t added_ = 0;
  Value root_;
  std::vector<Value> open_;
  std::vector<std::string> keys_;
  std::optional<Diagnostic> error_;
};

}  // namespace

Value parse_json(std::string_view text, const SizeLimits& limits, const Progress* progress) {
  if (text.size() > limits.document_bytes) {
    throw InputError(Diagnostic{.message = fmt::format("the text has {} bytes", text.size()),
                                .expected = fmt::format("at most {}", limits.document_bytes)});
  }
  // The parser would take a zero byte for the end of the text or of a comment.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const TextPosition at = text_position(text, zero);
    throw InputError(Diagnostic{
        .message = "a byte 0x00", .expected = "text in UTF-8 without it", .line = at.line, .column = at.column});
  }
  TreeBuilder builder(text, limits, progress);
  try {
    nlohmann::json::sax_parse(text.begin(), text.end(), &builder, nlohmann::json::input_format_t::json,
                              /*strict=*/true, /*ignore_comments=*/true);
  } catch (const Cancelled&) {
    free_later(builder.take_all());
    throw;
  }
  if (builder.error()) throw InputError(*builder.error());
  return builder.take_root();
}

}  // namespace meristem
