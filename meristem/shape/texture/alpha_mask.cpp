// SPDX-License-Identifier: Apache-2.0
// Answers whether a uv lies in a hole. Each block of pixels is classified once as solid, hole or edge, so that only
// edge blocks need a lookup of pixels.
#include "meristem/shape/texture/alpha_mask.h"

#include <algorithm>
#include <stdexcept>

namespace meristem {

namespace {

constexpr int kBlockBits = 3;

}  // namespace

AlphaMask::AlphaMask(const Image& image)
    : width_(image.width), height_(image.height), blocks_across_(((image.width - 1) >> kBlockBits) + 1) {
  alpha_.reserve(std::size_t{1} * width_ * height_);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) alpha_.push_back(image.rgba[i]);
  const int blocks_down = ((height_ - 1) >> kBlockBits) + 1;
  blocks_.reserve(std::size_t{1} * blocks_across_ * blocks_down);
  for (int row = 0; row < blocks_down; ++row) {
    for (int column = 0; column < blocks_across_; ++column) blocks_.push_back(block_at(column, row));
  }
}

/// Returns the state of all positions whose first pixels lie in a block. Their other pixels can lie one pixel beyond
/// the block.
AlphaMask::Block AlphaMask::block_at(int column, int row) const {
  constexpr int kSize = 1 << kBlockBits;
  bool has_solid = false;
  bool has_hole = false;
  for (int y = row * kSize; y <= std::min((row + 1) * kSize, height_); ++y) {
    for (int x = column * kSize; x <= std::min((column + 1) * kSize, width_); ++x) {
      const bool is_solid = alpha_[std::size_t{1} * (y % height_) * width_ + x % width_] >= 128;
      (is_solid ? has_solid : has_hole) = true;
    }
  }
  return has_solid && has_hole ? Block::edge : has_hole ? Block::hole : Block::solid;
}

bool AlphaMask::is_hole(Vec2 uv) const {
  const PixelNeighbours columns(uv.x, width_);
  const PixelNeighbours rows(1 - uv.y, height_);
  const Block block =
      blocks_[std::size_t{1} * (rows.first >> kBlockBits) * blocks_across_ + (columns.first >> kBlockBits)];
  return block == Block::edge ? is_hole_at(columns, rows) : block == Block::hole;
}

bool AlphaMask::is_hole_at(const PixelNeighbours& columns, const PixelNeighbours& rows) const {
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
