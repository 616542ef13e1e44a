// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/component.h"
#include "meristem/graph/table/selection.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// How it answers to light, its moves in steps.
struct LightResponseParameters {
  double shift = 0;               ///< movement of the whole cloud in each step, in steps
  std::optional<double> shift_m;  ///< metres, instead of `shift`
  double drift = 0;               ///< movement of a point in the shade in each step, in steps
  LightResponse response;         ///< without both
};

/// A tree that grows into the attraction points of its crown, or several of them.
struct Colonize : GrowingComponent {
  std::optional<CrownParameters> crown;  ///< form of the crown; unset: the points come from a file
  PointsParameters points;               ///< number, distribution or file of the points
  std::vector<Vec3> roots{Vec3(0)};      ///< where the trees stand, in the component's frame
  bool one_crown = false;                ///< one crown over the component's origin instead of one per root
  ColonizeParameters growth;             ///< without its light
  LightResponseParameters light;         ///< response to light
  std::optional<Condition> shed;         ///< branches that are gone when growth is done
  Surface surface;                       ///< surface of the stems
  TrimMode trim = TrimMode::cut;         ///< what a body around its stems does to them
};

/// The type of that name.
ComponentType colonize_component();

}  // namespace meristem
