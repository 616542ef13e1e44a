// SPDX-License-Identifier: Apache-2.0
// What components that deform all that hangs on them have in common.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "meristem/base/deform/deformation.h"
#include "meristem/base/deform/function_map.h"
#include "meristem/graph/component.h"

namespace meristem {

/// What a deformation acts on, and whether it acts within others.
struct Deforming {
  DeformedPart on = DeformedPart::geometry;
  bool off = false;  ///< the deformations above end here: all stands rigidly where they take the component
};

/// Rows of Deforming.
const ParameterTable& deforming_table();

/// Three functions of a position in the component's own frame; one that is missing leaves its coordinate.
struct SpaceFunctions {
  std::optional<Formula> dx, dy, dz;

  bool is_empty() const { return !dx && !dy && !dz; }
};

/// Rows of SpaceFunctions: expressions over x y z, the time and what the instance's site tells.
const ParameterTable& space_functions_table();

/// The map of those functions for the instance at a site.
FunctionMap map_of(const SpaceFunctions& functions, const Site& site, double time);

/// Has a map in the instance's frame deform all that hangs on it; null: none of its own.
void deform_below(const Deforming& how, std::shared_ptr<const SpaceMap> map, const Site& site, Emitter& out);

}  // namespace meristem
