// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/stem_looks.h"

#include <map>
#include <string_view>
#include <tuple>

namespace meristem {

StemLooks::StemLooks(const Stem& stem) {
  using Look = std::tuple<std::string_view, std::uint32_t, float, float, float>;
  std::map<Look, std::uint32_t> number;
  for (const StemPart& part : stem.parts) {
    const Look look(part.component, part.material, part.tint.r, part.tint.g, part.tint.b);
    const auto [known, is_new] = number.try_emplace(look, static_cast<std::uint32_t>(first_part.size()));
    if (is_new) first_part.push_back(&part);
    look_of_part.push_back(known->second);
  }
}

std::vector<std::vector<AxisIndex>> StemLooks::axes(const Stem& stem) const {
  std::vector<std::vector<AxisIndex>> axes(first_part.size());
  AxisIndex count = 0;
  for (const AxisIndex axis : stem.skeleton.axis) count = std::max(count, axis + 1);
  for (AxisIndex axis = 0; axis < count; ++axis) axes[look_of_part[stem.part_index(axis)]].push_back(axis);
  return axes;
}

}  // namespace meristem
