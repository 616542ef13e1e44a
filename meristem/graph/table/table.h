// SPDX-License-Identifier: Apache-2.0
// How a parameter table is written: a row a member, with its name, unit, range and meaning.
//
//   const ParameterTable& blade_table() {
//     static const ParameterTable table =
//         Table<Blade>("blade", "A flat leaf.")
//             .number("length", &Blade::length, {.unit = Unit::metre, .min = 0, .max = 10}, "Base to tip.")
//             .choice("edge", &Blade::edge, {"smooth", "toothed"}, "Shape of the margin.");
//     return table;
//   }
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/kinds.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/selection.h"

namespace meristem {

/// Makes something of a text.
template <class T>
using TextAsset = T (*)(const std::string& text, const std::string& path, ParameterReader& reader,
                        std::vector<Diagnostic>& warnings);

// The parts of Table that do not depend on the struct's type.
namespace table_detail {

template <class T>
struct Optional : std::false_type {
  using Type = T;
};
template <class T>
struct Optional<std::optional<T>> : std::true_type {
  using Type = T;
};

double to_document(Unit unit, double value);

void read_curve(const Parameter&, const Value&, const Place&, ParameterReader&, Curve& out);
Value show_curve(const Curve& curve);
void read_points(const Parameter&, const Value&, const Place&, ParameterReader&, std::vector<Vec2>& out);
Value show_points(const std::vector<Vec2>& points);
void read_integers(const Parameter&, const Value&, const Place&, ParameterReader&, std::vector<int>& out);
Value show_integers(const std::vector<int>& numbers);
void read_vector(const Parameter&, const Value&, const Place&, ParameterReader&, Vec3& out);
Value show_vector(Unit unit, Vec3 vector);
void read_places(const Parameter&, const Value&, const Place&, ParameterReader&, std::vector<Vec3>& out);
Value show_places(Unit unit, const std::vector<Vec3>& places);
void read_box(const Parameter&, const Value&, const Place&, ParameterReader&, Box& out);
Value show_box(Unit unit, const Box& box);
void read_colour(const Parameter&, const Value&, const Place&, ParameterReader&, Vec3& out);
Value show_colour(Vec3 colour);
void read_colours(const Parameter&, const Value&, const Place&, ParameterReader&, std::vector<Vec3>& out);
Value show_colours(const std::vector<Vec3>& colours);
void read_selection(const Parameter&, const Value&, const Place&, ParameterReader&, std::optional<Selection>& out);
Value show_selection(const Selection& selection);
void read_condition(const Parameter&, const Value&, const Place&, ParameterReader&, std::optional<Condition>& out);
void read_formula(const Parameter&, const Value&, const Place&, ParameterReader&, std::optional<Formula>& out);
Value show_object(const ParameterTable& table, const void* object);

}  // namespace table_detail

/// Builds the table of struct P, which must be default-constructible: its defaults are the parameters' defaults.
template <class P>
class Table {
 public:
  Table(std::string name, std::string doc) {
    table_.name = std::move(name);
    table_.doc = std::move(doc);
  }

  /// A double, float or optional of them. An optional without a value means: chosen by the program.
  template <class M>
  Table&& number(std::string name, M P::*member, NumberForm form, std::string doc) && {
    return numeric(ParameterKind::number, std::move(name), member, form, std::move(doc));
  }
  /// An int, uint64_t or optional<int>; varying values are rounded.
  template <class M>
  Table&& integer(std::string name, M P::*member, NumberForm form, std::string doc) && {
    return numeric(ParameterKind::integer, std::move(name), member, form, std::move(doc));
  }
  /// A number that may differ among the children of an instance.
  Table&& per_child(std::string name, PerChild P::*member, NumberForm form, std::string doc) && {
    Parameter& made = row(
        ParameterKind::number, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          reader.store_per_child(self, value, place, object.*member);
        },
        [member, unit = form.unit](const P& object) { return shown(unit, (object.*member).plain); });
    made.form = form;
    made.form.per_child = true;
    return std::move(*this);
  }
  Table&& boolean(std::string name, bool P::*member, std::string doc) && {
    row(
        ParameterKind::boolean, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          if (const bool* given = value.boolean()) {
            object.*member = *given;
          } else {
            reader.wrong_kind(self, value, place);
          }
        },
        [member](const P& object) { return Value(object.*member); });
    return std::move(*this);
  }
  Table&& text(std::string name, std::string P::*member, std::string doc) && {
    row(
        ParameterKind::text, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          if (const std::string* given = reader.text(self, value, place)) object.*member = *given;
        },
        [member](const P& object) { return Value(object.*member); });
    return std::move(*this);
  }
  /// An enum whose enumerators count from 0 in the order of `names`.
  template <class E>
  Table&& choice(std::string name, E P::*member, std::vector<std::string> names, std::string doc) && {
    static_assert(std::is_enum_v<E>);
    Parameter& made = row(
        ParameterKind::choice, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          if (const auto given = reader.choice(self, value, place)) object.*member = static_cast<E>(*given);
        },
        [member, names](const P& object) { return Value(names[static_cast<std::size_t>(object.*member)]); });
    made.choices = std::move(names);
    return std::move(*this);
  }
  /// Three numbers [x, y, z]; each may vary.
  Table&& vector(std::string name, Vec3 P::*member, NumberForm form, std::string doc) && {
    Parameter& made = row(
        ParameterKind::vector, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_vector(self, value, place, reader, object.*member);
        },
        [member, unit = form.unit](const P& object) { return table_detail::show_vector(unit, object.*member); });
    made.form = form;
    return std::move(*this);
  }
  Table&& vector(std::string name, std::optional<Vec3> P::*member, NumberForm form, std::string doc) && {
    Parameter& made = row(
        ParameterKind::vector, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_vector(self, value, place, reader, (object.*member).emplace(0.0F));
        },
        [member, unit = form.unit](const P& object) {
          return object.*member ? table_detail::show_vector(unit, *(object.*member)) : Value();
        });
    made.form = form;
    return std::move(*this);
  }
  /// Two corners [[x, y, z], [x, y, z]]; each number may vary.
  Table&& box(std::string name, std::optional<Box> P::*member, NumberForm form, std::string doc) && {
    Parameter& made = row(
        ParameterKind::box, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_box(self, value, place, reader, (object.*member).emplace(Box{Vec3(0), Vec3(0)}));
        },
        [member, unit = form.unit](const P& object) {
          return object.*member ? table_detail::show_box(unit, *(object.*member)) : Value();
        });
    made.form = form;
    return std::move(*this);
  }
  /// sRGB in [0, 1], written "#rrggbb".
  Table&& colour(std::string name, Vec3 P::*member, std::string doc) && {
    row(
        ParameterKind::colour, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_colour(self, value, place, reader, object.*member);
        },
        [member](const P& object) { return table_detail::show_colour(object.*member); });
    return std::move(*this);
  }
  Table&& colour(std::string name, std::optional<Vec3> P::*member, std::string doc) && {
    row(
        ParameterKind::colour, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_colour(self, value, place, reader, (object.*member).emplace(0.0F));
        },
        [member](const P& object) { return object.*member ? table_detail::show_colour(*(object.*member)) : Value(); });
    return std::move(*this);
  }
  /// At least one colour.
  Table&& colours(std::string name, std::vector<Vec3> P::*member, std::string doc) && {
    row(
        ParameterKind::colours, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_colours(self, value, place, reader, object.*member);
        },
        [member](const P& object) {
          return (object.*member).empty() ? Value() : table_detail::show_colours(object.*member);
        });
    return std::move(*this);
  }
  /// A function from [0, 1].
  Table&& curve(std::string name, Curve P::*member, std::string doc) && {
    row(
        ParameterKind::curve, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_curve(self, value, place, reader, object.*member);
        },
        [member](const P& object) { return table_detail::show_curve(object.*member); });
    return std::move(*this);
  }
  /// Pairs [[x, y], ...]; `form` bounds every number.
  Table&& points(std::string name, std::vector<Vec2> P::*member, NumberForm form, std::string doc) && {
    Parameter& made = row(
        ParameterKind::points, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_points(self, value, place, reader, object.*member);
        },
        [member](const P& object) {
          return (object.*member).empty() ? Value() : table_detail::show_points(object.*member);
        });
    made.form = form;
    return std::move(*this);
  }
  /// A list of places [[x, y, z], ...], at least one.
  Table&& places(std::string name, std::vector<Vec3> P::*member, NumberForm form, std::string doc) && {
    Parameter& made = row(
        ParameterKind::places, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_places(self, value, place, reader, object.*member);
        },
        [member, unit = form.unit](const P& object) { return table_detail::show_places(unit, object.*member); });
    made.form = form;
    made.form.fixed = true;
    return std::move(*this);
  }
  /// A list of exactly `count` whole numbers.
  Table&& integers(std::string name, std::vector<int> P::*member, std::size_t count, NumberForm form,
                   std::string doc) && {
    Parameter& made = row(
        ParameterKind::integers, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_integers(self, value, place, reader, object.*member);
        },
        [member](const P& object) {
          return (object.*member).empty() ? Value() : table_detail::show_integers(object.*member);
        });
    made.form = form;
    made.count = count;
    return std::move(*this);
  }
  /// An expression over `names` that says yes or no.
  Table&& condition(std::string name, std::optional<Condition> P::*member, std::vector<std::string> names,
                    std::string doc) && {
    Parameter& made = row(
        ParameterKind::condition, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_condition(self, value, place, reader, object.*member);
        },
        [member](const P& object) { return object.*member ? Value((object.*member)->text) : Value(); });
    made.names = std::move(names);
    return std::move(*this);
  }
  /// A number for each set of values of `names`.
  Table&& formula(std::string name, std::optional<Formula> P::*member, std::vector<std::string> names,
                  std::string doc) && {
    Parameter& made = row(
        ParameterKind::formula, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_formula(self, value, place, reader, object.*member);
        },
        [member](const P& object) { return object.*member ? Value((object.*member)->text) : Value(); });
    made.names = std::move(names);
    return std::move(*this);
  }
  /// Instances by number, range and condition.
  Table&& selection(std::string name, std::optional<Selection> P::*member, std::string doc) && {
    row(
        ParameterKind::selection, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          table_detail::read_selection(self, value, place, reader, object.*member);
        },
        [member](const P& object) {
          return object.*member ? table_detail::show_selection(*(object.*member)) : Value();
        });
    return std::move(*this);
  }
  /// A file; `load` reads it, and throws InputError for faults in it.
  template <class T>
  Table&& file(std::string name, Asset<T> P::*member, T (*load)(const std::string& path, const Limits& limits),
               std::string doc) && {
    row(
        ParameterKind::file, std::move(name), std::move(doc),
        [member, load](const Parameter& self, P& object, const Value& value, const Place& place,
                       ParameterReader& reader) {
          reader.file(self, value, place, [&](const std::string& path) {
            object.*member = {*value.text(), reader.kept_file<T>(path, load)};
          });
        },
        [member](const P& object) { return object.*member ? Value((object.*member).path) : Value(); });
    return std::move(*this);
  }
  /// A text, plain or as a list of its lines. `read` makes something of it and of a path in the document's folder,
  /// throws InputError for faults by line and column, and may give warnings.
  template <class T>
  Table&& lines(std::string name, Asset<T> P::*member, TextAsset<T> read, std::string doc) && {
    row(
        ParameterKind::lines, std::move(name), std::move(doc),
        [member, read](const Parameter& self, P& object, const Value& value, const Place& place,
                       ParameterReader& reader) {
          reader.lines(self, value, place, [&](const std::string& text, const std::string& path, auto& warnings) {
            object.*member = {text, reader.kept_text<T>(text, path, warnings, read)};
          });
        },
        [member](const P& object) { return object.*member ? Value((object.*member).path) : Value(); });
    return std::move(*this);
  }
  /// The same for the text of a file.
  template <class T>
  Table&& text_file(std::string name, Asset<T> P::*member, TextAsset<T> read, std::string doc) && {
    row(
        ParameterKind::file, std::move(name), std::move(doc),
        [member, read](const Parameter& self, P& object, const Value& value, const Place& place,
                       ParameterReader& reader) {
          reader.text_file(self, value, place, [&](const std::string& text, const std::string& path, auto& warnings) {
            object.*member = {*value.text(), reader.kept_text<T>(text, path, warnings, read)};
          });
        },
        [member](const P& object) { return object.*member ? Value((object.*member).path) : Value(); });
    return std::move(*this);
  }
  /// A nested struct, or an optional one. `nested` is the function that makes its table.
  template <class M>
  Table&& object(std::string name, M P::*member, const ParameterTable& (*nested)(), std::string doc) && {
    Parameter& made = row(
        ParameterKind::object, std::move(name), std::move(doc),
        [member, nested](const Parameter&, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          if constexpr (table_detail::Optional<M>::value) {
            reader.object(nested(), &(object.*member).emplace(), value, place);
          } else {
            reader.object(nested(), &(object.*member), value, place);
          }
        },
        [member, nested](const P& object) {
          if constexpr (table_detail::Optional<M>::value) {
            return object.*member ? table_detail::show_object(nested(), &*(object.*member)) : Value();
          } else {
            return table_detail::show_object(nested(), &(object.*member));
          }
        });
    made.nested = nested;
    return std::move(*this);
  }
  /// A list of nested structs. Numbers in them cannot vary from instance to instance.
  template <class Element>
  Table&& list(std::string name, std::vector<Element> P::*member, const ParameterTable& (*nested)(),
               std::string doc) && {
    Parameter& made = row(
        ParameterKind::list, std::move(name), std::move(doc),
        [member, nested](const Parameter& self, P& object, const Value& value, const Place& place,
                         ParameterReader& reader) {
          const Value::List* values = value.list();
          if (values == nullptr) return reader.wrong_kind(self, value, place);
          std::vector<Element>& elements = object.*member;
          elements.assign(values->size(), Element{});
          for (std::size_t k = 0; k < values->size(); ++k) {
            reader.object(nested(), &elements[k], (*values)[k], Place(place, k));
          }
        },
        [member, nested](const P& object) {
          Value::List shown;
          for (const Element& element : object.*member) shown.push_back(table_detail::show_object(nested(), &element));
          return Value(std::move(shown));
        });
    made.nested = nested;
    return std::move(*this);
  }

  /// A list of structs of several kinds. `kinds` says which, and `nested` makes the table of all of them.
  template <class... Structs>
  Table&& list_of_kinds(std::string name, std::vector<std::variant<Structs...>> P::*member, const Kinds& (*kinds)(),
                        const ParameterTable& (*nested)(), std::string doc) && {
    Parameter& made = row(
        ParameterKind::list, std::move(name), std::move(doc),
        [member, kinds, nested](const Parameter& self, P& object, const Value& value, const Place& place,
                                ParameterReader& reader) {
          const Value::List* values = value.list();
          if (values == nullptr) return reader.wrong_kind(self, value, place);
          (object.*member).assign(values->size(), {});
          for (std::size_t k = 0; k < values->size(); ++k) {
            const Place at(place, k);
            const std::optional<std::size_t> kind = read_kind(kinds(), nested(), (*values)[k], at, reader);
            if (!kind) continue;
            void* const element = table_detail::emplace_kind((object.*member)[k], *kind);
            reader.object(kinds().kinds[*kind].table(), element, (*values)[k], at);
          }
        },
        [member, kinds](const P& object) {
          Value::List shown;
          for (const auto& element : object.*member) {
            const void* const held =
                std::visit([](const auto& one) { return static_cast<const void*>(&one); }, element);
            shown.push_back(table_detail::show_kind(kinds(), element.index(), held));
          }
          return Value(std::move(shown));
        });
    made.nested = nested;
    return std::move(*this);
  }

  /// Nested structs by name, in the order of the document. Numbers in them cannot vary from instance to instance.
  template <class Element>
  Table&& map(std::string name, std::vector<std::pair<std::string, Element>> P::*member,
              const ParameterTable& (*nested)(), std::string doc) && {
    Parameter& made = row(
        ParameterKind::map, std::move(name), std::move(doc),
        [member, nested](const Parameter& self, P& object, const Value& value, const Place& place,
                         ParameterReader& reader) {
          const Value::Object* values = value.object();
          if (values == nullptr) return reader.wrong_kind(self, value, place);
          (object.*member).clear();
          for (const auto& [key, element] : *values) {
            (object.*member).emplace_back(key, Element{});
            reader.object(nested(), &(object.*member).back().second, element, Place(place, key));
          }
        },
        [member, nested](const P& object) {
          Value::Object shown;
          for (const auto& [key, element] : object.*member) {
            shown.emplace_back(key, table_detail::show_object(nested(), &element));
          }
          return Value(std::move(shown));
        });
    made.nested = nested;
    return std::move(*this);
  }

  /// All rows of a base struct's table.
  template <class Base>
  Table&& include(const ParameterTable& base) && {
    static_assert(std::is_base_of_v<Base, P>);
    return rows_of(base, [](P& object) -> Base& { return object; });
  }
  /// The rows of a member struct's table, as if they were this struct's own.
  template <class M>
  Table&& members(M P::*member, const ParameterTable& table) && {
    return rows_of(table, [member](P& object) -> M& { return object.*member; });
  }
  template <class M, class N>
  Table&& members(M P::*member, N M::*inner, const ParameterTable& table) && {
    return rows_of(table, [member, inner](P& object) -> N& { return object.*member.*inner; });
  }
  /// The row just written must be given.
  Table&& required() && {
    table_.parameters.back().required = true;
    return std::move(*this);
  }
  /// Of these parameters exactly one must be given.
  Table&& one_of(std::vector<std::string> names) && {
    table_.one_of.push_back(std::move(names));
    return std::move(*this);
  }
  /// None of these parameters may be given without `other`.
  Table&& only_with(const std::string& other, const std::vector<std::string>& names) && {
    for (const std::string& name : names) table_.company.push_back({name, other, true});
    return std::move(*this);
  }
  /// None of these parameters may be given beside `other`.
  Table&& never_with(const std::string& other, const std::vector<std::string>& names) && {
    for (const std::string& name : names) table_.company.push_back({name, other, false});
    return std::move(*this);
  }
  /// These parameters mean something only where any of `givers` is given or has one of its values.
  Table&& only_where(std::vector<ParameterTable::Meaning::Giver> givers, std::vector<std::string> names) && {
    table_.meanings.push_back({std::move(names), std::move(givers)});
    return std::move(*this);
  }
  /// Nothing gives these parameters a meaning here. Rows of that name are taken out; messages tell the reason, as in
  /// "a field has no geometry of its own".
  Table&& without(std::vector<std::string> names, std::string reason) && {
    const auto is_out = [&names](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::erase_if(table_.parameters, [&](const Parameter& row) { return is_out(row.name); });
    std::erase_if(table_.company, [&](const auto& rule) { return is_out(rule.parameter) || is_out(rule.other); });
    table_.meanings.push_back({std::move(names), {}, std::move(reason)});
    return std::move(*this);
  }
  /// Further keys that whoever owns the table reads itself.
  Table&& elsewhere(std::vector<std::string> names) && {
    table_.elsewhere = std::move(names);
    return std::move(*this);
  }
  /// A bare value instead of an object sets this parameter.
  Table&& shorthand(std::string name) && {
    table_.shorthand = std::move(name);
    return std::move(*this);
  }
  /// A rule between parameters.
  Table&& check(void (*rule)(const P&, const Place&, ParameterReader&)) && {
    table_.check = [rule](const void* object, const Place& place, ParameterReader& reader) {
      rule(*static_cast<const P*>(object), place, reader);
    };
    return std::move(*this);
  }

  /// What follows from several parameters, worked out once they are read and hold.
  Table&& prepare(void (*step)(P&, const Place&, ParameterReader&)) && {
    table_.prepare = [step](void* object, const Place& place, ParameterReader& reader) {
      step(*static_cast<P*>(object), place, reader);
    };
    return std::move(*this);
  }

  /// Finishes the table.
  operator ParameterTable() && {  // NOLINT(google-explicit-constructor): the builder ends as what it builds
    table_.defaults = [parameters = table_.parameters] {
      const P defaults{};
      std::vector<Value> values;
      values.reserve(parameters.size());
      for (const Parameter& parameter : parameters) values.push_back(parameter.show(&defaults));
      return values;
    };
    return std::move(table_);
  }

 private:
  template <class M>
  Table&& numeric(ParameterKind kind, std::string name, M P::*member, NumberForm form, std::string doc) {
    using Number = typename table_detail::Optional<M>::Type;
    static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>);
    Parameter& made = row(
        kind, std::move(name), std::move(doc),
        [member](const Parameter& self, P& object, const Value& value, const Place& place, ParameterReader& reader) {
          const StoreNumber store = [](void* slot, double number) {
            if constexpr (std::is_integral_v<Number>) number = std::floor(number + 0.5);
            *static_cast<M*>(slot) = static_cast<Number>(number);
          };
          const Value present = shown(self.form.unit, object.*member);
          reader.store_number(self, value, place,
                              {&(object.*member), store, present.is_null() ? 0 : *present.number()});
        },
        [member, unit = form.unit](const P& object) { return shown(unit, object.*member); });
    made.form = form;
    return std::move(*this);
  }

  /// Takes over the rows of `table`, which read and show the part of the struct that `part` picks, and what it says of
  /// their company; its rule stays behind.
  template <class Part>
  Table&& rows_of(const ParameterTable& table, Part part) {
    for (const Parameter& theirs : table.parameters) {
      Parameter& ours = table_.parameters.emplace_back(theirs);
      ours.read = [part, read = theirs.read](const Parameter& self, void* object, const Value& value,
                                             const Place& place, ParameterReader& reader) {
        read(self, &part(*static_cast<P*>(object)), value, place, reader);
      };
      ours.show = [part, show = theirs.show](const void* object) {
        return show(&part(*const_cast<P*>(static_cast<const P*>(object))));
      };
    }
    table_.one_of.insert(table_.one_of.end(), table.one_of.begin(), table.one_of.end());
    table_.company.insert(table_.company.end(), table.company.begin(), table.company.end());
    table_.meanings.insert(table_.meanings.end(), table.meanings.begin(), table.meanings.end());
    return std::move(*this);
  }

  template <class M>
  static Value shown(Unit unit, const M& member) {
    if constexpr (table_detail::Optional<M>::value) {
      return member ? Value(table_detail::to_document(unit, static_cast<double>(*member))) : Value();
    } else {
      return Value(table_detail::to_document(unit, static_cast<double>(member)));
    }
  }

  template <class Read, class Show>
  Parameter& row(ParameterKind kind, std::string name, std::string doc, Read read, Show show) {
    Parameter& made = table_.parameters.emplace_back();
    made.name = std::move(name);
    made.doc = std::move(doc);
    made.kind = kind;
    made.read = [read](const Parameter& self, void* object, const Value& value, const Place& place,
                       ParameterReader& reader) { read(self, *static_cast<P*>(object), value, place, reader); };
    made.show = [show](const void* object) { return show(*static_cast<const P*>(object)); };
    return made;
  }

  ParameterTable table_;
};

}  // namespace meristem
