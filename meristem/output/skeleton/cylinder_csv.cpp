// SPDX-License-Identifier: Apache-2.0
// Writes cylinders as rows of CSV in the columns of TreeQSM (source in the header). Rows are formatted in blocks on all
// threads.
#include "meristem/output/skeleton/cylinder_csv.h"

#include <string_view>

#include "meristem/base/atomic_file.h"
#include "meristem/output/skeleton/cylinders.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"
#include "meristem/output/write/finite.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

constexpr std::string_view kCylinderHeader =
    "radius,length,start.x,start.y,start.z,axis.x,axis.y,axis.z,parent,extension,added,UnmodRadius,branch,SurfCov,mad,"
    "BranchOrder,PositionInBranch\n";
constexpr std::size_t kCylinderColumns = 17;

/// Rows are counted from 1, and 0 marks a missing cylinder.
std::uint32_t row_number(std::uint32_t cylinder) { return cylinder == kNoCylinder ? 0 : cylinder + 1; }

void append_cylinder(const TreeCylinder& cylinder, std::string& out) {
  const DVec3 way = DVec3(cylinder.end) - DVec3(cylinder.begin);
  const double length = glm::length(way);
  const DVec3 axis = length > 0 ? way / length : DVec3(0, 0, 1);
  for (const double number : {double{cylinder.radius}, length, double{cylinder.begin.x}, double{cylinder.begin.y},
                              double{cylinder.begin.z}, axis.x, axis.y, axis.z}) {
    append_csv_number(static_cast<float>(number), out);
    out += ',';
  }
  append_csv_number(row_number(cylinder.parent), out);
  out += ',';
  append_csv_number(row_number(cylinder.extension), out);
  out += ",0,";
  append_csv_number(cylinder.radius, out);
  out += ',';
  append_csv_number(cylinder.axis + 1, out);
  out += ",1,0,";
  append_csv_number(cylinder.order, out);
  out += ',';
  append_csv_number(cylinder.position + 1, out);
  out += '\n';
}

}  // namespace

void write_cylinder_csv(const Plant& grown, const SizeLimits& limits, const std::string& path, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  require_finite(*expanded);
  const std::vector<TreeCylinder> cylinders = cylinders_of(*expanded);
  progress.begin("writing CSV", cylinders.size());
  AtomicFile file(path);
  file.write(kCylinderHeader);
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    for (std::size_t k = begin; k < end; ++k) append_cylinder(cylinders[k], out);
  };
  BlockWriter(file, progress).write(cylinders.size(), kCylinderColumns * kCsvNumberBytes, fill);
  file.commit();
}

}  // namespace meristem
