// SPDX-License-Identifier: Apache-2.0
// The forms of values in messages, as data. A form states which JSON values are valid, and a record lists the members
// of an object. The reader, the checks, the reference page and the types of the page are made from them.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

struct Record;
/// Returns a record, which lives as long as the program.
using RecordFunction = const Record& (*)();

inline constexpr double kMaxWhole = 9007199254740992;  ///< doubles hold all whole numbers up to here
inline constexpr std::size_t kMaxParts = 100'000;      ///< usual maximum size of a list or a map

/// The range of a number. The ends belong to the range.
struct Span {
  double min = -std::numeric_limits<double>::infinity();  ///< smallest valid number
  double max = std::numeric_limits<double>::infinity();   ///< largest valid number
  Unit unit = Unit::none;                                 ///< unit of the number
};

/// The form of a JSON value.
struct Form {
  enum class Kind {
    any,     ///< any JSON value
    flag,    ///< true or false
    number,  ///< a finite number within `span`
    whole,   ///< a whole number within `span`
    text,    ///< a text
    choice,  ///< one of the texts `names`
    list,    ///< a list whose elements have the form parts[0]
    tuple,   ///< a list with one element per form in `parts`; `names` has a name for each
    map,     ///< an object with any members, whose values have the form parts[0]
    record,  ///< an object with the members of records[0]
    kinds,   ///< an object of one of `records`; the first member of each record identifies it
  };
  Kind kind = Kind::any;
  Span span{};
  std::size_t min_size = 0;          ///< minimum size of a list or map
  std::size_t max_size = kMaxParts;  ///< maximum size of a list or map
  std::vector<std::string> names{};
  std::vector<Form> parts{};
  std::vector<RecordFunction> records{};
  bool or_null = false;  ///< true: null is valid too
};

/// A member of an object.
struct Member {
  std::string name;                 ///< name in messages
  Form form;                        ///< form of its value
  std::string doc;                  ///< meaning; for optional members also the effect of leaving it out
  bool is_required = true;          ///< false: the member may be missing
  std::optional<Value> fallback{};  ///< value that a missing member stands for, if there is one
  /// Stores a valid value into the struct at `object`. Empty for members that are only written. Throws a Refusal for
  /// values that break rules beyond the form.
  std::function<void(void* object, const Value& value, const DocumentPath& path)> store{};
};

/// The members of an object, and the rules between them.
struct Record {
  std::string name;  ///< name of the type of the page
  std::string doc;   ///< one sentence
  std::vector<Member> members{};

  /// Another record whose members belong to the object too.
  struct Part {
    RecordFunction record = nullptr;
    bool is_optional = false;  ///< true: all of them may be missing
  };
  std::vector<Part> parts{};
  std::vector<std::vector<std::string>> one_of{};  ///< of each group, exactly one member is given
  /// If the member has this value, all other members of this record are missing.
  std::optional<std::pair<std::string, Value>> alone{};
  /// Returns what is wrong with the struct that was read from `value`, or an empty text.
  std::function<std::string(const void* object, const Value& value)> rule{};

  /// Returns the member with this name, including the members of parts. Returns null if there is no such member.
  const Member* find(std::string_view member) const;
  /// Returns the names of all members, including the members of parts.
  std::vector<std::string> names() const;
};

/// Functions that return forms.
namespace forms {

Form any();
Form flag();
Form number(Span span = {});
/// Returns the form of whole numbers from 0 to kMaxWhole, or in a smaller range.
Form whole(Span span = {.min = 0, .max = kMaxWhole});
Form text();
Form choice(std::vector<std::string> names);
Form list(Form element, std::size_t max_size = kMaxParts, std::size_t min_size = 0);
/// Returns the form of a list with named elements: `tuple({{"at", whole()}, {"text", text()}})`.
Form tuple(const std::vector<std::pair<std::string, Form>>& parts);
Form map(Form value, std::size_t max_size = kMaxParts);
Form record(RecordFunction record);
Form kinds(std::vector<RecordFunction> records);
/// Returns `form`, for values that may also be null.
Form or_null(Form form);
/// Returns the form of [x, y, z].
Form vector(Span span = {});
/// Returns the form of an array in a packet: [first byte, counted from the first array, number of elements].
Form array();

}  // namespace forms

}  // namespace meristem::studio
