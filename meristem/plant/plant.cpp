// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/plant.h"

namespace meristem {

std::uint64_t Plant::node_count() const {
  std::uint64_t nodes = 0;
  for (const Stem& stem : stems) nodes += stem.skeleton.node_count();
  return nodes;
}

}  // namespace meristem
