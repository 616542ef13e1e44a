// SPDX-License-Identifier: Apache-2.0
// The parameters of self-organizing trees as documents write them.
#pragma once

#include <optional>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/grow/organize/organize.h"

namespace meristem {

/// Where the buds of a tree get their light, as documents write it.
struct OrganizeLight {
  BudLightModel model;
  std::optional<CrownParameters> room;  ///< over each root
};

const ParameterTable& organize_growth_table();  ///< of OrganizeParameters, without light, radii and operations
const ParameterTable& organize_light_table();   ///< of OrganizeLight

}  // namespace meristem
