// SPDX-License-Identifier: Apache-2.0
// The derived word of a grammar, one page of modules at a time.
#pragma once

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Returns {"text", "steps", "step", "interpreted", "count", "counts", "first", "modules", "places"} as protocol.md
/// defines it, at a time of the document, seconds. Returns {"text": null} if the component has no instance or no
/// grammar. Throws InputError, Cancelled.
Value derivation(const Document& document, const GrammarRequest& request, double time, Progress& progress);

}  // namespace meristem::studio
