// SPDX-License-Identifier: Apache-2.0
// Writes attraction points as rows of CSV, growth by growth, formatted in blocks on all threads.
#include "meristem/export/overlay/trace_csv.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"

namespace meristem {

namespace {

constexpr std::array<const char*, 3> kStates{"free", "used", "removed"};
constexpr std::size_t kRowBytes = 5 * kCsvNumberBytes + 16;  // maximum size of a point's row, without its component and
                                                             // instance

void append_point(const TracedPlace& point, std::size_t number, std::string& out) {
  append_csv_number(number, out);
  for (int axis = 0; axis < 3; ++axis) {
    out += ',';
    append_csv_number(point.position[axis], out);
  }
  out += ',';
  out += kStates[static_cast<std::size_t>(point.state)];
  out += ',';
  append_csv_number(point.used_in, out);
  out += '\n';
}

}  // namespace

void write_points_csv(const GrowthTraces& traces, const std::string& path, Progress& progress) {
  if (!traces.recorded.has(TracePart::points)) {
    throw InputError(Diagnostic{.message = "the growth of the plants was not recorded, so their points are not known",
                                .expected = "a growth that records points: in Python, document.grow(trace=True)"});
  }
  const std::vector<GrowthMarks> growths = traces.marks_of_growths(traces.shown_step(), {TracePart::points}, progress);
  std::uint64_t count = 0;
  for (const GrowthMarks& growth : growths) count += growth.marks.points.size();
  progress.begin("writing CSV", count);
  AtomicFile file(path);
  file.write("component,instance,number,x,y,z,state,used_in\n");
  BlockWriter writer(file, progress);
  for (const GrowthMarks& growth : growths) {
    const std::vector<TracedPlace>& points = growth.marks.points;
    const std::string of = csv_field(growth.component) + "," + std::to_string(growth.instance) + ",";
    writer.write(points.size(), of.size() + kRowBytes, [&](std::size_t begin, std::size_t end, std::string& out) {
      for (std::size_t point = begin; point < end; ++point) {
        out += of;
        append_point(points[point], point, out);
      }
    });
  }
  file.commit();
}

}  // namespace meristem
