// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The rows of PipeModel, for components whose stems get their radii by it.
const ParameterTable& pipe_table();

}  // namespace meristem
