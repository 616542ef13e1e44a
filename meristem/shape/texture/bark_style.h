// SPDX-License-Identifier: Apache-2.0
// What the styles of bark share, and the function of each that paints it.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/shape/texture/noise_field.h"
#include "meristem/shape/texture/texture_canvas.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// A recipe made ready for painting.
struct BarkPaints {
  /// `work` outlives it.
  BarkPaints(const BarkRecipe& recipe, Vec3 colour, int pixels_a_side, const Progress& work);

  /// How many features stand in a row, at least `least`, where there are `usual` at scale 1.
  int count(double usual, int least = 1) const;
  int even_count(double usual) const { return std::max(2, 2 * count(usual / 2)); }
  /// How many features there are on the tile's area.
  int area_count(double usual) const;
  /// A noise of its own for each name. Throws Cancelled.
  std::vector<float> noise(std::string_view name, const NoiseParameters& form) const {
    progress.check();
    return noise_field(key.child(name), form, pixels);
  }
  /// From one linear colour to another as far as the contrast wants it.
  Vec3 toward(Vec3 from, Vec3 to, float share) const {
    return glm::mix(from, to, std::clamp(share * contrast, 0.0F, 1.0F));
  }
  /// A factor on lightness.
  float tone(float lighter) const { return std::max(0.05F, 1 + contrast * lighter); }

  int pixels;
  const Progress& progress;
  RandomKey key;
  float scale;
  float contrast;
  Vec3 bark;   // linear
  Vec3 seams;  // linear
  std::optional<Vec3> marks;
};

Canvas paint_smooth_bark(const BarkPaints& paints);
Canvas paint_furrowed_bark(const BarkPaints& paints);
Canvas paint_plated_bark(const BarkPaints& paints);
Canvas paint_peeling_bark(const BarkPaints& paints);

}  // namespace meristem
