// SPDX-License-Identifier: Apache-2.0
// Fuzzes documents: all errors must have a place in the text, and valid documents must grow a small plant.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/parallel.h"
#include "meristem/base/progress.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

/// Limits that override the document's, so that one run takes milliseconds.
std::vector<ValueOverride> tight_limits() {
  return {{"limits.points", 500},
          {"limits.nodes", 2000},
          {"limits.instances", 500},
          {"limits.triangles", 20e3},
          {"limits.mesh_bytes", 4'000'000}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const Document document = read_document(text, "fuzz", builtin_components(), {.overrides = tight_limits()});
    const ThreadLimit one_thread(1);
    Progress progress;
    grow_document(document, progress);
  } catch (const InputError& error) {
    require(!error.diagnostics().empty());
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      require(!diagnostic.message.empty() && (diagnostic.file == "fuzz" || diagnostic.file.starts_with("--set ")));
    }
  }
  return 0;
}
