// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// Stops the fuzzer where a promise is broken.
inline void require(bool holds) {
  if (!holds) __builtin_trap();
}

/// Every fault says what is wrong, and that it is of this file.
inline void require_faults_of(const InputError& error, std::string_view file) {
  require(!error.diagnostics().empty());
  for (const Diagnostic& found : error.diagnostics()) require(!found.message.empty() && found.file == file);
}

}  // namespace meristem
