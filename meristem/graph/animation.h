// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace meristem {

/// The movement of a document over time, besides the keys of its parameters.
struct Animation {
  double length = 10;  ///< seconds
  double fps = 25;     ///< frames per second of a film
  /// Growth steps per second of a plant's clock. Unset: plants that grow by a model are shown as at their end.
  std::optional<double> steps_per_second;
  double unfold = 1;  ///< seconds in which a child on such a plant unfolds to its full size
  double hold = 2;    ///< seconds that a shed branch of such a plant stays after its last growth
};

}  // namespace meristem
