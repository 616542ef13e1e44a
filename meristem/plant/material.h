// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "meristem/base/vec.h"
#include "meristem/plant/texture.h"

namespace meristem {

/// The look of a surface. Colours are sRGB in [0, 1], as in documents.
struct Material {
  std::string name;        ///< the component's id; exports use it for groups and materials
  Vec3 colour{0.5F};       ///< mean colour of the surface, sRGB; textures are tinted so that their mean is this colour
  float roughness = 0.8F;  ///< 0 mirror-like, 1 matt
  float translucency = 0;  ///< share of light that passes through a thin blade, 0 for wood
  float opacity = 1;       ///< share of light that does not pass straight through: 1 solid, lower values like glass
  bool two_sided = false;  ///< true for blades, which are visible from both sides
  std::shared_ptr<const Texture> texture;  ///< null: one colour

  bool operator==(const Material&) const = default;

  /// Returns the linear factor for the colour of a texture's pixel, or for white if there is no texture.
  Vec3 tint() const;
};

}  // namespace meristem
