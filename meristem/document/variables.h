// SPDX-License-Identifier: Apache-2.0
// The variables of a document. A value may be an expression of other variables, in any order.
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// What the variables come to. Those without a value (a fault in the expression, a circle) count as 1 here, so that
/// what mentions them is not faulty as well.
struct VariableValues {
  std::vector<ExpressionNames::Constant> constants;  ///< those that expressions can name, in the document's order
  std::vector<std::vector<std::size_t>> uses;        ///< of each constant: those that its expression names
  std::vector<std::vector<std::size_t>> circles;  ///< constants that need each other: each the next, the last the first
};

/// Whether expressions know a name by themselves: of a function, a constant, or what a site or a node has.
bool has_meaning(const std::string& name);

/// Works out each variable after those that it uses. `given` is the document's object of variables or null; what is
/// wrong with it, read_variables tells.
VariableValues solve_variables(const Value* given, const Limits& limits);

/// The variables by their table, with faults for what cannot be one. The reader knows the `solved` constants.
std::vector<Variable> read_variables(const Value* given, const VariableValues& solved, ParameterReader& reader);

/// Warns of variables that no expression mentions, in the document's `root` or in a file that was read with it, and of
/// values beyond their own range.
void warn_of_variables(const Value& root, const std::vector<Variable>& variables, ParameterReader& reader);

/// What messages say of each constant that was set from outside or lies beyond its range: "age is 1000, beyond 8 to
/// 160". Empty where there is no such constant.
std::vector<VariableNote> note_variables(const std::vector<Variable>& variables, const VariableValues& solved,
                                         const std::vector<std::string>& overridden);

/// Returns true if an object has more variables than a document may have.
bool are_too_many_variables(const Value* given);

/// Adds to each error's message the notes on variables that the value at its path mentions, or that stand behind
/// those.
void tell_variables(const Value& root, const std::vector<VariableNote>& notes, std::vector<Diagnostic>& diagnostics);

}  // namespace meristem
