// SPDX-License-Identifier: Apache-2.0
// Areas of organs. The share of a triangle that a texture's mask covers is found once per triangle of a prototype, at
// the middles of equal small triangles about a pixel wide: a picture that fills half of its rectangle counts half.
#include "meristem/measure/foliage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/texture/alpha_mask.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerBlock = 1024;
constexpr int kLeastCuts = 4;  // of a triangle's sides, to ask a mask
constexpr int kMostCuts = 128;
constexpr double kMostLayers = 100'000;

/// Which share of a triangle in uv a mask covers.
double covered_share(const AlphaMask& mask, const Image& picture, const std::array<Vec2, 3>& uv) {
  const Vec2 pixels(picture.width, picture.height);
  const auto side = [&](int a, int b) { return glm::length((uv[a] - uv[b]) * pixels); };
  const float longest = std::max({side(0, 1), side(1, 2), side(2, 0)});
  const int cuts = std::clamp(static_cast<int>(std::ceil(longest)), kLeastCuts, kMostCuts);
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

/// The shares of a mesh's triangles that a texture's mask covers, which meshes with the same uvs have in common.
class Masks {
 public:
  std::vector<double> covered(const Mesh& mesh, const Texture* texture) {
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

 private:
  using Key = std::pair<const Texture*, std::array<float, 6>>;
  std::map<const Texture*, AlphaMask> masks_;
  std::map<Key, double> shares_;
};

/// What the organs of a prototype have in common.
struct MaskedSurface {
  const Mesh* mesh = nullptr;
  std::vector<DVec3> vectors;   // twice the area vector of each triangle, in its own frame
  std::vector<double> covered;  // share of each triangle
};

std::vector<MaskedSurface> surfaces_of(const Plant& plant) {
  Masks masks;
  std::vector<MaskedSurface> surfaces;
  for (const OrganPrototype& prototype : plant.prototypes) {
    const Mesh& mesh = *prototype.mesh;
    MaskedSurface& surface = surfaces.emplace_back();
    surface.mesh = &mesh;
    surface.vectors.reserve(mesh.triangle_count());
    for (const auto& [a, b, c] : mesh.triangles) {
      const DVec3 corner(mesh.positions[a]);
      surface.vectors.push_back(glm::cross(DVec3(mesh.positions[b]) - corner, DVec3(mesh.positions[c]) - corner));
    }
    surface.covered = masks.covered(mesh, texture_with_holes(plant.materials[prototype.material], mesh));
  }
  return surfaces;
}

/// Areas of triangles under a frame: area vectors turn and scale by the cofactors of its axes.
class AreaInFrame {
 public:
  explicit AreaInFrame(const Frame& frame) {
    const DVec3 x(frame.axes[0]);
    const DVec3 y(frame.axes[1]);
    const DVec3 z(frame.axes[2]);
    yz_ = glm::cross(y, z);
    zx_ = glm::cross(z, x);
    xy_ = glm::cross(x, y);
  }
  double twice(const DVec3& vector) const { return glm::length(vector.x * yz_ + vector.y * zx_ + vector.z * xy_); }

 private:
  DVec3 yz_, zx_, xy_;
};

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

/// The share of a triangle's area that lies below a height; its corners' heights rise.
double share_below(double height, const std::array<double, 3>& corners) {
  const auto [low, middle, high] = corners;
  if (height <= low) return 0;
  if (height >= high) return 1;
  if (height < middle) return (height - low) * (height - low) / ((middle - low) * (high - low));
  return 1 - (high - height) * (high - height) / ((high - middle) * (high - low));
}

struct Span {
  double low = 0;
  double high = 0;
};

/// From the lowest to the highest vertex of an organ.
Span heights_of(const Organ& organ, const Mesh& mesh) {
  Span span{HUGE_VAL, -HUGE_VAL};
  for (const Vec3 position : mesh.positions) {
    const double y = organ.frame.point(position).y;
    span.low = std::min(span.low, y);
    span.high = std::max(span.high, y);
  }
  return span;
}

/// Adds an organ's blade to the layers.
void add_to_layers(const Organ& organ, const MaskedSurface& surface, LeafLayers& layers) {
  const AreaInFrame areas(organ.frame);
  const Mesh& mesh = *surface.mesh;
  const auto layer_of = [&](double y) {
    const auto layer = static_cast<std::int64_t>(std::floor(y / layers.height)) - layers.first;
    return std::clamp<std::int64_t>(layer, 0, static_cast<std::int64_t>(layers.area.size()) - 1);
  };
  for (std::size_t k = mesh.stalk_triangles; k < mesh.triangle_count(); ++k) {
    const double area = surface.covered[k] * areas.twice(surface.vectors[k]) / 2;
    std::array<double, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = organ.frame.point(mesh.positions[mesh.triangles[k][i]]).y;
    std::sort(corners.begin(), corners.end());
    const std::int64_t first = layer_of(corners[0]);
    const std::int64_t last = layer_of(corners[2]);
    double below = 0;
    for (std::int64_t layer = first; layer < last; ++layer) {
      const double reached = share_below(layers.high(static_cast<std::size_t>(layer)), corners);
      layers.area[static_cast<std::size_t>(layer)] += area * (reached - below);
      below = reached;
    }
    layers.area[static_cast<std::size_t>(last)] += area * (1 - below);
  }
}

}  // namespace

bool is_leaf(const Plant& plant, const OrganPrototype& prototype) {
  return plant.materials[prototype.material].two_sided;
}

namespace {

/// `known` holds the plants that have been looked at.
bool has_holes(const Plant& plant, std::unordered_set<const Plant*>& known) {
  const bool has_own = std::any_of(plant.materials.begin(), plant.materials.end(), [](const Material& material) {
    return material.texture != nullptr && material.texture->masked && !material.texture->colour.is_empty();
  });
  return has_own || std::any_of(plant.plantings.begin(), plant.plantings.end(), [&known](const Planting& planting) {
           const Plant* placed = planting.variant->plant.get();
           return known.insert(placed).second && has_holes(*placed, known);
         });
}

}  // namespace

bool has_holes(const Plant& plant) {
  std::unordered_set<const Plant*> known;
  return has_holes(plant, known);
}

std::vector<OrganArea> organ_areas(const Plant& plant, Progress& progress) {
  const std::vector<MaskedSurface> surfaces = surfaces_of(plant);
  progress.begin("measuring", plant.organs.size());
  std::vector<OrganArea> areas(plant.organs.size());
  parallel_for(areas.size(), kOrgansPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      areas[k] = area_in(plant.organs[k].frame, surfaces[plant.organs[k].prototype]);
    }
    progress.advance(end - begin);
  });
  return areas;
}

Foliage measure_foliage(const Plant& grown, const Limits& limits, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  const Plant& plant = *expanded;
  const std::vector<OrganArea> areas = organ_areas(plant, progress);
  Foliage foliage;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (is_leaf(plant, plant.prototypes[plant.organs[k].prototype])) foliage.add(areas[k]);
  }
  return foliage;
}

LeafLayers measure_leaf_layers(const Plant& grown, const Limits& limits, double layer_height, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  const Plant& plant = *expanded;
  const std::vector<MaskedSurface> surfaces = surfaces_of(plant);
  const auto leaf = [&](std::size_t k) { return is_leaf(plant, plant.prototypes[plant.organs[k].prototype]); };
  const std::size_t blocks = (plant.organs.size() + kOrgansPerBlock - 1) / kOrgansPerBlock;

  // How far the leaves reach.
  progress.begin("measuring", plant.organs.size());
  std::vector<Span> spans(blocks, Span{HUGE_VAL, -HUGE_VAL});
  parallel_for(plant.organs.size(), kOrgansPerBlock, [&](std::size_t begin, std::size_t end) {
    Span& span = spans[begin / kOrgansPerBlock];
    for (std::size_t k = begin; k < end; ++k) {
      if (!leaf(k)) continue;
      const Span one = heights_of(plant.organs[k], *surfaces[plant.organs[k].prototype].mesh);
      span = {std::min(span.low, one.low), std::max(span.high, one.high)};
    }
    progress.advance(end - begin);
  });
  Span all{HUGE_VAL, -HUGE_VAL};
  for (const Span& span : spans) all = {std::min(all.low, span.low), std::max(all.high, span.high)};
  LeafLayers layers{layer_height, 0, {}};
  if (!(all.low <= all.high)) return layers;
  const double first = std::floor(all.low / layer_height);
  const double count = std::max(1.0, std::ceil(all.high / layer_height) - first);
  if (!(count <= kMostLayers)) {
    throw InputError(Diagnostic{.message = fmt::format("layers {:.6g} m high are too many", layer_height),
                                .expected = fmt::format("at most {:.0f} layers: higher ones", kMostLayers)});
  }
  layers.first = static_cast<std::int64_t>(first);
  layers.area.assign(static_cast<std::size_t>(count), 0);

  // Larger blocks where there are many layers, so that their sums stay small.
  const std::size_t grain = std::max(kOrgansPerBlock, layers.area.size());
  std::vector<LeafLayers> parts((plant.organs.size() + grain - 1) / grain, layers);
  progress.begin("measuring", plant.organs.size());
  parallel_for(plant.organs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (leaf(k)) add_to_layers(plant.organs[k], surfaces[plant.organs[k].prototype], parts[begin / grain]);
    }
    progress.advance(end - begin);
  });
  for (const LeafLayers& part : parts) {
    for (std::size_t k = 0; k < layers.area.size(); ++k) layers.area[k] += part.area[k];
  }
  return layers;
}

}  // namespace meristem
