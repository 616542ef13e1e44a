// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace meristem {

/// A value as a document's text contains it, before its meaning is known. Members keep their order. Builders limit the
/// depth of nesting, so recursion over a value is safe.
class Value {
 public:
  using List = std::vector<Value>;               ///< elements in their order
  using Member = std::pair<std::string, Value>;  ///< name and value
  using Object = std::vector<Member>;            ///< members in their order

  Value() = default;  ///< null
  // NOLINTBEGIN(google-explicit-constructor): a value is written as what it holds
  Value(bool boolean) : data_(boolean) {}
  Value(double number) : data_(number) {}
  Value(int number) : data_(static_cast<double>(number)) {}
  Value(std::string text) : data_(std::move(text)) {}
  Value(const char* text) : data_(std::string(text)) {}
  Value(List list) : data_(std::move(list)) {}
  Value(Object object) : data_(std::move(object)) {}
  // NOLINTEND(google-explicit-constructor)

  bool is_null() const { return std::holds_alternative<std::monostate>(data_); }  ///< true if nothing was written
  /// Returns the content if it is true or false, else null.
  const bool* boolean() const { return std::get_if<bool>(&data_); }
  /// Returns the content if it is a number, else null.
  const double* number() const { return std::get_if<double>(&data_); }
  /// Returns the content if it is a text, else null.
  const std::string* text() const { return std::get_if<std::string>(&data_); }
  /// Returns the content if it is a list, else null.
  const List* list() const { return std::get_if<List>(&data_); }
  /// Returns the content if it is an object, else null.
  const Object* object() const { return std::get_if<Object>(&data_); }
  List* list() { return std::get_if<List>(&data_); }
  Object* object() { return std::get_if<Object>(&data_); }

  /// Returns the member of an object. Returns null if the value has no such member or is not an object.
  const Value* find(std::string_view name) const;
  Value* find(std::string_view name);

  /// Returns a description for messages: "a number", "a list of 3", "the text 'abc'".
  std::string description() const;

  bool operator==(const Value&) const = default;

 private:
  std::variant<std::monostate, bool, double, std::string, List, Object> data_;
};

/// A path in a document, as a chain of objects on the stack from the top down. It costs nothing until text() is called.
class DocumentPath {
 public:
  DocumentPath() = default;
  /// The path of a member of `parent`, which must outlive this object.
  DocumentPath(const DocumentPath& parent, std::string_view member) : parent_(&parent), member_(member) {}
  DocumentPath(const DocumentPath& parent, std::size_t index) : parent_(&parent), index_(index), is_index_(true) {}

  /// Returns the path as text: "components.stem.angle", "links[1].density". Empty at the top.
  std::string text() const;

 private:
  const DocumentPath* parent_ = nullptr;
  std::string_view member_;
  std::size_t index_ = 0;
  bool is_index_ = false;
};

}  // namespace meristem
