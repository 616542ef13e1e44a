// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// The visible area of an organ's surface.
struct OrganArea {
  double blade = 0;    ///< square metres of the organ's triangles outside the holes of its texture; one side of blades
  double petiole = 0;  ///< square metres of the triangles of its petiole
};

/// The leaves of a plant. A leaf is an organ with a two-sided material: a blade without thickness, such as the
/// component `leaf` makes. Petals from this component count as leaves. Closed organs such as fruits do not.
struct FoliageMeasures {
  std::uint64_t leaves = 0;  ///< number of leaves
  double area = 0;           ///< square metres of blades, one side, without the holes of their textures
  double petiole_area = 0;   ///< surface of their petioles, square metres

  /// Adds one leaf.
  void add(const OrganArea& leaf) {
    ++leaves;
    area += leaf.blade;
    petiole_area += leaf.petiole;
  }
};

/// Leaf area by height, in layers of equal height that are counted from y = 0.
struct LeafLayers {
  double height = 0;         ///< height of each layer, metres
  std::int64_t first = 0;    ///< number of the lowest layer, which begins at `first` times `height`
  std::vector<double> area;  ///< leaf blades in each layer, square metres, from below; empty without leaves

  /// Returns the lower border of a layer, metres.
  double low(std::size_t layer) const { return height * static_cast<double>(first + static_cast<std::int64_t>(layer)); }
  /// Returns the upper border of a layer, metres.
  double high(std::size_t layer) const { return low(layer + 1); }
};

/// Returns true if organs of this prototype are leaves.
bool is_leaf(const Plant& plant, const OrganPrototype& prototype);
/// Returns true if an organ of the plant is a leaf.
bool is_leaf(const Plant& plant, const Organ& organ);

/// Returns true if textures of the plant, or of plants placed in it, cut holes. These textures must be painted before
/// leaves are measured and before rays are traced.
bool has_holes(const Plant& plant);

/// Returns the areas of each organ. Begins one stage of `progress`, which counts organs. The areas are equal on any
/// number of threads. Throws std::invalid_argument if a texture with holes is a sketch.
std::vector<OrganArea> organ_areas(const Plant& plant, Progress& progress);

/// Adds up the leaves of a plant. Begins one stage of `progress`, which counts organs. The sums are equal on any number
/// of threads. Throws like organ_areas.
FoliageMeasures measure_foliage(const Plant& plant, const SizeLimits& limits, Progress& progress);

/// Returns the leaf area in layers of height `layer_height` in metres, counted from y = 0. Triangles are cut at the
/// borders of the layers, and the holes of a triangle are spread evenly over it. The layers add up to
/// FoliageMeasures::area. Begins two stages of `progress`, which count organs. The areas are equal on any number of
/// threads. Throws like organ_areas, and InputError for more than 100,000 layers.
LeafLayers measure_leaf_layers(const Plant& plant, const SizeLimits& limits, double layer_height, Progress& progress);

}  // namespace meristem
