// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/overlay/trace_csv.h"

#include <algorithm>
#include <array>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/output/write/csv.h"

namespace meristem {

void write_points_csv(const GrowthTraces& traces, const std::string& path, Progress& progress) {
  static constexpr std::array<const char*, 3> kStates{"free", "used", "removed"};
  if (!traces.recorded.points) {
    throw InputError(Diagnostic{.message = "the growth of the plants was not recorded, so their points are not known",
                                .expected = "a growth that records points: in Python, document.grow(trace=True)"});
  }
  progress.begin("writing CSV", traces.growths.size());
  std::string text = "component,instance,number,x,y,z,state,used_in\n";
  for (const TracedGrowth& growth : traces.growths) {
    const StepMarks marks =
        growth.trace->marks(std::clamp(traces.shown_step(), 0, growth.trace->last_step()), {.points = true});
    const std::string of = csv_field(growth.component) + "," + std::to_string(growth.instance) + ",";
    for (std::size_t k = 0; k < marks.points.size(); ++k) {
      const TracedPlace& point = marks.points[k];
      text += of;
      append_csv_number(k, text);
      for (int axis = 0; axis < 3; ++axis) {
        text += ',';
        append_csv_number(point.position[axis], text);
      }
      text += ',';
      text += kStates[static_cast<std::size_t>(point.state)];
      text += ',';
      append_csv_number(point.used_in, text);
      text += '\n';
    }
    progress.advance();
  }
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace meristem
