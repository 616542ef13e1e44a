// SPDX-License-Identifier: Apache-2.0
// The variables of a document. A value may be an expression of other variables, in any order.
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// The values of the variables. A variable without a value (a fault in its expression, a circle) counts as 1, so that
/// values that use it cause no further fault.
struct VariableValues {
  std::vector<ExpressionNames::Constant> constants;  ///< constants that expressions can name, in the document's order
  std::vector<std::vector<std::size_t>> uses;        ///< for each constant, the constants that its expression names
  std::vector<std::vector<std::size_t>> circles;  ///< circles of constants: each uses the next one, and the last uses
                                                  ///< the first
};

/// Returns true if a name already has a meaning in expressions: a function, a constant, or a variable of sites or
/// nodes.
bool has_meaning(const std::string& name);

/// Computes the variables, each after the variables that it uses. `given` is the document's object of variables, or
/// null. Reports no faults; read_variables() does.
VariableValues solve_variables(const Value* given, const SizeLimits& limits);

/// Reads the variables by their table and reports faults. The reader must know the `solved` constants.
std::vector<Variable> read_variables(const Value* given, const VariableValues& solved, ParameterReader& reader);

/// Warns of variables that no expression mentions, in the document's `root` or in a file that was read with it. Warns
/// of values beyond their own range.
void warn_of_variables(const Value& root, const std::vector<Variable>& variables, ParameterReader& reader);

/// Returns a note for messages on each constant that was set by an override or lies beyond its range: "age is 1000,
/// beyond 8 to 160". Returns an empty list if there is no such constant.
std::vector<VariableNote> note_variables(const std::vector<Variable>& variables, const VariableValues& solved,
                                         const std::vector<std::string>& overridden);

/// Returns true if an object has more variables than a document may have.
bool are_too_many_variables(const Value* given);

/// Adds notes to each error's message: the notes on variables that the value at its path mentions, directly or through
/// other variables.
void tell_variables(const Value& root, const std::vector<VariableNote>& notes, std::vector<Diagnostic>& diagnostics);

}  // namespace meristem
