// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The rows of Surface, for every component that makes stems.
const ParameterTable& surface_table();

}  // namespace meristem
