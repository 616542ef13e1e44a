// SPDX-License-Identifier: Apache-2.0
// Writes the records of operations as rows of CSV.
#include "meristem/output/skeleton/operation_csv.h"

#include <algorithm>
#include <string_view>

#include "meristem/base/atomic_file.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"
#include "meristem/output/write/finite.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

constexpr std::string_view kOperationHeader =
    "operation,act,iteration,tree,shoot,rank,metamer,x,y,z,bud_x,bud_y,bud_z,bud_position_x,bud_position_y,"
    "bud_position_z,diameter,metamers,length,wood,light\n";
constexpr std::size_t kOperationNumbers = 18;  // numbers in a row

void append_operation_row(const OperationRecord& record, std::string& out) {
  const auto number = [&](auto value) {
    out += ',';
    append_csv_number(value, out);
  };
  out += csv_field(record.operation) + ',' + record.act;
  number(record.iteration);
  number(record.tree);
  out += ',' + record.shoot;
  number(record.rank);
  number(record.metamer);
  for (const Vec3 vector : {record.position, record.bud, record.bud_position}) {
    for (int k = 0; k < 3; ++k) number(vector[k]);
  }
  number(static_cast<float>(record.diameter));
  number(record.metamers);
  for (const double value : {record.length, record.wood, record.light}) number(static_cast<float>(value));
  out += '\n';
}

}  // namespace

std::vector<OperationRecord> operation_records(const Plant& plant) {
  std::vector<OperationRecord> records;
  for (const Stem& stem : plant.stems) {
    const OperationRecords& own = stem.skeleton.operations;
    records.insert(records.end(), own.begin(), own.end());
  }
  return records;
}

void write_operation_csv(const Plant& grown, const SizeLimits& limits, const std::string& path, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  require_finite(*expanded);
  const std::vector<OperationRecord> records = operation_records(*expanded);
  std::size_t longest = 0;
  for (const OperationRecord& record : records) {
    longest = std::max(longest, csv_field(record.operation).size() + record.act.size() + record.shoot.size() + 4);
  }
  progress.begin("writing CSV", records.size());
  AtomicFile file(path);
  file.write(kOperationHeader);
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    for (std::size_t k = begin; k < end; ++k) append_operation_row(records[k], out);
  };
  BlockWriter(file, progress).write(records.size(), longest + kOperationNumbers * kCsvNumberBytes + 1, fill);
  file.commit();
}

}  // namespace meristem
