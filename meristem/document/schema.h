// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Returns the JSON Schema (draft 7) of plant documents, made from the tables of `registry` and of the document.
Value document_schema(const Registry& registry);

}  // namespace meristem
