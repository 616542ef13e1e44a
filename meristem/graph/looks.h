// SPDX-License-Identifier: Apache-2.0
// Makes a component's material from the looks that the document gives, and the tint of each instance.
#pragma once

#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/graph/component.h"
#include "meristem/graph/graph.h"

namespace meristem {

/// Returns the material of a component, with a sketch of its texture.
Material material_of(const Prototype& prototype);
/// Paints the textures of materials that are sketches, equal ones once. With a `cache`, textures that it has are
/// reused. Throws Cancelled.
void paint_textures(const Graph& graph, std::vector<Material>& materials, Progress& progress, Cache* cache = nullptr);

/// Returns the material of what a component emits as blades.
Material blades_of(const Prototype& prototype);

/// Computes the differences in colour between a component's instances.
class Tinting {
 public:
  explicit Tinting(const Prototype& prototype);

  /// Returns linear factors on the material's colour for one instance: its position among the `colours` and its own
  /// shade.
  Vec3 tint(const ComponentBase& instance, RandomKey key) const;

 private:
  std::vector<Vec3> colours_;  // linear, divided by their mean
  double variety_;
};

}  // namespace meristem
