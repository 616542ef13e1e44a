// SPDX-License-Identifier: Apache-2.0
// Encodes pictures of textures as PNG, each once. New pictures run in parallel, and a failure removes all of them
// again.
#include "meristem/output/write/encoded_pictures.h"

#include <algorithm>

#include "meristem/base/parallel.h"
#include "meristem/output/write/png.h"

namespace meristem {

namespace {

Image mask_of(const Image& colour) {
  Image mask = colour;
  for (std::size_t i = 0; i < mask.rgba.size(); i += 4) {
    std::fill_n(mask.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, mask.rgba[i + 3]);
  }
  return mask;
}

std::string encoded(const TexturePicture& picture) {
  switch (picture.kind) {
    case TexturePicture::Kind::colour:
      return encode_png(picture.texture->colour, PixelKind::srgb, PngPacking::quick);
    case TexturePicture::Kind::normals:
      return encode_png(picture.texture->normals, PixelKind::numbers, PngPacking::quick);
    case TexturePicture::Kind::mask:
      return encode_png(mask_of(picture.texture->colour), PixelKind::numbers, PngPacking::quick);
  }
  return {};
}

}  // namespace

std::vector<std::shared_ptr<const std::string>> EncodedPictures::encode(std::span<const TexturePicture> pictures,
                                                                        const Progress& progress) {
  const auto number_of = [this](const TexturePicture& picture) {
    return static_cast<std::size_t>(std::ranges::find(entries_, picture, &Entry::picture) - entries_.begin());
  };
  const std::size_t known = entries_.size();
  for (const TexturePicture& picture : pictures) {
    if (number_of(picture) == entries_.size()) entries_.push_back({picture, nullptr});
  }
  try {
    parallel_for(entries_.size() - known, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = known + begin; k < known + end; ++k) {
        progress.check();
        entries_[k].bytes = std::make_shared<const std::string>(encoded(entries_[k].picture));
      }
    });
  } catch (...) {
    entries_.resize(known);
    throw;
  }
  std::vector<std::shared_ptr<const std::string>> bytes;
  for (const TexturePicture& picture : pictures) bytes.push_back(entries_[number_of(picture)].bytes);
  return bytes;
}

}  // namespace meristem
