// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "meristem/base/deform/deformation.h"

namespace meristem {

/// Hashes of the deformations of a stem's parts. Most parts share one deformation, and each is hashed only once.
class DeformationHashes {
 public:
  /// Returns the hash of a deformation, or 0 for null.
  std::uint64_t of(const std::shared_ptr<const Deformation>& deformation) {
    if (deformation == nullptr) return 0;
    const auto [known, is_new] = hashes_.try_emplace(deformation.get());
    if (is_new) known->second = deformation->hash();
    return known->second;
  }

 private:
  std::unordered_map<const Deformation*, std::uint64_t> hashes_;
};

}  // namespace meristem
