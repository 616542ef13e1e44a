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

}  // namespace meristem
