// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/image.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Pictures on a surface, placed by its uvs and repeated beyond them. v = 0 is the lower edge of the pictures.
struct Texture {
  std::string name;               ///< used in file names, such as "furrowed"
  Image colour;                   ///< colour; alpha is a mask if `masked`, else 255
  Image normals;                  ///< in the surface's tangent space, as in glTF: x along u, y along v, z outward
  Vec3 mean{1};                   ///< linear mean colour of the visible pixels; Material::colour replaces this mean
  bool masked = false;            ///< true: the surface has holes where alpha is below one half
  std::uint64_t fingerprint = 0;  ///< hash of all inputs of the texture; 0: unknown

  bool has_normals() const { return !normals.is_empty(); }  ///< true if the texture has a picture of normals
  /// Returns false for a sketch: a texture that the program makes, still without pixels and mean.
  bool is_painted() const { return colour.is_empty() || !colour.rgba.empty(); }
  /// Returns the heap memory of both pictures.
  std::uint64_t bytes() const { return colour.rgba.capacity() + normals.rgba.capacity(); }
};

}  // namespace meristem
