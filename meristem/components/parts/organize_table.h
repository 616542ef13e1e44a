// SPDX-License-Identifier: Apache-2.0
// The parameters of self-organizing trees as documents write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/table/kinds.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/grow/organize/organize.h"

namespace meristem {

/// Where the buds of a tree get their light, as documents write it.
struct OrganizeLight {
  BudLightModel model;
  std::optional<CrownParameters> room;  ///< of markers, over each root
};

const ParameterTable& organize_growth_table();  ///< of OrganizeParameters, without light, radii and operations
const ParameterTable& organize_light_table();   ///< of OrganizeLight
const ParameterTable& operation_table();        ///< of every kind of Operation
const Kinds& operation_kinds();                 ///< of the alternatives of Operation

/// Whether a text has the form of a shoot's name: `main`, `main.4.2`.
bool is_shoot_name(std::string_view text);

}  // namespace meristem
