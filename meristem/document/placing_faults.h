// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// What `work` returns; locates what it throws in the document's text.
template <class Work>
auto placing_faults(const Document& document, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    document.source.place(diagnostics);
    throw InputError(std::move(diagnostics));
  }
}

}  // namespace meristem
