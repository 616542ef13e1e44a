// SPDX-License-Identifier: Apache-2.0
// Puts the keys of an animation into the tree of a document. Each key path is resolved to a row of a parameter table.
// If a parameter follows the clocks of instances, its keys replace its value. Any other parameter gets the value of its
// keys at the document's time.
#include "meristem/document/animation_keys.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/name_table.h"
#include "meristem/base/track.h"
#include "meristem/document/instance_variables.h"
#include "meristem/document/member_index.h"
#include "meristem/document/override.h"
#include "meristem/document/short_forms.h"
#include "meristem/document/tables.h"
#include "meristem/graph/crown_placement.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/table/member_type.h"

namespace meristem {

namespace {

const std::vector<std::string> kWays{"linear", "smooth", "step"};

/// The row at the end of a path, or the reason why the path is wrong.
struct FoundRow {
  const Parameter* row = nullptr;
  bool is_element = false;  // one number of a vector
  bool in_component = false;
  std::string member{};  // ".count": the rest of the path if it ends at the short form of an object
  std::string error{}, expected{}, nearest{};
};

/// One key as it is written.
struct WrittenKey {
  double time = 0;
  const Value* value = nullptr;
  KeyTrack::Way way = KeyTrack::Way::linear;
};

constexpr std::size_t kNoElement = SIZE_MAX;

/// Returns the index in brackets: 2 for "[2]". Returns kNoElement for other texts.
std::size_t index_of(const std::string& element) {
  if (element.size() < 3 || element[0] != '[') return kNoElement;
  std::size_t index = 0;
  const char* const end = element.data() + element.size() - 1;
  const auto parsed = std::from_chars(element.data() + 1, end, index);
  return parsed.ec == std::errc() && parsed.ptr == end ? index : kNoElement;
}

/// Returns true for rows whose values are lists of points.
bool is_shape(const Parameter& row) {
  return row.kind == ParameterKind::curve || row.kind == ParameterKind::points || row.kind == ParameterKind::positions;
}

/// Returns true if two values have lists of equal lengths in each other. A curve has a list in an object.
bool are_formed_alike(const Value& a, const Value& b) {
  const Value* const curve_a = a.find("curve");
  const Value* const curve_b = b.find("curve");
  if (curve_a != nullptr && curve_b != nullptr) return are_formed_alike(*curve_a, *curve_b);
  if (a.list() == nullptr || b.list() == nullptr) return a.list() == b.list() && curve_a == curve_b;
  return std::ranges::equal(*a.list(), *b.list(), are_formed_alike);
}

/// Returns true if two values of curves have the same kind. The kind is spline if the value does not give it.
bool are_of_one_kind(const Value& a, const Value& b) {
  const Value spline("spline");
  const Value* const kind_a = a.find("kind");
  const Value* const kind_b = b.find("kind");
  return (kind_a == nullptr ? spline : *kind_a) == (kind_b == nullptr ? spline : *kind_b);
}

/// Returns a list of points with other numbers. `numbers` begins with the number that comes next.
Value with_numbers(const Value& shape, std::span<const double>& numbers) {
  if (const Value* points = shape.find("curve")) {
    Value curve = shape;
    *curve.find("curve") = with_numbers(*points, numbers);
    return curve;
  }
  if (shape.list() == nullptr) {
    const double number = numbers.front();
    numbers = numbers.subspan(1);
    return number;
  }
  Value::List made;
  for (const Value& part : *shape.list()) made.push_back(with_numbers(part, numbers));
  return made;
}

/// Finds the parameter that the short form of an object or element sets, if the path ends there.
FoundRow short_form_of(const ParameterTable& table) {
  FoundRow found{.row = table.find(table.shorthand)};
  if (found.row == nullptr) {
    found.error = "a path leads to a single parameter";
  } else {
    found.member = "." + found.row->name;
  }
  return found;
}

/// Finds the row at the end of a path, beginning at its k-th element.
FoundRow row_at(const ParameterTable& first, const std::vector<std::string>& elements, std::size_t k,
                const ParameterReader& reader) {
  FoundRow found;
  const ParameterTable* table = &first;
  while (k < elements.size()) {
    const std::string& name = elements[k++];
    const Parameter* row = table->find(name);
    if (row == nullptr) {
      std::vector<std::string> names;
      for (const Parameter& one : table->parameters) names.push_back(one.name);
      found.error = fmt::format("{} has no parameter '{}'", table->name, name);
      found.nearest = reader.nearest(name, names);
      if (found.nearest.empty()) found.expected = fmt::format("one of {}", fmt::join(names, ", "));
      return found;
    }
    const bool has_element = k < elements.size() && elements[k][0] == '[';
    if (row->kind == ParameterKind::vector && has_element && k + 1 == elements.size()) {
      found.is_element = index_of(elements[k]) < 3;
      if (found.is_element) found.row = row;
      if (!found.is_element) found.error = fmt::format("'{}' has the elements [0] to [2]", name);
      return found;
    }
    if (is_shape(*row) && k < elements.size()) {
      const bool is_curve = row->kind == ParameterKind::curve;
      const std::size_t next = k + (is_curve ? 1 : 0);
      const auto rest = std::span(elements).subspan(std::min(next, elements.size()));
      const bool are_indices = std::ranges::all_of(rest, [](const auto& each) { return index_of(each) != kNoElement; });
      if (are_indices && (!is_curve || elements[k] == "curve")) found.row = row;
      if (found.row == nullptr) {
        found.error = fmt::format("'{}' has nothing of the name '{}'", name, elements[k]);
        found.expected =
            fmt::format("points such as {0}[0], and numbers such as {0}[0][1]", is_curve ? name + ".curve" : name);
      }
      return found;
    }
    if (k == elements.size()) {
      if (row->kind == ParameterKind::object && !row->nested().shorthand.empty()) return short_form_of(row->nested());
      found.row = row;
      return found;
    }
    const bool is_many = row->kind == ParameterKind::list || row->kind == ParameterKind::map;
    if (row->nested == nullptr || has_element != (row->kind == ParameterKind::list)) {
      found.error = fmt::format("'{}' has nothing of the name '{}'", name, elements[k]);
      return found;
    }
    if (is_many) ++k;
    table = &row->nested();
  }
  return short_form_of(*table);
}

/// Reads the keys of all parameters, one after the other.
class KeyReader {
 public:
  KeyReader(Value& root, const Registry* registry, double time, ParameterReader& reader)
      : root_(root),
        registry_(registry),
        time_(time),
        reader_(reader),
        components_(root.find("components")),
        variables_(root.find("variables")) {}

  std::vector<KeyedParameter> run(bool of_variables) {
    const Value* animation = root_.find("animation");
    const Value* given = animation == nullptr ? nullptr : animation->find("keys");
    if (given == nullptr) return {};
    const DocumentPath animation_place(top_, "animation");
    const DocumentPath place(animation_place, "keys");
    if (given->object() == nullptr) {
      if (!of_variables) {
        reader_.add_error(place, fmt::format("the keys are {}", given->description()),
                          R"(an object such as {"stem.length": [[0, 0.05], [4, 1.8, "smooth"]]})");
      }
      return {};
    }
    const Value::Object keys = *given->object();  // a copy, as the tree changes
    for (const auto& [name, list] : keys) {
      reader_.check_stop();
      const bool is_path = !path_elements(name).empty();
      const std::string path = is_path ? full_path(root_, name) : name;
      if (path.starts_with("variables.") != of_variables) continue;
      const DocumentPath own(place, name);
      if (!is_path) {
        reader_.add_name_error(own, fmt::format("'{}' is not a path", name),
                               "one such as age, stem.length or links[1].density", "");
        continue;
      }
      read(name, path, list, own);
    }
    return std::move(keyed_);
  }

 private:
  void read(const std::string& name, const std::string& given_path, const Value& list, const DocumentPath& place) {
    const FoundRow found = find(path_elements(given_path));
    if (found.row == nullptr) return reader_.add_name_error(place, found.error, found.expected, found.nearest);
    const std::string path = given_path + found.member + points_of_curve(found, given_path, list);
    const KeyClock clock = found.row->key_clock(found.in_component);
    if (clock == KeyClock::none) {
      return reader_.add_name_error(place, fmt::format("'{}' cannot have keys", name),
                                    "a parameter that is a number, a vector, a colour, a choice, or true or false", "");
    }
    const std::size_t errors_before = reader_.error_count();
    const std::vector<WrittenKey> keys = read_keys(*found.row, list, place);
    if (reader_.error_count() > errors_before) return;
    const bool by_instance = clock == KeyClock::instance;
    std::optional<Value> value;
    if (found.row->has_values_between()) {
      value = between(found, keys, place, by_instance);
    } else {
      value = jumping(*found.row, keys, place);
    }
    if (reader_.error_count() > errors_before) return;
    put(path, found, std::move(*value), place, by_instance);
    keyed_.push_back({name, path, clock, keys.back().time});
  }

  /// Returns the rest of the path for keys that are the points of a whole curve, which keeps its kind.
  static std::string points_of_curve(const FoundRow& found, const std::string& path, const Value& list) {
    const bool is_whole = found.row->kind == ParameterKind::curve && path_elements(path).back() == found.row->name;
    const Value::List* keys = list.list();
    const Value::List* first = is_whole && keys != nullptr && !keys->empty() ? keys->front().list() : nullptr;
    return first != nullptr && first->size() > 1 && (*first)[1].list() != nullptr ? ".curve" : "";
  }

  FoundRow find(const std::vector<std::string>& elements) const {
    const std::string& top = elements[0];
    if (top == "variables" && elements.size() > 1) return find_variable(elements);
    if (top == "components" && elements.size() > 2) return find_in_component(elements);
    if (top == "links") return find_in_link(elements);
    if (top == "scene" && elements.size() > 1) return row_at(head_table(), elements, 0, reader_);
    FoundRow found;
    found.error = fmt::format("'{}' cannot have keys", top);
    found.expected = "a parameter of a component, a link or the scene, or a variable";
    return found;
  }

  FoundRow find_variable(const std::vector<std::string>& elements) const {
    const std::string& name = elements[1];
    const Value* variables = root_.find("variables");
    const Value* variable = variables_.find(name);
    if (variable == nullptr) return unknown("variable", name, variables);
    FoundRow found;
    const bool is_value = elements.size() == 2 || (elements.size() == 3 && elements[2] == "value");
    if (!is_value) found.error = "a variable has keys as a whole";
    if (is_per_instance(*variable)) {
      found.error = fmt::format("'{}' is drawn for each instance and cannot have keys", name);
      found.expected = "keys of the parameters that use it";
    }
    if (found.error.empty()) found.row = variable_table().find("value");
    return found;
  }

  FoundRow find_in_component(const std::vector<std::string>& elements) const {
    const Value* components = root_.find("components");
    const Value* component = components_.find(elements[1]);
    if (component == nullptr) return unknown("component", elements[1], components);
    const Value* type_name = component->find("type");
    const bool has_type = type_name != nullptr && type_name->text() != nullptr;
    const ComponentType* type = has_type ? registry_->find(*type_name->text()) : nullptr;
    FoundRow found;
    if (type == nullptr) {
      found.error = fmt::format("'{}' has no type that is known", elements[1]);
      return found;
    }
    found = row_at(type->parameters, elements, 2, reader_);
    found.in_component = true;
    return found;
  }

  FoundRow find_in_link(const std::vector<std::string>& elements) const {
    FoundRow found;
    const Value* links = root_.find("links");
    const std::size_t index = elements.size() > 1 ? index_of(elements[1]) : kNoElement;
    const bool is_there = links != nullptr && links->list() != nullptr && index < links->list()->size();
    const Value* link = is_there ? &(*links->list())[index] : nullptr;
    if (link == nullptr || link->object() == nullptr) {
      found.error = is_there ? "a link that is a pair has no parameters" : "there is no such link";
      found.expected = R"(a link such as links[1], which is an object with "from" and "to")";
      return found;
    }
    const Value* kind = link->find("kind");
    const bool is_crown = kind != nullptr && *kind == Value("crown");
    return row_at(is_crown ? crown_placement_table() : placement_table(), elements, 2, reader_);
  }

  FoundRow unknown(const char* what, const std::string& name, const Value* among) const {
    FoundRow found;
    found.error = fmt::format("there is no {} '{}'", what, name);
    if (reader_.error_count() >= reader_.limits().diagnostics) return found;  // further faults are only counted
    std::vector<std::string> names;
    if (among != nullptr && among->object() != nullptr) {
      for (const auto& [known, value] : *among->object()) names.push_back(known);
    }
    found.nearest = reader_.nearest(name, names);
    if (found.nearest.empty()) found.expected = names.empty() ? "" : fmt::format("one of {}", fmt::join(names, ", "));
    return found;
  }

  std::vector<WrittenKey> read_keys(const Parameter& row, const Value& list, const DocumentPath& place) {
    std::vector<WrittenKey> keys;
    if (list.list() == nullptr || list.list()->empty()) {
      reader_.add_error(place, fmt::format("the keys of '{}' are {}", row.name, list.description()),
                        R"(a list of keys such as [[0, 0.05], [4, 1.8, "smooth"]])");
      return keys;
    }
    for (std::size_t k = 0; k < list.list()->size(); ++k) {
      const DocumentPath own(place, k);
      const Value& written = (*list.list())[k];
      const Value::List* parts = written.list();
      if (parts == nullptr || parts->size() < 2 || parts->size() > 3) {
        reader_.add_error(own, fmt::format("a key is {}", written.description()),
                          R"([time, value], or [time, value, "smooth"])");
        continue;
      }
      WrittenKey key{.value = &(*parts)[1]};
      key.way = row.has_values_between() ? KeyTrack::Way::linear : KeyTrack::Way::step;
      if (!read_time((*parts)[0], DocumentPath(own, std::size_t{0}), key.time)) continue;
      if (parts->size() == 3) read_way(row, (*parts)[2], DocumentPath(own, std::size_t{2}), key.way);
      if (!keys.empty() && !(keys.back().time < key.time)) {
        reader_.add_error(DocumentPath(own, std::size_t{0}),
                          keys.back().time == key.time ? fmt::format("there are two keys at {:.12g} s", key.time)
                                                       : fmt::format("the key at {:.12g} s follows one at {:.12g} s",
                                                                     key.time, keys.back().time),
                          "keys at rising times");
        continue;
      }
      keys.push_back(key);
    }
    return keys;
  }

  bool read_time(const Value& value, const DocumentPath& place, double& time) {
    if (value.number() != nullptr && std::isfinite(*value.number()) && *value.number() >= 0) {
      time = *value.number();
      return true;
    }
    reader_.add_error(place, fmt::format("the time of a key cannot be {}", value.description()),
                      "seconds of at least 0");
    return false;
  }

  void read_way(const Parameter& row, const Value& value, const DocumentPath& place, KeyTrack::Way& way) {
    const auto found = value.text() == nullptr ? kWays.end() : std::ranges::find(kWays, *value.text());
    if (found == kWays.end()) {
      return reader_.add_error(place, fmt::format("{} is not a way between keys", value.description()),
                               "linear, smooth or step",
                               value.text() == nullptr ? "" : reader_.nearest(*value.text(), kWays));
    }
    way = static_cast<KeyTrack::Way>(found - kWays.begin());
    if (row.has_values_between() || way == KeyTrack::Way::step) return;
    reader_.add_error(place, fmt::format("'{}' has no values between its keys", row.name), "step, or nothing");
  }

  /// Returns the keys if the value differs from instance to instance. Otherwise returns the value of the keys at the
  /// present time.
  std::optional<Value> between(const FoundRow& found, const std::vector<WrittenKey>& keys, const DocumentPath& place,
                               bool by_instance) {
    const Parameter& row = *found.row;
    if (row.kind == ParameterKind::colour) return colour_now(row, keys, place);
    if (is_shape(row)) return shape_now(row, keys, place);
    Parameter number = row;
    if (row.kind == ParameterKind::vector) number.kind = ParameterKind::number;
    if (by_instance && number.kind == ParameterKind::integer) number.kind = ParameterKind::number;
    const bool is_whole_vector = row.kind == ParameterKind::vector && !found.is_element;
    if (!is_whole_vector) {
      Value::List list = numbers(number, keys, place, by_instance, std::nullopt);
      const bool is_whole = row.kind == ParameterKind::integer && !row.form.counts;
      return by_instance ? Value(std::move(list)) : now(list, is_whole);
    }
    Value::List vector;
    for (std::size_t c = 0; c < 3; ++c) {
      Value::List list = numbers(number, keys, place, by_instance, c);
      vector.push_back(by_instance ? Value(std::move(list)) : now(list, false));
    }
    return vector;
  }

  /// Reads keys as [[time, value, way], ...]: keys of numbers, of ranges, or of one component of vectors.
  Value::List numbers(const Parameter& number, const std::vector<WrittenKey>& keys, const DocumentPath& place,
                      bool with_ranges, std::optional<std::size_t> component) {
    Value::List list;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const DocumentPath key_place(place, k);
      const DocumentPath value_place(key_place, std::size_t{1});
      Value value = *keys[k].value;
      if (component) {
        if (value.list() == nullptr || value.list()->size() != 3) {
          if (*component == 0) {
            reader_.add_error(value_place, fmt::format("'{}' cannot be {}", number.name, value.description()),
                              "a list of three numbers [x, y, z]");
          }
          continue;
        }
        value = one_number(number, (*value.list())[*component], DocumentPath(value_place, *component));
      } else if (with_ranges && value.list() != nullptr && value.list()->size() == 2) {
        const Value::List ends = *value.list();
        value = Value::List{one_number(number, ends[0], DocumentPath(value_place, std::size_t{0})),
                            one_number(number, ends[1], DocumentPath(value_place, std::size_t{1}))};
      } else {
        value = one_number(number, value, value_place);
      }
      list.push_back(Value::List{keys[k].time, std::move(value), static_cast<int>(keys[k].way)});
    }
    return list;
  }

  Value one_number(const Parameter& number, const Value& value, const DocumentPath& place) {
    return reader_.numbers().read(number, value, place).value_or(0);
  }

  Value now(const Value::List& list, bool is_whole) const {
    if (list.empty()) return 0;
    std::vector<KeyTrack::Key> keys;
    for (const Value& key : list) {
      const Value::List& parts = *key.list();
      keys.push_back(
          {*parts[0].number(), *parts[1].number(), static_cast<KeyTrack::Way>(static_cast<int>(*parts[2].number()))});
    }
    const double value = KeyTrack(std::move(keys)).at(time_);
    return is_whole ? std::floor(value + 0.5) : value;
  }

  /// Returns the colour of the keys at the present time. Colours are interpolated in sRGB, as they are written.
  std::optional<Value> colour_now(const Parameter& row, const std::vector<WrittenKey>& keys,
                                  const DocumentPath& place) {
    std::array<std::vector<KeyTrack::Key>, 3> channels;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      Vec3 colour(0);
      const DocumentPath key_place(place, k);
      const std::size_t errors_before = reader_.error_count();
      read_value(row, colour, *keys[k].value, DocumentPath(key_place, std::size_t{1}), reader_);
      if (reader_.error_count() > errors_before) return std::nullopt;
      for (int c = 0; c < 3; ++c) {
        channels[static_cast<std::size_t>(c)].push_back(
            {keys[k].time, static_cast<double>(std::floor(colour[c] * 255.0F + 0.5F)), keys[k].way});
      }
    }
    std::string text = "#";
    for (std::vector<KeyTrack::Key>& channel : channels) {
      text += fmt::format("{:02x}", static_cast<int>(std::floor(KeyTrack(std::move(channel)).at(time_) + 0.5)));
    }
    return Value(std::move(text));
  }

  /// Returns the points of the keys at the present time. Each number is interpolated by itself, so all keys must have
  /// equally many points. The reader of the row checks the points.
  std::optional<Value> shape_now(const Parameter& row, const std::vector<WrittenKey>& keys, const DocumentPath& place) {
    const Value& first = *keys.front().value;
    std::vector<std::vector<KeyTrack::Key>> tracks;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const DocumentPath key_place(place, k);
      const DocumentPath value_place(key_place, std::size_t{1});
      if (!are_formed_alike(first, *keys[k].value)) {
        reader_.add_error(value_place, fmt::format("this key of '{}' has other points than the first key", row.name),
                          "as many points in each key, each a list of equally many numbers");
        return std::nullopt;
      }
      if (!are_of_one_kind(first, *keys[k].value)) {
        reader_.add_error(value_place, fmt::format("this key of '{}' has another kind than the first key", row.name),
                          "one kind in all keys");
        return std::nullopt;
      }
      std::vector<double> numbers;
      if (!add_numbers(row, *keys[k].value, value_place, numbers)) return std::nullopt;
      tracks.resize(numbers.size());
      for (std::size_t n = 0; n < numbers.size(); ++n) tracks[n].push_back({keys[k].time, numbers[n], keys[k].way});
    }
    std::vector<double> now;
    for (std::vector<KeyTrack::Key>& track : tracks) now.push_back(KeyTrack(std::move(track)).at(time_));
    std::span<const double> rest = now;
    return with_numbers(first, rest);
  }

  /// Adds the numbers of a list of points, which may be expressions. Returns false after an error.
  bool add_numbers(const Parameter& row, const Value& shape, const DocumentPath& place, std::vector<double>& numbers) {
    if (const Value* points = shape.find("curve")) {
      return add_numbers(row, *points, DocumentPath(place, "curve"), numbers);
    }
    if (shape.list() != nullptr) {
      for (std::size_t k = 0; k < shape.list()->size(); ++k) {
        if (!add_numbers(row, (*shape.list())[k], DocumentPath(place, k), numbers)) return false;
      }
      return true;
    }
    Parameter number = row;
    number.kind = ParameterKind::number;
    number.form = {.unit = row.form.unit, .fixed = true};
    const std::optional<double> found = reader_.numbers().read(number, shape, place);
    if (found) numbers.push_back(*found);
    return found.has_value();
  }

  /// Returns the value of the last key so far, for parameters without values between keys.
  std::optional<Value> jumping(const Parameter& row, const std::vector<WrittenKey>& keys, const DocumentPath& place) {
    const Value* last = keys.front().value;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const DocumentPath key_place(place, k);
      const DocumentPath value_place(key_place, std::size_t{1});
      if (row.kind == ParameterKind::choice) {
        if (!reader_.choice(row, *keys[k].value, value_place)) return std::nullopt;
      } else if (keys[k].value->boolean() == nullptr) {
        reader_.wrong_kind(row, *keys[k].value, value_place);
      }
      if (keys[k].time <= time_) last = keys[k].value;
    }
    return *last;
  }

  void put(const std::string& path, const FoundRow& found, Value value, const DocumentPath& place, bool by_instance) {
    std::vector<Diagnostic> errors;
    if (registry_ != nullptr) write_out_short_forms(root_, *registry_, path_elements(path));
    if (found.is_element) add_vector(path.substr(0, path.rfind('[')), *found.row, place, errors);
    Value* const target = find_or_add_known(path, place, errors);
    if (target == nullptr) {
      for (const Diagnostic& diagnostic : errors)
        reader_.add_name_error(place, diagnostic.message, diagnostic.expected, diagnostic.nearest);
      return;
    }
    if (!by_instance) {
      *target = std::move(value);
      return;
    }
    const bool is_whole_vector = found.row->kind == ParameterKind::vector && !found.is_element;
    if (!is_whole_vector) return put_keys(*target, std::move(value));
    Value::List& parts = *value.list();
    Value::List before = target->list() != nullptr ? *target->list() : Value::List();
    before.resize(3);
    for (std::size_t c = 0; c < 3; ++c) put_keys(before[c], std::move(parts[c]));
    *target = std::move(before);
  }

  /// Finds or adds the value at a path. The component or variable of the path must exist.
  Value* find_or_add_known(const std::string& path, const DocumentPath& place, std::vector<Diagnostic>& errors) {
    const std::vector<std::string> elements = path_elements(path);
    const bool is_component = elements.size() > 1 && elements[0] == "components";
    const auto position = is_component ? components_.position(elements[1]) : std::nullopt;
    if (!position) return find_or_add(root_, path, place.text(), errors);
    Value& component = (*root_.find("components")->object())[*position].second;
    return find_or_add_below(component, std::span(elements).subspan(2), place.text(), errors);
  }

  /// If only one number of a vector has keys and the document does not give the vector, adds the vector with its
  /// defaults.
  void add_vector(const std::string& path, const Parameter& row, const DocumentPath& place,
                  std::vector<Diagnostic>& errors) {
    Value* const vector = find_or_add_known(path, place, errors);
    if (vector == nullptr || !vector->is_null()) return;
    *vector = row.fallback();
    if (vector->is_null()) *vector = Value::List{0, 0, 0};
  }

  /// Replaces a value by its keys. An expression in "apply" is kept.
  static void put_keys(Value& target, Value keys) {
    const Value* apply = target.object() != nullptr ? target.find("apply") : nullptr;
    Value::Object made{{"keys", std::move(keys)}};
    if (apply != nullptr) made.emplace_back("apply", *apply);
    target = std::move(made);
  }

  Value& root_;
  const Registry* registry_;
  double time_;
  ParameterReader& reader_;
  const MemberIndex components_;
  const MemberIndex variables_;
  const DocumentPath top_;
  std::vector<KeyedParameter> keyed_;
};

/// Returns for each component 1 if it descends from a component that begins a clock, else 0.
std::vector<std::uint8_t> with_own_clocks(const Graph& graph) {
  std::vector<std::uint8_t> own(graph.components.size(), 0);
  std::vector<ComponentIndex> open;
  for (ComponentIndex c = 0; c < graph.components.size(); ++c) {
    if (graph.components[c].type->begins_clock) open.push_back(c);
  }
  while (!open.empty()) {
    const ComponentIndex from = open.back();
    open.pop_back();
    for (const LinkIndex link : graph.structure.outgoing[from]) {
      const ComponentIndex to = graph.links[link].to;
      if (own[to] != 0) continue;
      own[to] = 1;
      open.push_back(to);
    }
  }
  return own;
}

}  // namespace

std::vector<KeyedParameter> put_variable_keys(Value& root, double time, ParameterReader& reader) {
  return KeyReader(root, nullptr, time, reader).run(true);
}

std::vector<KeyedParameter> put_other_keys(Value& root, const Registry& registry, double time,
                                           ParameterReader& reader) {
  return KeyReader(root, &registry, time, reader).run(false);
}

void check_key_clocks(const std::vector<KeyedParameter>& keyed, const Graph& graph,
                      std::vector<Diagnostic>& diagnostics) {
  const std::vector<std::uint8_t> own = with_own_clocks(graph);
  NameTable ids;
  for (const Prototype& prototype : graph.components) ids.add(prototype.id);
  const double end = graph.animation->length;
  for (const KeyedParameter& parameter : keyed) {
    const std::vector<std::string> elements = path_elements(parameter.path);
    bool has_own_clock = false;
    if (elements[0] == "components") {
      const auto found = ids.find(elements[1]);
      has_own_clock = found && own[*found] != 0;
    } else if (elements[0] == "links") {
      const std::size_t link = index_of(elements[1]);
      const ComponentIndex from = graph.links[link].from;
      has_own_clock = own[from] != 0 || graph.components[from].type->begins_clock;
    }
    const std::string place = "animation.keys." + parameter.name;
    if (has_own_clock && parameter.clock == KeyClock::document) {
      diagnostics.push_back(
          {.message = fmt::format(
               "'{}' is one value for all instances, and each has a clock of its own below a sequence", parameter.name),
           .expected = "keys of a parameter that may differ from instance to instance",
           .path = place});
    } else if (!has_own_clock && parameter.last_time > end) {
      diagnostics.push_back({.message = fmt::format("'{}' has a key at {:.12g} s, after the animation's end",
                                                    parameter.name, parameter.last_time),
                             .expected = fmt::format("times up to the \"length\", {:.12g} s", end),
                             .path = place});
    }
  }
}

}  // namespace meristem
