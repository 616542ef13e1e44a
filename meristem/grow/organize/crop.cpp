// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/crop.h"

#include <algorithm>
#include <utility>

namespace meristem {

void Crop::begin(const Metamers& metamers, int iteration) {
  if (iteration == iteration_) return;
  iteration_ = iteration;
  bears_ = std::exchange(chosen_, {});
  fruits_ = 0;
  for (MetamerIndex metamer = 0; metamer < bears_.size(); ++metamer) {
    if (!metamers.lateral[metamer].is_open()) bears_[metamer] = 0;
    fruits_ += bears_[metamer];
  }
}

double Crop::share_of(double whole, const FruitBearing& bearing) const {
  return whole > 0 ? std::min(1.0, bearing.cost * fruits_ / whole) : 0;
}

void Crop::choose(const Metamers& metamers, const ResourceFlow& flow, const FruitBearing& bearing, int iteration) {
  chosen_.assign(metamers.count(), 0);
  for (MetamerIndex metamer = 1; metamer < metamers.count(); ++metamer) {
    const bool is_old_enough = metamers.birth[metamer] + bearing.age <= iteration;
    const bool is_ready = metamers.lateral[metamer].is_open() && is_old_enough;
    chosen_[metamer] = is_ready && flow.lateral(metamer) >= bearing.threshold ? 1 : 0;
  }
}

void Crop::remove(const std::vector<std::uint8_t>& gone) {
  erase_marked(bears_, gone);
  erase_marked(chosen_, gone);
}

void Crop::write(Skeleton& skeleton) const {
  std::vector<float>& column = skeleton.extra["fruit"];
  column.assign(bears_.begin(), bears_.end());
  column.resize(skeleton.node_count(), 0);
}

}  // namespace meristem
