// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// Returns the result of `work`. Sets the position, in the document's text, of errors that `work` throws.
template <class Work>
auto placing_errors(const Document& document, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    document.source.place(diagnostics);
    throw InputError(std::move(diagnostics));
  }
}

}  // namespace meristem
