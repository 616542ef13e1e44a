// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The parameter table of SurfaceOptions, for every component that makes stems.
const ParameterTable& surface_table();

/// Returns the names of TrimMode in the order of the enum, for every component that makes stems.
const std::vector<std::string>& trim_modes();
/// Sentence of the row that chooses a TrimMode.
inline constexpr const char* kTrimDoc =
    "What the body of a 'trim' component above does to the stems: 'cut' ends them flat at its boundary, 'fit' makes "
    "them shorter and thinner so that they end there, 'none' lets them pass.";

/// Returns the row paths of texture parameters that have no effect on stems, such as "texture.picture.repeat_u".
const std::vector<std::string>& names_off_stems();
/// Reason why the names of names_off_stems() mean nothing on stems.
inline constexpr const char* kWhyOffStems = "on stems 'surface.uv_scale' says how large a picture is";

}  // namespace meristem
