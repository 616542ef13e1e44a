// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/phiball.h"

#include <cmath>

#include <fmt/format.h>

#include "meristem/base/math.h"
#include "meristem/components/parts/around.h"

namespace meristem {

namespace {

constexpr double kDefaultRadius = 0.1;
constexpr const char* kNoZone = "the zone ends where it begins, or before";
constexpr const char* kZone = "'theta1' below 'theta2'";

void expand(const Phiball& ball, const Site&, const InstanceContext& instance, SiteSink& sites) {
  sites.no_children();
  const std::uint32_t number = sites.expect_parts(member_of(ball, &Phiball::number));
  std::vector<double> size = sites.per_child(ball.size, number);
  double whole = 0;
  // The last child takes the area of its current size.
  const double part = ball.number.last();
  for (const double s : size) whole += s * s;
  if (number > 0) whole -= size.back() * size.back() * (1 - part * part);
  if (!(whole > 0)) return;

  const double top = math::cos(ball.theta1);
  const double height = top - math::cos(ball.theta2);  // height of the zone on a sphere of radius 1
  if (!(height > 0)) {
    throw InputError(Diagnostic{
        .message = kNoZone, .expected = kZone, .path = fmt::format("components.{}.theta1", instance.component())});
  }
  const double radius =
      ball.area ? std::sqrt(*ball.area * whole / (2 * kPi * height)) : ball.radius.value_or(kDefaultRadius);
  const double golden = kGoldenAngleDeg * kPi / 180;
  const Vec3 middle(0, ball.pole ? -static_cast<float>(radius) : 0.0F, 0);
  double before = 0;
  for (std::uint32_t k = 0; k < number; ++k) {
    const double own = size[k] * size[k] * (k + 1 == number ? part * part : 1);
    const double polar = math::acos(top - (before + 0.5 * own) / whole * height);
    before += own;
    // Remove whole turns first, so that the angle is as exact for the last child as for the first.
    const double turns = std::fmod(k * (golden / (2 * kPi)), 1.0);
    Frame child{tilted(ball.roll + 2 * kPi * turns, polar), Vec3(0)};
    child.origin = middle + static_cast<float>(radius) * child.heading();
    child.axes *= static_cast<float>(size[k]);
    sites.add(child, 0, static_cast<float>(radius));
  }
}

void check_zone(const Phiball& ball, const DocumentPath& path, ParameterReader& reader) {
  if (ball.theta1 < ball.theta2) return;
  reader.add_error(DocumentPath(path, "theta1"), kNoZone, kZone);
}

}  // namespace

ComponentType phiball_component() {
  return define_component<Phiball>({
      .traits = {.name = "phiball",
                 .doc = "Sites for children on a sphere by the golden angle: florets of a head, leaves of a rosette.",
                 .has_geometry = false},
      .parameters =
          Table<Phiball>("a phiball", "Sites for children on a zone of a sphere by the golden angle.")
              .count("number", &Phiball::number, {.min = 0, .max = 2e9, .usual = {0, 500}},
                     "Number of children on the sphere; of 30.4 there are 31, and the last has 0.4 of its size.")
              .number("radius", &Phiball::radius, {.unit = Unit::metre, .min = 0, .max = 1e5, .usual = {0, 0.3}},
                      "Radius of the sphere; by default 0.1, unless 'area' is given.")
              .number("area", &Phiball::area, {.min = 0, .max = 1e8, .usual = {1e-6, 0.001}, .above_min = true},
                      "Area in square metres that a child of size 1 takes, which sets the sphere's radius; raised, "
                      "children stand farther apart.")
              .never_with("radius", {"area"})
              .number(
                  "theta1", &Phiball::theta1, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Angle from the sphere's pole, which lies along the heading, to where the zone of children begins.")
              .number("theta2", &Phiball::theta2, {.unit = Unit::degree, .min = 0, .max = 180},
                      "Angle from the sphere's pole to where the zone of children ends: small for a cap, 180 for the "
                      "whole sphere.")
              .per_child("size", &Phiball::size, {.min = 0, .max = 1000, .usual = {0, 2}},
                         "Scale of each child, which takes an area in proportion to its square.")
              .number("roll", &Phiball::roll, {.unit = Unit::degree, .min = -36000, .max = 36000},
                      "Turn of the sphere about its heading.")
              .boolean("pole", &Phiball::pole,
                       "Whether the sphere's pole stands on the frame; otherwise its centre does.")
              .check(check_zone),
      .expand = expand,
      .minimum_counts =
          [](const Phiball& ball, const KnownMembers& known) {
            if (ball.size.varying || known.varies(member_of(ball, &Phiball::size))) return MinimumCounts();
            return MinimumCounts{.children = known.minimum(member_of(ball, &Phiball::number)),
                                 .child_scale = ball.size.plain};
          },
  });
}

}  // namespace meristem
