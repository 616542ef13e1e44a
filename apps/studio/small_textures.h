// SPDX-License-Identifier: Apache-2.0
// Smaller textures for small pictures. In a picture of few pixels a small texture looks like a large one, and it is
// prepared in a tenth of the time.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/material.h"
#include "meristem/plant/texture.h"

namespace meristem::studio {

/// Keeps the small textures that were used last. Only one thread at a time may call it.
class SmallTextures {
 public:
  /// Replaces painted textures by textures with at most `size` pixels along their longer side. Each pixel is the mean
  /// of the pixels that it covers. Textures that are small enough stay. Throws Cancelled.
  void fit(const std::vector<std::vector<Material>*>& lists, int size, const Progress& progress);

 private:
  struct Small {
    std::shared_ptr<const Texture> whole;  // kept, so that its address is not used again
    std::shared_ptr<const Texture> small;
  };

  std::map<const Texture*, Small> known_;  // by the large texture
  int size_ = 0;                           // size of all small textures
};

}  // namespace meristem::studio
