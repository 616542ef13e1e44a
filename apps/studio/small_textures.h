// SPDX-License-Identifier: Apache-2.0
// Textures for small pictures: what a picture of few pixels shows of a texture, a smaller one shows as well, and it is
// ready to be looked up in a tenth of the time.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/material.h"
#include "meristem/plant/texture.h"

namespace meristem::studio {

/// Keeps the small textures that were used last. One thread at a time calls it.
class SmallTextures {
 public:
  /// Has materials wear painted textures with at most `size` pixels along their longer side, each the mean of those
  /// that it stands for; textures that are small enough stay. Throws Cancelled.
  void fit(const std::vector<std::vector<Material>*>& lists, int size, const Progress& progress);

 private:
  struct Small {
    std::shared_ptr<const Texture> whole;  // so that its address is not used again
    std::shared_ptr<const Texture> small;
  };

  std::map<const Texture*, Small> known_;  // by the whole one
  int size_ = 0;                           // of all of them
};

}  // namespace meristem::studio
