// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/cut_wounds.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "meristem/base/math.h"

namespace meristem {

void CutWounds::add(std::size_t metamers, MetamerIndex metamer, const OperationRecord& record, double section) {
  wounds_.resize(metamers);
  Wound& wound = wounds_[metamer];
  wound.at = static_cast<float>(record.iteration);
  wound.metamers += static_cast<float>(record.metamers);
  wound.length += static_cast<float>(record.length);
  wound.wood += static_cast<float>(record.wood);
  wound.light += static_cast<float>(record.light);
  wound.section += section;
}

void CutWounds::remove(const std::vector<std::uint8_t>& gone) {
  if (wounds_.empty()) return;
  wounds_.resize(gone.size());
  erase_marked(wounds_, gone);
}

void CutWounds::swell(double callus, Skeleton& skeleton) const {
  if (wounds_.empty() || !(callus > 0)) return;
  std::vector<double> section(skeleton.node_count(), 0);
  for (std::size_t k = 0; k < wounds_.size(); ++k) section[k] = wounds_[k].section;
  for (auto node = static_cast<NodeIndex>(skeleton.node_count()); node-- > 0;) {
    if (section[node] <= 0) continue;
    const double radius = skeleton.radius[node];
    if (!skeleton.is_root(node)) {
      const NodeIndex parent = skeleton.parent[node];
      const double length = glm::distance(skeleton.position[node], skeleton.position[parent]);
      section[parent] += section[node] * math::pow(0.5, length / (kCallusReach * radius));
    }
    skeleton.radius[node] = static_cast<float>(std::sqrt(radius * radius + callus * section[node] / kPi));
  }
}

void CutWounds::write(Skeleton& skeleton, std::optional<double> closure, int iteration) const {
  const auto column = [&](const char* name, float Wound::*member) {
    std::vector<float>& values = skeleton.extra[name];
    values.assign(skeleton.node_count(), 0);
    for (std::size_t k = 0; k < wounds_.size(); ++k) values[k] = wounds_[k].*member;
  };
  column("cut_at", &Wound::at);
  column("cut_metamers", &Wound::metamers);
  column("cut_length", &Wound::length);
  column("cut_wood", &Wound::wood);
  column("cut_light", &Wound::light);
  if (!closure) return;
  std::vector<float>& open = skeleton.extra["wound"];
  open.assign(skeleton.node_count(), 0);
  for (std::size_t k = 0; k < wounds_.size(); ++k) {
    const double closed = *closure * (iteration - static_cast<double>(wounds_[k].at));
    open[k] = static_cast<float>(std::max(0.0, std::sqrt(wounds_[k].section / kPi) - closed));
  }
}

}  // namespace meristem
