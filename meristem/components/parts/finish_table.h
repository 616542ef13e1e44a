// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/table.h"

namespace meristem {

/// The parameter table of FinishOptions.
const ParameterTable& finish_table();

}  // namespace meristem
