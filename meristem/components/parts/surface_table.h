// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The parameter table of SurfaceOptions, for every component that makes stems.
const ParameterTable& surface_table();

/// The names of TrimMode and the description of its parameter, for every component that makes stems.
const std::vector<std::string>& trim_modes();
/// Sentence of the row that chooses a TrimMode.
inline constexpr const char* kTrimDoc =
    "What the body of a 'trim' component above does to the stems: 'cut' ends them flat at its boundary, 'fit' tapers "
    "them to an end there, 'none' lets them pass.";

/// The parameters of a texture that have no effect on stems, and the reason.
const std::vector<std::string>& names_off_stems();
/// Reason why the names of names_off_stems() mean nothing on stems.
inline constexpr const char* kWhyOffStems = "on stems 'surface.uv_scale' says how large a picture is";

}  // namespace meristem
