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

/// How many recursions may lie within one another.
inline constexpr std::size_t kMaxRecursionLevels = 4;

/// In place of a stem's id.
inline constexpr std::uint64_t kOnNoStem = 0;

/// What the ancestors of an instance have given it by name: columns of tables, variables drawn per instance.
struct SiteValues {
  std::uint64_t names = 0;      ///< hash of the names
  std::vector<double> numbers;  ///< in the order of Graph::site_names; NaN where nothing has been given

  /// Hash of names and numbers.
  std::uint64_t hash() const;
};

/// How the time of an instance runs by that of the document.
struct Clock {
  double start = 0;       ///< the document's time at which it shows 0, seconds
  double speed = 1;       ///< its seconds per second of the document
  bool is_local = false;  ///< begun by a component: it shows 0 until it starts; else it is the document's own

  /// What it shows at a time of the document.
  double at(double time) const {
    const double shown = (time - start) * speed;
    return is_local && !(shown > 0) ? 0 : shown;
  }
  /// The document's time at which it shows a time.
  double when(double shown) const { return start + shown / speed; }
};

/// A site where a child stands: what the child can see of its parent and of itself.
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
  NodeIndex node = 0;               ///< on the segment of that stem that ends in this node
  float along = 1;                  ///< at this share of it
  std::uint64_t section = 0;        ///< id of the section that the parent has given to a surface; 0: it gave none
  RandomKey surface = RandomKey();  ///< key of that surface
  std::uint64_t individual = 0;     ///< id of the plant that the site is part of; 0: of none
  std::uint32_t row = kNoRow;       ///< row, from 0, of the table that placed the site or one of its ancestors
  std::array<std::uint16_t, kMaxRecursionLevels> depths{};  ///< by level of nested recursions
  Clock clock;                                              ///< how time runs for the instance
  double appeared = 0;  ///< when it came to be, by its clock, seconds; plus infinity where it has not yet
  float part = 1;       ///< n - 1 + part siblings have come to be, of a count that has a fraction
  std::shared_ptr<const SiteValues> values{};          ///< null where nothing has been given
  std::shared_ptr<const Surroundings> surroundings{};  ///< null where nothing has been said of them
};

/// The directions of light and gravity at a site: those that its surroundings say, or else the scene's.
inline const Directions& directions_at(const Site& site, const Directions& of_scene) {
  const bool is_said = site.surroundings != nullptr && site.surroundings->directions != nullptr;
  return is_said ? *site.surroundings->directions : of_scene;
}

/// What deforms what is seen of an instance at a site; null: nothing.
inline const std::shared_ptr<const Deformation>& deformation_at(const Site& site) {
  static const std::shared_ptr<const Deformation> nothing;
  return site.surroundings != nullptr ? site.surroundings->deformation : nothing;
}

/// Names that parameters' expressions may use, in the order in which `site_variable` gives their values:
/// v i n u depth order x y z hx hy hz t length radius.
std::span<const std::string> site_variables();

/// The value of the k-th of them at a site; `v` is the parameter's own value and `time` the document's time in seconds,
/// of which t is what the site's clock shows.
/// Beyond the last of them, those of the site's values follow.
double site_variable(std::size_t k, const Site& site, double v, double time);

}  // namespace meristem
