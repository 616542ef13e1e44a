// SPDX-License-Identifier: Apache-2.0
// Reads numbers. A plain number is stored at once. A range, a sample, keys or an expression in a component becomes a
// Varying, which is evaluated for each instance later.
#include "meristem/graph/table/number_reader.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/graph/table/sample.h"
#include "meristem/scene/light/clock.h"

namespace meristem {

namespace {

double document_scale(Unit unit) { return unit == Unit::degree ? kPi / 180 : 1; }

bool is_in_range(const NumberRange& form, double value) {
  return std::isfinite(value) && value <= form.max && (form.above_min ? value > form.min : value >= form.min);
}

bool is_any_of(std::string_view name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns the value of an expression that is equal for all instances, or nothing for other expressions.
std::optional<double> constant_of(const Varying& varying) {
  if (!varying.expression || !varying.expression->is_constant()) return std::nullopt;
  return varying.expression->evaluate();
}

/// Returns the rest of a path after the component: "components.leaf.curl" gives "curl".
std::string_view path_in_component(std::string_view file_path) {
  for (int level = 0; level < 2; ++level) {
    const std::size_t dot = file_path.find('.');
    if (dot == std::string_view::npos) break;
    file_path.remove_prefix(dot + 1);
  }
  return file_path;
}

/// Makes a range over time of keys that the reader of animations has checked and sorted.
KeyedRange keyed_range(const Value& keys) {
  std::vector<KeyTrack::Key> first;
  std::vector<KeyTrack::Key> last;
  for (const Value& key : *keys.list()) {
    const Value::List& parts = *key.list();
    const auto way = static_cast<KeyTrack::Way>(static_cast<int>(*parts[2].number()));
    const Value::List* range = parts[1].list();
    first.push_back({*parts[0].number(), range != nullptr ? *(*range)[0].number() : *parts[1].number(), way});
    last.push_back({*parts[0].number(), range != nullptr ? *(*range)[1].number() : *parts[1].number(), way});
  }
  return {KeyTrack(std::move(first)), KeyTrack(std::move(last))};
}

}  // namespace

bool NumberReader::check_range(const Parameter& parameter, double value, const DocumentPath& path,
                               std::string_view what) {
  if (is_in_range(parameter.form, value)) return true;
  errors_.add_error(path, fmt::format("{} {:.12g} is out of range for '{}'", what, value, parameter.name),
                    parameter.expectation());
  return false;
}

/// Returns the reason why a number must not vary, as the rest of a sentence that begins with its name.
std::string_view NumberReader::why_one(const Parameter& parameter) const {
  return parameter.form.fixed || holder_ != nullptr ? "is one number for all instances"
                                                    : "is one number (only those of components vary)";
}

std::optional<double> NumberReader::read(const Parameter& parameter, const Value& value, const DocumentPath& path) {
  check_stop();
  if (const double* plain = value.number()) {
    if (parameter.kind == ParameterKind::integer && !parameter.form.counts && *plain != std::floor(*plain)) {
      errors_.add_error(path, fmt::format("'{}' cannot be the fraction {:.12g}", parameter.name, *plain),
                        parameter.expectation());
      return std::nullopt;
    }
    return check_range(parameter, *plain, path, "the value") ? std::optional(*plain) : std::nullopt;
  }
  if (value.text() == nullptr) {
    errors_.wrong_kind(parameter, value, path);
    return std::nullopt;
  }
  if (parameter.form.unit == Unit::hour && value.text()->find(':') != std::string::npos) {
    const std::optional<double> hours = parse_clock_hour(*value.text());
    if (!hours) {
      errors_.add_error(path, fmt::format("'{}' is not a time", *value.text()),
                        "hours and minutes such as \"15:30\", or a number");
      return std::nullopt;
    }
    return check_range(parameter, *hours, path, "the time") ? hours : std::nullopt;
  }
  const std::optional<Expression> compiled = expressions_.read(value, path, expressions_.instance_names());
  if (!compiled) return std::nullopt;
  if (!compiled->is_constant()) {
    errors_.add_error(
        path, fmt::format("'{}' {}, and this expression differs between instances", parameter.name, why_one(parameter)),
        "an expression of numbers and the document's variables");
    return std::nullopt;
  }
  const double result = compiled->evaluate();
  return check_range(parameter, result, path, "the expression's value") ? std::optional(result) : std::nullopt;
}

void NumberReader::store(const Parameter& parameter, const Value& value, const DocumentPath& path,
                         const NumberSlot& slot) {
  if (value.number() == nullptr) worked_out_.insert(path.text());
  const double scale = document_scale(parameter.form.unit);
  const auto store = [&](double number) { slot.store(slot.member, number * scale); };
  const bool may_vary = holder_ != nullptr && parameter.may_vary();
  if (value.number() != nullptr || (value.text() != nullptr && !may_vary)) {
    const std::optional<double> given = read(parameter, value, path);
    if (given) store(parameter.form.counts && value.number() == nullptr ? std::floor(*given + 0.5) : *given);
    return;
  }
  if (!may_vary) {
    const bool has_form = value.list() != nullptr || value.find("range") != nullptr || value.find("apply") != nullptr ||
                          value.find("sample") != nullptr;
    if (!has_form) {
      return errors_.wrong_kind(parameter, value, path);
    }
    errors_.add_error(path,
                      fmt::format("'{}' {} and cannot be {}", parameter.name, why_one(parameter), value.description()),
                      parameter.expectation());
    return;
  }
  std::optional<Varying> varied = varying(parameter, value, path, slot.present);
  if (!varied) return;
  if (const std::optional<double> constant = constant_of(*varied)) {
    const double number = parameter.form.counts ? std::floor(*constant + 0.5) : *constant;
    if (check_range(parameter, number, path, "the expression's value")) store(number);
    return;
  }
  varied->store = slot.store;
  varied->way = way_;
  varied->offset = static_cast<std::size_t>(static_cast<std::byte*>(slot.member) - holder_);
  // Until an instance has its own value, the member has the default: rules between parameters see it as given.
  store(slot.present);
  varyings_.push_back(std::move(*varied));
}

void NumberReader::store_per_child(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                   PerChild& number) {
  const double scale = document_scale(parameter.form.unit);
  std::optional<Varying> varied;
  std::optional<double> plain;
  if (value.number() != nullptr) {
    plain = read(parameter, value, path);
  } else {
    varied = varying(parameter, value, path, number.plain / scale);
    if (varied) plain = constant_of(*varied);
    if (plain && !check_range(parameter, *plain, path, "the expression's value")) return;
  }
  if (plain) {
    number = PerChild(*plain * scale);
  } else if (varied) {
    number.varying = std::move(varied);
  }
}

/// Checks the keys of a value that is an object.
void NumberReader::check_members(const Value& value, const DocumentPath& path) {
  static const std::vector<std::string> names{"range", "sample", "smooth", "apply"};
  const bool is_keyed = value.find("keys") != nullptr && keyed_.contains(path.text());
  for (const auto& [name, member] : *value.object()) {
    if (is_any_of(name, names) || (is_keyed && name == "keys")) continue;
    errors_.add_error(DocumentPath(path, name), fmt::format("'{}' does not belong to a value", name),
                      name == "keys" ? "keys in the document's \"animation\"" : "range or sample, and apply",
                      errors_.nearest(name, names));
  }
  const bool has_sample = value.find("sample") != nullptr;
  if (has_sample && value.find("range") != nullptr) {
    errors_.add_error(DocumentPath(path, "range"), "a value has both a sample and a range", "one of them");
  }
  if (!has_sample && value.find("smooth") != nullptr) {
    errors_.add_error(DocumentPath(path, "smooth"), "'smooth' has no meaning without a sample", "'sample' beside it");
  }
}

/// Reads both ends of a range. Returns false if the value is no range.
bool NumberReader::read_range(const Parameter& parameter, const Value& value, const DocumentPath& path,
                              Varying& varying) {
  const Value::List* ends = value.list();
  if (ends == nullptr || ends->size() != 2) {
    errors_.add_error(path, fmt::format("the range of '{}' is {}", parameter.name, value.description()),
                      "a list of two numbers");
    return false;
  }
  varying.first = read(parameter, (*ends)[0], DocumentPath(path, std::size_t{0})).value_or(0);
  varying.last = read(parameter, (*ends)[1], DocumentPath(path, std::size_t{1})).value_or(0);
  return true;
}

/// Reads a range or a sample, an expression, or an object with both. Returns nothing after a fault. An expression
/// without a range sees `present` as v.
std::optional<Varying> NumberReader::varying(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                             double present) {
  const Value* range = value.list() != nullptr ? &value : value.find("range");
  const Value* apply = value.object() != nullptr ? value.find("apply") : value.text() != nullptr ? &value : nullptr;
  const bool has_sample = value.object() != nullptr && value.find("sample") != nullptr;
  const Value* keys = value.object() != nullptr ? value.find("keys") : nullptr;
  if (range == nullptr && apply == nullptr && !has_sample && keys == nullptr) {
    errors_.wrong_kind(parameter, value, path);
    return std::nullopt;
  }
  const std::size_t errors_before = errors_.error_count();
  if (value.object() != nullptr) check_members(value, path);
  Varying varying{.path = path.text(),
                  .min = parameter.form.min,
                  .max = parameter.form.max,
                  .scale = document_scale(parameter.form.unit)};
  varying.name_hash = hash64(path_in_component(varying.path));
  if (parameter.form.above_min) varying.min = std::nextafter(static_cast<float>(varying.min), HUGE_VALF);
  varying.first = varying.last = present;
  if (range != nullptr) {
    const DocumentPath named(path, "range");
    if (!read_range(parameter, *range, range == &value ? path : named, varying)) return std::nullopt;
  }
  if (has_sample) varying.sample = read_sample(parameter, value, path, {*this, files_, errors_});
  if (keys != nullptr && errors_.error_count() == errors_before)
    varying.keys = std::make_shared<const KeyedRange>(keyed_range(*keys));
  varying.is_rounded = parameter.form.counts && (keys == nullptr || apply != nullptr);
  if (apply != nullptr) {
    const DocumentPath apply_place(path, "apply");
    varying.expression =
        expressions_.read(*apply, value.text() != nullptr ? path : apply_place, expressions_.instance_names());
    varying.names = expressions_.instance_names().size();
  }
  return errors_.error_count() == errors_before ? std::optional(std::move(varying)) : std::nullopt;
}

void NumberReader::begin_component(void* object) {
  holder_ = static_cast<std::byte*>(object);
  varyings_.clear();
}

std::vector<Varying> NumberReader::end_component() {
  holder_ = nullptr;
  return std::move(varyings_);
}

NumberReader::InElement::InElement(NumberReader& reader, const void* list, const MemberType* type, std::size_t index,
                                   void* element)
    : reader_(reader), holder_(reader.holder_) {
  if (holder_ == nullptr) return;
  reader.way_.push_back({static_cast<std::size_t>(static_cast<const std::byte*>(list) - holder_), type, index});
  reader.holder_ = static_cast<std::byte*>(element);
}

NumberReader::InElement::~InElement() {
  if (holder_ == nullptr) return;
  reader_.holder_ = holder_;
  reader_.way_.pop_back();
}

}  // namespace meristem
