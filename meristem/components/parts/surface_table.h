// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The rows of Surface, for every component that makes stems.
const ParameterTable& surface_table();

/// What of a texture means nothing on stems, and why.
const std::vector<std::string>& names_off_stems();
inline constexpr const char* kWhyOffStems = "on stems 'surface.uv_scale' says how large a picture is";

}  // namespace meristem
