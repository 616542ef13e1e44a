// SPDX-License-Identifier: Apache-2.0
// The common parts of components that deform their descendants.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "meristem/base/deform/deformation.h"
#include "meristem/base/deform/function_map.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The target of a deformation, and whether it combines with others.
struct Deforming {
  DeformedPart on = DeformedPart::geometry;
  bool off = false;  ///< true: ends the deformations above; everything stays rigidly in the component's frame
};

/// The parameter table of Deforming.
const ParameterTable& deforming_table();

/// Three functions of a position in the component's own frame. A missing function leaves its coordinate unchanged.
struct SpaceFunctions {
  std::optional<ParameterFormula> dx, dy, dz;

  bool is_empty() const { return !dx && !dy && !dz; }
};

/// The parameter table of SpaceFunctions: expressions over x, y, z, the time and variables of the instance's site.
const ParameterTable& space_functions_table();

/// Returns the map of these functions for the instance at a site.
FunctionMap map_of(const SpaceFunctions& functions, const Site& site, double time);

/// Deforms all descendants of the instance by `map`, given in the instance's frame. Null: adds no deformation.
void deform_below(const Deforming& how, std::shared_ptr<const SpaceMap> map, const Site& site,
                  const InstanceContext& instance, SiteSink& sites);

}  // namespace meristem
