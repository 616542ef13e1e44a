// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/texture/alpha_mask.h"

#include <stdexcept>

#include "meristem/shape/texture/pixel_neighbours.h"

namespace meristem {

AlphaMask::AlphaMask(const Image& image) : width_(image.width), height_(image.height) {
  alpha_.reserve(std::size_t{1} * width_ * height_);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) alpha_.push_back(image.rgba[i]);
}

bool AlphaMask::is_hole(Vec2 uv) const {
  const PixelNeighbours columns(uv.x, width_);
  const PixelNeighbours rows(1 - uv.y, height_);
  const std::uint8_t* upper = alpha_.data() + std::size_t{1} * rows.first * width_;
  const std::uint8_t* lower = alpha_.data() + std::size_t{1} * rows.second * width_;
  const auto along = [&](const std::uint8_t* row) {
    return glm::mix(static_cast<float>(row[columns.first]), static_cast<float>(row[columns.second]), columns.share);
  };
  return glm::mix(along(upper), along(lower), rows.share) < 127.5F;
}

const Texture* texture_with_holes(const Material& material, const Mesh& mesh) {
  const Texture* texture = material.texture.get();
  const bool has_holes = texture != nullptr && texture->masked && !texture->colour.is_empty();
  if (!has_holes || mesh.uvs.empty()) return nullptr;
  if (!texture->is_painted()) throw std::invalid_argument("the texture is a sketch and has no mask yet");
  return texture;
}

}  // namespace meristem
