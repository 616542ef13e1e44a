// SPDX-License-Identifier: Apache-2.0
// Shows attraction points as dots, before growth or after it.
#include "meristem/components/cloud.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "meristem/base/colour.h"
#include "meristem/scene/light_of_points.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {

namespace {

constexpr int kDotSegments = 8;
constexpr Vec3 kDotColour{0.06F, 0.16F, 0.55F};

// Values of `birth` that tell kept and removed points apart.
constexpr float kKept = 0;
constexpr float kRemoved = 1;

RootsInCrowns roots_of(const Cloud& cloud) { return {cloud.crown, cloud.points, cloud.roots, cloud.one_crown}; }

/// Points that do not change; each is a root. They are a Grower, so that they are placed during growth, component by
/// component, with progress reports and cancelling.
class PlacedPoints : public Grower {
 public:
  PlacedPoints(const std::vector<Vec3>& points, const std::vector<bool>& is_kept) {
    skeleton_.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      skeleton_.add_node(kNoNode, points[k], is_kept[k] ? kKept : kRemoved);
    }
  }

  int step_limit() const override { return 0; }
  bool step(Progress&) override { return false; }
  Skeleton take_skeleton(Progress&) override { return std::move(skeleton_); }

 private:
  Skeleton skeleton_;  // in the component's frame
};

/// Returns false for each point that obstacles or the limit on light remove.
std::vector<bool> kept_points(const std::vector<Vec3>& places, const LightLimit& limit, const GrowContext& context) {
  const std::vector<std::uint8_t> is_inside = inside_of(context.scene.obstacles, places, context.progress);
  std::vector<bool> is_kept(places.size());
  std::vector<Vec3> outside;
  std::vector<std::size_t> index;
  for (std::size_t k = 0; k < places.size(); ++k) {
    is_kept[k] = is_inside[k] == 0;
    if (!is_kept[k]) continue;
    outside.push_back(places[k]);
    index.push_back(k);
  }
  if (!(limit.share > 0) || context.scene.light.is_none()) return is_kept;
  const std::vector<double> light = light_of_points(outside, context.scene, limit.radius, limit.k, context.progress);
  std::fill(is_kept.begin(), is_kept.end(), false);
  for (const std::uint32_t k : brightest(light, limit.share)) is_kept[index[k]] = true;
  return is_kept;
}

std::unique_ptr<Grower> grow(const Cloud& cloud, const Site& site, const GrowContext& context) {
  std::vector<Vec3> points, places;
  for (const PointsOfRoot& of_root : points_of_roots(roots_of(cloud), site.key.child("points"), context)) {
    for (const Vec3 point : of_root.points) points.push_back(of_root.base + point);
  }
  for (const Vec3 point : points) places.push_back(site.frame.point(point));
  LightLimit limit = cloud.limit;
  limit.radius *= glm::length(site.frame.heading());
  return std::make_unique<PlacedPoints>(points, kept_points(places, limit, context));
}

/// Returns the points before growth, in the component's frame.
std::vector<TracedPlace> points_before_growth(StemSink& stems) {
  const Skeleton points = stems.take_grown();
  std::vector<TracedPlace> places;
  for (NodeIndex k = 0; k < points.node_count(); ++k) {
    places.push_back({points.position[k], points.birth[k] == kKept ? PlaceState::free : PlaceState::removed, 0});
  }
  return places;
}

/// Returns the tree's own points after growth, in the tree's frame.
std::vector<TracedPlace> points_after_growth(const Cloud& cloud, const InstanceContext& instance, StemSink& stems) {
  const GrowthTrace* const growth = instance.watched_growth();
  if (growth == nullptr) {
    throw InputError(Diagnostic{
        .message =
            fmt::format("'{}' shows the growth of '{}' and does not stand beside it", instance.component(), cloud.of),
        .expected = fmt::format("links to '{}' and '{}' from the same components", instance.component(), cloud.of),
        .path = fmt::format("components.{}.after_growth", instance.component())});
  }
  const auto step = static_cast<int>(stems.grown_to(growth->last_step()));
  std::vector<TracedPlace> places = growth->marks(step, {TracePart::points}, instance.progress()).points;
  const Mat3 from_world = glm::inverse(growth->place.axes);
  for (TracedPlace& place : places) place.position = from_world * (place.position - growth->place.origin);
  return places;
}

void expand(const Cloud& cloud, const Site&, const InstanceContext& instance, OrganSink& organs, StemSink& stems) {
  const bool is_watched = cloud.after_growth && !cloud.of.empty();
  const std::vector<TracedPlace> points =
      is_watched ? points_after_growth(cloud, instance, stems) : points_before_growth(stems);
  const Vec3 own = linear_from_srgb(cloud.colour.value_or(kDotColour));
  const auto tint = [&](const std::optional<Vec3>& colour) {
    return linear_from_srgb(colour.value_or(kDotColour)) / glm::max(own, 1e-4F);
  };
  const Vec3 used_tint = tint(cloud.used_colour);
  const Vec3 removed_tint = tint(cloud.removed_colour);
  Frame dot{.axes = Mat3(static_cast<float>(cloud.size))};
  for (const TracedPlace& point : points) {
    if (point.state == PlaceState::used && !cloud.used_colour) continue;
    if (point.state == PlaceState::removed && !cloud.removed_colour) continue;
    dot.origin = point.position;
    const Vec3 state_tint = point.state == PlaceState::used ? used_tint : removed_tint;
    organs.add(
        dot, shape_key({}), [] { return make_sphere(0.5, kDotSegments); },
        point.state == PlaceState::free ? Vec3(1) : state_tint);
  }
}

}  // namespace

ComponentType cloud_component() {
  return define_component<Cloud>({
      .traits = {.name = "cloud",
                 .doc = "The attraction points of a crown as dots, which show the effect of a crown, a distribution or "
                        "the scene.",
                 .material = {.colour = kDotColour, .roughness = 0.9F},
                 .shows = {.type = "colonize",
                           .rows = {{"crown", "crown"},
                                    {"points", "points"},
                                    {"roots", "roots"},
                                    {"one_crown", "one_crown"},
                                    {"limit", "light.limit"},
                                    {"frame", "frame"},
                                    {"gravitropism", "gravitropism"},
                                    {"phototropism", "phototropism"}},
                           .before_growth = {"crown", "points", "roots", "one_crown", "limit"}}},
      .parameters =
          Table<Cloud>("a cloud", "The attraction points of a crown as dots.")
              .text("of", &Cloud::of,
                    "Id of a colonize component whose attraction points the dots show; crown, points, roots, light "
                    "limit and frame are the tree's unless the cloud gives its own.")
              .object("crown", &Cloud::crown, crown_table,
                      "Envelope that the attraction points fill; required unless the points come from a file.")
              .object("points", &Cloud::points, points_table, "Number, distribution or file of the attraction points.")
              .positions("roots", &Cloud::roots, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-20, 20}},
                         "Positions of the crowns, as of the trees of a colonize component.")
              .boolean("one_crown", &Cloud::one_crown,
                       "Whether all roots share one crown, which stands at the component's origin.")
              .object("limit", &Cloud::limit, limit_table,
                      "Removes the points in the deepest shade, as the light response of a colonize component does.")
              .number("size", &Cloud::size, {.unit = Unit::metre, .min = 1e-5, .max = 1e4, .usual = {0.005, 0.2}},
                      "Diameter of each dot.")
              .boolean("after_growth", &Cloud::after_growth,
                       "Whether the dots are the points that growth has left to the tree of 'of': moved, and without "
                       "those that are used up; by default as before growth.")
              .colour("used_colour", &Cloud::used_colour,
                      "Colour of the points that the tree has used up; by default, they are not shown.")
              .colour("removed_colour", &Cloud::removed_colour,
                      "Colour of the points that obstacles or the light limit remove; by default, they are not shown.")
              .only_with("roots", {"one_crown"})
              .only_with("of", {"after_growth"})
              .only_where({{"after_growth", {true}}}, {"used_colour"})
              .check([](const Cloud& cloud, const DocumentPath& path, ParameterReader& reader) {
                const std::size_t times = roots_of(cloud).share_points() ? 1 : cloud.roots.size();
                check_cloud(cloud.crown, cloud.points, times, "a cloud", path, reader);
              }),
      .expand = expand,
      .grow = grow,
      .watches_growth = [](const Cloud& cloud) { return cloud.after_growth; },
  });
}

}  // namespace meristem
