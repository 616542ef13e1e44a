// SPDX-License-Identifier: Apache-2.0
// Writes skeletons as rows of CSV from SkeletonTable, formatted in blocks on all threads.
#include "meristem/output/skeleton/skeleton_csv.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/atomic_file.h"
#include "meristem/output/skeleton/skeleton_table.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"
#include "meristem/output/write/finite.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

class CsvRows {
 public:
  explicit CsvRows(const SkeletonTable& table) : table_(table) {
    for (const std::string& component : table.components()) components_.push_back(csv_field(component));
  }

  std::string header() const {
    std::string line;
    for (const SkeletonColumn& column : table_.columns()) line += csv_field(column.name) + ',';
    line.back() = '\n';
    return line;
  }

  std::size_t max_row_bytes() const {
    return longest(components_) + longest(table_.labels()) + table_.columns().size() * kCsvNumberBytes;
  }

  void append(const SkeletonRow& row, std::string& out) const {
    for (std::size_t k = 0; k < table_.columns().size(); ++k) {
      append_field(table_.columns()[k].kind, table_.value(row, k), out);
      out += ',';
    }
    out.back() = '\n';
  }

 private:
  static std::size_t longest(const std::vector<std::string>& texts) {
    std::size_t bytes = 0;
    for (const std::string& text : texts) bytes = std::max(bytes, text.size());
    return bytes;
  }

  void append_field(SkeletonColumn::Kind kind, double value, std::string& out) const {
    if (kind == SkeletonColumn::Kind::component) {
      out += components_[static_cast<std::size_t>(value)];
    } else if (kind == SkeletonColumn::Kind::label) {
      out += table_.labels()[static_cast<std::size_t>(value)];
    } else if (kind == SkeletonColumn::Kind::index) {
      if (value != SkeletonTable::kNoRow) append_csv_number(static_cast<std::uint64_t>(value), out);
    } else if (!std::isnan(value)) {
      append_csv_number(static_cast<float>(value), out);
    }
  }

  const SkeletonTable& table_;
  std::vector<std::string> components_;  // as CSV fields
};

}  // namespace

void write_skeleton_csv(const Plant& grown, const SizeLimits& limits, const std::string& path, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  require_finite(*expanded);
  const Plant& plant = *expanded;
  const SkeletonTable table(plant);
  const CsvRows rows(table);
  progress.begin("writing CSV", table.row_count());
  AtomicFile file(path);
  file.write(rows.header());
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    table.for_each_row(begin, end, [&](const SkeletonRow& row) { rows.append(row, out); });
  };
  BlockWriter(file, progress).write(table.row_count(), rows.max_row_bytes(), fill);
  file.commit();
}

}  // namespace meristem
