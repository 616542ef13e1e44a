// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/parameter.h"
#include "meristem/grow/colonize/light_response.h"

namespace meristem {

const ParameterTable& limit_table();  ///< table of LightLimit

}  // namespace meristem
