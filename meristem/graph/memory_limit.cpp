// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/memory_limit.h"

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

// Bytes that a plant may take for each instance of limits.instances
constexpr double kBytesPerInstance = 160;
constexpr double kBytesPerNode = 100;                   // bytes for each node of limits.nodes
constexpr double kBytesInAnyCase = 64.0 * 1024 * 1024;  // bytes that are always allowed, however low both limits are

}  // namespace

void MemoryLimit::add(const std::string& component, const BatchResult& result) {
  const double room = kBytesInAnyCase + kBytesPerInstance * static_cast<double>(limits_.instances) +
                      kBytesPerNode * static_cast<double>(limits_.nodes);
  held_ += static_cast<double>(result.bytes_without_sites());
  if (held_ <= room) return;
  throw InputError(Diagnostic{
      .message =
          fmt::format("with '{}' the instances take {:.2g} bytes of memory, which are too many", component, held_),
      .expected = fmt::format("at most {:.2g}: {:.0f} for each of {} (limits.instances), and {:.0f} for each of {} "
                              "(limits.nodes)",
                              room, kBytesPerInstance, limits_.instances, kBytesPerNode, limits_.nodes),
      .path = "components." + component});
}

}  // namespace meristem
