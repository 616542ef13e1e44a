// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/cloud.h"

#include "meristem/shape/primitives.h"

namespace meristem {

namespace {

constexpr int kDotSegments = 8;

/// Points that stay as they are: each is a root of its own. Points are placed where plants grow, one component after
/// another, so that they report and can be cancelled as growth can.
class PlacedPoints : public Grower {
 public:
  explicit PlacedPoints(const std::vector<Vec3>& points) {
    skeleton_.reserve(points.size());
    for (const Vec3 point : points) skeleton_.add_node(kNoNode, point, 0);
  }

  int step_limit() const override { return 0; }
  bool step(Progress&) override { return false; }
  Skeleton take_skeleton(Progress&) override { return std::move(skeleton_); }

 private:
  Skeleton skeleton_;  // in the component's frame
};

std::unique_ptr<Grower> grow(const Cloud& cloud, const Site& site, const GrowContext& context) {
  return std::make_unique<PlacedPoints>(make_points(cloud.crown, cloud.points, site.key.child("points"), context));
}

void expand(const Cloud& cloud, const Site&, Emitter& out) {
  Frame dot{.axes = Mat3(static_cast<float>(cloud.size))};
  for (const Vec3 point : out.take_grown().position) {
    dot.origin = point;
    out.organ(dot, shape_key({}), [] { return make_sphere(0.5, kDotSegments); });
  }
}

}  // namespace

ComponentType cloud_component() {
  return define_component<Cloud>({
      .name = "cloud",
      .doc = "The attraction points of a crown as dots, to see what a crown or a distribution is.",
      .parameters = Table<Cloud>("a cloud", "Attraction points as dots.")
                        .object("crown", &Cloud::crown, crown_table,
                                "The envelope that the points fill; needed unless they come from a file.")
                        .object("points", &Cloud::points, points_table, "The attraction points.")
                        .number("size", &Cloud::size, {.unit = Unit::metre, .min = 1e-5, .max = 1e4}, "Across a dot.")
                        .check([](const Cloud& cloud, const Place& place, ParameterReader& reader) {
                          check_cloud(cloud.crown, cloud.points, 1, "a cloud", place, reader);
                        }),
      .material = {.colour = {0.06F, 0.16F, 0.55F}, .roughness = 0.9F},
      .expand = expand,
      .grow = grow,
  });
}

}  // namespace meristem
