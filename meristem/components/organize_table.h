// SPDX-License-Identifier: Apache-2.0
// The parameters of self-organizing trees as documents write them.
#pragma once

#include <string_view>

#include "meristem/graph/parameter.h"

namespace meristem {

const ParameterTable& organize_growth_table();  ///< of OrganizeParameters, without light, radii and cuts
const ParameterTable& organize_light_table();   ///< of OrganizeLight
const ParameterTable& operation_table();        ///< of Operation

/// Whether a text has the form of a shoot's name: `main`, `main.4.2`.
bool is_shoot_name(std::string_view text);

}  // namespace meristem
