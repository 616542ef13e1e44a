// SPDX-License-Identifier: Apache-2.0
// Common parts of the bark styles, and the function that paints each style.
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

/// A recipe prepared for painting.
struct BarkPaints {
  /// `work` must outlive this object.
  BarkPaints(const BarkRecipe& recipe, Vec3 colour, int pixels_a_side, const Progress& work);

  /// Returns the number of features in a row, at least `min`. `usual` is the number at scale 1.
  int count(double usual, int min = 1) const;
  int even_count(double usual) const { return std::max(2, 2 * count(usual / 2)); }
  /// Returns the number of features on the tile's area.
  int area_count(double usual) const;
  /// Returns a separate noise for each name. Throws Cancelled.
  std::vector<float> noise(std::string_view name, const NoiseParameters& form) const {
    progress.check();
    return noise_field(key.child(name), form, pixels);
  }
  /// Returns a mix of two linear colours, scaled by the contrast.
  Vec3 toward(Vec3 from, Vec3 to, float share) const {
    return glm::mix(from, to, std::clamp(share * contrast, 0.0F, 1.0F));
  }
  /// Returns a factor on lightness.
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
