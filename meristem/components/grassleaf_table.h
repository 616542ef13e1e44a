// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/grassleaf.h"

namespace meristem {

/// All rows of a grass leaf, in the order of its stages.
Table<Grassleaf> grassleaf_table();

}  // namespace meristem
