// SPDX-License-Identifier: Apache-2.0
// The light that a point of a surface gives back is texture x Material::tint() x the instance's tint, linear; a
// material's tint brings its texture's mean to Material::colour. Every file and picture keeps to that product, or
// says which part of it its format cannot hold.
#include "meristem/plant/material.h"

#include "meristem/base/colour.h"

namespace meristem {

Vec3 Material::tint() const {
  const Vec3 wanted = linear_from_srgb(colour);
  return texture == nullptr ? wanted : wanted / glm::max(texture->mean, Vec3(1e-4F));
}

}  // namespace meristem
