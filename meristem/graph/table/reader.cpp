// SPDX-License-Identifier: Apache-2.0
// Reads values into structs by their parameter tables and collects all faults, each with its path. A plain number is
// stored at once. A range, a sample, keys or an expression in a component becomes a Varying, which is evaluated for
// each instance later.
#include "meristem/graph/table/reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/base/read_file.h"
#include "meristem/graph/table/meaning.h"
#include "meristem/graph/table/sample.h"
#include "meristem/scene/light/clock.h"

namespace meristem {

namespace {

/// Returns the byte at which a character of a line begins. Line and column count from 0. Returns the text's end if
/// there is no such character.
std::size_t byte_offset(std::string_view text, std::size_t line, std::size_t column) {
  std::size_t at = 0;
  for (; line > 0; --line) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return text.size();
    at = end + 1;
  }
  const auto continues = [&](std::size_t byte) { return (static_cast<unsigned char>(text[byte]) & 0xc0U) == 0x80U; };
  for (; column > 0 && at < text.size() && text[at] != '\n'; --column) {
    ++at;
    while (at < text.size() && continues(at)) ++at;
  }
  return at;
}

/// Returns a position in a file as text, as "fir.txt:3:7". Omits line and column if they are unknown.
std::string place_in_file(const Diagnostic& found, const std::string& file) {
  std::string path = file;
  if (found.line > 0) path += fmt::format(":{}", found.line);
  if (found.column > 0) path += fmt::format(":{}", found.column);
  return path;
}

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

/// Returns the word of a text that begins at a byte.
std::string_view name_at(std::string_view text, std::size_t offset) {
  std::size_t end = offset;
  while (end < text.size() && is_identifier(text.substr(offset, end + 1 - offset))) ++end;
  return text.substr(std::min(offset, text.size()), end - std::min(offset, end));
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

}  // namespace

void ParameterReader::add_error(const DocumentPath& path, std::string message, std::string expected,
                                std::string nearest, int text_offset) {
  if (++errors_ > limits_.diagnostics) return;
  diagnostics_.push_back({.message = std::move(message),
                          .expected = std::move(expected),
                          .nearest = std::move(nearest),
                          .path = path.text(),
                          .file = {},
                          .text_offset = text_offset});
}

void ParameterReader::error_name(const DocumentPath& path, std::string message, std::string expected,
                                 std::string nearest) {
  add_error(path, std::move(message), std::move(expected), std::move(nearest), kAtName);
}

void ParameterReader::error_meaning(const DocumentPath& path, std::string message, std::string expected,
                                    const DocumentPath* other) {
  meaningless_.push_back({path.text(), other == nullptr ? std::string() : other->text()});
  error_name(path, std::move(message), std::move(expected), "");
}

std::string ParameterReader::nearest(std::string_view name, std::span<const std::string> candidates) const {
  if (errors_ >= limits_.diagnostics || names_compared_ + candidates.size() > kMaxNamesCompared) return {};
  names_compared_ += candidates.size();
  return nearest_name(name, candidates);
}

void ParameterReader::warn(const DocumentPath& path, std::string message) {
  if (diagnostics_.size() > 2 * limits_.diagnostics) return;
  diagnostics_.push_back({.severity = Severity::warning,
                          .message = std::move(message),
                          .expected = {},
                          .nearest = {},
                          .path = path.text(),
                          .file = {}});
}

void ParameterReader::error_limit(const DocumentPath& path, std::string_view what, double wanted, std::uint64_t limit,
                                  std::string_view limit_name) {
  if (++errors_ > limits_.diagnostics) return;
  diagnostics_.push_back(limit_diagnostic(what, wanted, limit, limit_name, path.text()));
}

void ParameterReader::wrong_kind(const Parameter& parameter, const Value& value, const DocumentPath& path) {
  add_error(path, fmt::format("'{}' cannot be {}", parameter.name, value.description()), parameter.expectation());
}

GivenRows ParameterReader::read(const ParameterTable& table, void* object, const Value& value,
                                const DocumentPath& path) {
  return this->object(table, object, value, path);
}

std::vector<Varying> ParameterReader::read_varying(const ParameterTable& table, void* object, const Value& value,
                                                   const DocumentPath& path) {
  holder_.object = static_cast<std::byte*>(object);
  varyings_.clear();
  this->object(table, object, value, path);
  holder_.object = nullptr;
  return std::move(varyings_);
}

void ParameterReader::element(const Parameter& row, void* member, std::size_t index, const Value& value,
                              const DocumentPath& path) {
  void* const element = row.type->element(member, index);
  const ParameterTable& table = row.table_of(member, index);
  if (holder_.object == nullptr) {
    object(table, element, value, path);
    return;
  }
  std::byte* const holder = holder_.object;
  holder_.way.push_back({static_cast<std::size_t>(static_cast<std::byte*>(member) - holder), row.type, index});
  holder_.object = static_cast<std::byte*>(element);
  object(table, element, value, path);
  holder_.object = holder;
  holder_.way.pop_back();
}

GivenRows ParameterReader::object(const ParameterTable& table, void* object, const Value& value,
                                  const DocumentPath& path) {
  check_stop();
  GivenRows given;
  const std::size_t errors_before = errors_;
  const auto finish = [&] {
    if (table.check && errors_ == errors_before) table.check(object, path, *this);
    if (table.prepare && errors_ == errors_before) table.prepare(object, path, *this);
  };
  const Value::Object* members = value.object();
  if (members == nullptr) {
    if (const Parameter* bare = table.shorthand.empty() ? nullptr : table.find(table.shorthand)) {
      given.add(*bare);
      bare->read(object, value, path, *this);
      finish();
    } else {
      add_error(path, fmt::format("{} cannot be {}", table.name, value.description()),
                fmt::format("an object with {}", fmt::join(table.names(), ", ")));
    }
    return given;
  }

  // Each member is read by its row. An unknown member is reported with the nearest known name.
  for (const auto& [name, member] : *members) {
    const DocumentPath member_place(path, name);
    const Parameter* row = table.find(name);
    if (row == nullptr && is_any_of(name, table.elsewhere)) continue;
    if (const std::string* reason = row == nullptr ? table.reason_without(name) : nullptr) {
      error_name(member_place, fmt::format("'{}' has no meaning here: {}", name, *reason), "no such key", "");
      continue;
    }
    if (row == nullptr) {
      const std::vector<std::string> names = table.names();
      const std::string similar = nearest(name, names);
      error_name(member_place, fmt::format("'{}' is not a parameter of {}", name, table.name),
                 similar.empty() ? fmt::format("one of {}", fmt::join(names, ", ")) : "", similar);
      continue;
    }
    given.add(*row);
    row->read(object, member, member_place, *this);
  }

  check_given(table, given, path);
  if (errors_ == errors_before) check_meanings(table, object, value, path, *this);
  finish();
  return given;
}

/// Reports missing required rows, and rows that exclude each other.
void ParameterReader::check_given(const ParameterTable& table, const GivenRows& given, const DocumentPath& path) {
  for (const Parameter& row : table.parameters) {
    if (row.required && !given.contains(row.name)) {
      add_error(path, fmt::format("{} has no '{}'", table.name, row.name), row.expectation());
    }
  }
  for (const std::vector<std::string>& group : table.one_of) {
    const auto count =
        std::count_if(group.begin(), group.end(), [&](const auto& name) { return given.contains(name); });
    if (count != 1) {
      add_error(
          path,
          fmt::format("{} has {} of {}", table.name, count == 0 ? "none" : "more than one", fmt::join(group, ", ")),
          "exactly one of them");
    }
  }
  for (const ParameterTable::Company& rule : table.company) {
    if (!given.contains(rule.parameter) || given.contains(rule.other) == rule.is_wanted) continue;
    const DocumentPath other(path, rule.other);
    error_meaning(
        DocumentPath(path, rule.parameter),
        fmt::format("'{}' has no meaning {} '{}'", rule.parameter, rule.is_wanted ? "without" : "beside", rule.other),
        rule.is_wanted ? fmt::format("'{}' beside it", rule.other) : "only one of them",
        rule.is_wanted ? nullptr : &other);
  }
}

bool ParameterReader::check_range(const Parameter& parameter, double value, const DocumentPath& path,
                                  std::string_view what) {
  if (is_in_range(parameter.form, value)) return true;
  add_error(path, fmt::format("{} {:.12g} is out of range for '{}'", what, value, parameter.name),
            parameter.expectation());
  return false;
}

std::optional<Expression> ParameterReader::expression(const Value& value, const DocumentPath& path,
                                                      std::span<const std::string> variables) {
  const std::string* text = value.text();
  if (text == nullptr) {
    add_error(path, fmt::format("an expression cannot be {}", value.description()), "a text with an expression");
    return std::nullopt;
  }
  if (expression_paths_ != nullptr) expression_paths_->push_back(path.text());
  try {
    const bool is_of_instance = variables.data() == instance_names().data();
    const bool has_nearest = errors_ < limits_.diagnostics && names_compared_ <= kMaxNamesCompared;
    return Expression::compile_in(*text,
                                  {.variables = variables,
                                   .constants = constants(),
                                   .variable_table = is_of_instance ? &instance_names_ : nullptr,
                                   .constant_table = &constants_.names(),
                                   .has_nearest = has_nearest},
                                  limits_.expression_bytes);
  } catch (const ExpressionError& raised) {
    const SyntaxError& found = raised.details();
    names_compared_ += variables.size() + constants().size();
    const std::string_view name = name_at(*text, found.offset);
    if (const auto refused = refused_names_.find(name); refused != refused_names_.end()) {
      add_error(path, fmt::format("'{}' {}", name, refused->second), "", "", static_cast<int>(found.offset));
      return std::nullopt;
    }
    add_error(path, found.message, found.expected, found.nearest, static_cast<int>(found.offset));
    return std::nullopt;
  }
}

/// Returns the reason why a number must not vary, as the rest of a sentence that begins with its name.
std::string_view ParameterReader::why_one(const Parameter& parameter) const {
  return parameter.form.fixed || holder_.object != nullptr ? "is one number for all instances"
                                                           : "is one number (only those of components vary)";
}

std::optional<double> ParameterReader::number(const Parameter& parameter, const Value& value,
                                              const DocumentPath& path) {
  check_stop();
  if (const double* plain = value.number()) {
    if (parameter.kind == ParameterKind::integer && !parameter.form.counts && *plain != std::floor(*plain)) {
      add_error(path, fmt::format("'{}' cannot be the fraction {:.12g}", parameter.name, *plain),
                parameter.expectation());
      return std::nullopt;
    }
    return check_range(parameter, *plain, path, "the value") ? std::optional(*plain) : std::nullopt;
  }
  if (value.text() == nullptr) {
    wrong_kind(parameter, value, path);
    return std::nullopt;
  }
  if (parameter.form.unit == Unit::hour && value.text()->find(':') != std::string::npos) {
    const std::optional<double> hours = parse_clock_hour(*value.text());
    if (!hours) {
      add_error(path, fmt::format("'{}' is not a time", *value.text()),
                "hours and minutes such as \"15:30\", or a number");
      return std::nullopt;
    }
    return check_range(parameter, *hours, path, "the time") ? hours : std::nullopt;
  }
  const std::optional<Expression> compiled = expression(value, path, instance_names());
  if (!compiled) return std::nullopt;
  if (!compiled->is_constant()) {
    add_error(path,
              fmt::format("'{}' {}, and this expression differs between instances", parameter.name, why_one(parameter)),
              "an expression of numbers and the document's variables");
    return std::nullopt;
  }
  const double result = compiled->evaluate();
  return check_range(parameter, result, path, "the expression's value") ? std::optional(result) : std::nullopt;
}

void ParameterReader::store_number(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                   const NumberSlot& slot) {
  if (value.number() == nullptr) worked_out_.insert(path.text());
  const double scale = document_scale(parameter.form.unit);
  const auto store = [&](double number) { slot.store(slot.member, number * scale); };
  const bool may_vary = holder_.object != nullptr && parameter.may_vary();
  if (value.number() != nullptr || (value.text() != nullptr && !may_vary)) {
    const std::optional<double> given = number(parameter, value, path);
    if (given) store(parameter.form.counts && value.number() == nullptr ? std::floor(*given + 0.5) : *given);
    return;
  }
  if (!may_vary) {
    const bool has_form = value.list() != nullptr || value.find("range") != nullptr || value.find("apply") != nullptr ||
                          value.find("sample") != nullptr;
    if (!has_form) {
      return wrong_kind(parameter, value, path);
    }
    add_error(path, fmt::format("'{}' {} and cannot be {}", parameter.name, why_one(parameter), value.description()),
              parameter.expectation());
    return;
  }
  std::optional<Varying> read = varying(parameter, value, path, slot.present);
  if (!read) return;
  if (const std::optional<double> constant = constant_of(*read)) {
    const double number = parameter.form.counts ? std::floor(*constant + 0.5) : *constant;
    if (check_range(parameter, number, path, "the expression's value")) store(number);
    return;
  }
  read->store = slot.store;
  read->way = holder_.way;
  read->offset = static_cast<std::size_t>(static_cast<std::byte*>(slot.member) - holder_.object);
  // Until an instance has its own value, the member has the default: rules between parameters see it as given.
  store(slot.present);
  varyings_.push_back(std::move(*read));
}

bool ParameterReader::is_worked_out(const DocumentPath& path) const { return worked_out_.contains(path.text()); }

void ParameterReader::store_per_child(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                      PerChild& number) {
  const double scale = document_scale(parameter.form.unit);
  std::optional<Varying> read;
  std::optional<double> plain;
  if (value.number() != nullptr) {
    plain = this->number(parameter, value, path);
  } else {
    read = varying(parameter, value, path, number.plain / scale);
    if (read) plain = constant_of(*read);
    if (plain && !check_range(parameter, *plain, path, "the expression's value")) return;
  }
  if (plain) {
    number = PerChild(*plain * scale);
  } else if (read) {
    number.varying = std::move(read);
  }
}

/// Checks the keys of a value that is an object.
void ParameterReader::check_members(const Value& value, const DocumentPath& path) {
  static const std::vector<std::string> names{"range", "sample", "smooth", "apply"};
  const bool is_keyed = value.find("keys") != nullptr && keyed_.contains(path.text());
  for (const auto& [name, member] : *value.object()) {
    if (is_any_of(name, names) || (is_keyed && name == "keys")) continue;
    add_error(DocumentPath(path, name), fmt::format("'{}' does not belong to a value", name),
              name == "keys" ? "keys in the document's \"animation\"" : "range or sample, and apply",
              nearest(name, names));
  }
  const bool has_sample = value.find("sample") != nullptr;
  if (has_sample && value.find("range") != nullptr) {
    add_error(DocumentPath(path, "range"), "a value has both a sample and a range", "one of them");
  }
  if (!has_sample && value.find("smooth") != nullptr) {
    add_error(DocumentPath(path, "smooth"), "'smooth' has no meaning without a sample", "'sample' beside it");
  }
}

namespace {

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

/// Reads a range or a sample, an expression, or an object with both. Returns nothing after a fault. An expression
/// without a range sees `present` as v.
std::optional<Varying> ParameterReader::varying(const Parameter& parameter, const Value& value,
                                                const DocumentPath& path, double present) {
  const Value* range = value.list() != nullptr ? &value : value.find("range");
  const Value* apply = value.object() != nullptr ? value.find("apply") : value.text() != nullptr ? &value : nullptr;
  const bool has_sample = value.object() != nullptr && value.find("sample") != nullptr;
  const Value* keys = value.object() != nullptr ? value.find("keys") : nullptr;
  if (range == nullptr && apply == nullptr && !has_sample && keys == nullptr) {
    wrong_kind(parameter, value, path);
    return std::nullopt;
  }
  const std::size_t errors_before = errors_;
  if (value.object() != nullptr) check_members(value, path);
  Varying varying{.path = path.text(),
                  .min = parameter.form.min,
                  .max = parameter.form.max,
                  .scale = document_scale(parameter.form.unit)};
  varying.name_hash = hash64(path_in_component(varying.path));
  if (parameter.form.above_min) varying.min = std::nextafter(static_cast<float>(varying.min), HUGE_VALF);
  varying.first = varying.last = present;
  if (range != nullptr) {
    const Value::List* ends = range->list();
    if (ends == nullptr || ends->size() != 2) {
      add_error(path, fmt::format("the range of '{}' is {}", parameter.name, range->description()),
                "a list of two numbers");
      return std::nullopt;
    }
    const DocumentPath named(path, "range");
    const DocumentPath& range_place = value.list() != nullptr ? path : named;
    const auto first = number(parameter, (*ends)[0], DocumentPath(range_place, std::size_t{0}));
    const auto last = number(parameter, (*ends)[1], DocumentPath(range_place, std::size_t{1}));
    varying.first = first.value_or(0);
    varying.last = last.value_or(0);
  }
  if (has_sample) varying.sample = read_sample(parameter, value, path, *this);
  if (keys != nullptr && errors_ == errors_before)
    varying.keys = std::make_shared<const KeyedRange>(keyed_range(*keys));
  varying.is_rounded = parameter.form.counts && (keys == nullptr || apply != nullptr);
  if (apply != nullptr) {
    const DocumentPath apply_place(path, "apply");
    varying.expression = expression(*apply, value.text() != nullptr ? path : apply_place, instance_names());
    varying.names = instance_names_.size();
  }
  return errors_ == errors_before ? std::optional(std::move(varying)) : std::nullopt;
}

const std::string* ParameterReader::text(const Parameter& parameter, const Value& value, const DocumentPath& path) {
  if (value.text() == nullptr) wrong_kind(parameter, value, path);
  return value.text();
}

void ParameterReader::file(const Parameter& parameter, const Value& value, const DocumentPath& path,
                           FunctionRef<void(const std::string& file_path)> load) {
  const std::string* given = text(parameter, value, path);
  if (given == nullptr) return;
  const std::filesystem::path folder(access_.folder);
  const std::string file_path = given->empty() ? "" : (folder / *given).string();
  try {
    if (!given->empty()) access_.require_within(file_path);
    name_file({.path = file_path, .is_beside = !std::filesystem::path(*given).is_absolute()});
    load(file_path);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) report_in_file(found, *given, path);
  } catch (const MachineError& error) {
    add_error(path, error.what());
  }
}

std::shared_ptr<const PlantSource> ParameterReader::plant_source(const std::string& name, const DocumentPath& path) {
  if (access_.sources == nullptr) {
    add_error(path, "no other documents can be read here", "a document that is read from a file");
    return nullptr;
  }
  try {
    PlantSources::Opened opened = access_.sources->open(name, access_);
    for (NamedFile& file : opened.files) name_file(std::move(file));
    return std::move(opened.source);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) {
      if (found.file.empty()) {
        report(path, found, -1);
      } else {
        report_in_file(found, found.file, path);
      }
    }
  } catch (const MachineError& error) {
    add_error(path, error.what());
  }
  return nullptr;
}

/// Reports a fault within a file. The message names two positions: this path, and the position in the file.
void ParameterReader::report_in_file(const Diagnostic& found, const std::string& file, const DocumentPath& path) {
  const std::filesystem::path folder(access_.folder);
  Diagnostic told = found;
  told.message = fmt::format("'{}': {}", place_in_file(found, file), found.message);
  // The nearest file name is written as the document would write it.
  if (!access_.folder.empty() && told.nearest.starts_with((folder / "").string())) {
    told.nearest.erase(0, (folder / "").string().size());
  }
  report(path, told, -1);
}

void ParameterReader::report(const DocumentPath& path, const Diagnostic& found, int text_offset) {
  if (found.severity == Severity::warning) {
    warn(path, found.message);
  } else {
    add_error(path, found.message, found.expected, found.nearest, text_offset);
  }
}

void ParameterReader::report_in_text(const Diagnostic& found, const Value& value, const DocumentPath& path) {
  Diagnostic told = found;
  if (!found.file.empty()) {
    told.message = fmt::format("'{}': {}", place_in_file(found, found.file), found.message);
    return report(path, told, -1);
  }
  if (found.line < 1) return report(path, told, -1);
  auto line = static_cast<std::size_t>(found.line - 1);
  const auto column = static_cast<std::size_t>(std::max(found.column, 1) - 1);
  if (value.list() == nullptr) return report(path, told, static_cast<int>(byte_offset(*value.text(), line, column)));
  // An element may hold several lines.
  const Value::List& elements = *value.list();
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const std::string& text = *elements[k].text();
    const auto own = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
    if (line < own) return report(DocumentPath(path, k), told, static_cast<int>(byte_offset(text, line, column)));
    line -= own;
  }
  report(path, told, -1);
}

void ParameterReader::lines(const Parameter& parameter, const Value& value, const DocumentPath& path, ReadText read) {
  std::string text;
  if (const Value::List* lines = value.list()) {
    for (std::size_t k = 0; k < lines->size(); ++k) {
      const std::string* line = (*lines)[k].text();
      if (line == nullptr) return wrong_kind(parameter, (*lines)[k], DocumentPath(path, k));
      text += *line + '\n';
    }
  } else if (value.text() != nullptr) {
    text = *value.text();
  } else {
    return wrong_kind(parameter, value, path);
  }
  std::vector<Diagnostic> warnings;
  try {
    read(text, (std::filesystem::path(access_.folder) / "").string(), warnings);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) report_in_text(found, value, path);
  }
  for (const Diagnostic& found : warnings) report_in_text(found, value, path);
}

void ParameterReader::text_file(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                ReadText read) {
  std::vector<Diagnostic> warnings;
  file(parameter, value, path,
       [&](const std::string& file_path) { read(read_file(file_path, limits_.file_bytes), file_path, warnings); });
  for (const Diagnostic& found : warnings) report_in_file(found, *value.text(), path);
}

std::string ParameterReader::included_text(const std::string& file, const std::string& name, std::uint64_t max_bytes) {
  const std::string file_path = (std::filesystem::path(file).parent_path() / name).string();
  access_.require_within(file_path);
  const bool is_relative = !std::filesystem::path(name).is_absolute();
  name_file({.path = file_path, .is_beside = is_relative && is_below_folder(file)});
  return read_file(file_path, max_bytes);
}

/// Records a file that the document names. Errors of hashing are ignored here: reading the file reports them.
void ParameterReader::name_file(NamedFile file) {
  try {
    file.hash = file_hash(file.path);
  } catch (const InputError&) {
  } catch (const MachineError&) {
  }
  files_.push_back(std::move(file));
}

/// Returns true if the path begins with the document's folder.
bool ParameterReader::is_below_folder(const std::string& file_path) const {
  return file_path.starts_with(access_.folder);
}

std::optional<std::uint64_t> ParameterReader::file_hash(const std::string& file_path) {
  return access_.store == nullptr ? std::nullopt : access_.store->file_hash(file_path, limits_.file_bytes);
}

Fingerprint ParameterReader::fingerprint_of_loading(void (*load)()) const {
  static_assert(std::has_unique_object_representations_v<SizeLimits>);
  const std::string_view limits(reinterpret_cast<const char*>(&limits_), sizeof(SizeLimits));
  return Fingerprint().add(reinterpret_cast<std::uintptr_t>(load)).add_text(limits);
}

/// Returns the hash of all constants, which is computed once.
std::uint64_t ParameterReader::fingerprint_of_constants() {
  if (!constants_hash_) {
    Fingerprint all;
    for (const ExpressionNames::Constant& constant : constants()) all.add_text(constant.name).add(constant.value);
    constants_hash_ = all.hash();
  }
  return *constants_hash_;
}

bool ParameterReader::are_present(const std::vector<NamedFile>& files) {
  return std::all_of(files.begin(), files.end(),
                     [&](const NamedFile& file) { return file.hash && file_hash(file.path) == file.hash; });
}

std::optional<std::size_t> ParameterReader::choice(const Parameter& parameter, const Value& value,
                                                   const DocumentPath& path) {
  const std::string* given = text(parameter, value, path);
  if (given == nullptr) return std::nullopt;
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), *given);
  if (found != parameter.choices.end()) return static_cast<std::size_t>(found - parameter.choices.begin());
  add_error(path, fmt::format("'{}' is not a value of '{}'", *given, parameter.name), parameter.expectation(),
            nearest(*given, parameter.choices));
  return std::nullopt;
}

}  // namespace meristem
