// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/material.h"

#include "meristem/base/colour.h"

namespace meristem {

Vec3 Material::tint() const {
  const Vec3 wanted = linear_from_srgb(colour);
  return texture == nullptr ? wanted : wanted / glm::max(texture->mean, Vec3(1e-4F));
}

}  // namespace meristem
