// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/around.h"

#include <algorithm>

namespace meristem {

const ParameterTable& around_table() {
  static const ParameterTable table =
      Table<Around>("children around", "Children in even steps around a heading.")
          .count("number", &Around::number, {.min = 0, .max = 2e9},
                 "Number of children; of 3.4 there are four, and the last has 0.4 of its size.")
          .per_child("angle", &Around::angle, {.unit = Unit::degree, .min = 0, .max = 180},
                     "Angle between the heading and each child: 0 along the heading, 90 straight outward, beyond 90 "
                     "bent back.")
          .per_child("size", &Around::size, {.min = 0, .max = 1000, .usual = {0, 2}}, "Scale of each child.")
          .per_child("roll", &Around::roll, {.unit = Unit::degree, .min = -36000, .max = 36000},
                     "Turn of each child around the heading, in addition to the even spacing.")
          .number("arc", &Around::arc, {.unit = Unit::degree, .min = 0, .max = 360},
                  "Angle around the heading over which the children are spread; below 360 they form a fan.");
  return table;
}

std::vector<ChildAround> children_around(const ComponentMember<Around>& member, SiteSink& sites) {
  const Around& around = member.value();
  const std::uint32_t number = sites.expect_parts(member.part(&Around::number));
  const std::vector<double> angle = sites.per_child(around.angle, number);
  const std::vector<double> size = sites.per_child(around.size, number);
  const std::vector<double> roll = sites.per_child(around.roll, number);
  const bool is_closed = around.arc >= 2 * kPi - 1e-9;
  const double gaps = is_closed ? around.number.value : around.number.value - 1.0;
  // A second child appears beside the first one, and then they move apart evenly.
  const double arc = is_closed ? around.arc : around.arc * std::clamp(gaps, 0.0, 1.0);
  const double first = is_closed ? 0 : -0.5 * arc;
  std::vector<ChildAround> children;
  children.reserve(number);
  for (std::uint32_t k = 0; k < number; ++k) {
    const double turn = first + (gaps > 0 ? arc * k / std::max(gaps, is_closed ? 0.0 : 1.0) : 0.5 * arc);
    children.push_back({roll[k] + turn, angle[k], size[k]});
  }
  return children;
}

MinimumCounts minimum_around(const ComponentMember<Around>& member, const KnownMembers& known) {
  const PerChild& size = member.value().size;
  if (size.varying || known.varies(member.part(&Around::size))) return {};  // sizes may be 0
  return {.children = known.minimum(member.part(&Around::number)), .child_scale = size.plain};
}

Mat3 tilted(double turn, double angle) { return rotation(kUp, turn) * rotation({1, 0, 0}, -angle); }

}  // namespace meristem
