// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/graph/batch.h"

namespace meristem {

/// Limits the memory that the results of an expansion take, in proportion to limits.instances and limits.nodes.
class MemoryLimit {
 public:
  explicit MemoryLimit(const SizeLimits& limits) : limits_(limits) {}

  /// Adds a result of a component, without its sites for children. Throws InputError with the component's id if all
  /// results together take too much memory.
  void add(const std::string& component, const BatchResult& result);

 private:
  const SizeLimits& limits_;
  double held_ = 0;  // bytes
};

}  // namespace meristem
