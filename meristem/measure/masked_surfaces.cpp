// SPDX-License-Identifier: Apache-2.0
// Finds the share of each triangle that is not a hole, once per triangle of a prototype. The triangle is divided into
// equal small triangles about a pixel wide, and the mask is read at their middles. A picture that fills half of its
// rectangle therefore counts half.
#include "meristem/measure/masked_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "meristem/base/parallel.h"
#include "meristem/plant/material.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerTask = 1024;
constexpr int kMinCuts = 4;  // least number of parts into which each side is cut to sample the mask
constexpr int kMaxCuts = 128;

/// Returns the share of a triangle in uv that is not a hole of the mask.
double covered_share(const AlphaMask& mask, const Image& picture, const std::array<Vec2, 3>& uv) {
  const Vec2 pixels(picture.width, picture.height);
  const auto side = [&](int a, int b) { return glm::length((uv[a] - uv[b]) * pixels); };
  const float longest = std::max({side(0, 1), side(1, 2), side(2, 0)});
  const int cuts = std::clamp(static_cast<int>(std::ceil(longest)), kMinCuts, kMaxCuts);
  int holes = 0;
  const auto ask = [&](double b, double c) {
    const auto x = static_cast<float>(b / cuts);
    const auto y = static_cast<float>(c / cuts);
    if (mask.is_hole((1 - x - y) * uv[0] + x * uv[1] + y * uv[2])) ++holes;
  };
  for (int i = 0; i < cuts; ++i) {
    for (int j = 0; i + j < cuts; ++j) {
      ask(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < cuts) ask(i + 2.0 / 3, j + 2.0 / 3);
    }
  }
  return 1 - static_cast<double>(holes) / (double{static_cast<double>(cuts)} * cuts);
}

OrganArea area_in(const Frame& frame, const MaskedSurface& surface) {
  const AreaInFrame areas(frame);
  const std::size_t stalk = surface.mesh->stalk_triangles;
  OrganArea twice;
  for (std::size_t k = 0; k < stalk; ++k) twice.petiole += areas.twice(surface.vectors[k]);
  for (std::size_t k = stalk; k < surface.vectors.size(); ++k) {
    twice.blade += surface.covered[k] * areas.twice(surface.vectors[k]);
  }
  return {twice.blade / 2, twice.petiole / 2};
}

}  // namespace

std::vector<double> MaskedSurfaces::covered(const Mesh& mesh, const Texture* texture) {
  std::vector<double> shares(mesh.triangle_count(), 1);
  if (texture == nullptr) return shares;
  const AlphaMask& mask = masks_.try_emplace(texture, texture->colour).first->second;
  for (std::size_t k = mesh.stalk_triangles; k < shares.size(); ++k) {
    const auto [a, b, c] = mesh.triangles[k];
    const std::array<Vec2, 3> uv = {mesh.uvs[a], mesh.uvs[b], mesh.uvs[c]};
    const Key key{texture, {uv[0].x, uv[0].y, uv[1].x, uv[1].y, uv[2].x, uv[2].y}};
    const auto [known, is_new] = shares_.try_emplace(key, 1);
    if (is_new) known->second = covered_share(mask, texture->colour, uv);
    shares[k] = known->second;
  }
  return shares;
}

void MaskedSurfaces::add_new(const Plant& block) {
  for (std::size_t k = surfaces_.size(); k < block.prototypes.size(); ++k) {
    const OrganPrototype& prototype = block.prototypes[k];
    const Mesh& mesh = *prototype.mesh;
    MaskedSurface& surface = surfaces_.emplace_back();
    surface.mesh = &mesh;
    surface.vectors.reserve(mesh.triangle_count());
    for (const auto& [a, b, c] : mesh.triangles) {
      const DVec3 corner(mesh.positions[a]);
      surface.vectors.push_back(glm::cross(DVec3(mesh.positions[b]) - corner, DVec3(mesh.positions[c]) - corner));
    }
    surface.covered = covered(mesh, texture_with_holes(block.materials[prototype.material], mesh));
  }
}

std::vector<OrganArea> MaskedSurfaces::areas(const Plant& block, Progress& progress) const {
  std::vector<OrganArea> areas(block.organs.size());
  parallel_for(areas.size(), kOrgansPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) areas[k] = area_in(block.organs[k].frame, of(block.organs[k]));
    progress.advance(end - begin);
  });
  return areas;
}

}  // namespace meristem
