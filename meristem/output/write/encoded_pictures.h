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
    mask,  ///< alpha of the colours in all four channels: readers use the alpha or the green channel
  };
  const Texture* texture = nullptr;  ///< must outlive the picture; not null
  Kind kind = Kind::colour;          ///< which of the texture's pictures

  bool operator==(const TexturePicture&) const = default;
};

/// Pictures as the bytes of PNG files. Each picture is encoded once for all files that are written together: levels of
/// detail and formats share it.
class EncodedPictures {
 public:
  /// Returns the bytes of each of `pictures`, in their order. New pictures are encoded in parallel. Their textures must
  /// not move while this object is used. Throws Cancelled, std::invalid_argument for sketches.
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
