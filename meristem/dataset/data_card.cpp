// SPDX-License-Identifier: Apache-2.0
// Writes the data card of a data set. Two passes read the manifest row by row: the first finds the range of each
// column, the second counts the values in bins. Memory therefore does not depend on the number of plants.
#include "meristem/dataset/data_card.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/function_ref.h"
#include "meristem/base/markdown.h"
#include "meristem/base/version.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/manifest.h"

namespace meristem {

namespace {

constexpr std::size_t kBins = 10;
constexpr std::size_t kBarLength = 20;       // characters
constexpr std::size_t kMaxValuesShown = 12;  // number of different texts and other values without a number
constexpr std::size_t kFailuresShown = 10;

/// A summary of a column of the manifest over all plants that did not fail.
struct ColumnSummary {
  std::string name;
  std::size_t place = 0;
  std::uint64_t numbers = 0;
  double sum = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::vector<std::uint64_t> bins = std::vector<std::uint64_t>(kBins);
  std::map<std::string, std::uint64_t> others;  // counts of values that are not numbers, for the first few of them
  std::uint64_t further = 0;                    // number of rows with other texts

  void add(const std::string& field);
  void add_to_bin(const std::string& field);
};

std::optional<double> number_in(const std::string& field) {
  double number = 0;
  const auto read = std::from_chars(field.data(), field.data() + field.size(), number);
  const bool is_all = !field.empty() && read.ec == std::errc() && read.ptr == field.data() + field.size();
  return is_all && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

void ColumnSummary::add(const std::string& field) {
  if (const auto number = number_in(field)) {
    ++numbers;
    sum += *number;
    low = std::min(low, *number);
    high = std::max(high, *number);
  } else if (!field.empty()) {
    if (others.size() < kMaxValuesShown || others.contains(field)) {
      ++others[field];
    } else {
      ++further;
    }
  }
}

void ColumnSummary::add_to_bin(const std::string& field) {
  const auto number = number_in(field);
  if (!number) return;
  const double share = high > low ? (*number - low) / (high - low) : 0;
  ++bins[std::min(kBins - 1, static_cast<std::size_t>(share * static_cast<double>(kBins)))];
}

/// Calls `body` with the fields of each row of the manifest.
void for_each_row(const DatasetPlan& plan, const std::string& folder, Progress& progress,
                  FunctionRef<void(const std::vector<std::string>&)> body) {
  const DatasetInfo info = info_of(plan);
  for (std::uint64_t table = 0; table < info.table_count(); ++table) {
    progress.advance();
    const std::string path = manifest_path(folder, table);
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) throw MachineError(fmt::format("cannot read '{}'", path));
    while (std::getline(file, line)) {
      if (const auto fields = csv_fields(line)) body(*fields);
    }
  }
}

/// Returns the ending of a plant's file, from its first dot on.
std::string ending_in(const std::string& path) {
  const std::size_t slash = path.find_last_of('/') + 1;
  const std::size_t dot = path.find('.', slash);
  return dot == std::string::npos ? "" : path.substr(dot);
}

struct FilesOfKind {
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
};

std::string megabytes(std::uint64_t bytes) { return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6); }

std::string bar(std::uint64_t count, std::uint64_t max) {
  const auto length = static_cast<std::size_t>(std::ceil(static_cast<double>(kBarLength) * static_cast<double>(count) /
                                                         static_cast<double>(std::max<std::uint64_t>(1, max))));
  std::string text;
  for (std::size_t k = 0; k < length; ++k) text += "█";
  return text;
}

std::string histogram(const ColumnSummary& column) {
  std::string text = fmt::format("\n### {}\n\n", markdown_text(column.name));
  if (column.numbers > 0) {
    text += fmt::format("{} numbers from {:.6g} to {:.6g}, mean {:.6g}\n", column.numbers, column.low, column.high,
                        column.sum / static_cast<double>(column.numbers));
  }
  std::string rows;
  if (column.high > column.low) {
    const std::uint64_t max = *std::max_element(column.bins.begin(), column.bins.end());
    const double width = (column.high - column.low) / static_cast<double>(kBins);
    for (std::size_t k = 0; k < kBins; ++k) {
      fmt::format_to(std::back_inserter(rows), "| {:.4g} to {:.4g} | {} | {} |\n",
                     column.low + width * static_cast<double>(k), column.low + width * static_cast<double>(k + 1),
                     column.bins[k], bar(column.bins[k], max));
    }
  }
  for (const auto& [value, count] : column.others) {
    fmt::format_to(std::back_inserter(rows), "| {} | {} | {} |\n", markdown_text(value), count, "");
  }
  if (column.further > 0) rows += fmt::format("| other values | {} | |\n", column.further);
  if (!rows.empty())
    text += std::string(column.numbers > 0 ? "\n" : "") + "| value | plants | |\n| --- | ---: | --- |\n" + rows;
  return text;
}

std::string_view or_none(const std::string& text) {
  return text.empty() ? std::string_view("not given") : std::string_view(text);
}

}  // namespace

std::string data_card(const DatasetPlan& plan, const std::string& folder, Progress& progress) {
  progress.begin("writing the data card", 2 * info_of(plan).table_count());
  const std::vector<std::string> names = manifest_columns(plan);
  const auto layout = ManifestLayout::of_header(manifest_header(plan).substr(0, manifest_header(plan).size() - 1));
  std::vector<ColumnSummary> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool is_value = k >= 3 && k < 3 + plan.columns.size();
    if (is_value || k > layout->error) columns.push_back({.name = names[k], .place = k, .others = {}});
  }

  // The first pass finds ranges, files and failures. The second pass counts values in bins.
  std::map<std::string, std::uint64_t> plants_of;
  std::map<std::string, FilesOfKind> kinds;
  std::uint64_t failed = 0;
  std::vector<std::string> failures;
  std::set<std::string> versions;
  for_each_row(plan, folder, progress, [&](const std::vector<std::string>& fields) {
    ++plants_of[fields.at(1)];
    versions.insert(fields.at(layout->error - 1));
    if (!fields.at(layout->error).empty()) {
      ++failed;
      if (failures.size() < kFailuresShown) failures.push_back(fields[0] + ": " + fields[layout->error]);
      return;
    }
    if (const auto entry = layout->entry(fields)) {
      for (const PlantFile& file : entry->files) {
        FilesOfKind& kind = kinds[ending_in(file.path)];
        ++kind.files;
        kind.bytes += file.bytes;
      }
    }
    for (ColumnSummary& column : columns) column.add(fields.at(column.place));
  });
  for_each_row(plan, folder, progress, [&](const std::vector<std::string>& fields) {
    if (!fields.at(layout->error).empty()) return;
    for (ColumnSummary& column : columns) column.add_to_bin(fields.at(column.place));
  });

  std::string card = fmt::format("# {}\n\n", plan.name.empty() ? "Data set of plants" : markdown_text(plan.name));
  if (!plan.description.empty()) card += markdown_text(plan.description) + "\n\n";
  card += fmt::format("| | |\n| --- | --- |\n| Plants | {} |\n| of them failed | {} |\n", plan.count(), failed);
  card += fmt::format("| Author | {} |\n| Licence | {} |\n", markdown_text(or_none(plan.author)),
                      markdown_text(or_none(plan.licence)));
  card += fmt::format("| Grown by | Meristem {} |\n", markdown_text(fmt::format("{}", fmt::join(versions, ", "))));
  card += fmt::format("| Plan | `plan.json`, {} |\n", plan.hash);
  card += fmt::format("| Manifest | `manifest/`, {} rows per table |\n", plan.rows);

  card += "\n## How it was made\n\n";
  card +=
      "Every plant was grown by a program from a document, a seed and the values in its row of the manifest; "
      "nothing was measured on real plants. `meristem dataset` with this folder checks it, or makes again what is "
      "missing. The same plan and version give the same bytes on every machine of one kind.\n\n";
  card += "| Document | Name | Licence | Plants |\n| --- | --- | --- | ---: |\n";
  for (const PlannedDocument& document : plan.documents) {
    card += fmt::format("| documents/{} | {} | {} | {} |\n", markdown_text(document.name),
                        markdown_text(or_none(document.title)), markdown_text(or_none(document.licence)),
                        plants_of[document.name]);
  }
  if (!kinds.empty()) card += "\n## Files\n\n| Ending | Files | Size |\n| --- | ---: | ---: |\n";
  for (const auto& [ending, kind] : kinds) {
    card += fmt::format("| `{}` | {} | {} |\n", ending, kind.files, megabytes(kind.bytes));
  }
  if (failed > 0) card += "\n## Plants that failed\n\n";
  for (const std::string& failure : failures) card += fmt::format("- {}\n", markdown_text(failure));
  if (failed > failures.size())
    card += fmt::format("- and {} more, in the column `error` of the manifest\n", failed - failures.size());
  if (!columns.empty()) card += "\n## Values and measures\n";
  for (const ColumnSummary& column : columns) card += histogram(column);
  return card;
}

}  // namespace meristem
