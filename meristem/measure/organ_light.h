// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// One organ and the share of the scene's light that it gets, sun, sky and lamps by their strengths. Both shares are
/// means over its surface, in [0, 1], and 0 where the scene has no light.
struct LitOrgan {
  double area = 0;        ///< square metres, of a blade one side, as organ_areas has it (foliage.h)
  double exposure = 0;    ///< share of the light's rays that arrives
  double irradiance = 0;  ///< share of the rays, each times |cosine| between ray and face normal: what a matt surface
                          ///< takes up, against one that faces all light unshaded
};

/// The light on each organ, in the order of expanded() (plant_variant.h). Organs, itself included, stems and obstacles
/// shade it; holes of masked textures let light through. `meshes` is what make_mesh_scene makes of the plant.
///
/// Each organ is asked at one position in 10 cm² of its surface, at least 4 and at most 64, and not on its petiole; a
/// closed one at positions on its dark side too. The scene need not be the one that the plant grew in. About a
/// microsecond per position and light. Results are equal on any number of threads. Begins one stage of `progress`,
/// which counts organs. Throws InputError past `limits`, Cancelled, MachineError (memory).
std::vector<LitOrgan> measure_organ_light(const Plant& plant, const Limits& limits, const MeshScene& meshes,
                                          const Scene& scene, Progress& progress);

/// Organs as one: their area together, and means by area.
class MeanLight {
 public:
  /// Adds an organ.
  void add(const LitOrgan& organ) {
    sum_.area += organ.area;
    sum_.exposure += organ.area * organ.exposure;
    sum_.irradiance += organ.area * organ.irradiance;
  }
  /// All 0 without area.
  LitOrgan mean() const {
    if (!(sum_.area > 0)) return {};
    return {sum_.area, sum_.exposure / sum_.area, sum_.irradiance / sum_.area};
  }

 private:
  LitOrgan sum_;  // shares times area
};

/// All leaves (foliage.h) as one organ: their area together, and means by area. 0 without leaves.
LitOrgan mean_leaf_light(const Plant& plant, const std::vector<LitOrgan>& organs);

}  // namespace meristem
