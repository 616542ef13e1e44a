// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/image.h"
#include "meristem/base/mesh.h"
#include "meristem/base/vec.h"
#include "meristem/plant/material.h"

namespace meristem {

/// Where a masked texture has holes. By itself, as rays ask for it at every leaf they meet.
class AlphaMask {
 public:
  explicit AlphaMask(const Image& image);
  /// Whether alpha, bilinear between pixels, is below one half.
  bool is_hole(Vec2 uv) const;

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> alpha_;
};

/// The texture whose mask cuts holes into a mesh of this material; null where there are none.
const Texture* texture_with_holes(const Material& material, const Mesh& mesh);

}  // namespace meristem
