// SPDX-License-Identifier: Apache-2.0
// Transfers the vertices of one blade to another by their uvs. A grid over the picture finds the triangle at each
// position, and vertices are interpolated in this triangle.
#include "meristem/shape/moving/moving_blade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace meristem {

namespace {

constexpr float kCoveredTwice = 1.05F;  // in areas of the box around all positions
constexpr float kFarOff = 0.1F;         // share of the picture's width; positions farther away lie on no triangle
constexpr int kCellsAcross = 16;

float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

/// Returns the number of vertices of the stalk, which are at the front of the list.
std::uint32_t stalk_vertices(const Mesh& mesh) {
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < mesh.stalk_triangles; ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) count = std::max(count, vertex + 1);
  }
  return count;
}

/// The triangles of a blade, found by their positions on its picture.
class PictureMap {
 public:
  explicit PictureMap(const Mesh& mesh) : mesh_(mesh), cells_(kCellsAcross * kCellsAcross) {
    low_ = high_ = mesh.uvs.empty() ? Vec2(0) : mesh.uvs.back();
    for (std::size_t t = mesh.stalk_triangles; t < mesh.triangle_count(); ++t) {
      for (const std::uint32_t vertex : mesh.triangles[t]) {
        low_ = glm::min(low_, mesh.uvs[vertex]);
        high_ = glm::max(high_, mesh.uvs[vertex]);
      }
    }
    for (std::size_t t = mesh.stalk_triangles; t < mesh.triangle_count(); ++t) add(static_cast<std::uint32_t>(t));
  }

  bool covers_places_twice() const {
    const Vec2 size = high_ - low_;
    return covered_ > kCoveredTwice * size.x * size.y;
  }

  /// Returns the triangle at a position, and the weights of its corners. Far from all triangles, a weight is far below
  /// 0.
  std::uint32_t at(Vec2 place, std::array<float, 3>& shares) const {
    std::uint32_t best = 0;
    float min = -std::numeric_limits<float>::infinity();
    const auto look = [&](std::uint32_t triangle) {
      std::array<float, 3> own;
      if (!find_shares(triangle, place, own)) return;
      const float lowest = std::min({own[0], own[1], own[2]});
      if (lowest <= min) return;
      min = lowest;
      best = triangle;
      shares = own;
    };
    for (const std::uint32_t triangle : cells_[cell_of(place)]) look(triangle);
    // On the outline, rounding can put the position outside all triangles of its cell.
    if (min < -1e-4F) {
      for (std::size_t t = mesh_.stalk_triangles; t < mesh_.triangle_count(); ++t) look(static_cast<std::uint32_t>(t));
    }
    return best;
  }

 private:
  void add(std::uint32_t triangle) {
    const auto [a, b, c] = mesh_.triangles[triangle];
    const Vec2 u = mesh_.uvs[a], v = mesh_.uvs[b], w = mesh_.uvs[c];
    covered_ += 0.5F * std::abs(cross(v - u, w - u));
    const auto [first_x, first_y] = cell(glm::min(u, glm::min(v, w)));
    const auto [last_x, last_y] = cell(glm::max(u, glm::max(v, w)));
    for (int y = first_y; y <= last_y; ++y) {
      for (int x = first_x; x <= last_x; ++x)
        cells_[static_cast<std::size_t>(y * kCellsAcross + x)].push_back(triangle);
    }
  }

  std::pair<int, int> cell(Vec2 place) const {
    const Vec2 size = glm::max(high_ - low_, Vec2(1e-6F));
    const Vec2 share = (place - low_) / size * static_cast<float>(kCellsAcross);
    return {std::clamp(static_cast<int>(share.x), 0, kCellsAcross - 1),
            std::clamp(static_cast<int>(share.y), 0, kCellsAcross - 1)};
  }
  std::size_t cell_of(Vec2 place) const {
    const auto [x, y] = cell(place);
    return static_cast<std::size_t>(y * kCellsAcross + x);
  }

  bool find_shares(std::uint32_t triangle, Vec2 place, std::array<float, 3>& shares) const {
    const auto [a, b, c] = mesh_.triangles[triangle];
    const Vec2 u = mesh_.uvs[a];
    const Vec2 to_b = mesh_.uvs[b] - u, to_c = mesh_.uvs[c] - u;
    const float area = cross(to_b, to_c);
    if (std::abs(area) < 1e-9F) return false;
    shares[1] = cross(place - u, to_c) / area;
    shares[2] = cross(to_b, place - u) / area;
    shares[0] = 1 - shares[1] - shares[2];
    return true;
  }

  const Mesh& mesh_;
  Vec2 low_{0}, high_{0};
  float covered_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

bool can_be_read(const Mesh& mesh) {
  return mesh.uvs.size() == mesh.vertex_count() && mesh.normals.size() == mesh.vertex_count() &&
         mesh.triangle_count() > mesh.stalk_triangles;
}

}  // namespace

std::optional<Mesh> as_model_is_cut(const Mesh& blade, const Mesh& model) {
  if (!can_be_read(blade) || !can_be_read(model)) return std::nullopt;
  const std::uint32_t stalk = stalk_vertices(model);
  if (blade.stalk_triangles != model.stalk_triangles || stalk_vertices(blade) != stalk) return std::nullopt;
  const PictureMap map(blade);
  if (map.covers_places_twice() || PictureMap(model).covers_places_twice()) return std::nullopt;
  Mesh made;
  made.positions.assign(blade.positions.begin(), blade.positions.begin() + stalk);
  made.normals.assign(blade.normals.begin(), blade.normals.begin() + stalk);
  for (std::size_t k = stalk; k < model.vertex_count(); ++k) {
    std::array<float, 3> shares{-1, -1, -1};
    const std::uint32_t triangle = map.at(model.uvs[k], shares);
    // The outline of a differently cut blade can lie slightly outside all triangles.
    float sum = 0;
    for (float& share : shares) sum += share = std::max(share, 0.0F);
    if (!(sum > 0)) return std::nullopt;
    Vec2 found(0);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      shares[corner] /= sum;
      found += shares[corner] * blade.uvs[blade.triangles[triangle][corner]];
    }
    if (glm::distance(found, model.uvs[k]) > kFarOff) return std::nullopt;
    Vec3 position(0), normal(0);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = blade.triangles[triangle][corner];
      position += shares[corner] * blade.positions[vertex];
      normal += shares[corner] * blade.normals[vertex];
    }
    const float length = glm::length(normal);
    made.positions.push_back(position);
    made.normals.push_back(length > 1e-6F ? normal / length : model.normals[k]);
  }
  return made;
}

}  // namespace meristem
