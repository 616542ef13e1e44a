// SPDX-License-Identifier: Apache-2.0
// Parameter tables: what a struct of parameters is called, measured in, bounded by, and means, written once. Reading,
// checking, the JSON Schema, the command line's `components`, and every later editor are driven by the table alone.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/table/value.h"

namespace meristem {

class ParameterReader;
class ParameterTable;

/// The unit in which documents write a number. Angles are degrees in documents and radians in the struct.
enum class Unit { none, metre, degree, per_metre, per_cubic_metre, second, hour, day, step };
std::string_view unit_name(Unit unit);  ///< "m", "°", ...; empty for none

enum class ParameterKind {
  number,   ///< double, float or optional<double>
  integer,  ///< int, uint64_t or optional<int>
  boolean,
  text,
  lines,      ///< a text, plain or as a list of its lines
  choice,     ///< an enum by its enumerators' names
  integers,   ///< a list of so many whole numbers
  vector,     ///< three numbers
  colour,     ///< "#6b8e23"
  colours,    ///< a list of colours, at least one
  curve,      ///< {"curve": [[x, y], ...], "kind": "spline" | "linear"}
  points,     ///< a list of pairs [x, y]
  places,     ///< a list of places [x, y, z]
  condition,  ///< an expression that is true or false for each place
  formula,    ///< an expression over names of its own that gives a number, or a number
  selection,  ///< a list of instance numbers, ranges and conditions
  box,        ///< two corners [[x, y, z], [x, y, z]], the lower first
  file,       ///< the path of a file, from the document's folder, whose content is read with the document
  object,     ///< a nested table
  list,       ///< a list of nested tables
  map,        ///< an object of names, with a nested table each
};

/// From `low` to `high`, in document units; an end that is NaN is left to usual_range (usual_range.h).
struct UsualSpan {
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

/// What a number may be. In a component every number may differ from instance to instance unless it is `fixed`.
struct NumberForm {
  Unit unit = Unit::none;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  UsualSpan usual{};       ///< where people move it, which sliders show; what is not given follows from the rest
  bool above_min = false;  ///< `min` itself is excluded
  bool fixed = false;      ///< one value for the whole component
  bool per_child = false;  ///< differs among the children of an instance, and not from instance to instance
};

/// One row of a table.
struct Parameter {
  std::string name;
  std::string doc;  ///< one sentence, with what happens when the value is raised where that is not plain
  ParameterKind kind = ParameterKind::number;
  NumberForm form;                   ///< of numbers, integers and the elements of vectors
  std::vector<std::string> choices;  ///< of a choice
  std::size_t count = 0;             ///< of integers
  /// Of an object, list or map. A function, so that tables may contain themselves.
  const ParameterTable& (*nested)() = nullptr;
  std::vector<std::string> names;  ///< variables of a condition or formula
  bool required = false;

  /// Stores what `value` says into the struct at `object`, or reports faults.
  std::function<void(const Parameter& self, void* object, const Value& value, const Place& place,
                     ParameterReader& reader)>
      read;
  /// The struct's present value as a document would write it; null where unset.
  std::function<Value(const void* object)> show;

  /// "a number of metres above 0, at most 10".
  std::string expectation() const;
};

/// The rows of one struct. Made with Table<P> in table.h.
class ParameterTable {
 public:
  std::string name;  ///< of the struct, as messages and the schema call it
  std::string doc;
  std::vector<Parameter> parameters;
  std::vector<std::string> elsewhere;            ///< further keys, which whoever owns the table reads itself ("type")
  std::string shorthand;                         ///< the parameter that a bare value sets, or empty
  std::vector<std::vector<std::string>> one_of;  ///< of each group exactly one must be given
  /// A parameter that stands only beside another, or never beside it.
  struct Company {
    std::string parameter;
    std::string other;
    bool is_wanted = true;
  };
  std::vector<Company> company;
  /// Parameters that mean something only where something else does: the choice that they belong to, the object that
  /// they serve. Where they are given without, they are faults, whatever their values.
  struct Meaning {
    /// A parameter that is given, or that has one of these values, given or not.
    struct Giver {
      std::string parameter;
      std::vector<Value> values{};
    };
    std::vector<std::string> parameters;  ///< and those of nested tables, as in "resource.pass_back"
    std::vector<Giver> givers;            ///< of which any will do
    std::string reason{};                 ///< what is so instead, where nothing gives them a meaning
  };
  std::vector<Meaning> meanings;
  /// Rules between parameters; called when all of them could be read.
  std::function<void(const void* object, const Place& place, ParameterReader& reader)> check;
  /// Works out what follows from several parameters; called after the rules, once they hold.
  std::function<void(void* object, const Place& place, ParameterReader& reader)> prepare;
  /// The defaults, as documents write them.
  std::function<std::vector<Value>()> defaults;

  const Parameter* find(std::string_view parameter) const;
  std::vector<std::string> names() const;
  /// Why it has no such parameter where others of its kind have one; null where that is not known.
  const std::string* reason_without(std::string_view parameter) const;
  /// Whether a row below, at any depth, has this table again.
  bool contains_itself() const;
};

}  // namespace meristem
