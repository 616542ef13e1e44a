// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// One organ and the share of the scene's light that reaches it. Sun, sky and lamps count by their strengths. Both
/// shares are means over the organ's surface, in [0, 1], and 0 if the scene has no light.
struct LitOrgan {
  double area = 0;        ///< square metres, for a blade one side, as in organ_areas (foliage.h)
  double exposure = 0;    ///< share of the light's rays that reaches the organ
  double irradiance = 0;  ///< share of the rays, each times |cosine| between ray and face normal: the light that a matt
                          ///< surface absorbs, relative to a surface that faces all light unshaded
};

/// Returns the light on each organ, in the order of expanded() (plant_variant.h). Organs, stems and obstacles cast
/// shadows, and an organ also shades itself. The holes of masked textures let light pass. `meshes` must be the result
/// of make_mesh_scene for the plant.
///
/// Each organ has one sample per 10 cm² of its surface, at least 4 and at most 64, and none on its petiole. On a closed
/// organ, samples also lie on the dark side. The scene may differ from the scene in which the plant grew. Takes about a
/// microsecond per sample and light. Results are equal on any number of threads. Begins one stage of `progress`, which
/// counts organs. Throws InputError if `limits` are exceeded, Cancelled, MachineError (memory).
std::vector<LitOrgan> measure_organ_light(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes,
                                          const Scene& scene, Progress& progress);

/// Combines organs into one: the sum of the areas, and means weighted by area.
class MeanLight {
 public:
  /// Adds an organ.
  void add(const LitOrgan& organ) {
    sum_.area += organ.area;
    sum_.exposure += organ.area * organ.exposure;
    sum_.irradiance += organ.area * organ.irradiance;
  }
  /// Returns the combined organ. All fields are 0 if the area is 0.
  LitOrgan mean() const {
    if (!(sum_.area > 0)) return {};
    return {sum_.area, sum_.exposure / sum_.area, sum_.irradiance / sum_.area};
  }

 private:
  LitOrgan sum_;  // sums of share times area
};

/// Combines all leaves (foliage.h) into one organ: the sum of the areas, and means weighted by area. All fields are 0
/// without leaves.
LitOrgan mean_leaf_light(const Plant& plant, const std::vector<LitOrgan>& organs);

}  // namespace meristem
