// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/frame.h"
#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The pose of a file's content in a document. First the file's up axis is turned up, then the content is scaled,
/// rotated and moved, all in 64 bits.
struct ImportPose {
  /// The axis of the file that points up.
  enum class Up { y, z };
  Up up = Up::y;       ///< up axis of the file
  double scale = 1;    ///< metres per unit of the file
  DVec3 rotate{0};     ///< radians, as of InstanceTransform
  DVec3 translate{0};  ///< metres, after scale and rotation

  /// Returns the pose as a frame, from the file's coordinates to the document's. With z up, the file's y points north,
  /// which is -z in the document.
  DFrame frame() const;
};

const ParameterTable& import_table();  ///< the rows of ImportPose
/// Returns the names of the rows of ImportPose, which stand beside a file's own rows in a table.
const std::vector<std::string>& import_names();

}  // namespace meristem
