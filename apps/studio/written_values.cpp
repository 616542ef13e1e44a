// SPDX-License-Identifier: Apache-2.0
#include "written_values.h"

#include <optional>
#include <utility>

#include "meristem/base/visible_text.h"

namespace meristem::studio {

namespace {

Value count_or_null(int number) { return number > 0 ? Value(number) : Value(); }

/// `unit` is the position of the fault in the text. Unset: unknown.
Value error_value(const Diagnostic& found, std::optional<std::size_t> unit, const std::string& file) {
  Diagnostic error = visible(found);
  if (!file.empty() && error.line > 0) error.file = file;
  // Not written as `condition ? Value(x) : Value()`: GCC 12 then warns of an uninitialised string at -O1.
  Value offset;
  if (unit) offset = static_cast<double>(*unit);
  return Value::Object{{"severity", error.severity == Severity::error ? "error" : "warning"},
                       {"message", error.message},
                       {"expected", error.expected},
                       {"nearest", error.nearest},
                       {"path", error.path},
                       {"line", count_or_null(error.line)},
                       {"column", count_or_null(error.column)},
                       {"offset", std::move(offset)},
                       {"text", error.text()}};
}

}  // namespace

Value errors_value(const std::vector<Diagnostic>& errors, std::string_view text, const std::string& file) {
  std::vector<LineColumn> places;
  for (const Diagnostic& error : errors) places.push_back({error.line, error.column});
  const bool is_placed = !text.empty();
  const std::vector<std::size_t> units = is_placed ? units_of(text, places) : std::vector<std::size_t>();
  Value::List list;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const bool is_known = is_placed && errors[k].line > 0;
    list.push_back(error_value(errors[k], is_known ? std::optional(units[k]) : std::nullopt, file));
  }
  return list;
}

Value patch_value(const std::vector<UnitSplice>& splices) {
  Value::List list;
  for (const UnitSplice& splice : splices) {
    list.push_back(
        Value::List{static_cast<double>(splice.offset), static_cast<double>(splice.length), splice.replacement});
  }
  return list;
}

Value variables_value(const std::vector<Variable>& variables) {
  Value::List list;
  for (const Variable& variable : variables) {
    list.push_back(Value::Object{{"name", variable.name},
                                 {"value", variable.value},
                                 {"min", variable.min},
                                 {"max", variable.max},
                                 {"unit", variable.unit},
                                 {"doc", variable.doc},
                                 {"expression", variable.expression},
                                 {"private", variable.is_private}});
  }
  return list;
}

Value copied_value(const NamedFileCopies& copies) {
  Value::List files;
  for (const std::string& file : copies.copied) files.push_back(file);
  return files;
}

Value omitted_value(const NamedFileCopies& copies) {
  Value::List files;
  for (const auto& [file, reason] : copies.omitted) {
    files.push_back(Value::Object{{"file", file}, {"reason", visible_lines(reason)}});
  }
  return files;
}

}  // namespace meristem::studio
