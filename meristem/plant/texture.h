// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/image.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Pictures that lie on a surface by its uvs and repeat beyond them; v = 0 is the pictures' lower edge.
struct Texture {
  std::string name;     ///< for files: "furrowed"
  Image colour;         ///< colour with an alpha that is a mask where `masked`, else 255
  Image normals;        ///< in the surface's tangent space: x along u, y along v, z outward, as glTF wants them
  Vec3 mean{1};         ///< linear mean colour of what is not masked out; what Material::colour stands for
  bool masked = false;  ///< where alpha is below one half the surface has a hole
  std::uint64_t fingerprint = 0;  ///< hash of everything that the texture is made of; 0: not known

  bool has_normals() const { return !normals.is_empty(); }
  /// False for a sketch, which has all but the pixels and the mean of what the program makes.
  bool is_painted() const { return colour.is_empty() || !colour.rgba.empty(); }
  std::uint64_t bytes() const { return colour.rgba.capacity() + normals.rgba.capacity(); }
};

}  // namespace meristem
