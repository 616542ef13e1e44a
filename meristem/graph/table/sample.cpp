// SPDX-License-Identifier: Apache-2.0
// Measured values as a distribution. The values are sorted once; a share from 0 to 1 selects one of them, or a point
// between two neighbours for a smooth sample.
#include "meristem/graph/table/sample.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "meristem/base/read_columns.h"
#include "meristem/base/read_file.h"
#include "meristem/graph/table/number_reader.h"

namespace meristem {

namespace {

constexpr const char* kForms = "a list of numbers, or {\"file\": \"angles.csv\", \"column\": \"angle\"}";

std::string read_text(const std::string& path, const SizeLimits& limits) { return read_file(path, limits.file_bytes); }

/// Reports values of a file's column that are out of a number's range.
void check_rows(const Parameter& row, std::string_view text, const Columns& columns, const std::string& column) {
  const NumberRange& form = row.form;
  for (std::size_t k = 0; k < columns.row_count(); ++k) {
    const double value = columns.numbers[0][k];
    const bool is_in = value <= form.max && (form.above_min ? value > form.min : value >= form.min);
    const bool is_whole = row.kind != ParameterKind::integer || value == std::floor(value);
    if (is_in && is_whole) continue;
    throw InputError(Diagnostic{
        .message = fmt::format("the value {:.12g} of the column '{}' cannot be that of '{}'", value, column, row.name),
        .expected = row.expectation(),
        .line = columns.lines[k],
        .column = column_of_cell(text, columns.lines[k], column)});
  }
}

std::vector<double> values_of_file(const Parameter& row, const Value& said, const DocumentPath& path,
                                   const SampleReaders& readers) {
  const Value* file = said.find("file");
  const Value* column = said.find("column");
  for (const auto& [name, member] : *said.object()) {
    if (name == "file" || name == "column") continue;
    readers.errors.add_name_error(DocumentPath(path, name), fmt::format("'{}' does not belong to a sample", name),
                                  "file and column",
                                  readers.errors.nearest(name, std::vector<std::string>{"file", "column"}));
  }
  if (file == nullptr || column == nullptr || column->text() == nullptr) {
    readers.errors.add_error(
        path, fmt::format("the sample of '{}' has no {}", row.name, file == nullptr ? "file" : "column"), kForms);
    return {};
  }
  Parameter file_row;
  file_row.name = "file";
  file_row.kind = ParameterKind::file;
  std::vector<double> values;
  readers.files.read(file_row, *file, DocumentPath(path, "file"), [&](const std::string& file_path) {
    const std::shared_ptr<const std::string> text = readers.files.kept_file<std::string>(file_path, read_text);
    Columns columns = read_columns(*text, {{*column->text()}}, readers.errors.limits());
    check_rows(row, *text, columns, *column->text());
    values = std::move(columns.numbers[0]);
  });
  return values;
}

std::vector<double> values_of_list(const Parameter& row, const Value::List& list, const DocumentPath& path,
                                   const SampleReaders& readers) {
  std::vector<double> values;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::optional<double> value = readers.numbers.read(row, list[k], DocumentPath(path, k));
    if (value) values.push_back(*value);
  }
  if (list.empty()) {
    readers.errors.add_error(path, fmt::format("the sample of '{}' has no values", row.name), "at least one number");
  }
  return values;
}

}  // namespace

double Sample::quantile(double share) const {
  const auto last = static_cast<double>(values.size() - 1);
  if (!is_smooth) {
    const double place = std::floor(share * static_cast<double>(values.size()));
    return values[static_cast<std::size_t>(std::clamp(place, 0.0, last))];
  }
  const double place = std::clamp(share, 0.0, 1.0) * last;
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == values.size()) return values.back();
  return values[below] + (place - static_cast<double>(below)) * (values[below + 1] - values[below]);
}

std::shared_ptr<const Sample> read_sample(const Parameter& row, const Value& object, const DocumentPath& path,
                                          const SampleReaders& readers) {
  const std::size_t errors_before = readers.errors.error_count();
  const DocumentPath place(path, "sample");
  const Value& said = *object.find("sample");
  auto sample = std::make_shared<Sample>();
  if (said.list() != nullptr) {
    sample->values = values_of_list(row, *said.list(), place, readers);
  } else if (said.object() != nullptr) {
    sample->values = values_of_file(row, said, place, readers);
  } else {
    readers.errors.add_error(place, fmt::format("the sample of '{}' is {}", row.name, said.description()), kForms);
  }
  if (const Value* smooth = object.find("smooth")) {
    if (smooth->boolean() == nullptr) {
      readers.errors.add_error(DocumentPath(path, "smooth"),
                               fmt::format("'smooth' cannot be {}", smooth->description()), "true or false");
    } else {
      sample->is_smooth = *smooth->boolean();
    }
  }
  if (readers.errors.error_count() != errors_before || sample->values.empty()) return nullptr;
  std::sort(sample->values.begin(), sample->values.end());
  return sample;
}

}  // namespace meristem
