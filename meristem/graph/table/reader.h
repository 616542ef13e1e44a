// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/expression/expression_scope.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/expression_reader.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/file_reader.h"
#include "meristem/graph/table/number_reader.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/read_errors.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// Reads values into structs by their tables, and collects all errors. Numbers, expressions and files have readers of
/// their own, which report to the same errors.
class ParameterReader : public ReadErrors {
 public:
  /// `constants` are the document's variables.
  ParameterReader(std::vector<ExpressionNames::Constant> constants, const SizeLimits& limits, FileAccess access = {});
  ParameterReader(const ParameterReader&) = delete;
  ParameterReader& operator=(const ParameterReader&) = delete;

  /// Reads `value` into the struct at `object`. Every number must be a single number. Returns the rows that `value`
  /// gives.
  GivenRows read(const ParameterTable& table, void* object, const Value& value, const DocumentPath& path);
  /// Reads `value` into a component's struct. Returns the numbers, including those in the elements of its lists, that
  /// vary from instance to instance.
  std::vector<Varying> read_varying(const ParameterTable& table, void* object, const Value& value,
                                    const DocumentPath& path);

  // The functions below are used by tables. Each reports values that it cannot accept.

  /// Reads the table's members from an object, or its shorthand from a bare value.
  GivenRows object(const ParameterTable& table, void* object, const Value& value, const DocumentPath& path);
  /// Reads the element with this index of the list or map at `member`.
  void element(const Parameter& row, void* member, std::size_t index, const Value& value, const DocumentPath& path);
  /// Returns the text of a value; null after an error.
  const std::string* text(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Returns the index of a choice; nothing after an error.
  std::optional<std::size_t> choice(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Returns what `make_of` makes of a text, or its result in an earlier read. Warnings are reported in both cases.
  template <class T>
  std::shared_ptr<const T> kept_text(const std::string& text, const std::string& file_path,
                                     std::vector<Diagnostic>& warnings,
                                     T (*make_of)(const std::string&, const std::string&, ParameterReader&,
                                                  std::vector<Diagnostic>&)) {
    const auto make = [&] { return make_of(text, file_path, *this, warnings); };
    if (!files_.keeps()) return std::make_shared<const T>(make());
    Fingerprint key = files_.key_of(reinterpret_cast<void (*)()>(make_of));
    key.add_text(file_path).add_text(text).add(expressions_.constants_hash());
    return files_.kept_text<T>(key, warnings, make);
  }

  ExpressionReader& expressions() { return expressions_; }  ///< expressions, and the names that they may use
  NumberReader& numbers() { return numbers_; }              ///< numbers, and which of them vary
  FileReader& files() { return files_; }                    ///< files, texts and other documents

  /// Reading throws Cancelled soon after `progress` was asked to stop. Null: reading cannot be stopped.
  void stop_with(const Progress* progress) { numbers_.stop_with(progress); }
  /// Throws Cancelled if reading was asked to stop.
  void check_stop() const { numbers_.check_stop(); }

 private:
  void check_given(const ParameterTable& table, const GivenRows& given, const DocumentPath& path);

  ExpressionReader expressions_;
  FileReader files_;
  NumberReader numbers_;
};

}  // namespace meristem
