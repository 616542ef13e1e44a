// SPDX-License-Identifier: Apache-2.0
// A parameter table has one row per member, with its name, unit, range and meaning. For example:
//
//   const ParameterTable& blade_table() {
//     static const ParameterTable table =
//         Table<Blade>("blade", "A flat leaf.")
//             .number("length", &Blade::length, {.unit = Unit::metre, .min = 0, .max = 10}, "Base to tip.")
//             .choice("edge", &Blade::edge, {"smooth", "toothed"}, "Shape of the margin.");
//     return table;
//   }
//
// A row finds its member by offset and type (member_type.h), so all tables share the functions for each type.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/count.h"
#include "meristem/graph/table/kinds.h"
#include "meristem/graph/table/member_type.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/selection.h"

namespace meristem {

/// Builds the table of struct P, which must be default-constructible: its defaults are the parameters' defaults.
template <class P>
class Table {
 public:
  /// A table without rows. `name` is used in messages ("a leaf"), `doc` is one sentence.
  Table(std::string name, std::string doc) : original_(std::make_shared<const P>()) {
    table_.name = std::move(name);
    table_.doc = std::move(doc);
    table_.original = original_;
  }

  /// Adds a double, a float or an optional one. An optional without a value means: chosen by the program.
  template <class M>
  Table&& number(std::string_view name, M P::*member, const NumberRange& form, std::string_view doc) && {
    static_assert(std::is_arithmetic_v<ValueOf<M>> && !std::is_same_v<ValueOf<M>, bool>);
    row(ParameterKind::number, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds an int, a uint64_t or an optional<int>. Varying values are rounded.
  template <class M>
  Table&& integer(std::string_view name, M P::*member, const NumberRange& form, std::string_view doc) && {
    static_assert(std::is_arithmetic_v<ValueOf<M>> && !std::is_same_v<ValueOf<M>, bool>);
    row(ParameterKind::integer, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds a number of parts: a PartCount or an optional one. The number is whole, unless keys or a plain number give it
  /// a fraction.
  template <class M>
  Table&& count(std::string_view name, M P::*member, NumberRange form, std::string_view doc) && {
    static_assert(std::is_same_v<ValueOf<M>, PartCount>);
    form.counts = true;
    row(ParameterKind::integer, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds a number that may differ among the children of an instance.
  Table&& per_child(std::string_view name, PerChild P::*member, NumberRange form, std::string_view doc) && {
    form.per_child = true;
    row(ParameterKind::number, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds a number that may differ among the children of a link, or among the instances of a component.
  Table&& per_site(std::string_view name, PerChild P::*member, NumberRange form, std::string_view doc) && {
    form.per_site = true;
    row(ParameterKind::number, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds a value that is true or false.
  Table&& boolean(std::string_view name, bool P::*member, std::string_view doc) && {
    row(ParameterKind::boolean, name, member, doc);
    return std::move(*this);
  }
  /// Adds a text on one line.
  Table&& text(std::string_view name, std::string P::*member, std::string_view doc) && {
    row(ParameterKind::text, name, member, doc);
    return std::move(*this);
  }
  /// Adds an enum whose enumerators count from 0 in the order of `names`.
  template <class E>
  Table&& choice(std::string_view name, E P::*member, std::vector<std::string> names, std::string_view doc) && {
    static_assert(std::is_enum_v<E>);
    row(ParameterKind::choice, name, member, doc).choices = std::move(names);
    return std::move(*this);
  }
  /// Adds three numbers [x, y, z], each of which may vary: a Vec3, a DVec3 or an optional one.
  template <class M>
  Table&& vector(std::string_view name, M P::*member, const NumberRange& form, std::string_view doc) && {
    static_assert(std::is_same_v<ValueOf<M>, Vec3> || std::is_same_v<ValueOf<M>, DVec3>);
    row(ParameterKind::vector, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds a direction [x, y, z] of the world with any length above 0, or "surface".
  Table&& facing(std::string_view name, std::optional<FacingDirection> P::*member, std::string_view doc) && {
    row(ParameterKind::facing, name, member, doc).form.fixed = true;
    return std::move(*this);
  }
  /// Adds two corners [[x, y, z], [x, y, z]]; each number may vary.
  Table&& box(std::string_view name, std::optional<Box> P::*member, const NumberRange& form, std::string_view doc) && {
    row(ParameterKind::box, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds an sRGB colour in [0, 1], written "#rrggbb": a Vec3 or an optional one.
  template <class M>
  Table&& colour(std::string_view name, M P::*member, std::string_view doc) && {
    static_assert(std::is_same_v<ValueOf<M>, Vec3>);
    row(ParameterKind::colour, name, member, doc);
    return std::move(*this);
  }
  /// Adds a list of at least one colour.
  Table&& colours(std::string_view name, std::vector<Vec3> P::*member, std::string_view doc) && {
    row(ParameterKind::colours, name, member, doc);
    return std::move(*this);
  }
  /// Adds a function on [0, 1].
  Table&& curve(std::string_view name, Curve P::*member, std::string_view doc) && {
    row(ParameterKind::curve, name, member, doc);
    return std::move(*this);
  }
  /// Adds pairs [[x, y], ...]. `form` is the range of every number unless `second` follows. The points form a line
  /// unless `together` follows.
  Table&& points(std::string_view name, std::vector<Vec2> P::*member, const NumberRange& form,
                 std::string_view doc) && {
    row(ParameterKind::points, name, member, doc).form = form;
    return std::move(*this);
  }
  /// Adds a list of at least one position [[x, y, z], ...]. The positions are not joined unless `together` follows.
  Table&& positions(std::string_view name, std::vector<Vec3> P::*member, NumberRange form, std::string_view doc) && {
    form.fixed = true;
    Parameter& made = row(ParameterKind::positions, name, member, doc);
    made.form = form;
    made.together = PointsForm::apart;
    return std::move(*this);
  }
  /// Adds a list of exactly `count` whole numbers.
  Table&& integers(std::string_view name, std::vector<int> P::*member, std::size_t count, const NumberRange& form,
                   std::string_view doc) && {
    Parameter& made = row(ParameterKind::integers, name, member, doc);
    made.form = form;
    made.count = count;
    return std::move(*this);
  }
  /// Adds an expression over `names` that is true or false.
  Table&& condition(std::string_view name, std::optional<SiteCondition> P::*member, std::vector<std::string> names,
                    std::string_view doc) && {
    row(ParameterKind::condition, name, member, doc).names = std::move(names);
    return std::move(*this);
  }
  /// Adds an expression over `names` that gives a number.
  Table&& formula(std::string_view name, std::optional<ParameterFormula> P::*member, std::vector<std::string> names,
                  std::string_view doc) && {
    row(ParameterKind::formula, name, member, doc).names = std::move(names);
    return std::move(*this);
  }
  /// Adds a selection of instances by number, range and condition.
  Table&& selection(std::string_view name, std::optional<InstanceSelection> P::*member, std::string_view doc) && {
    row(ParameterKind::selection, name, member, doc);
    return std::move(*this);
  }
  /// Adds a file. `load` reads it, and throws InputError for faults in it.
  template <class T>
  Table&& file(std::string_view name, Asset<T> P::*member, LoadAsset<T> load, std::string_view doc) && {
    row(ParameterKind::file, name, member, doc).load_file = reinterpret_cast<void (*)()>(load);
    return std::move(*this);
  }
  /// Adds a text, plain or as a list of its lines. `read` makes an asset from the text and a path in the document's
  /// folder. It throws InputError for faults by line and column, and may add warnings.
  template <class T>
  Table&& lines(std::string_view name, Asset<T> P::*member, TextAsset<T> read, std::string_view doc) && {
    row(ParameterKind::lines, name, member, doc).make_asset = reinterpret_cast<void (*)()>(read);
    return std::move(*this);
  }
  /// Adds a text file. `read` makes an asset from its text, as in `lines`.
  template <class T>
  Table&& text_file(std::string_view name, Asset<T> P::*member, TextAsset<T> read, std::string_view doc) && {
    row(ParameterKind::file, name, member, doc).make_asset = reinterpret_cast<void (*)()>(read);
    return std::move(*this);
  }
  /// Adds a nested struct, or an optional one. `nested` is the function that returns its table.
  template <class M>
  Table&& object(std::string_view name, M P::*member, const ParameterTable& (*nested)(), std::string_view doc) && {
    return holder(ParameterKind::object, name, member, nested, doc);
  }
  /// Adds a list of nested structs.
  template <class Element>
  Table&& list(std::string_view name, std::vector<Element> P::*member, const ParameterTable& (*nested)(),
               std::string_view doc) && {
    return holder(ParameterKind::list, name, member, nested, doc);
  }
  /// Adds a list of structs of several kinds. `kinds` returns the kinds, and `nested` the table of all of them.
  template <class... Structs>
  Table&& list_of_kinds(std::string_view name, std::vector<std::variant<Structs...>> P::*member,
                        const ElementKinds& (*kinds)(), const ParameterTable& (*nested)(), std::string_view doc) && {
    holder(ParameterKind::list, name, member, nested, doc);
    table_.parameters.back().kinds = kinds;
    return std::move(*this);
  }
  /// Adds nested structs by name, in the order of the document.
  template <class Element>
  Table&& map(std::string_view name, std::vector<std::pair<std::string, Element>> P::*member,
              const ParameterTable& (*nested)(), std::string_view doc) && {
    return holder(ParameterKind::map, name, member, nested, doc);
  }

  /// Adds all rows of a base struct's table.
  template <class Base>
  Table&& include(const ParameterTable& base) && {
    return rows_of(base, offset_of(static_cast<const Base&>(*original_)));
  }
  /// Adds the rows of a member struct's table, as if they were this struct's own.
  template <class M>
  Table&& members(M P::*member, const ParameterTable& table) && {
    return rows_of(table, offset_of((*original_).*member));
  }
  template <class M, class N>
  Table&& members(M P::*member, N M::*inner, const ParameterTable& table) && {
    return rows_of(table, offset_of(((*original_).*member).*inner));
  }
  /// Sets the range of the second numbers of points, for the last row. The range of the first numbers stays.
  Table&& second(double min, double max, UsualSpan usual = {}) && {
    NumberRange form = table_.parameters.back().form;
    form.min = min;
    form.max = max;
    form.usual = usual;
    form.above_min = false;
    table_.parameters.back().second = form;
    return std::move(*this);
  }
  /// Sets how the points or positions of the last row are joined.
  Table&& together(PointsForm form) && {
    table_.parameters.back().together = form;
    return std::move(*this);
  }
  /// Sets the geometric role of the last row.
  Table&& in_space(InSpace what) && {
    table_.parameters.back().in_space = what;
    return std::move(*this);
  }
  /// Makes the last row required.
  Table&& required() && {
    table_.parameters.back().required = true;
    return std::move(*this);
  }
  /// Requires exactly one of these parameters.
  Table&& one_of(std::vector<std::string> names) && {
    table_.one_of.push_back(std::move(names));
    return std::move(*this);
  }
  /// Forbids these parameters without `other`.
  Table&& only_with(const std::string& other, const std::vector<std::string>& names) && {
    for (const std::string& name : names) table_.company.push_back({name, other, true});
    return std::move(*this);
  }
  /// Forbids these parameters beside `other`.
  Table&& never_with(const std::string& other, const std::vector<std::string>& names) && {
    for (const std::string& name : names) table_.company.push_back({name, other, false});
    return std::move(*this);
  }
  /// Gives these parameters an effect only if one of `givers` is given or has one of its values.
  Table&& only_where(std::vector<ParameterTable::Meaning::Giver> givers, std::vector<std::string> names) && {
    table_.meanings.push_back({std::move(names), std::move(givers)});
    return std::move(*this);
  }
  /// Removes the rows with these names, which have no effect here. Messages give the reason, as in "a field has no
  /// geometry of its own".
  Table&& without(std::vector<std::string> names, std::string reason) && {
    table_.leave_out(std::move(names), std::move(reason));
    return std::move(*this);
  }
  /// Adds further keys, which the caller reads itself.
  Table&& elsewhere(std::vector<std::string> names) && {
    table_.elsewhere = std::move(names);
    return std::move(*this);
  }
  /// Lets a bare value instead of an object set this parameter.
  Table&& shorthand(std::string name) && {
    table_.shorthand = std::move(name);
    return std::move(*this);
  }
  /// Sets a rule between parameters.
  Table&& check(void (*rule)(const P&, const DocumentPath&, ParameterReader&)) && {
    table_.check = [rule](const void* object, const DocumentPath& path, ParameterReader& reader) {
      rule(*static_cast<const P*>(object), path, reader);
    };
    return std::move(*this);
  }
  /// Sets a function that computes values from several parameters. Called once they are read and the rules hold.
  Table&& prepare(void (*step)(P&, const DocumentPath&, ParameterReader&)) && {
    table_.prepare = [step](void* object, const DocumentPath& path, ParameterReader& reader) {
      step(*static_cast<P*>(object), path, reader);
    };
    return std::move(*this);
  }

  /// Finishes the table.
  operator ParameterTable() && {  // NOLINT(google-explicit-constructor): the builder ends as what it builds
    return std::move(table_);
  }

 private:
  /// Returns the offset in bytes from the beginning of the original to a part of it.
  template <class Part>
  std::size_t offset_of(const Part& part) const {
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&part) -
                                    reinterpret_cast<const std::byte*>(original_.get()));
  }

  template <class M>
  Parameter& row(ParameterKind kind, std::string_view name, M P::*member, std::string_view doc) {
    return table_.add(kind, name, doc, offset_of((*original_).*member), kMemberType<M>);
  }

  template <class M>
  Table&& holder(ParameterKind kind, std::string_view name, M P::*member, const ParameterTable& (*nested)(),
                 std::string_view doc) {
    table_.add(kind, name, doc, offset_of((*original_).*member), kHolderType<M>).nested = nested;
    return std::move(*this);
  }

  Table&& rows_of(const ParameterTable& table, std::size_t offset) {
    table_.add_rows(table, offset);
    return std::move(*this);
  }

  std::shared_ptr<const P> original_;
  ParameterTable table_;
};

}  // namespace meristem
