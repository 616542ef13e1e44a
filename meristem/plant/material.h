// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "meristem/base/vec.h"
#include "meristem/plant/texture.h"

namespace meristem {

/// How a surface looks. Colours are sRGB in [0, 1], as documents write them.
struct Material {
  std::string name;        ///< the component's id; groups and materials in exports carry it
  Vec3 colour{0.5F};       ///< the mean of the surface; a texture's colours are tinted so that theirs is this one
  float roughness = 0.8F;  ///< 0 mirror-like, 1 matt
  float translucency = 0;  ///< share of light that passes through a thin blade, 0 for wood
  bool two_sided = false;  ///< blades are seen from both sides
  std::shared_ptr<const Texture> texture;  ///< null: one colour

  bool operator==(const Material&) const = default;

  /// What the light that a texture's pixel (or white, without one) gives back is multiplied with, linear.
  Vec3 tint() const;
};

}  // namespace meristem
