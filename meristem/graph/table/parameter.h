// SPDX-License-Identifier: Apache-2.0
// Parameter tables: what a struct of parameters is called, measured in, bounded by, and means, written once. Reading,
// checking, the JSON Schema, the command line's `components`, and every later editor are driven by the table alone.
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

struct Kinds;
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
  facing,     ///< three numbers that say a direction, or "surface"
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

/// What the points of a row are together, for editors that draw them.
enum class PointsForm {
  line,        ///< joined in their order
  polygon,     ///< joined in their order, and the last to the first
  silhouette,  ///< pairs [distance from an axis, position along it], joined in their order: half of what is seen
  apart,       ///< not joined
};
std::string_view points_form_name(PointsForm form);  ///< as it is spelt here: "line", "polygon", ...

/// What a row says of space, for editors with handles in it: in metres (turns: degrees), in the frame of whatever the
/// row's table belongs to. Boxes and positions say so by their kind.
enum class InSpace {
  none,
  position,   ///< where the table's thing stands
  shift,      ///< how far all that the table places is moved
  turn,       ///< angles of its turns about x, y and z
  direction,  ///< where it points; its length may count
  radii,      ///< half of its size along x, y and z, from its position
  radius,     ///< about its direction, or about the vertical where it has none
  height,     ///< upward from its position
  width,      ///< of the square around its position
  profile,    ///< pairs [radius, height] above its root, turned about the vertical
};
std::string_view in_space_name(InSpace what);  ///< as it is spelt here; empty for none

std::string_view kind_name(ParameterKind kind);  ///< as it is spelt here: "number", "integer", ...

/// From `low` to `high`, in document units; an end that is NaN is left to usual_range (usual_range.h).
struct UsualSpan {
  double low = std::numeric_limits<double>::quiet_NaN();   ///< NaN: follows from the rest of the row
  double high = std::numeric_limits<double>::quiet_NaN();  ///< NaN: follows from the rest of the row
};

/// The range of a number. In a component every number may differ from instance to instance unless it is `fixed`.
struct NumberRange {
  Unit unit = Unit::none;                                 ///< unit in documents
  double min = -std::numeric_limits<double>::infinity();  ///< least allowed value, in document units
  double max = std::numeric_limits<double>::infinity();   ///< greatest allowed value, in document units
  UsualSpan usual{};       ///< where people move it, which sliders show; what is not given follows from the rest
  bool above_min = false;  ///< `min` itself is excluded
  bool fixed = false;      ///< one value for the whole component
  bool per_child = false;  ///< differs among the children of an instance, and not from instance to instance
  bool per_site = false;   ///< in a link, differs among the children; in a component, from instance to instance
  bool counts = false;     ///< counts parts; of a number with a fraction, the last part has come to be so far
  bool timeless = false;   ///< says how time runs, and so does not change with it
};

/// Whose time the keys of a parameter follow.
enum class KeyClock {
  none,      ///< it has no keys
  document,  ///< the document's: it is one value for all instances
  instance,  ///< that of each instance
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
  /// Puts new structs for what `value` says into the member, where it holds structs with tables of their own, as
  /// objects, lists and maps do; null for other members.
  void (*make)(void* member, const Value& value) = nullptr;
  /// Returns how many structs the member holds; null for members that hold none.
  std::size_t (*count)(const void* member) = nullptr;
  /// Returns the struct with this index; null for members that hold none.
  void* (*element)(void* member, std::size_t index) = nullptr;
  std::string_view (*name)(const void* member, std::size_t index) = nullptr;  ///< name of a map's element
  /// Which kind an element of a list with several kinds is, and how it becomes a new element of another kind.
  std::size_t (*kind)(const void* member, std::size_t index) = nullptr;
  /// Replaces an element by a new one of another kind; null for members with one kind.
  void (*make_kind)(void* member, std::size_t index, std::size_t kind) = nullptr;
};

/// One row of a table.
struct Parameter {
  std::string name;  ///< key in documents
  std::string doc;   ///< one sentence, with what happens when the value is raised where that is not plain
  ParameterKind kind = ParameterKind::number;  ///< what the member is
  NumberRange form;                            ///< range of numbers, integers and the elements of vectors
  std::optional<NumberRange> second;           ///< range of the second numbers of points; unset: `form`
  std::vector<std::string> choices;            ///< the values of a choice
  std::size_t count = 0;                       ///< number of integers
  PointsForm together = PointsForm::line;      ///< what points or positions are together
  InSpace in_space = InSpace::none;            ///< role of the value in space, for grips of editors
  /// The table of an object, or of the elements of a list or map. A function, so that tables may contain themselves.
  const ParameterTable& (*nested)() = nullptr;
  const Kinds& (*kinds)() =
      nullptr;  ///< the kinds of a list's elements where there are several; `nested` has the rows of all
  std::vector<std::string> names;        ///< variables of a condition or formula
  void (*load_file)() = nullptr;         ///< a LoadAsset, which reads a file from its path
  void (*make_asset)() = nullptr;        ///< a TextAsset, which reads lines or the text of a file
  bool required = false;                 ///< true: a document must give it
  std::size_t offset = 0;                ///< bytes from the struct's beginning to the member
  const MemberType* type = nullptr;      ///< the member's type
  std::shared_ptr<const void> original;  ///< a struct with the defaults

  /// Stores what `value` says into the struct at `object`, or reports faults.
  void read(void* object, const Value& value, const DocumentPath& path, ParameterReader& reader) const;
  /// What the struct holds as a document would write it; null where unset.
  Value show(const void* object) const;
  /// The default as a document would write it.
  Value fallback() const;
  /// The table for the element with this index of the member of an object, list or map.
  const ParameterTable& table_of(const void* member, std::size_t index) const;

  /// Whether its numbers may differ from instance to instance, or from child to child, where it stands in a component.
  bool may_vary() const;
  /// Whose time its keys follow, where it stands in a component or elsewhere.
  KeyClock key_clock(bool in_component) const;
  /// Whether keys pass from one value to the next, or can only jump.
  bool has_values_between() const;

  /// "a number of metres above 0, at most 10".
  std::string expectation() const;
};

/// The rows of one struct. Made with Table<P> in table.h.
class ParameterTable {
 public:
  std::string name;                              ///< what messages and the schema call the struct
  std::string doc;                               ///< one sentence
  std::vector<Parameter> parameters;             ///< rows in their order
  std::vector<std::string> elsewhere;            ///< further keys, which the caller reads itself ("type")
  std::string shorthand;                         ///< the parameter that a bare value sets, or empty
  std::vector<std::vector<std::string>> one_of;  ///< groups of parameters; exactly one of each group must be given
  /// A parameter that stands only beside another, or never beside it.
  struct Company {
    std::string parameter;  ///< name of the parameter
    std::string other;      ///< name of the other parameter
    bool is_wanted = true;  ///< true: stands only beside the other; false: never
  };
  std::vector<Company> company;  ///< rules on which parameters stand together
  /// Parameters that mean something only where something else does: the choice that they belong to, the object that
  /// they serve. Where they are given without, they are faults, whatever their values.
  struct Meaning {
    /// A parameter that is given, or that has one of these values, given or not.
    struct Giver {
      std::string parameter;        ///< name of the parameter
      std::vector<Value> values{};  ///< values that give a meaning; empty: any value
    };
    std::vector<std::string> parameters;  ///< parameters, also of nested tables, as in "resource.pass_back"
    std::vector<Giver> givers;            ///< any of them will do
    std::string reason{};                 ///< what is so instead, where nothing gives them a meaning
  };
  std::vector<Meaning> meanings;  ///< rules on where parameters mean something
  /// Rules between parameters; called when all of them could be read.
  std::function<void(const void* object, const DocumentPath& path, ParameterReader& reader)> check;
  /// Works out what follows from several parameters; called after the rules, once they hold.
  std::function<void(void* object, const DocumentPath& path, ParameterReader& reader)> prepare;
  std::shared_ptr<const void> original;  ///< a struct with the defaults

  /// The defaults, as documents write them.
  std::vector<Value> defaults() const;
  /// A struct as documents write it.
  Value show(const void* object) const;
  /// A row for the member of this type at this byte offset into the struct.
  Parameter& add(ParameterKind kind, std::string_view row_name, std::string_view row_doc, std::size_t offset,
                 const MemberType& type);
  /// The rows of the table of a part of the struct that begins at this byte offset, and what it says of their
  /// company; its rules stay behind.
  void add_rows(const ParameterTable& table, std::size_t offset);

  /// Rows of these names go; a meaning without givers tells the reason.
  void leave_out(std::vector<std::string> rows, std::string reason);

  /// Returns the row of this name, or null.
  const Parameter* find(std::string_view parameter) const;
  std::vector<std::string> names() const;  ///< names of the rows, in their order
  /// Why it has no such parameter where others of its kind have one; null where that is not known.
  const std::string* reason_without(std::string_view parameter) const;
  /// Whether a row below, at any depth, has this table again.
  bool contains_itself() const;
  /// Reports where the struct at `object`, or one that it holds at any depth, breaks the rules of its table.
  void check_all(const void* object, const DocumentPath& path, ParameterReader& reader) const;
};

/// The rows of a table that a value gave, each once, in the value's order. The table outlives it.
class GivenRows {
 public:
  /// Adds a row, which must outlive this object.
  void add(const Parameter& row) { rows_.push_back(&row); }
  bool is_empty() const { return rows_.empty(); }     ///< true if no row was given
  std::size_t count() const { return rows_.size(); }  ///< number of given rows
  /// Returns true if the row of this name was given.
  bool contains(std::string_view row) const;
  /// Copies what these rows are of from one struct of the table's into another.
  void copy(const void* from, void* to) const;
  bool operator==(const GivenRows&) const = default;

 private:
  std::vector<const Parameter*> rows_;
};

}  // namespace meristem
