// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "meristem/graph/table/count.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// Minimum counts of each instance of a component, for any site, random numbers and time. Smaller numbers are always
/// valid; 0 means unknown.
struct MinimumCounts {
  double children = 0;       ///< sites for the children of child links
  double child_scale = 1;    ///< scale of the smallest of these sites, relative to the frame of the instance
  double nodes = 0;          ///< skeleton nodes
  bool bears_along = false;  ///< true: it has a stem on which a branch link with a `count` places that many children
};

/// Distinguishes members of a component's parameters that are equal for all instances from members that vary.
class KnownMembers {
 public:
  /// `parameters` is the component's struct, `varyings` are the members that differ. Both must outlive this object.
  KnownMembers(const void* parameters, std::span<const Varying> varyings)
      : parameters_(parameters), varyings_(varyings) {}

  /// Returns true if the member of the struct, or a part of it, differs from instance to instance.
  template <class Member>
  bool varies(const Member& member) const {
    return find(&member, sizeof(Member)) != nullptr;
  }
  /// Returns the minimum number of parts of a count, or 0 if unknown.
  double minimum(const Count& count) const;

 private:
  const Varying* find(const void* member, std::size_t size) const;

  const void* parameters_;
  std::span<const Varying> varyings_;
};

}  // namespace meristem
