// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meristem {

/// The bytes of the meshes of each component, and their sum.
class MeshBytes {
 public:
  explicit MeshBytes(std::size_t components) : of_(components) {}

  void set(std::size_t component, std::uint64_t bytes) {
    sum_ += bytes - of_[component];
    of_[component] = bytes;
  }
  std::uint64_t sum() const { return sum_; }
  std::uint64_t sum_without(std::size_t component) const { return sum_ - of_[component]; }

 private:
  std::vector<std::uint64_t> of_;  // by component
  std::uint64_t sum_ = 0;
};

}  // namespace meristem
