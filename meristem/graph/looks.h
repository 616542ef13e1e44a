// SPDX-License-Identifier: Apache-2.0
// From what a document says of a component's looks to its material, and to what each instance makes of it.
#pragma once

#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/graph/component.h"
#include "meristem/graph/graph.h"

namespace meristem {

/// The material of a component, with a sketch of its texture.
Material material_of(const Prototype& prototype);
/// Paints the textures that materials have as sketches, equal ones once. With a `cache`, those that it has are not
/// painted anew. Throws Cancelled.
void paint_textures(const Graph& graph, std::vector<Material>& materials, Progress& progress, Cache* cache = nullptr);

/// The material of what a component emits as blades.
Material blades_of(const Prototype& prototype);

/// What tells a component's instances apart in colour.
class Tinting {
 public:
  explicit Tinting(const Prototype& prototype);

  /// Linear factors on the material's colour for one instance: its position among the `colours`, and its own shade.
  Vec3 tint(const ComponentBase& instance, RandomKey key) const;

 private:
  std::vector<Vec3> colours_;  // over their mean, linear
  double variety_;
};

}  // namespace meristem
