// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "meristem/graph/table/count.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// Minimum counts of each instance of a component, for any site, random numbers and time. Smaller numbers are always
/// valid; 0 means unknown.
struct MinimumCounts {
  double children = 0;           ///< sites for the children of child links
  double child_scale = 1;        ///< scale of the smallest of these sites, relative to the frame of the instance
  bool shuns_obstacles = false;  ///< true: it has no sites within obstacles
  std::vector<double> named{};   ///< sites for each component that it places itself (ComponentType::placed); empty:
                                 ///< unknown
  double nodes = 0;              ///< skeleton nodes
  double points = 0;             ///< attraction points that it adds to the stand if there are no obstacles
  bool grows_other = false;      ///< true: each instance is a plant of another document, different from all others
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
  double minimum(const PartCount& count) const { return minimum(find(&count, sizeof(PartCount)), count.value); }
  /// Returns the minimum of a whole number, or 0 if unknown.
  template <class Whole>
  double minimum(const Whole& number) const {
    static_assert(std::is_integral_v<Whole>);
    return minimum(find(&number, sizeof(Whole)), static_cast<double>(number));
  }

 private:
  static double minimum(const Varying* varying, double plain);
  const Varying* find(const void* member, std::size_t size) const;

  const void* parameters_;
  std::span<const Varying> varyings_;
};

}  // namespace meristem
