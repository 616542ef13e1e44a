// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace meristem {

/// How a document moves, besides the keys of its parameters.
struct Animation {
  double length = 10;  ///< seconds
  double fps = 25;     ///< frames per second of a film
  /// Growth steps per second of a plant's clock; unset: plants that grow by a model stand as they are at the end.
  std::optional<double> steps_per_second;
  double unfold = 1;  ///< seconds from when a part of such a plant bears something to when that has its full size
  double hold = 2;    ///< seconds that a branch that such a plant sheds stands after its last growth
};

}  // namespace meristem
