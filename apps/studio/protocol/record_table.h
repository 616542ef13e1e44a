// SPDX-License-Identifier: Apache-2.0
// Describes the members of a message, in the way of parameter tables (meristem/graph/table/table.h). For example:
//
//   const Record& sweep_members() {
//     static const Record record =
//         RecordTable<SweepRequest>("SweepRequest", "Measures the plant for each of several values.")
//             .text("path", &SweepRequest::path, "Path of a variable or a number.")
//             .flag("light", &SweepRequest::light, "True: also measures the light on organs.")
//             .or_default();
//     return record;
//   }
//
// Members are found by pointers to members, or by functions that return a reference into the struct. A member with an
// optional<> may be missing or null; the others are required unless `optional` or `or_default` follows. Messages that
// are only written have a WrittenRecord.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "meristem/base/vec.h"
#include "protocol/check.h"
#include "protocol/form.h"

namespace meristem::studio {

// The functions below store a value whose form was checked.

inline void store_value(bool& member, const Value& value) { member = *value.boolean(); }
inline void store_value(std::string& member, const Value& value) { member = *value.text(); }
inline void store_value(Value& member, const Value& value) { member = value; }
template <class Number>
requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) void store_value(Number& member,
                                                                                         const Value& value) {
  member = static_cast<Number>(*value.number());
}
inline void store_value(Vec3& member, const Value& value) {
  for (int axis = 0; axis < 3; ++axis)
    member[axis] = static_cast<float>(*(*value.list())[static_cast<std::size_t>(axis)].number());
}
template <class T>
void store_value(std::optional<T>& member, const Value& value) {
  store_value(member.emplace(), value);
}
template <class T>
void store_value(std::vector<T>& member, const Value& value) {
  for (const Value& element : *value.list()) store_value(member.emplace_back(), element);
}
template <class T>
void store_value(std::vector<std::pair<std::string, T>>& member, const Value& value) {
  for (const auto& [name, element] : *value.object()) store_value(member.emplace_back(name, T{}).second, element);
}

/// Stores an object of one of several kinds. The records of the form have the order of the alternatives.
template <class... Structs>
void store_kind(std::variant<Structs...>& member, const Form& form, const Value& object, const DocumentPath& path) {
  const std::size_t index = kind_index(form, object);
  const auto store = [&]<std::size_t... K>(std::index_sequence<K...>) {
    ((K == index ? store_record(form.records[K](), &member.template emplace<K>(), object, path) : void()), ...);
  };
  store(std::index_sequence_for<Structs...>());
}

/// T for T and for an optional<T>.
template <class T>
struct Unwrapped {
  using Type = T;
  static constexpr bool kIsOptional = false;
};
template <class T>
struct Unwrapped<std::optional<T>> {
  using Type = T;
  static constexpr bool kIsOptional = true;
};

/// Describes an object that is read into a struct P, whose defaults are the defaults of the members.
template <class P>
class RecordTable {
 public:
  RecordTable(std::string name, std::string doc) : record_{.name = std::move(name), .doc = std::move(doc)} {}

  template <class Access>
  RecordTable&& flag(std::string name, Access access, std::string doc) && {
    static_assert(std::is_same_v<ValueOf<Access>, bool>);
    return std::move(*this).member(std::move(name), forms::flag(), access, std::move(doc));
  }
  template <class Access>
  RecordTable&& number(std::string name, Access access, Span span, std::string doc) && {
    static_assert(std::is_floating_point_v<ValueOf<Access>>);
    return std::move(*this).member(std::move(name), forms::number(span), access, std::move(doc));
  }
  template <class Access>
  RecordTable&& whole(std::string name, Access access, Span span, std::string doc) && {
    static_assert(std::is_arithmetic_v<ValueOf<Access>> && !std::is_same_v<ValueOf<Access>, bool>);
    return std::move(*this).member(std::move(name), forms::whole(span), access, std::move(doc));
  }
  template <class Access>
  RecordTable&& text(std::string name, Access access, std::string doc) && {
    static_assert(std::is_same_v<ValueOf<Access>, std::string>);
    return std::move(*this).member(std::move(name), forms::text(), access, std::move(doc));
  }
  template <class Access>
  RecordTable&& any(std::string name, Access access, std::string doc) && {
    static_assert(std::is_same_v<ValueOf<Access>, Value>);
    return std::move(*this).member(std::move(name), forms::any(), access, std::move(doc));
  }
  /// Adds a point or a direction [x, y, z].
  template <class Access>
  RecordTable&& vector(std::string name, Access access, Span span, std::string doc) && {
    static_assert(std::is_same_v<ValueOf<Access>, Vec3>);
    return std::move(*this).member(std::move(name), forms::vector(span), access, std::move(doc));
  }
  /// Adds a list or a map of plain values. `form` must be the form of the member's type.
  template <class Access>
  RecordTable&& several(std::string name, Form form, Access access, std::string doc) && {
    return std::move(*this).member(std::move(name), std::move(form), access, std::move(doc));
  }
  /// Adds a value of an enum by its names.
  template <class Access>
  RecordTable&& choice(
      std::string name, Access access,
      std::vector<
          std::pair<std::string, typename Unwrapped<std::remove_reference_t<std::invoke_result_t<Access, P&>>>::Type>>
          choices,
      std::string doc) && {
    std::vector<std::string> names;
    for (const auto& [choice, value] : choices) names.push_back(choice);
    add<Access>(std::move(name), forms::choice(std::move(names)), std::move(doc)).store =
        [access, choices = std::move(choices)](void* object, const Value& value, const DocumentPath&) {
          for (const auto& [choice, enumerator] : choices) {
            if (*value.text() == choice) std::invoke(access, *static_cast<P*>(object)) = enumerator;
          }
        };
    return std::move(*this);
  }
  /// Adds a nested struct, or an optional one.
  template <class Access>
  RecordTable&& record(std::string name, Access access, RecordFunction nested, std::string doc) && {
    add<Access>(std::move(name), forms::record(nested), std::move(doc)).store =
        [access, nested](void* object, const Value& value, const DocumentPath& path) {
          auto& member = std::invoke(access, *static_cast<P*>(object));
          if constexpr (Unwrapped<std::remove_reference_t<decltype(member)>>::kIsOptional) {
            store_record(nested(), &member.emplace(), value, path);
          } else {
            store_record(nested(), &member, value, path);
          }
        };
    return std::move(*this);
  }
  /// Adds a required member that `store` stores into the struct. `store` may throw a Refusal.
  RecordTable&& read(std::string name, Form form, void (*store)(P&, const Value&, const DocumentPath&),
                     std::string doc) && {
    record_.members.push_back({.name = std::move(name), .form = std::move(form), .doc = std::move(doc)});
    record_.members.back().store = [store](void* object, const Value& value, const DocumentPath& path) {
      store(*static_cast<P*>(object), value, path);
    };
    return std::move(*this);
  }
  /// Allows the last member to be missing or null. The struct's default is then kept.
  RecordTable&& optional() && {
    record_.members.back().is_required = false;
    record_.members.back().form.or_null = true;
    return std::move(*this);
  }
  /// Like optional(). The struct's default belongs to the description: `written`, or the default as a message writes
  /// it.
  RecordTable&& or_default(std::optional<Value> written = {}) && {
    record_.members.back().fallback = written ? std::move(written) : default_;
    return std::move(*this).optional();
  }
  /// Sets a rule between members. It returns what is wrong, as in "needs a picture or a text", or an empty text.
  RecordTable&& rule(std::string (*check)(const P&, const Value& object)) && {
    record_.rule = [check](const void* object, const Value& value) {
      return check(*static_cast<const P*>(object), value);
    };
    return std::move(*this);
  }

  /// Finishes the record.
  operator Record() && {  // NOLINT(google-explicit-constructor): the builder ends as what it builds
    return std::move(record_);
  }

 private:
  template <class Access>
  using ValueOf = typename Unwrapped<std::remove_reference_t<std::invoke_result_t<Access, P&>>>::Type;

  template <class Access>
  Member& add(std::string name, Form form, std::string doc) {
    constexpr bool kIsOptional = Unwrapped<std::remove_reference_t<std::invoke_result_t<Access, P&>>>::kIsOptional;
    form.or_null = form.or_null || kIsOptional;
    record_.members.push_back(
        {.name = std::move(name), .form = std::move(form), .doc = std::move(doc), .is_required = !kIsOptional});
    return record_.members.back();
  }
  /// Notes the default of the last member if it is a flag or a number.
  template <class Access>
  void note_default(Access access) {
    P original;
    const auto& member = std::invoke(access, original);
    using M = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_same_v<M, bool>) {
      default_ = Value(member);
    } else if constexpr (std::is_arithmetic_v<M>) {
      default_ = Value(static_cast<double>(member));
    } else {
      default_.reset();
    }
  }
  template <class Access>
  RecordTable&& member(std::string name, Form form, Access access, std::string doc) && {
    add<Access>(std::move(name), std::move(form), std::move(doc)).store = [access](void* object, const Value& value,
                                                                                   const DocumentPath&) {
      store_value(std::invoke(access, *static_cast<P*>(object)), value);
    };
    note_default(access);
    return std::move(*this);
  }

  Record record_;
  std::optional<Value> default_;  // default of the last member
};

/// Describes an object that the server writes.
class WrittenRecord {
 public:
  WrittenRecord(std::string name, std::string doc) : record_{.name = std::move(name), .doc = std::move(doc)} {}

  /// Adds a member that is always there.
  WrittenRecord&& member(std::string name, Form form, std::string doc) && {
    record_.members.push_back({.name = std::move(name), .form = std::move(form), .doc = std::move(doc)});
    return std::move(*this);
  }
  /// Adds a member that may be missing.
  WrittenRecord&& optional(std::string name, Form form, std::string doc) && {
    record_.members.push_back(
        {.name = std::move(name), .form = std::move(form), .doc = std::move(doc), .is_required = false});
    return std::move(*this);
  }
  /// Adds the members of another record.
  WrittenRecord&& with(RecordFunction part) && {
    record_.parts.push_back({.record = part});
    return std::move(*this);
  }
  /// Adds the members of another record, which may be missing as a whole.
  WrittenRecord&& or_without(RecordFunction part) && {
    record_.parts.push_back({.record = part, .is_optional = true});
    return std::move(*this);
  }
  /// Requires exactly one of these members.
  WrittenRecord&& one_of(std::vector<std::string> names) && {
    record_.one_of.push_back(std::move(names));
    return std::move(*this);
  }
  /// Removes all other members if the member has this value.
  WrittenRecord&& alone(std::string name, Value value) && {
    record_.alone.emplace(std::move(name), std::move(value));
    return std::move(*this);
  }

  /// Finishes the record.
  operator Record() && {  // NOLINT(google-explicit-constructor): the builder ends as what it builds
    return std::move(record_);
  }

 private:
  Record record_;
};

}  // namespace meristem::studio
