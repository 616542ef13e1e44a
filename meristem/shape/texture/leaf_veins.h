// SPDX-License-Identifier: Apache-2.0
// The course of a leaf's veins in closed form: the amount of vein at any point.
#pragma once

#include <vector>

#include "meristem/base/random.h"
#include "meristem/shape/texture/blade_map.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

class LeafVeins {
 public:
  /// Shares of a pixel, in [0, 1].
  struct Spot {
    float main = 0;   ///< midrib and other main veins
    float side = 0;   ///< side veins
    float cross = 0;  ///< thin veins from one side vein to the next
    float swell = 0;  ///< 0 on side veins, 1 midway between two
  };

  /// `map` must outlive this object.
  LeafVeins(const LeafRecipe& recipe, const TextureShape& shape, const BladeMap& map, int pixels);
  /// Returns the veins at a point. `row` is the row of pixels that contains v. `wobble`, about [-1, 1], bends the
  /// veins.
  Spot at(float u, float v, std::size_t row, float wobble) const;

 private:
  struct MainVein {
    Vec2 heading{0, 1};
    float length = 1;
    std::vector<float> shifts;  // shifts of side veins along the main vein, in their spacing, alternating right and
                                // left
  };
  struct SideVeins {
    float first;    // where the first side vein leaves its main vein
    float spacing;  // distance between side veins
    float count;
    float reach;  // length of side veins across their main vein
  };

  Spot pinnate_at(Vec2 position, std::size_t row, float wobble) const;
  Spot palmate_at(Vec2 position, float wobble) const;
  Spot parallel_at(float u, float v, std::size_t row) const;
  void add_sides(const MainVein& vein, const SideVeins& form, float along, float across, float wobble,
                 Spot& spot) const;
  void find_palm(const TextureShape& shape);
  float line(float distance, float half_width) const;

  LeafRecipe recipe_;
  const BladeMap& map_;
  float aspect_;
  float pixel_;
  float lean_;  // distance along the main vein per distance across
  std::vector<MainVein> mains_;
};

}  // namespace meristem
