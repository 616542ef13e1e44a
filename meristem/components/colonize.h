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

/// The response to light; movements are in steps.
struct LightResponseParameters {
  double shift = 0;               ///< movement of the whole cloud in each step, in steps
  std::optional<double> shift_m;  ///< metres; replaces `shift`
  double drift = 0;               ///< movement of a point in the shade in each step, in steps
  double field = 0;               ///< movement of a point along a field of strength 1 in each step, in steps
  LightResponse response;         ///< all other parameters of the response
};

/// One or several trees that grow into the attraction points of their crowns.
struct Colonize : GrowingComponent {
  std::optional<CrownParameters> crown;  ///< form of the crown; unset: the points come from a file
  PointsParameters points;               ///< number, distribution or file of the points
  std::vector<Vec3> roots{Vec3(0)};      ///< positions of the trees, in the component's frame
  bool one_crown = false;                ///< true: one crown above the component's origin; false: one crown per root
  ColonizeParameters growth;             ///< growth parameters except the light response
  LightResponseParameters light;         ///< response to light
  std::optional<SiteCondition> shed;     ///< branches that are removed after growth
  SurfaceOptions surface;                ///< surface of the stems
  TrimMode trim = TrimMode::cut;         ///< effect of a body around its stems
};

/// Returns the component type `colonize`.
ComponentType colonize_component();

}  // namespace meristem
