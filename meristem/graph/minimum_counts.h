// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "meristem/graph/table/count.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// What each instance of a component has at least, whatever its site, chance and the time are. Smaller numbers are
/// always true; 0 says that nothing is known.
struct MinimumCounts {
  double children = 0;       ///< sites for the children of child links
  double child_scale = 1;    ///< scale of the smallest of these sites, relative to the frame of the instance
  double nodes = 0;          ///< skeleton nodes
  bool bears_along = false;  ///< it has a stem on which a branch link with a `count` has as many children
};

/// Tells which members of a component's parameters are the same for all instances.
class KnownMembers {
 public:
  /// `parameters` is the component's struct, `varyings` are the members that differ. Both must outlive this object.
  KnownMembers(const void* parameters, std::span<const Varying> varyings)
      : parameters_(parameters), varyings_(varyings) {}

  /// True if the member of the struct, or a part of the member, differs from instance to instance.
  template <class Member>
  bool varies(const Member& member) const {
    return find(&member, sizeof(Member)) != nullptr;
  }
  /// Returns the smallest whole number of parts that a count has. Returns 0 if this is not known.
  double minimum(const Count& count) const;

 private:
  const Varying* find(const void* member, std::size_t size) const;

  const void* parameters_;
  std::span<const Varying> varyings_;
};

}  // namespace meristem
