// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/cut_wounds.h"

#include <string>

namespace meristem {

void CutWounds::add(std::size_t metamers, MetamerIndex metamer, const OperationRecord& record) {
  wounds_.resize(metamers);
  Wound& wound = wounds_[metamer];
  wound.at = static_cast<float>(record.iteration);
  wound.metamers += static_cast<float>(record.metamers);
  wound.length += static_cast<float>(record.length);
  wound.wood += static_cast<float>(record.wood);
  wound.light += static_cast<float>(record.light);
}

void CutWounds::remove(const std::vector<std::uint8_t>& gone) {
  if (wounds_.empty()) return;
  wounds_.resize(gone.size());
  erase_marked(wounds_, gone);
}

void CutWounds::write(Skeleton& skeleton) const {
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
}

}  // namespace meristem
