// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "meristem/graph/component_member.h"
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
  /// `varyings` are the members that differ. They must outlive this object.
  explicit KnownMembers(std::span<const Varying> varyings) : varyings_(varyings) {}

  /// Returns true if the member, or a part of it, differs from instance to instance.
  template <class M>
  bool varies(const ComponentMember<M>& member) const {
    return find(member) != nullptr;
  }
  /// Returns the minimum number of parts of a count, or 0 if unknown.
  double minimum(const ComponentMember<PartCount>& count) const { return minimum_of(find(count), count.value().value); }
  /// Returns the minimum of a whole number, or 0 if unknown.
  template <std::integral Whole>
  double minimum(const ComponentMember<Whole>& number) const {
    return minimum_of(find(number), static_cast<double>(number.value()));
  }

 private:
  static double minimum_of(const Varying* varying, double plain);
  /// Returns the first number that varies within the member, or null.
  template <class M>
  const Varying* find(const ComponentMember<M>& member) const {
    const auto is_inside = [&](const Varying& varying) { return member.contains(varying.offset_in_struct()); };
    const auto found = std::ranges::find_if(varyings_, is_inside);
    return found == varyings_.end() ? nullptr : &*found;
  }

  std::span<const Varying> varyings_;
};

}  // namespace meristem
