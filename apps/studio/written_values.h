// SPDX-License-Identifier: Apache-2.0
// Converts results of the library to JSON values in the form of protocol.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/document/document.h"
#include "meristem/graph/table/value.h"
#include "named_files.h"
#include "text_units.h"

namespace meristem::studio {

/// Returns faults of a text. `file` is the name of the file that the user knows, instead of its path; empty: the faults
/// keep their own.
Value errors_value(const std::vector<Diagnostic>& errors, std::string_view text, const std::string& file);

Value patch_value(const std::vector<UnitSplice>& splices);

/// Returns the variables of a document as a value.
Value variables_value(const std::vector<Variable>& variables);

/// Returns the names of the files that were copied, for the answer to `save`.
Value copied_value(const NamedFileCopies& copies);
/// Returns the files that were not copied, each with the reason.
Value omitted_value(const NamedFileCopies& copies);

}  // namespace meristem::studio
