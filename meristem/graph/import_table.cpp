// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/import_table.h"

#include "meristem/graph/table/table.h"

namespace meristem {

DFrame ImportPose::frame() const {
  DFrame frame{.axes = DMat3(scale), .origin = translate};
  if (rotate != DVec3(0)) {
    const DMat3 turn =
        exact_rotation({0, 0, 1}, rotate.z) * exact_rotation({1, 0, 0}, rotate.x) * exact_rotation({0, 1, 0}, rotate.y);
    frame.axes = turn * frame.axes;
  }
  // With z up, y points north, which is -z in the document.
  if (up == Up::z) frame.axes = {frame.axes[0], -frame.axes[2], frame.axes[1]};
  return frame;
}

const ParameterTable& import_table() {
  static const ParameterTable table =
      Table<ImportPose>("an import", "Transform of the content of a file into the scene.")
          .choice("up", &ImportPose::up, {"y", "z"},
                  "Axis of the file that points up; with z, the file's y points north.")
          .number("scale", &ImportPose::scale, {.min = 1e-6, .max = 1e6, .usual = {0.001, 10}},
                  "Scale factor on the file's lengths, applied first.")
          .vector("rotate", &ImportPose::rotate, {.unit = Unit::degree, .min = -1e6, .max = 1e6},
                  "Angles of pitch about x, roll about y and yaw about z, applied after the scale.")
          .in_space(InSpace::turn)
          .vector("translate", &ImportPose::translate,
                  {.unit = Unit::metre, .min = -1e8, .max = 1e8, .usual = {-10, 10}},
                  "Shift along x, y and z, applied last.")
          .in_space(InSpace::shift);
  return table;
}

const std::vector<std::string>& import_names() {
  static const std::vector<std::string> names = import_table().names();
  return names;
}

}  // namespace meristem
