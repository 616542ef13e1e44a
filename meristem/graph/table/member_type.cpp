// SPDX-License-Identifier: Apache-2.0
// Reads values of a document into members of each type that a row may have, and shows members as values again. Every
// overload reports a value of a wrong kind with what was expected. Numbers are rounded to 7 digits when shown.
#include "meristem/graph/table/member_type.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "meristem/graph/table/kinds.h"

namespace meristem {

namespace {

/// Rounds a value to the digits that people write: 137.508 instead of the 137.50800323486328 of a float, 60 instead of
/// 59.999999999999993.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  // std::stod is not used: it reads a comma if the host program's locale does.
  const std::string digits = fmt::format("{:.7g}", value);
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

/// Returns a row for one number of another row's value. The number is stored as a float.
Parameter element_of(const Parameter& self) {
  Parameter element;
  element.name = self.name;
  element.kind = ParameterKind::number;
  element.form = self.form;
  constexpr double kLargest = std::numeric_limits<float>::max();
  element.form.min = std::max(element.form.min, -kLargest);
  element.form.max = std::min(element.form.max, kLargest);
  return element;
}

/// Rows for the first and the second numbers of points.
struct PairRows {
  explicit PairRows(const Parameter& self) : first(element_of(self)), second(first) {
    if (!self.second) return;
    second = self;
    second.form = *self.second;
    second = element_of(second);
  }
  Parameter first;
  Parameter second;
};

/// Reads a pair [x, y] of plain numbers.
bool read_pair(const PairRows& rows, const Value& value, const DocumentPath& path, ParameterReader& reader, Vec2& out) {
  const Value::List* pair = value.list();
  if (pair == nullptr || pair->size() != 2) {
    reader.add_error(path, fmt::format("a point of '{}' cannot be {}", rows.first.name, value.description()),
                     "a pair of numbers such as [0.5, 2]");
    return false;
  }
  const auto x = reader.numbers().read(rows.first, (*pair)[0], DocumentPath(path, std::size_t{0}));
  const auto y = reader.numbers().read(rows.second, (*pair)[1], DocumentPath(path, std::size_t{1}));
  if (!x || !y) return false;
  out = Vec2(*x, *y);
  return true;
}

bool read_pairs(const PairRows& rows, const Value& value, const DocumentPath& path, ParameterReader& reader,
                std::vector<Vec2>& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->empty()) {
    reader.add_error(path, fmt::format("'{}' cannot be {}", rows.first.name, value.description()),
                     "a list of pairs such as [[0, 1], [0.5, 2]]");
    return false;
  }
  bool good = true;
  std::vector<Vec2> points(list->size());
  for (std::size_t k = 0; k < list->size(); ++k) {
    good = read_pair(rows, (*list)[k], DocumentPath(path, k), reader, points[k]) && good;
  }
  if (good) out = std::move(points);
  return good;
}

int hexadecimal(char digit) {
  if ('0' <= digit && digit <= '9') return digit - '0';
  if ('a' <= digit && digit <= 'f') return digit - 'a' + 10;
  if ('A' <= digit && digit <= 'F') return digit - 'A' + 10;
  return -1;
}

double to_document(Unit unit, double value) { return rounded(unit == Unit::degree ? degrees(value) : value); }

/// Returns a row for one element of a list of vectors or colours.
Parameter each_of(const Parameter& self) {
  Parameter each = element_of(self);
  each.kind = self.kind == ParameterKind::colours ? ParameterKind::colour : ParameterKind::vector;
  return each;
}

void read_colour(const Parameter& self, const Value& value, const DocumentPath& path, ParameterReader& reader,
                 Vec3& out) {
  const std::string* text = reader.text(self, value, path);
  if (text == nullptr) return;
  bool good = text->size() == 7 && (*text)[0] == '#';
  for (std::size_t k = 1; good && k < 7; ++k) good = hexadecimal((*text)[k]) >= 0;
  if (!good) return reader.add_error(path, fmt::format("'{}' is not a colour", *text), self.expectation());
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(1 + 2 * k);
    out[k] = static_cast<float>(16 * hexadecimal((*text)[at]) + hexadecimal((*text)[at + 1])) / 255.0F;
  }
}

Value show_colour(Vec3 colour) {
  const Vec3 bytes = glm::round(colour * 255.0F);
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(bytes.x), static_cast<int>(bytes.y),
                     static_cast<int>(bytes.z));
}

/// Reads [x, y, z] into a Vec3 or a DVec3.
template <class V>
void read_coordinates(const Parameter& self, const Value& value, const DocumentPath& path, ParameterReader& reader,
                      V& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->size() != 3) return reader.wrong_kind(self, value, path);
  const Parameter element = element_of(self);
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::size_t>(k);
    read_value(element, out[k], (*list)[index], DocumentPath(path, index), reader);
  }
}

}  // namespace

void read_value(const Parameter& self, bool& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (const bool* given = value.boolean()) {
    member = *given;
  } else {
    reader.wrong_kind(self, value, path);
  }
}

Value show_value(const Parameter&, bool member) { return member; }

Value show_number(const Parameter& self, double member) { return to_document(self.form.unit, member); }

void read_value(const Parameter& self, std::string& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (const std::string* given = reader.text(self, value, path)) member = *given;
}

Value show_value(const Parameter&, const std::string& member) { return member; }

void read_value(const Parameter& self, PerChild& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (!self.form.per_site || !reader.numbers().reads_component())
    return reader.numbers().store_per_child(self, value, path, member);
  const StoreNumber store = [](void* to, double number) { *static_cast<PerChild*>(to) = PerChild(number); };
  reader.numbers().store(self, value, path, {&member, store, to_document(self.form.unit, member.plain)});
}

Value show_value(const Parameter& self, const PerChild& member) { return to_document(self.form.unit, member.plain); }

void read_value(const Parameter& self, PartCount& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const StoreNumber store = [](void* to, double number) { *static_cast<PartCount*>(to) = PartCount(number); };
  reader.numbers().store(self, value, path, {&member, store, member.value});
}

Value show_value(const Parameter&, const PartCount& member) { return rounded(member.value); }

void read_value(const Parameter& self, Curve& curve, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (value.object() == nullptr) return reader.wrong_kind(self, value, path);
  CurveKind kind = CurveKind::spline;
  std::vector<Vec2> points;
  bool good = true;
  Parameter kind_row;
  kind_row.name = "kind";
  kind_row.kind = ParameterKind::choice;
  kind_row.choices = {"spline", "linear"};
  const std::vector<std::string> names = {"curve", "kind"};
  for (const auto& [name, member] : *value.object()) {
    const DocumentPath member_place(path, name);
    if (name == "curve") {
      good = read_pairs(PairRows(self), member, member_place, reader, points) && good;
    } else if (name == "kind") {
      const auto chosen = reader.choice(kind_row, member, member_place);
      good = chosen.has_value() && good;
      kind = static_cast<CurveKind>(chosen.value_or(0));
    } else {
      reader.add_error(member_place, fmt::format("'{}' does not belong to a curve", name), "curve and kind",
                       reader.nearest(name, names));
      good = false;
    }
  }
  if (!good) return;
  if (points.empty()) return reader.add_error(path, "the curve has no points", self.expectation());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool outside = points[k].x < 0 || points[k].x > 1;
    if (outside || (k > 0 && !(points[k - 1].x < points[k].x))) {
      const DocumentPath curve_place(path, "curve");
      reader.add_error(DocumentPath(curve_place, k),
                       outside ? fmt::format("x = {:.7g} of the curve's point {} is out of range", points[k].x, k)
                               : fmt::format("x = {:.7g} of the curve's point {} does not rise", points[k].x, k),
                       "x from 0 to 1, strictly rising");
      return;
    }
  }
  curve = Curve(std::move(points), kind);
}

Value show_value(const Parameter& self, const Curve& curve) {
  Value::Object object{{"curve", show_value(self, curve.points())}};
  if (curve.kind() == CurveKind::linear) object.emplace_back("kind", "linear");
  return object;
}

void read_value(const Parameter& self, std::vector<Vec2>& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  read_pairs(PairRows(self), value, path, reader, member);
}

Value show_value(const Parameter&, const std::vector<Vec2>& points) {
  if (points.empty()) return {};
  Value::List list;
  for (const Vec2& point : points) list.emplace_back(Value::List{rounded(point.x), rounded(point.y)});
  return list;
}

void read_value(const Parameter& self, std::vector<int>& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const Value::List* list = value.list();
  if (list == nullptr || list->size() != self.count) return reader.wrong_kind(self, value, path);
  Parameter element = element_of(self);
  element.kind = ParameterKind::integer;
  std::vector<int> numbers;
  for (std::size_t k = 0; k < list->size(); ++k) {
    if (const auto number = reader.numbers().read(element, (*list)[k], DocumentPath(path, k)))
      numbers.push_back(static_cast<int>(*number));
  }
  if (numbers.size() == self.count) member = std::move(numbers);
}

Value show_value(const Parameter&, const std::vector<int>& numbers) {
  return numbers.empty() ? Value() : Value::List(numbers.begin(), numbers.end());
}

void read_value(const Parameter& self, Vec3& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (self.kind == ParameterKind::colour) return read_colour(self, value, path, reader, member);
  read_coordinates(self, value, path, reader, member);
}

void read_value(const Parameter& self, DVec3& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  read_coordinates(self, value, path, reader, member);
}

Value show_value(const Parameter& self, const Vec3& member) {
  if (self.kind == ParameterKind::colour) return show_colour(member);
  return show_value(self, DVec3(member));
}

Value show_value(const Parameter& self, const DVec3& member) {
  const Unit unit = self.form.unit;
  return Value::List{to_document(unit, member.x), to_document(unit, member.y), to_document(unit, member.z)};
}

void read_value(const Parameter& self, std::vector<Vec3>& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const Value::List* list = value.list();
  if (list == nullptr || list->empty()) return reader.wrong_kind(self, value, path);
  member.assign(list->size(), Vec3(0));
  const Parameter each = each_of(self);
  for (std::size_t k = 0; k < list->size(); ++k) read_value(each, member[k], (*list)[k], DocumentPath(path, k), reader);
}

Value show_value(const Parameter& self, const std::vector<Vec3>& member) {
  if (self.kind == ParameterKind::colours && member.empty()) return {};
  const Parameter each = each_of(self);
  Value::List list;
  for (const Vec3 vector : member) list.push_back(show_value(each, vector));
  return list;
}

void read_value(const Parameter& self, FacingDirection& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  if (const std::string* text = value.text()) {
    member.is_from_surface = *text == "surface";
    if (member.is_from_surface) return;
    return reader.add_error(path, fmt::format("'{}' is not a value of '{}'", *text, self.name), self.expectation(),
                            reader.nearest(*text, std::vector<std::string>{"surface"}));
  }
  Parameter numbers = self;
  numbers.kind = ParameterKind::vector;
  DVec3 direction(0);
  const std::size_t errors_before = reader.error_count();
  read_coordinates(numbers, value, path, reader, direction);
  if (reader.error_count() != errors_before) return;
  const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  if (!(largest > 0)) {
    return reader.add_error(path, fmt::format("the direction '{}' has no length", self.name),
                            "one number that is not 0");
  }
  member.direction = Vec3(glm::normalize(direction / largest));
}

Value show_value(const Parameter& self, const FacingDirection& member) {
  return member.is_from_surface ? Value("surface") : show_value(self, DVec3(member.direction));
}

void read_value(const Parameter& self, Box& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const Value::List* corners = value.list();
  if (corners == nullptr || corners->size() != 2) return reader.wrong_kind(self, value, path);
  read_value(self, member.low, (*corners)[0], DocumentPath(path, std::size_t{0}), reader);
  read_value(self, member.high, (*corners)[1], DocumentPath(path, std::size_t{1}), reader);
}

Value show_value(const Parameter& self, const Box& member) {
  return Value::List{show_value(self, member.low), show_value(self, member.high)};
}

void read_value(const Parameter& self, InstanceSelection& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const Value::List* list = value.list();
  if (list == nullptr) return reader.wrong_kind(self, value, path);
  Parameter number_row = element_of(self);
  number_row.kind = ParameterKind::integer;
  number_row.form = {.min = 0, .max = 4294967295.0, .fixed = true};
  InstanceSelection selection;
  selection.names = reader.expressions().instance_names().size();
  for (std::size_t k = 0; k < list->size(); ++k) {
    const Value& entry = (*list)[k];
    const DocumentPath entry_place(path, k);
    if (entry.text() != nullptr) {
      if (auto compiled = reader.expressions().read(entry, entry_place, reader.expressions().instance_names())) {
        selection.conditions.push_back({*entry.text(), std::move(*compiled)});
      }
      continue;
    }
    const Value::List* ends = entry.list();
    if (ends != nullptr && ends->size() != 2) {
      reader.add_error(entry_place, fmt::format("an entry of '{}' is {}", self.name, entry.description()),
                       self.expectation());
      continue;
    }
    const auto low = ends == nullptr
                         ? reader.numbers().read(number_row, entry, entry_place)
                         : reader.numbers().read(number_row, (*ends)[0], DocumentPath(entry_place, std::size_t{0}));
    const auto high = ends == nullptr
                          ? low
                          : reader.numbers().read(number_row, (*ends)[1], DocumentPath(entry_place, std::size_t{1}));
    if (!low || !high) continue;
    if (*low > *high) {
      reader.add_error(entry_place, fmt::format("the range from {:.12g} to {:.12g} is in the wrong order", *low, *high),
                       "the lower number first");
      continue;
    }
    selection.ranges.emplace_back(static_cast<std::uint32_t>(*low), static_cast<std::uint32_t>(*high));
  }
  member = std::move(selection);
}

Value show_value(const Parameter&, const InstanceSelection& selection) {
  Value::List list;
  for (const auto& [low, high] : selection.ranges) {
    const Value first(static_cast<double>(low));
    list.push_back(low == high ? first : Value(Value::List{first, static_cast<double>(high)}));
  }
  for (const SiteCondition& condition : selection.conditions) list.emplace_back(condition.text);
  return list;
}

void read_value(const Parameter& self, ParameterFormula& member, const Value& value, const DocumentPath& path,
                ParameterReader& reader) {
  const bool is_number = self.kind == ParameterKind::formula && value.number() != nullptr;
  const Value text = is_number ? Value(fmt::format("{}", *value.number())) : value;
  if (text.text() == nullptr) return reader.wrong_kind(self, text, path);
  if (auto compiled = reader.expressions().read(text, path, self.names)) member = {*text.text(), std::move(*compiled)};
}

Value show_value(const Parameter&, const ParameterFormula& member) { return member.text; }

void read_held(const Parameter& self, void* member, const Value& value, const DocumentPath& path,
               ParameterReader& reader) {
  const bool is_list = self.kind == ParameterKind::list, is_map = self.kind == ParameterKind::map;
  if ((is_list && value.list() == nullptr) || (is_map && value.object() == nullptr)) {
    return reader.wrong_kind(self, value, path);
  }
  self.type->make(member, value);
  if (is_list) {
    const Value::List& values = *value.list();
    for (std::size_t k = 0; k < values.size(); ++k) {
      const DocumentPath at(path, k);
      if (self.kinds != nullptr) {
        const std::optional<std::size_t> kind = read_kind(self.kinds(), self.nested(), values[k], at, reader);
        if (!kind) continue;
        self.type->make_kind(member, k, *kind);
      }
      reader.element(self, member, k, values[k], at);
    }
  } else if (is_map) {
    const Value::Object& values = *value.object();
    for (std::size_t k = 0; k < values.size(); ++k) {
      reader.element(self, member, k, values[k].second, DocumentPath(path, values[k].first));
    }
  } else {
    reader.object(self.nested(), self.type->element(member, 0), value, path);
  }
}

Value show_held(const Parameter& self, const void* member) {
  // The function gives elements only by a pointer that could change them; nothing changes here.
  const auto shown = [&](std::size_t index) {
    Value element = self.table_of(member, index).show(self.type->element(const_cast<void*>(member), index));
    if (self.kinds != nullptr) {
      const ElementKinds& kinds = self.kinds();
      element.object()->insert(element.object()->begin(),
                               {kinds.key, kinds.kinds[self.type->kind(member, index)].name});
    }
    return element;
  };
  const std::size_t count = self.type->count(member);
  if (self.kind == ParameterKind::object) return count > 0 ? shown(0) : Value();
  Value::List list;
  Value::Object map;
  for (std::size_t k = 0; k < count; ++k) {
    if (self.kind == ParameterKind::list) {
      list.push_back(shown(k));
    } else {
      map.emplace_back(self.type->name(member, k), shown(k));
    }
  }
  return self.kind == ParameterKind::list ? Value(std::move(list)) : Value(std::move(map));
}

}  // namespace meristem
