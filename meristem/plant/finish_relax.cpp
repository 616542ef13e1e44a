// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/finish.h"

namespace meristem {

void relax_angles(Skeleton& skeleton) {
  // Children before parents, so that every parent still stands at its old position when it is read. The source's
  // equation 3.21 takes half the distance times the vector to the parent; half the vector is meant.
  for (std::size_t node = skeleton.node_count(); node-- > 0;) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent != kNoNode) skeleton.position[node] = 0.5F * (skeleton.position[node] + skeleton.position[parent]);
  }
}

}  // namespace meristem
