// SPDX-License-Identifier: Apache-2.0
// Measures the leaves of a plant: number, areas, and leaf area by height. Organs come in blocks, and each block adds
// the areas of its blades, without the holes of their textures. For leaf area by height, each triangle is cut at the
// borders of the layers in closed form.
#include "meristem/measure/foliage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/masked_surfaces.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerBlock = 1024;
constexpr double kMaxLayers = 100'000;

/// Returns the share of a triangle's area that lies below a height. The heights of the corners must be in ascending
/// order.
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

  void add(const Span& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

constexpr Span kNoSpan{HUGE_VAL, -HUGE_VAL};

/// Returns the lowest and the highest vertex of an organ.
Span heights_of(const Organ& organ, const Mesh& mesh) {
  Span span = kNoSpan;
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

bool is_leaf(const Plant& plant, const Organ& organ) { return is_leaf(plant, plant.prototypes[organ.prototype]); }

namespace {

/// `known` holds the plants that were already checked.
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
  MaskedSurfaces surfaces;
  surfaces.add_new(plant);
  progress.begin("measuring", plant.organs.size());
  return surfaces.areas(plant, progress);
}

FoliageMeasures measure_foliage(const Plant& plant, const SizeLimits& limits, Progress& progress) {
  progress.begin("measuring", totals_of(plant).organs);
  MaskedSurfaces surfaces;
  FoliageMeasures foliage;
  expand_in_blocks(plant, limits, progress, [&](const Plant& block) {
    surfaces.add_new(block);
    const std::vector<OrganArea> areas = surfaces.areas(block, progress);
    for (std::size_t k = 0; k < areas.size(); ++k) {
      if (is_leaf(block, block.organs[k])) foliage.add(areas[k]);
    }
  });
  return foliage;
}

namespace {

/// Returns the heights of the lowest and the highest leaf of a block.
Span heights_of_leaves(const Plant& block, Progress& progress) {
  std::vector<Span> spans((block.organs.size() + kOrgansPerBlock - 1) / kOrgansPerBlock, kNoSpan);
  parallel_for(block.organs.size(), kOrgansPerBlock, [&](std::size_t begin, std::size_t end) {
    Span& span = spans[begin / kOrgansPerBlock];
    for (std::size_t k = begin; k < end; ++k) {
      const Organ& organ = block.organs[k];
      if (is_leaf(block, organ)) span.add(heights_of(organ, *block.prototypes[organ.prototype].mesh));
    }
    progress.advance(end - begin);
  });
  Span all = kNoSpan;
  for (const Span& span : spans) all.add(span);
  return all;
}

/// Returns the layers between two heights, without area.
LeafLayers empty_layers(const Span& heights, double layer_height) {
  LeafLayers layers{layer_height, 0, {}};
  if (!(heights.low <= heights.high)) return layers;
  const double first = std::floor(heights.low / layer_height);
  const double count = std::max(1.0, std::ceil(heights.high / layer_height) - first);
  if (!(count <= kMaxLayers)) {
    throw InputError(Diagnostic{.message = fmt::format("layers {:.6g} m high are too many", layer_height),
                                .expected = fmt::format("at most {:.0f} layers: higher ones", kMaxLayers)});
  }
  layers.first = static_cast<std::int64_t>(first);
  layers.area.assign(static_cast<std::size_t>(count), 0);
  return layers;
}

/// Adds up the leaf area of each layer. Each run of `grain` organs has its own sum, and the sums are added in order.
/// The result therefore depends neither on threads nor on the sizes of blocks.
class LayerSum {
 public:
  /// With many layers the runs are longer, so that the memory of their sums stays small.
  explicit LayerSum(const LeafLayers& empty)
      : empty_(empty), sum_(empty), open_(empty), grain_(std::max(kOrgansPerBlock, empty.area.size())) {}

  void add(const Plant& block, Progress& progress) {
    surfaces_.add_new(block);
    if (block.organs.empty()) return;
    const std::size_t before = organs_ % grain_;  // organs of the open run
    const std::size_t runs = (before + block.organs.size() + grain_ - 1) / grain_;
    std::vector<LeafLayers> sums(runs, empty_);
    std::swap(sums[0], open_);
    parallel_for(runs, 1, [&](std::size_t run, std::size_t) {
      const std::size_t begin = run == 0 ? 0 : run * grain_ - before;
      const std::size_t end = std::min(block.organs.size(), (run + 1) * grain_ - before);
      for (std::size_t k = begin; k < end; ++k) {
        const Organ& organ = block.organs[k];
        if (is_leaf(block, organ)) add_to_layers(organ, surfaces_.of(organ), sums[run]);
      }
      progress.advance(end - begin);
    });
    organs_ += block.organs.size();
    if (organs_ % grain_ == 0) {
      open_ = empty_;
    } else {
      open_ = std::move(sums.back());
      sums.pop_back();
    }
    for (const LeafLayers& one : sums) close(one);
  }

  LeafLayers finish() {
    close(open_);
    return std::move(sum_);
  }

 private:
  void close(const LeafLayers& run) {
    for (std::size_t k = 0; k < sum_.area.size(); ++k) sum_.area[k] += run.area[k];
  }

  const LeafLayers empty_;
  LeafLayers sum_;
  LeafLayers open_;  // the run that the next block continues
  const std::size_t grain_;
  std::size_t organs_ = 0;
  MaskedSurfaces surfaces_;
};

}  // namespace

LeafLayers measure_leaf_layers(const Plant& plant, const SizeLimits& limits, double layer_height, Progress& progress) {
  const std::uint64_t organs = totals_of(plant).organs;
  progress.begin("measuring", organs);
  Span heights = kNoSpan;
  expand_in_blocks(plant, limits, progress,
                   [&](const Plant& block) { heights.add(heights_of_leaves(block, progress)); });
  const LeafLayers empty = empty_layers(heights, layer_height);
  if (empty.area.empty()) return empty;
  progress.begin("measuring", organs);
  LayerSum sum(empty);
  expand_in_blocks(plant, limits, progress, [&](const Plant& block) { sum.add(block, progress); });
  return sum.finish();
}

}  // namespace meristem
