// SPDX-License-Identifier: Apache-2.0
// What the library says, as protocol.md writes it in JSON.
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

/// Faults of a text; `file` is its name as the user knows it, in place of its path; empty: as they say.
Value faults_value(const std::vector<Diagnostic>& faults, std::string_view text, const std::string& file);

Value patch_value(const std::vector<UnitSplice>& splices);

/// The variables of a document as a value.
Value variables_value(const std::vector<Variable>& variables);

/// The names of the files that were copied, as `save` answers them.
Value copied_value(const NamedFileCopies& copies);
/// The files that were not copied, each with the reason.
Value omitted_value(const NamedFileCopies& copies);

}  // namespace meristem::studio
