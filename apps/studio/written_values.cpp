// SPDX-License-Identifier: Apache-2.0
#include "written_values.h"

#include <utility>

#include "meristem/base/visible_text.h"

namespace meristem::studio {

namespace {

Value count_or_null(int number) { return number > 0 ? Value(number) : Value(); }

Value fault_value(const Diagnostic& found, std::string_view text, const std::string& file) {
  Diagnostic fault = visible(found);
  if (!file.empty() && fault.line > 0) fault.file = file;
  // Not written as `condition ? Value(x) : Value()`: GCC 12 then warns of an uninitialised string at -O1.
  Value offset;
  if (fault.line > 0 && !text.empty()) offset = static_cast<double>(unit_of(text, fault.line, fault.column));
  return Value::Object{{"severity", fault.severity == Severity::error ? "error" : "warning"},
                       {"message", fault.message},
                       {"expected", fault.expected},
                       {"nearest", fault.nearest},
                       {"path", fault.path},
                       {"line", count_or_null(fault.line)},
                       {"column", count_or_null(fault.column)},
                       {"offset", std::move(offset)},
                       {"text", fault.text()}};
}

}  // namespace

Value faults_value(const std::vector<Diagnostic>& faults, std::string_view text, const std::string& file) {
  Value::List list;
  for (const Diagnostic& fault : faults) list.push_back(fault_value(fault, text, file));
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

}  // namespace meristem::studio
