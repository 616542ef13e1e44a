// SPDX-License-Identifier: Apache-2.0
// Writes the rows of the manifest as CSV, and reads them back. A row begins with the values of the plan and ends with
// the measures; names of columns that are already taken get a prefix.
#include "meristem/dataset/manifest.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/version.h"
#include "meristem/document/json.h"
#include "meristem/output/write/csv.h"

namespace meristem {

namespace {

constexpr std::array<const char*, 5> kPlantColumns{"files", "bytes", "hashes", "version", "error"};

/// Returns a text without line ends and other control characters.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

/// Returns a value of a plan as text. Texts stay as they are; other values become JSON.
std::string value_text(const Value& value) {
  return one_line(value.text() != nullptr ? *value.text() : write_json_line(value));
}

template <class Number>
std::string number_text(Number number) {
  std::string text;
  append_csv_number(number, text);
  return text;
}

std::string measure_text(std::monostate) { return {}; }
std::string measure_text(std::uint64_t count) { return number_text(count); }
std::string measure_text(double number) { return std::isfinite(number) ? number_text(number) : ""; }
template <class Number>
std::string measure_text(const std::vector<Number>& numbers) {
  std::string text;
  for (const Number number : numbers) text += (text.empty() ? "" : " ") + number_text(number);
  return text;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

std::optional<std::uint64_t> count_of(std::string_view text) {
  std::uint64_t count = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
  if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return count;
}

}  // namespace

std::vector<std::string> manifest_columns(const DatasetPlan& plan) {
  std::vector<std::string> columns{"key", "document", "seed"};
  const auto is_taken = [&columns](const std::string& name) {
    return std::find(columns.begin(), columns.end(), name) != columns.end() ||
           std::find(kPlantColumns.begin(), kPlantColumns.end(), name) != kPlantColumns.end();
  };
  for (const std::string& path : plan.columns) columns.push_back(is_taken(path) ? "value." + path : path);
  for (const char* const name : kPlantColumns) columns.emplace_back(name);
  for (const std::string& name : plan.measures) columns.push_back(is_taken(name) ? "result." + name : name);
  return columns;
}

std::string manifest_header(const DatasetPlan& plan) {
  std::string line;
  for (const std::string& column : manifest_columns(plan)) {
    if (!line.empty()) line += ',';
    line += csv_field(one_line(column));
  }
  line += '\n';
  return line;
}

std::vector<std::string> planned_fields(const DatasetPlan& plan, const PlannedPlant& plant) {
  std::vector<std::string> fields{plant.key, plan.documents[plant.document].name, std::to_string(plant.seed)};
  for (const std::string& path : plan.columns) {
    const auto value =
        std::find_if(plant.values.begin(), plant.values.end(), [&](const auto& other) { return other.first == path; });
    fields.push_back(value != plant.values.end() ? value_text(value->second) : "");
  }
  return fields;
}

std::string manifest_row(const DatasetPlan& plan, const MadePlant& made) {
  std::string line;
  for (const std::string& field : planned_fields(plan, made.plant))
    line += (line.empty() ? "" : ",") + csv_field(field);
  std::array<std::string, 3> lists;
  for (const PlantFile& file : made.files) {
    const char* const space = &file == &made.files.front() ? "" : " ";
    lists[0] += space + file.path;
    lists[1] += space + number_text(file.bytes);
    lists[2] += space + file.hash;
  }
  for (const std::string& list : lists) line += ',' + csv_field(list);
  line += ',' + csv_field(std::string(version())) + ',' + csv_field(one_line(made.error));
  for (std::size_t k = 0; k < plan.measures.size(); ++k) {
    line += ',';
    if (k < made.measures.size()) {
      line += csv_field(std::visit([](const auto& some) { return measure_text(some); }, made.measures[k]));
    }
  }
  return line + "\n";
}

std::optional<std::vector<std::string>> csv_fields(std::string_view line) {
  std::vector<std::string> fields;
  std::size_t at = 0;
  for (;;) {
    std::string& field = fields.emplace_back();
    if (at < line.size() && line[at] == '"') {
      for (++at;; ++at) {
        if (at >= line.size()) return std::nullopt;
        if (line[at] != '"') {
          field += line[at];
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
          field += line[++at];
        } else {
          break;
        }
      }
      ++at;
      if (at < line.size() && line[at] != ',') return std::nullopt;
    } else {
      const std::size_t end = std::min(line.find(',', at), line.size());
      field = line.substr(at, end - at);
      at = end;
    }
    if (at >= line.size()) return fields;
    ++at;
  }
}

std::optional<ManifestLayout> ManifestLayout::of_header(std::string_view line) {
  const auto fields = csv_fields(line);
  if (!fields || fields->empty() || fields->front() != "key") return std::nullopt;
  ManifestLayout layout{.count = fields->size()};
  const std::array<std::size_t*, 4> places{&layout.files, &layout.bytes, &layout.hashes, &layout.error};
  const std::array<const char*, 4> names{"files", "bytes", "hashes", "error"};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto found = std::find(fields->begin(), fields->end(), names[k]);
    if (found == fields->end()) return std::nullopt;
    *places[k] = static_cast<std::size_t>(found - fields->begin());
  }
  return layout;
}

std::optional<ManifestEntry> ManifestLayout::entry(std::string_view line) const {
  const auto fields = csv_fields(line);
  return fields ? entry(*fields) : std::nullopt;
}

std::optional<ManifestEntry> ManifestLayout::entry(const std::vector<std::string>& fields) const {
  if (fields.size() != count) return std::nullopt;
  const auto number = count_of(fields.front());
  if (!number) return std::nullopt;
  ManifestEntry found{.number = *number, .files = {}, .error = fields[error]};
  const auto paths = words_of(fields[files]);
  const auto sizes = words_of(fields[bytes]);
  const auto all_hashes = words_of(fields[hashes]);
  if (sizes.size() != paths.size() || all_hashes.size() != paths.size()) return std::nullopt;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto size = count_of(sizes[k]);
    // Files outside the folder of the data set are never examined.
    if (!size || paths[k].starts_with('/') || paths[k].find("..") != std::string_view::npos) return std::nullopt;
    found.files.push_back({std::string(paths[k]), *size, std::string(all_hashes[k])});
  }
  return found;
}

}  // namespace meristem
