// SPDX-License-Identifier: Apache-2.0
// Groups the parts of a stem by their looks, then splits the groups by individual if a stem belongs to several.
#include "meristem/shape/stem/stem_looks.h"

#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "meristem/shape/stem/deformation_hashes.h"

namespace meristem {

StemLooks::StemLooks(const Stem& stem) {
  using Look = std::tuple<std::string_view, std::uint32_t, float, float, float, std::uint64_t>;
  std::map<Look, std::uint32_t> number;
  DeformationHashes hashes;
  for (const StemPart& part : stem.parts) {
    const Look look(part.component, part.material, part.tint.r, part.tint.g, part.tint.b, hashes.of(part.deformation));
    const auto [known, is_new] = number.try_emplace(look, static_cast<std::uint32_t>(first_part.size()));
    if (is_new) first_part.push_back(&part);
    mesh_of_part.push_back(known->second);
  }
  individual.assign(first_part.size(), stem.individual());
  if (stem.individual() != kNoIndividual) return;

  // Divide the meshes among the individuals.
  const std::vector<const StemPart*> first_of_look = std::exchange(first_part, {});
  individual.clear();
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_of_mesh;
  const std::vector<std::uint32_t> individual_of_axis = stem.individual_of_axis();
  for (AxisIndex axis = 0; axis < individual_of_axis.size(); ++axis) {
    const std::uint32_t look = mesh_of_part[stem.part_index(axis)];
    const auto next = static_cast<std::uint32_t>(first_part.size());
    const auto [known, is_new] = number_of_mesh.try_emplace({look, individual_of_axis[axis]}, next);
    if (is_new) {
      first_part.push_back(first_of_look[look]);
      individual.push_back(individual_of_axis[axis]);
    }
    mesh_of_axis.push_back(known->second);
  }
}

}  // namespace meristem
