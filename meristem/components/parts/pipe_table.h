// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The parameter table of PipeModel, for components that use the pipe model.
const ParameterTable& pipe_table();

}  // namespace meristem
