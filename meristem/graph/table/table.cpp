// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace meristem::table_detail {

namespace {

/// A value as people write it: 137.508 and not the 137.50800323486328 of a float, 60 and not 59.999999999999993.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  // Not std::stod, which reads a comma where the host program's locale says so.
  const std::string digits = fmt::format("{:.7g}", value);
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

const StoreNumber kStoreFloat = [](void* slot, double number) {
  *static_cast<float*>(slot) = static_cast<float>(number);
};

/// A row that stands for one number inside another row's value, which is stored as a float.
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

/// Reads a pair [x, y] of plain numbers.
bool read_pair(const Parameter& element, const Value& value, const Place& place, ParameterReader& reader, Vec2& out) {
  const Value::List* pair = value.list();
  if (pair == nullptr || pair->size() != 2) {
    reader.fault(place, fmt::format("a point of '{}' cannot be {}", element.name, value.description()),
                 "a pair of numbers such as [0.5, 2]");
    return false;
  }
  const auto x = reader.number(element, (*pair)[0], Place(place, std::size_t{0}));
  const auto y = reader.number(element, (*pair)[1], Place(place, std::size_t{1}));
  if (!x || !y) return false;
  out = Vec2(*x, *y);
  return true;
}

bool read_pairs(const Parameter& element, const Value& value, const Place& place, ParameterReader& reader,
                std::vector<Vec2>& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->empty()) {
    reader.fault(place, fmt::format("'{}' cannot be {}", element.name, value.description()),
                 "a list of pairs such as [[0, 1], [0.5, 2]]");
    return false;
  }
  bool good = true;
  std::vector<Vec2> points(list->size());
  for (std::size_t k = 0; k < list->size(); ++k) {
    good = read_pair(element, (*list)[k], Place(place, k), reader, points[k]) && good;
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

}  // namespace

double to_document(Unit unit, double value) { return rounded(unit == Unit::degree ? degrees(value) : value); }

void read_curve(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader, Curve& out) {
  if (value.object() == nullptr) return reader.wrong_kind(self, value, place);
  CurveKind kind = CurveKind::spline;
  std::vector<Vec2> points;
  bool good = true;
  Parameter kind_row;
  kind_row.name = "kind";
  kind_row.kind = ParameterKind::choice;
  kind_row.choices = {"spline", "linear"};
  const std::vector<std::string> names = {"curve", "kind"};
  for (const auto& [name, member] : *value.object()) {
    const Place member_place(place, name);
    if (name == "curve") {
      good = read_pairs(element_of(self), member, member_place, reader, points) && good;
    } else if (name == "kind") {
      const auto chosen = reader.choice(kind_row, member, member_place);
      good = chosen.has_value() && good;
      kind = static_cast<CurveKind>(chosen.value_or(0));
    } else {
      reader.fault(member_place, fmt::format("'{}' does not belong to a curve", name), "curve and kind",
                   reader.nearest(name, names));
      good = false;
    }
  }
  if (!good) return;
  if (points.empty()) return reader.fault(place, "the curve has no points", self.expectation());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool outside = points[k].x < 0 || points[k].x > 1;
    if (outside || (k > 0 && !(points[k - 1].x < points[k].x))) {
      const Place curve_place(place, "curve");
      reader.fault(Place(curve_place, k),
                   outside ? fmt::format("x = {:.7g} of the curve's point {} is out of range", points[k].x, k)
                           : fmt::format("x = {:.7g} of the curve's point {} does not rise", points[k].x, k),
                   "x from 0 to 1, strictly rising");
      return;
    }
  }
  out = Curve(std::move(points), kind);
}

Value show_curve(const Curve& curve) {
  Value::Object object{{"curve", show_points(curve.points())}};
  if (curve.kind() == CurveKind::linear) object.emplace_back("kind", "linear");
  return object;
}

void read_points(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                 std::vector<Vec2>& out) {
  read_pairs(element_of(self), value, place, reader, out);
}

Value show_points(const std::vector<Vec2>& points) {
  Value::List list;
  for (const Vec2& point : points) list.emplace_back(Value::List{rounded(point.x), rounded(point.y)});
  return list;
}

void read_integers(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                   std::vector<int>& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->size() != self.count) return reader.wrong_kind(self, value, place);
  Parameter element = element_of(self);
  element.kind = ParameterKind::integer;
  std::vector<int> numbers;
  for (std::size_t k = 0; k < list->size(); ++k) {
    if (const auto number = reader.number(element, (*list)[k], Place(place, k)))
      numbers.push_back(static_cast<int>(*number));
  }
  if (numbers.size() == self.count) out = std::move(numbers);
}

Value show_integers(const std::vector<int>& numbers) { return Value::List(numbers.begin(), numbers.end()); }

void read_vector(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader, Vec3& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->size() != 3) return reader.wrong_kind(self, value, place);
  const Parameter element = element_of(self);
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::size_t>(k);
    reader.store_number(element, (*list)[index], Place(place, index),
                        {&out[k], kStoreFloat, to_document(self.form.unit, out[k])});
  }
}

Value show_vector(Unit unit, Vec3 vector) {
  return Value::List{to_document(unit, vector.x), to_document(unit, vector.y), to_document(unit, vector.z)};
}

void read_places(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                 std::vector<Vec3>& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->empty()) return reader.wrong_kind(self, value, place);
  out.assign(list->size(), Vec3(0));
  Parameter each = element_of(self);
  each.kind = ParameterKind::vector;
  for (std::size_t k = 0; k < list->size(); ++k) read_vector(each, (*list)[k], Place(place, k), reader, out[k]);
}

Value show_places(Unit unit, const std::vector<Vec3>& places) {
  Value::List list;
  for (const Vec3 place : places) list.push_back(show_vector(unit, place));
  return list;
}

void read_box(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader, Box& out) {
  const Value::List* corners = value.list();
  if (corners == nullptr || corners->size() != 2) return reader.wrong_kind(self, value, place);
  read_vector(self, (*corners)[0], Place(place, std::size_t{0}), reader, out.low);
  read_vector(self, (*corners)[1], Place(place, std::size_t{1}), reader, out.high);
}

Value show_box(Unit unit, const Box& box) {
  return Value::List{show_vector(unit, box.low), show_vector(unit, box.high)};
}

void read_colour(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader, Vec3& out) {
  const std::string* text = reader.text(self, value, place);
  if (text == nullptr) return;
  bool good = text->size() == 7 && (*text)[0] == '#';
  for (std::size_t k = 1; good && k < 7; ++k) good = hexadecimal((*text)[k]) >= 0;
  if (!good) return reader.fault(place, fmt::format("'{}' is not a colour", *text), self.expectation());
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

void read_colours(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                  std::vector<Vec3>& out) {
  const Value::List* list = value.list();
  if (list == nullptr || list->empty()) return reader.wrong_kind(self, value, place);
  out.assign(list->size(), Vec3(0));
  Parameter each = element_of(self);
  each.kind = ParameterKind::colour;
  for (std::size_t k = 0; k < list->size(); ++k) read_colour(each, (*list)[k], Place(place, k), reader, out[k]);
}

Value show_colours(const std::vector<Vec3>& colours) {
  Value::List list;
  for (const Vec3 colour : colours) list.push_back(show_colour(colour));
  return list;
}

void read_selection(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                    std::optional<Selection>& out) {
  const Value::List* list = value.list();
  if (list == nullptr) return reader.wrong_kind(self, value, place);
  Parameter number_row = element_of(self);
  number_row.kind = ParameterKind::integer;
  number_row.form = {.min = 0, .max = 4294967295.0, .fixed = true};
  Selection selection;
  for (std::size_t k = 0; k < list->size(); ++k) {
    const Value& entry = (*list)[k];
    const Place entry_place(place, k);
    if (entry.text() != nullptr) {
      if (auto compiled = reader.expression(entry, entry_place, site_variables())) {
        selection.conditions.push_back({*entry.text(), std::move(*compiled)});
      }
      continue;
    }
    const Value::List* ends = entry.list();
    if (ends != nullptr && ends->size() != 2) {
      reader.fault(entry_place, fmt::format("an entry of '{}' is {}", self.name, entry.description()),
                   self.expectation());
      continue;
    }
    const auto low = ends == nullptr ? reader.number(number_row, entry, entry_place)
                                     : reader.number(number_row, (*ends)[0], Place(entry_place, std::size_t{0}));
    const auto high = ends == nullptr ? low : reader.number(number_row, (*ends)[1], Place(entry_place, std::size_t{1}));
    if (!low || !high) continue;
    if (*low > *high) {
      reader.fault(entry_place, fmt::format("the range from {:.12g} to {:.12g} falls", *low, *high),
                   "the lower number first");
      continue;
    }
    selection.ranges.emplace_back(static_cast<std::uint32_t>(*low), static_cast<std::uint32_t>(*high));
  }
  out = std::move(selection);
}

Value show_selection(const Selection& selection) {
  Value::List list;
  for (const auto& [low, high] : selection.ranges) {
    const Value first(static_cast<double>(low));
    list.push_back(low == high ? first : Value(Value::List{first, static_cast<double>(high)}));
  }
  for (const Condition& condition : selection.conditions) list.emplace_back(condition.text);
  return list;
}

void read_condition(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                    std::optional<Condition>& out) {
  if (value.text() == nullptr) return reader.wrong_kind(self, value, place);
  if (auto compiled = reader.expression(value, place, self.names)) out = Condition{*value.text(), std::move(*compiled)};
}

void read_formula(const Parameter& self, const Value& value, const Place& place, ParameterReader& reader,
                  std::optional<Formula>& out) {
  const Value text = value.number() != nullptr ? Value(fmt::format("{}", *value.number())) : value;
  read_condition(self, text, place, reader, out);
}

Value show_object(const ParameterTable& table, const void* object) {
  Value::Object members;
  for (const Parameter& row : table.parameters) {
    Value shown = row.show(object);
    if (!shown.is_null()) members.emplace_back(row.name, std::move(shown));
  }
  return members;
}

}  // namespace meristem::table_detail
