// SPDX-License-Identifier: Apache-2.0
// Parameter tables state the name, unit, range and meaning of every parameter of a struct once. Reading, checks, the
// JSON Schema, the command `components` and all editors use only these tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/table/value.h"

namespace meristem {

struct ElementKinds;
class ParameterReader;
class ParameterTable;

/// The unit in which documents write a number. Angles are degrees in documents and radians in the struct.
enum class Unit { none, metre, degree, per_metre, per_cubic_metre, second, hour, day, step };
std::string_view unit_name(Unit unit);  ///< "m", "°", ...; empty for none

/// The kind of a row's member, and its form in documents.
enum class ParameterKind {
  number,   ///< double, float or optional<double>
  integer,  ///< int, uint64_t or optional<int>
  boolean,
  text,
  lines,      ///< a text, plain or as a list of its lines
  choice,     ///< an enum by its enumerators' names
  integers,   ///< a list of a fixed number of whole numbers
  vector,     ///< three numbers
  facing,     ///< three numbers that give a direction, or "surface"
  colour,     ///< "#6b8e23"
  colours,    ///< a list of colours, at least one
  curve,      ///< {"curve": [[x, y], ...], "kind": "spline" | "linear"}
  points,     ///< a list of pairs [x, y]
  positions,  ///< a list of points [x, y, z]
  condition,  ///< an expression that is true or false for each site
  formula,    ///< an expression over names of its own that gives a number, or a number
  selection,  ///< a list of instance numbers, ranges and conditions
  box,        ///< two corners [[x, y, z], [x, y, z]], the lower first
  file,       ///< the path of a file, from the document's folder, whose content is read with the document
  object,     ///< a nested table
  list,       ///< a list of nested tables
  map,        ///< an object of names, with a nested table each
};

/// The way in which the points of a row are joined, for editors that draw them.
enum class PointsForm {
  line,        ///< joined in their order
  polygon,     ///< joined in their order, and the last to the first
  silhouette,  ///< pairs [distance from an axis, position along it], joined in their order: half of the visible outline
  apart,       ///< not joined
};
std::string_view points_form_name(PointsForm form);  ///< as it is spelt here: "line", "polygon", ...

/// The geometric role of a row, for editors with handles in space. Values are in metres (turns in degrees), in the
/// frame of the object that the row's table describes. Boxes and positions have a role by their kind.
enum class InSpace {
  none,
  position,   ///< position of the object
  shift,      ///< translation of everything that the table places
  turn,       ///< angles of its rotations about x, y and z
  direction,  ///< direction in which the object points; its length may matter
  radii,      ///< half of the size along x, y and z, around the position
  radius,     ///< radius around the direction, or around the vertical if there is no direction
  height,     ///< height above the position
  width,      ///< width of the square around the position
  profile,    ///< pairs [radius, height] above the root, revolved around the vertical
};
std::string_view in_space_name(InSpace what);  ///< as it is spelt here; empty for none

std::string_view kind_name(ParameterKind kind);  ///< as it is spelt here: "number", "integer", ...

/// A range from `low` to `high`, in document units. An end that is NaN is derived by usual_range (usual_range.h).
struct UsualSpan {
  double low = std::numeric_limits<double>::quiet_NaN();   ///< lower end; NaN: derived from the rest of the row
  double high = std::numeric_limits<double>::quiet_NaN();  ///< upper end; NaN: derived from the rest of the row
};

/// The range of a number. In a component every number may differ from instance to instance unless it is `fixed`.
struct NumberRange {
  Unit unit = Unit::none;                                 ///< unit in documents
  double min = -std::numeric_limits<double>::infinity();  ///< least allowed value, in document units
  double max = std::numeric_limits<double>::infinity();   ///< greatest allowed value, in document units
  UsualSpan usual{};       ///< the range of sliders; missing ends are derived from the rest of the row
  bool above_min = false;  ///< `min` itself is excluded
  bool fixed = false;      ///< one value for the whole component
  bool per_child = false;  ///< differs among the children of an instance, and not from instance to instance
  bool per_site = false;   ///< in a link, differs among the children; in a component, from instance to instance
  bool counts = false;     ///< counts parts; a number with a fraction gives the size of the last part
  bool timeless = false;   ///< describes the course of time, so it does not change with time
};

/// The clock that the keys of a parameter follow.
enum class KeyClock {
  none,      ///< the parameter has no keys
  document,  ///< the document's clock: all instances have one value
  instance,  ///< the clock of each instance
};

struct Parameter;

/// The functions for members of one type, in any struct. Made by table.h.
struct MemberType {
  /// Reads a document's value into the member. Reports faults to the reader.
  void (*read)(const Parameter& row, void* member, const Value& value, const DocumentPath& path,
               ParameterReader& reader);
  /// Returns the member as a document would write it; null if it is unset.
  Value (*show)(const Parameter& row, const void* member);
  /// Copies the member.
  void (*copy)(void* to, const void* from);
  /// Makes new structs in the member for the structs of `value`. Set for objects, lists and maps; null for other
  /// members.
  void (*make)(void* member, const Value& value) = nullptr;
  /// Returns the number of structs in the member; null for members that hold none.
  std::size_t (*count)(const void* member) = nullptr;
  /// Returns the struct with this index; null for members that hold none.
  void* (*element)(void* member, std::size_t index) = nullptr;
  std::string_view (*name)(const void* member, std::size_t index) = nullptr;  ///< name of a map's element
  /// Returns the index of the kind of an element of a list with several kinds; null for members with one kind.
  std::size_t (*kind)(const void* member, std::size_t index) = nullptr;
  /// Replaces an element by a new one of another kind; null for members with one kind.
  void (*make_kind)(void* member, std::size_t index, std::size_t kind) = nullptr;
};

/// One row of a table.
struct Parameter {
  std::string name;                            ///< key in documents
  std::string doc;                             ///< one sentence; says what a larger value does unless that is plain
  ParameterKind kind = ParameterKind::number;  ///< what the member is
  NumberRange form;                            ///< range of numbers, integers and the elements of vectors
  std::optional<NumberRange> second;           ///< range of the second numbers of points; unset: `form`
  std::vector<std::string> choices;            ///< the values of a choice
  std::size_t count = 0;                       ///< number of integers
  PointsForm together = PointsForm::line;      ///< how the points or positions are joined
  InSpace in_space = InSpace::none;            ///< role of the value in space, for grips of editors
  /// The table of an object, or of the elements of a list or map. A function, so that tables may contain themselves.
  const ParameterTable& (*nested)() = nullptr;
  const ElementKinds& (*kinds)() =
      nullptr;  ///< kinds of a list's elements, if there are several; `nested` then has the rows of all kinds
  std::vector<std::string> names;        ///< variables of a condition or formula
  void (*load_file)() = nullptr;         ///< a LoadAsset, which reads a file from its path
  void (*make_asset)() = nullptr;        ///< a TextAsset, which reads lines or the text of a file
  bool required = false;                 ///< true: a document must give it
  std::size_t offset = 0;                ///< bytes from the struct's beginning to the member
  const MemberType* type = nullptr;      ///< the member's type
  std::shared_ptr<const void> original;  ///< a struct with the defaults

  /// Stores `value` into the struct at `object`, or reports faults.
  void read(void* object, const Value& value, const DocumentPath& path, ParameterReader& reader) const;
  /// Returns the struct's value as a document would write it; null if unset.
  Value show(const void* object) const;
  /// Returns the default as a document would write it.
  Value fallback() const;
  /// Returns the table for the element with this index of an object, list or map.
  const ParameterTable& table_of(const void* member, std::size_t index) const;

  /// Returns true if its numbers may differ from instance to instance, or from child to child, when it belongs to a
  /// component.
  bool may_vary() const;
  /// Returns the clock that its keys follow, in a component or elsewhere.
  KeyClock key_clock(bool in_component) const;
  /// Returns true if keys have values between them, and false if values can only jump.
  bool has_values_between() const;

  /// Returns the expected value as text: "a number of metres above 0, at most 10".
  std::string expectation() const;
};

/// The rows of one struct. Made with Table<P> in table.h.
class ParameterTable {
 public:
  std::string name;                              ///< name of the struct in messages and in the schema
  std::string doc;                               ///< one sentence
  std::vector<Parameter> parameters;             ///< rows in their order
  std::vector<std::string> elsewhere;            ///< further keys, which the caller reads itself ("type")
  std::string shorthand;                         ///< the parameter that a bare value sets, or empty
  std::vector<std::vector<std::string>> one_of;  ///< groups of parameters; exactly one of each group must be given
  /// A rule that a parameter requires another one, or excludes it.
  struct Company {
    std::string parameter;  ///< name of the parameter
    std::string other;      ///< name of the other parameter
    bool is_wanted = true;  ///< true: allowed only beside the other; false: never
  };
  std::vector<Company> company;  ///< rules on which parameters stand together
  /// Parameters that have an effect only under a condition: a choice that they belong to, or an object that they serve.
  /// If they are given without it, they are faults, whatever their values.
  struct Meaning {
    /// The condition: a parameter that is given, or that has one of these values, given or by default.
    struct Giver {
      std::string parameter;        ///< name of the parameter
      std::vector<Value> values{};  ///< values that give a meaning; empty: any value
    };
    std::vector<std::string> parameters;  ///< parameters, also of nested tables, as in "resource.pass_back"
    std::vector<Giver> givers;            ///< any one of them is sufficient
    std::string reason{};                 ///< explanation, if there is no giver
  };
  std::vector<Meaning> meanings;  ///< rules on parameters that have an effect only under a condition
  /// Rules between parameters; called when all of them could be read.
  std::function<void(const void* object, const DocumentPath& path, ParameterReader& reader)> check;
  /// Computes values that depend on several parameters. Called after the rules, if they hold.
  std::function<void(void* object, const DocumentPath& path, ParameterReader& reader)> prepare;
  std::shared_ptr<const void> original;  ///< a struct with the defaults

  /// Returns the defaults as documents write them.
  std::vector<Value> defaults() const;
  /// Returns a struct as documents write it.
  Value show(const void* object) const;
  /// Adds a row for the member of this type at this byte offset into the struct.
  Parameter& add(ParameterKind kind, std::string_view row_name, std::string_view row_doc, std::size_t offset,
                 const MemberType& type);
  /// Adds the rows of the table of a part of the struct that begins at this byte offset. Copies the rules on company,
  /// but not the check.
  void add_rows(const ParameterTable& table, std::size_t offset);

  /// Removes the rows with these names. A meaning without givers gives the reason in messages.
  void leave_out(std::vector<std::string> rows, std::string reason);

  /// Returns the row of this name, or null.
  const Parameter* find(std::string_view parameter) const;
  std::vector<std::string> names() const;  ///< names of the rows, in their order
  /// Returns the reason why this table has no such parameter although similar tables have one. Null if there is no
  /// reason.
  const std::string* reason_without(std::string_view parameter) const;
  /// Returns true if a row below, at any depth, has this table again.
  bool contains_itself() const;
  /// Reports where the struct at `object`, or one that it holds at any depth, breaks the rules of its table.
  void check_all(const void* object, const DocumentPath& path, ParameterReader& reader) const;
};

/// The rows of a table that a value gave, each once, in the value's order. The table must outlive this object.
class GivenRows {
 public:
  /// Adds a row, which must outlive this object.
  void add(const Parameter& row) { rows_.push_back(&row); }
  bool is_empty() const { return rows_.empty(); }     ///< true if no row was given
  std::size_t count() const { return rows_.size(); }  ///< number of given rows
  /// Returns true if the row of this name was given.
  bool contains(std::string_view row) const;
  /// Copies the members of these rows from one struct of the table to another.
  void copy(const void* from, void* to) const;
  bool operator==(const GivenRows&) const = default;

 private:
  std::vector<const Parameter*> rows_;
};

}  // namespace meristem
