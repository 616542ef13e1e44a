// SPDX-License-Identifier: Apache-2.0
// Splits colours into a factor per material and a factor per instance. The material's factor is the maximum over its
// instances, so that no instance needs a factor above 1.
#include "meristem/output/write/colour_factors.h"

namespace meristem {

namespace {

Vec3 within_one(Vec3 factor) { return glm::clamp(factor, Vec3(0), Vec3(1)); }

}  // namespace

Vec3 ColourFactors::instance(Vec3 tint) const {
  // A channel that is 0 in all instances stays 0 through its base.
  constexpr float kDark = 1e-6F;
  return within_one(within_one(material * tint) / glm::max(base, Vec3(kDark)));
}

std::vector<ColourFactors> colour_factors(const MeshScene& scene) {
  const std::size_t count = scene.materials.size();
  std::vector<ColourFactors> factors(count);
  std::vector<Vec3> max(count, Vec3(0));
  std::vector<DVec3> sums(count, DVec3(0));
  std::vector<std::size_t> instance_counts(count, 0);
  for (const MeshInstances& instances : scene.meshes) {
    const std::uint32_t m = instances.material;
    const std::size_t frames = instances.count();
    instance_counts[m] += frames;
    if (instances.tints.empty()) {
      max[m] = glm::max(max[m], Vec3(1));
      sums[m] += DVec3(static_cast<double>(frames));
    }
    const auto places = static_cast<double>(instances.place_count());
    for (const Vec3 tint : instances.tints) {
      max[m] = glm::max(max[m], tint);
      sums[m] += places * DVec3(tint);
    }
    factors[m].varies |= !instances.tints.empty();
  }
  for (std::size_t m = 0; m < count; ++m) {
    const Vec3 tint = scene.materials[m].tint();
    factors[m].material = tint;
    if (instance_counts[m] == 0) max[m] = Vec3(1);
    factors[m].base = within_one(tint * max[m]);
    const Vec3 mean = instance_counts[m] == 0 ? Vec3(1) : Vec3(sums[m] / static_cast<double>(instance_counts[m]));
    factors[m].mean = within_one(tint * mean);
  }
  return factors;
}

std::vector<ColourFactors> colour_factors(const MovingScene& moving) {
  std::vector<ColourFactors> factors = colour_factors(moving.scene);
  for (std::size_t k = 0; k < moving.motions.size(); ++k) {
    ColourFactors& factor = factors[moving.scene.meshes[k].material];
    for (const std::vector<Vec3>& tints : moving.motions[k].tints) {
      for (const Vec3 tint : tints) factor.base = glm::max(factor.base, within_one(factor.material * tint));
    }
  }
  return factors;
}

}  // namespace meristem
