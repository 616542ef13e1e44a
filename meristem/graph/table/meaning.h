// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Reports parameters in `value` that have no effect, at their names. Whether a parameter has an effect depends on the
/// parameters beside it and on `object`, the struct that was read from `value`.
void check_meanings(const ParameterTable& table, const void* object, const Value& value, const DocumentPath& path,
                    ParameterReader& reader);

}  // namespace meristem
