// SPDX-License-Identifier: Apache-2.0
// The parameters of self-organizing trees in documents.
#pragma once

#include <optional>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/grow/organize/organize.h"

namespace meristem {

/// The light model of a tree's buds and its space.
struct OrganizeLight {
  BudLightModel model;
  std::optional<CrownParameters> room;  ///< above each root
};

const ParameterTable& organize_growth_table();  ///< table of OrganizeParameters without light, radii and operations
const ParameterTable& organize_light_table();   ///< table of OrganizeLight

}  // namespace meristem
