// SPDX-License-Identifier: Apache-2.0
// From what a document says of a component's looks to its material, and to what each instance makes of it.
#pragma once

#include "meristem/base/random.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The material of a component, with its texture.
Material material_of(const Prototype& prototype);

/// That of what it emits as blades.
Material blades_of(const Prototype& prototype);

/// What tells a component's instances apart in colour.
class Tinting {
 public:
  explicit Tinting(const Prototype& prototype);

  /// Linear factors on the material's colour for one instance: its place among the `colours`, and its own shade.
  Vec3 tint(const ComponentBase& instance, RandomKey key) const;

 private:
  std::vector<Vec3> colours_;  // over their mean, linear
  double variety_;
};

}  // namespace meristem
