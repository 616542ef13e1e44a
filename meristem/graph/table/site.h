// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/random.h"
#include "meristem/graph/table/surroundings.h"
#include "meristem/plant/planting.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Maximum number of recursions that lie within one another.
inline constexpr std::size_t kMaxRecursionLevels = 4;

/// Stem id of a site that stands on no stem.
inline constexpr std::uint64_t kOnNoStem = 0;

/// The values that the ancestors of an instance give by name: columns of tables, and variables drawn per instance.
struct SiteValues {
  std::uint64_t names = 0;      ///< hash of the names
  std::vector<double> numbers;  ///< in the order of Graph::site_names; NaN if no value was given

  /// Returns a hash of names and numbers.
  std::uint64_t hash() const;
};

/// The clock of an instance, relative to the document's time.
struct InstanceClock {
  double start = 0;       ///< document time at which the clock shows 0, seconds
  double speed = 1;       ///< seconds of this clock per second of the document
  bool is_local = false;  ///< true: begun by a component, and 0 until it starts; false: the document's own clock

  /// Returns the time that the clock shows at a time of the document, seconds.
  double at(double time) const {
    const double shown = (time - start) * speed;
    return is_local && !(shown > 0) ? 0 : shown;
  }
  /// Returns the document's time at which the clock shows `shown`, seconds.
  double when(double shown) const { return start + shown / speed; }
};

/// A site where a child stands, with the properties of the parent and of the child that expressions may use.
struct Site {
  Frame frame;                      ///< world space
  RandomKey key = RandomKey();      ///< key of the instance's path from the root
  std::uint32_t i = 0;              ///< instance number among its siblings
  std::uint32_t n = 1;              ///< number of siblings, itself included
  float u = 0;                      ///< position along the parent's axis, from 0 to 1
  float length = 0;                 ///< length of the parent, metres
  float radius = 0;                 ///< radius of the parent at this site, metres
  float birth = 0;                  ///< growth step at which the site appeared
  std::uint16_t order = 0;          ///< branching order of the axis it stands on
  std::uint16_t depth = 0;          ///< recursion depth
  std::uint64_t stem = kOnNoStem;   ///< id of the stem that it stands on, made of its random key
  NodeIndex node = 0;               ///< node that ends the segment of that stem on which the site stands
  float along = 1;                  ///< position on this segment, as a share of its length
  std::uint64_t section = 0;        ///< id of the section that the parent has added to a surface; 0: no section
  RandomKey surface = RandomKey();  ///< key of that surface
  std::uint64_t individual = 0;     ///< id of the plant that the site belongs to; 0: no plant
  std::uint32_t row = kNoRow;       ///< row, from 0, of the table that placed the site or one of its ancestors
  std::array<std::uint16_t, kMaxRecursionLevels> depths{};  ///< by level of nested recursions
  InstanceClock clock;                                      ///< how time runs for the instance
  double appeared = 0;  ///< time of its clock at which it appeared, seconds; plus infinity if it has not yet appeared
  float part = 1;       ///< size of the last sibling, as a share: a count with a fraction has n - 1 + part siblings
  std::shared_ptr<const SiteValues> values{};          ///< null if no values were given
  std::shared_ptr<const Surroundings> surroundings{};  ///< null if no component has set surroundings
};

/// Returns the directions of light and gravity at a site: from its surroundings, or else from the scene.
inline const Directions& directions_at(const Site& site, const Directions& of_scene) {
  const bool is_said = site.surroundings != nullptr && site.surroundings->directions != nullptr;
  return is_said ? *site.surroundings->directions : of_scene;
}

/// Returns the deformation of the visible geometry of an instance at a site, or null.
inline const std::shared_ptr<const Deformation>& deformation_at(const Site& site) {
  static const std::shared_ptr<const Deformation> nothing;
  return site.surroundings != nullptr ? site.surroundings->deformation : nothing;
}

/// Returns the names that parameters' expressions may use, in the order of `site_variable`: v i n u depth order x y z
/// hx hy hz t length radius.
std::span<const std::string> site_variables();

/// Returns the value of the k-th site variable at a site. `v` is the parameter's own value, `time` the document's time
/// in seconds; the variable t is the time of the site's clock. Indices beyond the last site variable refer to the
/// site's values.
double site_variable(std::size_t k, const Site& site, double v, double time);

}  // namespace meristem
