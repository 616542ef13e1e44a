// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/texture.h"

namespace meristem {

/// A picture of a texture.
struct TexturePicture {
  /// The pictures of a texture.
  enum class Kind {
    colour,
    normals,
    mask,  ///< the colours' alpha in all four channels: readers look for it in its alpha or in its green
  };
  const Texture* texture = nullptr;  ///< must outlive the picture; not null
  Kind kind = Kind::colour;          ///< which of the texture's pictures

  bool operator==(const TexturePicture&) const = default;
};

/// Pictures as the bytes of PNG files, each encoded once for all files that are written with it: levels of detail and
/// formats share them.
class EncodedPictures {
 public:
  /// The bytes of each of `pictures`, in their order; new pictures are encoded side by side. Their textures stay where
  /// they are for as long as this is used. Throws Cancelled, std::invalid_argument for sketches.
  std::vector<std::shared_ptr<const std::string>> encode(std::span<const TexturePicture> pictures,
                                                         const Progress& progress);

 private:
  struct Entry {
    TexturePicture picture;
    std::shared_ptr<const std::string> bytes;
  };
  std::vector<Entry> entries_;
};

}  // namespace meristem
