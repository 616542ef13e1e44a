// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/frame.h"
#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The position of a file's content in a document. The up axis of the file is turned up; then the content is scaled,
/// rotated and moved. All of this is done in 64 bits.
struct ImportPose {
  /// The axis of the file that points up.
  enum class Up { y, z };
  Up up = Up::y;       ///< up axis of the file
  double scale = 1;    ///< metres per unit of the file
  DVec3 rotate{0};     ///< radians, as of Transform
  DVec3 translate{0};  ///< metres, after scale and rotation

  /// Returns the pose as a frame, from the file's coordinates to the document's.
  DFrame frame() const;
};

const ParameterTable& import_table();  ///< the rows of ImportPose
/// The names of its rows, which stand beside the file's own in a table.
const std::vector<std::string>& import_names();

}  // namespace meristem
