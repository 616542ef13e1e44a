// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// Stops the fuzzer if a promise is broken.
inline void require(bool holds) {
  if (!holds) __builtin_trap();
}

/// Requires that every error has a message and the name of this file.
inline void require_errors_of(const InputError& error, std::string_view file) {
  require(!error.diagnostics().empty());
  for (const Diagnostic& found : error.diagnostics()) require(!found.message.empty() && found.file == file);
}

}  // namespace meristem
