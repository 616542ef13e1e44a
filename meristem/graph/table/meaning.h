// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Reports those parameters in `value` that nothing gives a meaning, at their names: what stands beside them there and
/// what the struct at `object`, which was read from it, has come to be.
void check_meanings(const ParameterTable& table, const void* object, const Value& value, const DocumentPath& path,
                    ParameterReader& reader);

}  // namespace meristem
