// SPDX-License-Identifier: Apache-2.0
// The linear colour of a surface point is texture x Material::tint() x the instance's tint. Material::tint() brings the
// mean of the texture to Material::colour. All files and pictures use this product. A format that cannot hold a factor
// documents it.
#include "meristem/plant/material.h"

#include "meristem/base/colour.h"

namespace meristem {

Vec3 Material::tint() const {
  const Vec3 wanted = linear_from_srgb(colour);
  return texture == nullptr ? wanted : wanted / glm::max(texture->mean, Vec3(1e-4F));
}

}  // namespace meristem
