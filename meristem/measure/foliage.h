// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// What of an organ's surface is there.
struct OrganArea {
  double blade = 0;    ///< square metres of the organ's triangles outside its texture's holes; one side of blades
  double petiole = 0;  ///< square metres of its petiole's triangles
};

/// The leaves of a plant. A leaf is an organ with a two-sided material: a blade without thickness, such as the
/// component `leaf` makes. Petals from this component count as leaves. Closed organs such as fruits do not.
struct Foliage {
  std::uint64_t leaves = 0;  ///< number of leaves
  double area = 0;           ///< square metres of blades, one side, without the holes of their textures
  double petiole_area = 0;   ///< square metres of their petioles' surface

  /// One more leaf.
  void add(const OrganArea& leaf) {
    ++leaves;
    area += leaf.blade;
    petiole_area += leaf.petiole;
  }
};

/// Leaf area by height, in layers of equal height that count from y = 0.
struct LeafLayers {
  double height = 0;         ///< metres, of each layer
  std::int64_t first = 0;    ///< number of the lowest layer, which begins at `first` times `height`
  std::vector<double> area;  ///< square metres of leaf blades in each, from below; empty without leaves

  /// Returns the lower border of a layer, metres.
  double low(std::size_t layer) const { return height * static_cast<double>(first + static_cast<std::int64_t>(layer)); }
  /// Returns the upper border of a layer, metres.
  double high(std::size_t layer) const { return low(layer + 1); }
};

/// Returns true if organs of this prototype are leaves.
bool is_leaf(const Plant& plant, const OrganPrototype& prototype);
/// Returns true if an organ of the plant is a leaf.
bool is_leaf(const Plant& plant, const Organ& organ);

/// Whether textures of the plant, or of plants placed in it, cut holes: then they must be painted before leaves are
/// measured and rays are asked.
bool has_holes(const Plant& plant);

/// The areas of each organ. Begins one stage of `progress`, which counts organs. The numbers are equal on any number
/// of threads. Throws std::invalid_argument where a texture with holes is a sketch.
std::vector<OrganArea> organ_areas(const Plant& plant, Progress& progress);

/// Begins one stage of `progress`, which counts organs. The sums are equal on any number of threads. Throws as
/// organ_areas.
Foliage measure_foliage(const Plant& plant, const Limits& limits, Progress& progress);

/// Leaf area in layers of this height in metres, counted from 0: triangles are cut at the borders of the layers, and
/// the holes of a triangle count evenly. The sum is Foliage::area. Begins two stages of `progress`, which count organs.
/// The areas are equal on any number of threads. Throws as organ_areas, and InputError for more than 100,000 layers.
LeafLayers measure_leaf_layers(const Plant& plant, const Limits& limits, double layer_height, Progress& progress);

}  // namespace meristem
