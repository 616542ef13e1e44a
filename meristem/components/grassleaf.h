// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/grassleaf_table.h"
#include "meristem/graph/component.h"

namespace meristem {

ComponentType grassleaf_component();

}  // namespace meristem
