// SPDX-License-Identifier: Apache-2.0
// What a grammar derives, told a page at a time.
#pragma once

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// {"text", "steps", "step", "interpreted", "count", "counts", "first", "modules", "places"} as protocol.md says, at a
/// time of the document in seconds; {"text": null} where the component has no instance or no grammar. Throws
/// InputError, Cancelled.
Value derivation(const Document& document, const GrammarRequest& request, double time, Progress& progress);

}  // namespace meristem::studio
