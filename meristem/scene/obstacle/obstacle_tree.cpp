// SPDX-License-Identifier: Apache-2.0
// Finds triangles on rays with Embree, but decides in double precision. The tree holds float boxes relative to the
// centre of all bodies. A ray is first clipped, in double, to the part within their bounds. Its floats there have an
// error below one two-millionth of the bounds' extent. Every box is larger than its triangle by twice that error, so no
// triangle on the ray is missed.
#include "meristem/scene/obstacle/obstacle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "meristem/base/diagnostic.h"
#include "meristem/base/embree.h"
#include "meristem/base/reading_stop.h"
#include "meristem/scene/obstacle/watertight_ray.h"

namespace meristem {

namespace {

constexpr double kBoxMargin = 1e-6;   // relative to the bounds' extent
constexpr double kFarMargin = 1e-12;  // relative to the distance from the origin, for the resolution of doubles

struct Facet {
  std::array<WatertightRay::Corner, 3> corners;
  std::uint32_t body = 0;
};

/// The triangles of all bodies and their bounds.
struct Facets {
  std::vector<Facet> all;
  DVec3 low{std::numeric_limits<double>::infinity()};  ///< reduced by the margin
  DVec3 high{-std::numeric_limits<double>::infinity()};
  DVec3 middle{0};
  double margin = 0;  ///< margin of boxes around their content, metres

  explicit Facets(const std::vector<const TriangleMesh*>& bodies) {
    StopCounter stop;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      for (const auto& triangle : bodies[body]->triangles) {
        stop.step();
        Facet& facet = all.emplace_back();
        facet.body = static_cast<std::uint32_t>(body);
        for (std::size_t k = 0; k < 3; ++k) {
          const DVec3 corner = bodies[body]->positions[triangle[k]];
          facet.corners[k] = {corner.x, corner.y, corner.z};
          low = glm::min(low, corner);
          high = glm::max(high, corner);
        }
      }
    }
    if (all.empty()) return;
    middle = 0.5 * (low + high);
    const DVec3 farthest = glm::max(glm::abs(low), glm::abs(high));
    margin = kBoxMargin * glm::length(high - low) + kFarMargin * glm::length(farthest) +
             double{std::numeric_limits<float>::min()};
    low -= margin;
    high += margin;
  }

  RTCBounds bounds(std::size_t index) const {
    std::array<double, 3> lowest{};
    std::array<double, 3> highest{};
    const auto& corners = all[index].corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto centre = middle[static_cast<int>(k)];
      lowest[k] = std::min({corners[0][k], corners[1][k], corners[2][k]}) - centre - margin;
      highest[k] = std::max({corners[0][k], corners[1][k], corners[2][k]}) - centre + margin;
    }
    return {static_cast<float>(lowest[0]),  static_cast<float>(lowest[1]),  static_cast<float>(lowest[2]),  0,
            static_cast<float>(highest[0]), static_cast<float>(highest[1]), static_cast<float>(highest[2]), 0};
  }
};

/// The part of a ray within the facets' bounds, in metres along the ray.
struct Part {
  double begin = 0;
  double end = 0;
};

std::optional<Part> part_within(const Facets& facets, DVec3 origin, DVec3 unit, double reach) {
  Part part{0, reach};
  for (int k = 0; k < 3; ++k) {
    if (unit[k] == 0) {
      if (origin[k] < facets.low[k] || origin[k] > facets.high[k]) return std::nullopt;
      continue;
    }
    const double to_low = (facets.low[k] - origin[k]) / unit[k];
    const double to_high = (facets.high[k] - origin[k]) / unit[k];
    part.begin = std::max(part.begin, std::min(to_low, to_high));
    part.end = std::min(part.end, std::max(to_low, to_high));
  }
  return part.begin <= part.end ? std::optional(part) : std::nullopt;
}

/// The state of a ray query in the tree.
struct Query : EmbreeRayContext {
  Query(const WatertightRay& asked, double metres, double reach) : ray(asked), length(metres), within(reach) {}

  /// Returns the tree's distance for this number of metres along the ray; never too small.
  float in_tree_distance(double metres) const { return static_cast<float>(metres - skipped + margin); }

  WatertightRay ray;
  double length;       ///< length of its direction, metres
  double within;       ///< in lengths of its direction; reduced to the best hit
  double skipped = 0;  ///< metres before the ray enters the bounds
  double margin = 0;
  RTCRay in_tree{};
  bool is_met = false;
  std::uint32_t body = 0;
};

/// Returns nothing if the ray misses the bounds or is not finite.
std::optional<Query> begin_query(const Facets& facets, DVec3 origin, DVec3 direction, double within) {
  const double length = glm::length(direction);
  if (!(length > 0) || !std::isfinite(length + glm::dot(origin, origin))) return std::nullopt;
  const DVec3 unit = direction / length;
  const auto part = part_within(facets, origin, unit, within * length);
  if (!part) return std::nullopt;
  std::optional<Query> query(std::in_place, WatertightRay(origin, direction), length, within);
  query->skipped = part->begin;
  query->margin = facets.margin;
  const DVec3 from = origin + part->begin * unit - facets.middle;
  RTCRay& ray = query->in_tree;
  ray.org_x = static_cast<float>(from.x);
  ray.org_y = static_cast<float>(from.y);
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(unit.x);
  ray.dir_y = static_cast<float>(unit.y);
  ray.dir_z = static_cast<float>(unit.z);
  ray.tfar = query->in_tree_distance(part->end);
  ray.mask = ~0U;
  return query;
}

/// Returns the position on a segment that is nearest to `position`.
DVec3 nearest_on_edge(DVec3 position, DVec3 from, DVec3 to) {
  const DVec3 along = to - from;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0 ? std::clamp(glm::dot(position - from, along) / length2, 0.0, 1.0) : 0;
  return from + share * along;
}

/// Returns the position on a triangle that is nearest to `position`: the projection if it is within all edges, else the
/// nearest position on an edge.
ObstacleTree::Near nearest_on(const Facet& facet, DVec3 position) {
  std::array<DVec3, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) corner[k] = {facet.corners[k][0], facet.corners[k][1], facet.corners[k][2]};
  const DVec3 across = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double area = glm::length(across);
  ObstacleTree::Near near;
  if (area > 0) {
    near.normal = across / area;
    bool is_within = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const DVec3 edge = corner[(k + 1) % 3] - corner[k];
      is_within = is_within && glm::dot(glm::cross(edge, position - corner[k]), near.normal) >= 0;
    }
    if (is_within) {
      near.position = position - glm::dot(position - corner[0], near.normal) * near.normal;
      return near;
    }
  }
  double min = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const DVec3 found = nearest_on_edge(position, corner[k], corner[(k + 1) % 3]);
    const double distance = glm::distance(found, position);
    if (distance >= min) continue;
    min = distance;
    near.position = found;
  }
  return near;
}

/// The state of a search for the nearest triangle. Distances in the tree are floats.
struct NearQuery {
  const Facets* facets = nullptr;
  DVec3 position{0};
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t facet = 0;
  ObstacleTree::Near best;
};

bool look_nearer(RTCPointQueryFunctionArguments* arguments) {
  auto& query = *static_cast<NearQuery*>(arguments->userPtr);
  const std::uint32_t index = arguments->primID;
  const ObstacleTree::Near found = nearest_on(query.facets->all[index], query.position);
  const double distance = glm::distance(found.position, query.position);
  if (distance > query.distance || (distance == query.distance && index >= query.facet)) return false;
  query.distance = distance;
  query.facet = index;
  query.best = found;
  // Larger than the error of the boxes, so that equally near triangles are also tested.
  arguments->query->radius = static_cast<float>(distance * (1 + kBoxMargin) + 2 * query.facets->margin);
  return true;
}

void give_bounds(const RTCBoundsFunctionArguments* arguments) {
  *arguments->bounds_o = static_cast<const Facets*>(arguments->geometryUserPtr)->bounds(arguments->primID);
}

void find_first(const RTCIntersectFunctionNArguments* arguments) {
  auto& query = *static_cast<Query*>(arguments->context);
  const Facet& facet = static_cast<const Facets*>(arguments->geometryUserPtr)->all[arguments->primID];
  const auto distance = query.ray.distance_to(facet.corners, query.within);
  if (!distance || (query.is_met && *distance == query.within && facet.body >= query.body)) return;
  query.is_met = true;
  query.body = facet.body;
  query.within = *distance;
  reinterpret_cast<RTCRayHit*>(arguments->rayhit)->ray.tfar = query.in_tree_distance(*distance * query.length);
}

void find_any(const RTCOccludedFunctionNArguments* arguments) {
  auto& query = *static_cast<Query*>(arguments->context);
  const Facet& facet = static_cast<const Facets*>(arguments->geometryUserPtr)->all[arguments->primID];
  if (!query.ray.distance_to(facet.corners, query.within)) return;
  query.is_met = true;
  reinterpret_cast<RTCRay*>(arguments->ray)->tfar = -std::numeric_limits<float>::infinity();
}

struct ReleaseEmbree {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <class T>
using EmbreeOwner = std::unique_ptr<T, ReleaseEmbree>;

}  // namespace

struct ObstacleTree::Tree {
  Facets facets;
  std::string failure;
  EmbreeOwner<RTCDeviceTy> device;
  EmbreeOwner<RTCSceneTy> scene;

  explicit Tree(const std::vector<const TriangleMesh*>& bodies) : facets(bodies) {
    device.reset(rtcNewDevice(kEmbreeDevice));
    if (device == nullptr) throw MachineError("obstacles: Embree could not be started");
    const auto keep_failure = [](void* self, RTCError, const char* reason) {
      static_cast<Tree*>(self)->failure = reason;
    };
    rtcSetDeviceErrorFunction(device.get(), keep_failure, this);
    scene.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    const EmbreeOwner<RTCGeometryTy> geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(facets.all.size()));
    rtcSetGeometryUserData(geometry.get(), &facets);
    rtcSetGeometryBoundsFunction(geometry.get(), give_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), find_first);
    rtcSetGeometryOccludedFunction(geometry.get(), find_any);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene.get(), geometry.get());
    // Embree calls this function on all of its threads.
    const auto goes_on = [](void* progress, double) { return !static_cast<const Progress*>(progress)->is_cancelled(); };
    const Progress* const progress = ReadingStop::progress();
    if (progress != nullptr) {
      rtcSetSceneProgressMonitorFunction(scene.get(), goes_on, const_cast<Progress*>(progress));
    }
    rtcCommitScene(scene.get());
    rtcSetSceneProgressMonitorFunction(scene.get(), nullptr, nullptr);
    ReadingStop::check();
    if (!failure.empty()) throw MachineError("obstacles: " + failure);
  }
};

ObstacleTree::ObstacleTree(const std::vector<const TriangleMesh*>& bodies) : tree_(std::make_unique<Tree>(bodies)) {}

ObstacleTree::~ObstacleTree() = default;

std::optional<ObstacleTree::Hit> ObstacleTree::first_hit(DVec3 origin, DVec3 direction, double within) const {
  auto query = begin_query(tree_->facets, origin, direction, within);
  if (!query) return std::nullopt;
  RTCRayHit asked{query->in_tree, {}};
  asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  find_first_hit(tree_->scene.get(), *query, asked);
  return query->is_met ? std::optional(Hit{query->within, query->body}) : std::nullopt;
}

std::optional<ObstacleTree::Near> ObstacleTree::nearest(DVec3 position) const {
  const Facets& facets = tree_->facets;
  if (facets.all.empty() || !std::isfinite(glm::dot(position, position))) return std::nullopt;
  NearQuery query{.facets = &facets, .position = position};
  const DVec3 from = position - facets.middle;
  RTCPointQuery asked{};
  asked.x = static_cast<float>(from.x);
  asked.y = static_cast<float>(from.y);
  asked.z = static_cast<float>(from.z);
  // Far away, floats are too coarse for the tree. The radius then contains all triangles.
  asked.radius = std::numeric_limits<float>::infinity();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(tree_->scene.get(), &asked, &context, look_nearer, &query);
  return query.best;
}

bool ObstacleTree::is_met(DVec3 origin, DVec3 direction, double within) const {
  auto query = begin_query(tree_->facets, origin, direction, within);
  if (!query) return false;
  find_any_hit(tree_->scene.get(), *query, query->in_tree);
  return query->is_met;
}

}  // namespace meristem
