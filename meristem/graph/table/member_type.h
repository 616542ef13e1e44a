// SPDX-License-Identifier: Apache-2.0
// Functions on members of each type that a row may have: one overload of read_value and of show_value per type. If a
// type serves several kinds (a Vec3 is a vector or a colour), the row's kind selects one.
#pragma once

#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/count.h"
#include "meristem/graph/table/facing.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/selection.h"

namespace meristem {

/// Makes an asset from a file, or throws InputError.
template <class T>
using LoadAsset = T (*)(const std::string& file_path, const SizeLimits& limits);
/// Makes an asset from a text. `path` is the path of the file, or a path in the document's folder if the text is in the
/// document.
template <class T>
using TextAsset = T (*)(const std::string& text, const std::string& file_path, ParameterReader& reader,
                        std::vector<Diagnostic>& warnings);

/// The type within an optional, or the type itself.
template <class M>
struct ValueOfMember {
  using Type = M;  ///< the type without `optional`
};
template <class M>
struct ValueOfMember<std::optional<M>> {
  using Type = M;
};
/// The type of a member's value: the type within an optional, or the type itself.
template <class M>
using ValueOf = typename ValueOfMember<M>::Type;

/// Reads a document's value into a member of the row's struct. Reports errors to the reader, at the path. After an
/// error, the member may be partly changed.
void read_value(const Parameter&, bool& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, std::string& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, PerChild& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, PartCount& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, Vec3& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, DVec3& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, FacingDirection& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, Box& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, Curve& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, std::vector<Vec2>& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, std::vector<Vec3>& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, std::vector<int>& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, InstanceSelection& member, const Value&, const DocumentPath&, ParameterReader&);
void read_value(const Parameter&, ParameterFormula& member, const Value&, const DocumentPath&, ParameterReader&);

/// Returns a member as a document would write it; null if it is unset. Numbers are in document units and are rounded to
/// 7 digits. Lists of whole numbers are exact.
Value show_value(const Parameter&, bool member);
Value show_value(const Parameter&, const std::string& member);
Value show_value(const Parameter&, const PerChild& member);
Value show_value(const Parameter&, const PartCount& member);
Value show_value(const Parameter&, const Vec3& member);
Value show_value(const Parameter&, const DVec3& member);
Value show_value(const Parameter&, const FacingDirection& member);
Value show_value(const Parameter&, const Box& member);
Value show_value(const Parameter&, const Curve& member);
Value show_value(const Parameter&, const std::vector<Vec2>& member);
Value show_value(const Parameter&, const std::vector<Vec3>& member);
Value show_value(const Parameter&, const std::vector<int>& member);
Value show_value(const Parameter&, const InstanceSelection& member);
Value show_value(const Parameter&, const ParameterFormula& member);

/// Returns a number of the struct in document units, rounded to 7 digits.
Value show_number(const Parameter&, double number);

/// Writes to a member of type M, which is a number or an optional one.
template <class M>
void store_in(void* member, double number) {
  if constexpr (std::is_integral_v<ValueOf<M>>) number = std::floor(number + 0.5);
  *static_cast<M*>(member) = static_cast<ValueOf<M>>(number);
}

template <class M>
requires std::is_arithmetic_v<ValueOf<M>>
void read_value(const Parameter& row, M& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const Value present = show_value(row, member);
  reader.numbers().store(row, value, path, {&member, store_in<M>, present.is_null() ? 0 : *present.number()});
}

template <class N>
requires std::is_arithmetic_v<N> Value show_value(const Parameter& row, N member) {
  return show_number(row, static_cast<double>(member));
}

template <class E>
requires std::is_enum_v<E>
void read_value(const Parameter& row, E& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (const auto given = reader.choice(row, value, path)) member = static_cast<E>(*given);
}
template <class E>
requires std::is_enum_v<E> Value show_value(const Parameter& row, E member) {
  return row.choices[static_cast<std::size_t>(member)];
}

template <class T>
requires std::is_class_v<T>
void read_value(const Parameter& row, std::optional<T>& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  read_value(row, member.emplace(T{}), value, path, reader);
}
template <class T>
Value show_value(const Parameter& row, const std::optional<T>& member) {
  return member ? show_value(row, *member) : Value();
}

template <class T>
void read_value(const Parameter& row, Asset<T>& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (row.load_file != nullptr) {
    return reader.files().read(row, value, path, [&](const std::string& file_path) {
      const auto load = reinterpret_cast<LoadAsset<T>>(row.load_file);
      member = {*value.text(), reader.files().kept_file<T>(file_path, load)};
    });
  }
  const auto make = [&](const std::string& text, const std::string& file_path, std::vector<Diagnostic>& warnings) {
    const auto read = reinterpret_cast<TextAsset<T>>(row.make_asset);
    const std::string& written = row.kind == ParameterKind::lines ? text : *value.text();
    member = {written, reader.kept_text<T>(text, file_path, warnings, read)};
  };
  if (row.kind == ParameterKind::lines) return reader.files().read_lines(row, value, path, make);
  reader.files().read_text_file(row, value, path, make);
}
template <class T>
Value show_value(const Parameter&, const Asset<T>& member) {
  return member ? Value(member.path) : Value();
}

/// Like read_value(), for a member behind a pointer.
template <class M>
void read_member(const Parameter& row, void* member, const Value& value, const DocumentPath& path,
                 ParameterReader& reader) {
  read_value(row, *static_cast<M*>(member), value, path, reader);
}
/// Like show_value(), for a member behind a pointer.
template <class M>
Value show_member(const Parameter& row, const void* member) {
  return show_value(row, *static_cast<const M*>(member));
}
/// Copies a member of type M.
template <class M>
void copy_member(void* to, const void* from) {
  *static_cast<M*>(to) = *static_cast<const M*>(from);
}
/// The functions for members of type M.
template <class M>
inline constexpr MemberType kMemberType{read_member<M>, show_member<M>, copy_member<M>};

/// Makes and finds the structs that a member holds. A member holds one struct, an optional struct, a list or a map.
template <class T>
struct HeldStructs {
  /// Makes as many new structs in the member as `value` has.
  static void make(T&, const Value&) {}
  /// Returns the number of structs in the member.
  static std::size_t count(const T&) { return 1; }
  /// Returns the struct with this index.
  static void* element(T& member, std::size_t) { return &member; }
};
template <class T>
struct HeldStructs<std::optional<T>> {
  static void make(std::optional<T>& member, const Value&) { member.emplace(); }
  static std::size_t count(const std::optional<T>& member) { return member ? 1 : 0; }
  static void* element(std::optional<T>& member, std::size_t) { return &*member; }
};
template <class T>
struct HeldStructs<std::vector<T>> {
  static void make(std::vector<T>& member, const Value& value) { member.assign(value.list()->size(), T{}); }
  static std::size_t count(const std::vector<T>& member) { return member.size(); }
  static void* element(std::vector<T>& member, std::size_t index) { return &member[index]; }
};
template <class... T>
struct HeldStructs<std::vector<std::variant<T...>>> {
  using List = std::vector<std::variant<T...>>;  ///< the type of the member
  static void make(List& member, const Value& value) { member.assign(value.list()->size(), {}); }
  static std::size_t count(const List& member) { return member.size(); }
  static void* element(List& member, std::size_t index) {
    return std::visit([](auto& one) { return static_cast<void*>(&one); }, member[index]);
  }
  /// Returns the index of an element's kind among the alternatives.
  static std::size_t kind(const List& member, std::size_t index) { return member[index].index(); }
  /// Replaces an element by a new one of another kind.
  static void make_kind(List& member, std::size_t index, std::size_t kind) {
    const auto make = [&]<std::size_t... K>(std::index_sequence<K...>) {
      ((K == kind ? static_cast<void>(member[index].template emplace<K>()) : static_cast<void>(0)), ...);
    };
    make(std::index_sequence_for<T...>());
  }
};
template <class T>
struct HeldStructs<std::vector<std::pair<std::string, T>>> {
  using Map = std::vector<std::pair<std::string, T>>;  ///< the type of the member
  static void make(Map& member, const Value& value) {
    member.clear();
    for (const Value::Member& given : *value.object()) member.emplace_back(given.first, T{});
  }
  static std::size_t count(const Map& member) { return member.size(); }
  static void* element(Map& member, std::size_t index) { return &member[index].second; }
  /// Returns the name of an element.
  static std::string_view name(const Map& member, std::size_t index) { return member[index].first; }
};

/// Reads a member that holds structs of any type.
void read_held(const Parameter&, void* member, const Value&, const DocumentPath&, ParameterReader&);
/// Returns the structs that a member holds as a document would write them.
Value show_held(const Parameter&, const void* member);

/// Returns the functions for a member of type M that holds structs.
template <class M>
constexpr MemberType holder_type() {
  MemberType type{read_held, show_held, copy_member<M>};
  type.make = [](void* member, const Value& value) { HeldStructs<M>::make(*static_cast<M*>(member), value); };
  type.count = [](const void* member) { return HeldStructs<M>::count(*static_cast<const M*>(member)); };
  type.element = [](void* member, std::size_t index) {
    return HeldStructs<M>::element(*static_cast<M*>(member), index);
  };
  if constexpr (requires(const M& map) { HeldStructs<M>::name(map, 0); }) {
    type.name = [](const void* member, std::size_t index) {
      return HeldStructs<M>::name(*static_cast<const M*>(member), index);
    };
  }
  if constexpr (requires(const M& list) { HeldStructs<M>::kind(list, 0); }) {
    type.kind = [](const void* member, std::size_t index) {
      return HeldStructs<M>::kind(*static_cast<const M*>(member), index);
    };
    type.make_kind = [](void* member, std::size_t index, std::size_t kind) {
      HeldStructs<M>::make_kind(*static_cast<M*>(member), index, kind);
    };
  }
  return type;
}
/// The functions for members of type M that hold structs.
template <class M>
inline constexpr MemberType kHolderType = holder_type<M>();

}  // namespace meristem
