// SPDX-License-Identifier: Apache-2.0
// Overlays of the plants at the shown step: skeleton, light on buds, resource, hull of the crown. Quantities are shown
// as colours along the axes.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/counted.h"
#include "meristem/export/overlay/hull_edges.h"
#include "meristem/export/overlay/overlay_makers.h"
#include "meristem/shape/stem/body_meshes.h"

namespace meristem {

namespace {

constexpr Vec3 kWood{0.1F, 0.1F, 0.1F};
constexpr Vec3 kDark{0.13F, 0.16F, 0.38F};
constexpr Vec3 kMiddle{0.78F, 0.25F, 0.32F};
constexpr Vec3 kBright{1, 0.88F, 0.25F};
constexpr Vec3 kHull{0.75F, 0.26F, 0.1F};
constexpr Vec3 kSupport{0.55F, 0.36F, 0.14F};
constexpr Vec3 kBox{0.42F, 0.2F, 0.6F};
constexpr std::string_view kLight = "light";
constexpr std::string_view kResource = "resource";

/// Returns a colour between dark and bright.
Vec3 shade_of(double share) {
  const auto u = static_cast<float>(std::clamp(share, 0.0, 1.0));
  return u < 0.5F ? glm::mix(kDark, kMiddle, 2 * u) : glm::mix(kMiddle, kBright, 2 * u - 1);
}

void add_ramp(OverlayLayer& layer, double max, const char* what) {
  for (const double share : {0.0, 0.5, 1.0}) {
    layer.legend.push_back({shade_of(share), fmt::format("{} {:.3g}", what, share * max)});
  }
}

/// A quantity at a position.
struct Reading {
  Vec3 position{0};
  double value = 0;
};

/// Reads the mean light of each metamer's own open buds. The column also includes the light of later parts.
void read_buds(const Skeleton& skeleton, std::vector<Reading>& readings) {
  const std::vector<float>& light = skeleton.extra.find(kLight)->second;
  const auto states = [&](const char* name) {
    const auto found = skeleton.extra.find(name);
    return found == skeleton.extra.end() ? std::vector<float>(skeleton.node_count(), 1) : found->second;
  };
  const std::vector<float> terminal = states("terminal_bud");
  const std::vector<float> lateral = states("lateral_bud");
  std::vector<double> own(light.begin(), light.end());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.is_root(node)) own[skeleton.parent[node]] -= static_cast<double>(light[node]);
  }
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const int buds = (terminal[node] == 0 ? 1 : 0) + (lateral[node] == 0 && !skeleton.is_root(node) ? 1 : 0);
    if (buds > 0) readings.push_back({skeleton.position[node], std::max(0.0, own[node] / buds)});
  }
}

/// Reads the share of the scene's light that obstacles leave at each node.
void read_scene(const Skeleton& skeleton, const OverlaySubject& subject, std::vector<Reading>& readings) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (node % 256 == 0) subject.progress.check();
    const Vec3 position = skeleton.position[node];
    double arrives = 0;
    subject.scene.light.for_each_ray(position, [&](const LightRay& ray) {
      if (!subject.scene.obstacles.block(position, ray.toward, ray.distance)) arrives += ray.strength;
    });
    readings.push_back({position, arrives});
  }
}

template <class Visit>
void for_each_segment(const Skeleton& skeleton, Visit visit) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!skeleton.is_root(node)) visit(node, skeleton.position[skeleton.parent[node]], skeleton.position[node]);
  }
}

void add_box(const Box& box, Vec3 colour, OverlayLayer& layer) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 from = box.low;
      const int second = (axis + 1) % 3;
      const int third = (axis + 2) % 3;
      if ((corner & 1) != 0) from[second] = box.high[second];
      if ((corner & 2) != 0) from[third] = box.high[third];
      Vec3 to = from;
      to[axis] = box.high[axis];
      layer.lines.push_back({from, to, colour});
    }
  }
}

}  // namespace

bool has_buds(const Skeleton& skeleton) { return skeleton.extra.contains(kLight); }

void show_skeleton(const OverlaySubject& subject, OverlayLayer& layer) {
  std::size_t nodes = 0;
  for (const Stem& stem : subject.plant.stems) {
    nodes += stem.skeleton.node_count();
    for_each_segment(stem.skeleton, [&](NodeIndex, Vec3 from, Vec3 to) { layer.lines.push_back({from, to, kWood}); });
    for (const Vec3 position : stem.skeleton.position) layer.points.push_back({position, kWood});
  }
  if (nodes > 0) layer.legend.push_back({kWood, counted(nodes, "node")});
}

void show_light(const OverlaySubject& subject, OverlayLayer& layer) {
  std::vector<Reading> readings;
  bool are_buds = false;
  for (const Stem& stem : subject.plant.stems) {
    const bool has_own = has_buds(stem.skeleton);
    are_buds = are_buds || has_own;
    if (has_own) {
      read_buds(stem.skeleton, readings);
    } else {
      read_scene(stem.skeleton, subject, readings);
    }
  }
  double max = 0;
  for (const Reading& reading : readings) max = std::max(max, reading.value);
  if (!(max > 0)) max = 1;
  for (const Reading& reading : readings) layer.points.push_back({reading.position, shade_of(reading.value / max)});
  if (!readings.empty()) add_ramp(layer, max, are_buds ? "light of a bud" : "light");
}

void show_resource(const OverlaySubject& subject, OverlayLayer& layer) {
  double max = 0;
  for (const Stem& stem : subject.plant.stems) {
    const auto found = stem.skeleton.extra.find(kResource);
    if (found == stem.skeleton.extra.end()) continue;
    for (const float value : found->second) max = std::max(max, static_cast<double>(value));
  }
  if (!(max > 0)) return;
  // Resource falls toward the tips by powers, so the colour shows its logarithm.
  const double scale = std::log1p(max);
  for (const Stem& stem : subject.plant.stems) {
    const auto found = stem.skeleton.extra.find(kResource);
    if (found == stem.skeleton.extra.end()) continue;
    for_each_segment(stem.skeleton, [&](NodeIndex node, Vec3 from, Vec3 to) {
      layer.lines.push_back({from, to, shade_of(std::log1p(static_cast<double>(found->second[node])) / scale)});
    });
  }
  for (const double share : {0.0, 0.5, 1.0}) {
    layer.legend.push_back({shade_of(share), fmt::format("resource {:.3g}", std::expm1(share * scale))});
  }
}

void show_hull(const OverlaySubject& subject, OverlayLayer& layer) {
  for (const Mesh& hull : crown_hulls(subject.plant, subject.progress)) {
    for (const HullEdge& edge : hull_edges(hull)) layer.lines.push_back({edge.from, edge.to, kHull});
  }
  if (!layer.lines.empty()) layer.legend.push_back({kHull, "hull of the crown"});
}

void show_supports(const OverlaySubject& subject, OverlayLayer& layer) {
  for (const auto& [name, line] : subject.scene.supports) {
    for (std::size_t k = 1; k < line.size(); ++k) layer.lines.push_back({line[k - 1], line[k], kSupport});
    if (!line.empty()) layer.labels.push_back({line.back(), name});
  }
  if (!layer.lines.empty()) layer.legend.push_back({kSupport, "supports"});
}

void show_box(const OverlaySubject& subject, OverlayLayer& layer) {
  const std::vector<BodyCells> bodies = find_body_cells(subject.plant, subject.progress);
  if (bodies.empty()) return;
  double min = bodies[0].cell;
  double max = min;
  for (const BodyCells& body : bodies) {
    add_box(body.box, kBox, layer);
    Box corner;
    corner.add(body.box.low);
    corner.add(body.box.low + Vec3(static_cast<float>(body.cell)));
    add_box(corner, kBox, layer);
    min = std::min(min, body.cell);
    max = std::max(max, body.cell);
  }
  const Vec3 size = bodies[0].box.size();
  const std::string boxes = bodies.size() == 1
                                ? fmt::format("box of {:.3g} x {:.3g} x {:.3g} m", size.x, size.y, size.z)
                                : fmt::format("{} boxes", bodies.size());
  const std::string cells = fmt::format("cells of {:.3g}", 1000 * min);
  const std::string up_to = max > min ? fmt::format(" to {:.3g}", 1000 * max) : "";
  layer.legend.push_back({kBox, fmt::format("{}, {}{} mm", boxes, cells, up_to)});
}

}  // namespace meristem
